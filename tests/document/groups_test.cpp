// Groups: their edits on random documents, what hides and locks objects, and their text in files.

#include <set>

#include "core/document/format/format.hpp"
#include "tests/document/random_documents.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

Document row_of_cubes(int count) {
  return duplicate_objects(cube_document(), std::vector{cube_id}, static_cast<std::size_t>(count - 1))
      ->document;
}

std::vector<ObjectId> ids_of(const Document& document) {
  std::vector<ObjectId> ids;
  for (const auto& object : document.objects) ids.push_back(object->id);
  return ids;
}

/// Definition of what shows: its own switches, and those of every group round it.
void expect_switches(const Document& document) {
  for (const auto& object : document.objects) {
    bool visible = object->visible_itself(), locked = object->locked_itself();
    for (const Group* group = find_group(*document.groups, object->group); group;
         group = find_group(*document.groups, group->parent)) {
      visible = visible && group->visible;
      locked = locked || group->locked;
    }
    EXPECT_EQ(object->visible, visible) << object->name;
    EXPECT_EQ(object->locked, locked) << object->name;
    EXPECT_FALSE(object->hidden_by_group && object->visible) << object->name;
    EXPECT_FALSE(object->locked_by_group && !object->locked) << object->name;
  }
}

void expect_sound(const Document& document) {
  EXPECT_EQ(group_fault(*document.groups), std::nullopt);
  const GroupTree tree(document);
  for (const Group& group : *document.groups) EXPECT_FALSE(tree.objects_in(group.id).empty()) << group.name;
  EXPECT_EQ(tree.objects_in({}).size(), document.objects.size());
  EXPECT_LE(tree.depth(), Group::max_depth);
  expect_switches(document);
  const auto read = test::must(read_document(write_document(document)));
  EXPECT_TRUE(*read == document);
}

/// One edit with random arguments, which may be refused.
Result<Document> any_group_edit(std::mt19937_64& rng, const Document& document) {
  const std::vector<ObjectId> all = ids_of(document);
  std::vector<ObjectId> some;
  for (const ObjectId id : all)
    if (test::chance(rng, 0.3)) some.push_back(id);
  const ObjectId one = all[rng() % all.size()];
  const Groups& groups = *document.groups;
  const GroupId group =
      groups.empty() || test::chance(rng, 0.2) ? GroupId{} : groups[rng() % groups.size()].id;
  const GroupTree tree(document);
  const auto rows = tree.members(group);
  MemberPlace place{group, std::nullopt};
  if (!rows.empty() && test::chance(rng, 0.7)) place.before = rows[rng() % rows.size()];
  switch (test::uniform_int(rng, 0, 12)) {
    case 0:
    case 1:
    case 2: {
      auto added = make_group(document, some, free_group_name(document, "Group"));
      return added ? Result<Document>(std::move(added).value().document) : added.error();
    }
    case 3:
      return ungroup(document, std::vector{group});
    case 4:
      return move_members(document, tree.members_of(some), place);
    case 5:
      return move_members(document, std::vector<Member>{group, one}, place);
    case 6:
      return shift_members(document, tree.members_of(some, one), test::chance(rng, 0.5));
    case 7:
      return set_group_visible(document, group, test::chance(rng, 0.5));
    case 8:
      return set_group_locked(document, group, test::chance(rng, 0.3));
    case 9:
      return test::chance(rng, 0.5) ? set_visible(document, one, test::chance(rng, 0.5))
                                    : set_locked(document, one, test::chance(rng, 0.3));
    case 10: {
      auto added = duplicate_object(document, one);
      return added ? Result<Document>(std::move(added).value().document) : added.error();
    }
    case 11:
      return test::chance(rng, 0.5) ? showing_only(document, some) : show_objects(document, some);
    default:
      return all.size() > 3 ? delete_objects(document, std::vector{one}) : Result<Document>(document);
  }
}

TEST(Groups, any_edits_keep_what_holds_of_groups) {
  int done = 0;
  std::set<std::string> refusals;
  test::for_random(4207, 60, [&](std::mt19937_64& rng) {
    Document document = row_of_cubes(test::uniform_int(rng, 2, 12));
    for (int i = 0; i < 40; ++i) {
      const Document before = document;
      auto next = any_group_edit(rng, document);
      if (!next) {
        refusals.emplace(next.error().code.name);
        EXPECT_TRUE(document == before);
        continue;
      }
      ++done;
      document = std::move(next).value();
      expect_sound(document);
      if (::testing::Test::HasFailure()) return;
    }
  });
  EXPECT_GT(done, 1000);
  EXPECT_TRUE(refusals.contains("E_LOCKED"));
  EXPECT_TRUE(refusals.contains("E_GROUP_CYCLE"));
}

TEST(Groups, ungrouping_right_after_grouping_neighbours_gives_the_old_document) {
  test::for_random(4208, 40, [](std::mt19937_64& rng) {
    const Document document = row_of_cubes(6);
    const auto ids = ids_of(document);
    const std::size_t first = rng() % 5, count = 1 + rng() % (6 - first);
    const auto made = test::must(make_group(document, std::span(ids).subspan(first, count), "Group"));
    EXPECT_FALSE(made->document == document);
    const auto back = test::must(ungroup(made->document, std::vector{made->id}));
    EXPECT_TRUE(*back == document);
  });
}

TEST(Groups, a_selection_becomes_a_group_where_its_first_object_stands) {
  const Document document = row_of_cubes(5);
  const auto ids = ids_of(document);
  const auto made = test::must(make_group(document, std::vector{ids[3], ids[1]}, "Wheels"));
  EXPECT_EQ(ids_of(made->document), (std::vector{ids[0], ids[1], ids[3], ids[2], ids[4]}));
  EXPECT_EQ(made->document.find(ids[1])->group, made->id);
  EXPECT_EQ(made->document.find(ids[2])->group, GroupId{});
  // A group all of whose objects are chosen lies in the new one as it is.
  const auto outer = test::must(make_group(made->document, std::vector{ids[1], ids[3], ids[2]}, "Car"));
  EXPECT_EQ(find_group(*outer->document.groups, made->id)->parent, outer->id);
  EXPECT_EQ(outer->document.find(ids[2])->group, outer->id);
  // Some objects of a group go into a group within it.
  const auto inner = test::must(make_group(outer->document, std::vector{ids[1]}, "Front"));
  EXPECT_EQ(find_group(*inner->document.groups, inner->id)->parent, made->id);
}

TEST(Groups, hide_and_lock_what_they_contain_and_give_it_back) {
  Document document = row_of_cubes(4);
  const auto ids = ids_of(document);
  document = set_visible(document, ids[1], false).value();
  const auto inner = make_group(document, std::vector{ids[0], ids[1]}, "Inner").value();
  const auto outer = make_group(inner.document, std::vector{ids[0], ids[1], ids[2]}, "Outer").value();
  const Document hidden = set_group_visible(outer.document, outer.id, false).value();
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(hidden.find(ids[static_cast<std::size_t>(i)])->visible);
  EXPECT_TRUE(hidden.find(ids[3])->visible);
  EXPECT_TRUE(set_group_visible(hidden, outer.id, true).value() == outer.document)
      << "what was hidden by its own switch stays so";
  EXPECT_FALSE(set_visible(hidden, ids[0], true)->find(ids[0])->visible);
  EXPECT_TRUE(show_objects(hidden, std::vector{ids[1]})->find(ids[1])->visible);

  const Document locked = set_group_locked(outer.document, outer.id, true).value();
  EXPECT_EQ(set_transform(locked, ids[0], {}).error().code.name, e_locked.name);
  EXPECT_EQ(delete_objects(locked, std::vector{ids[2]}).error().code.name, e_locked.name);
  EXPECT_EQ(ungroup(locked, std::vector{inner.id}).error().code.name, e_locked.name);
  EXPECT_EQ(move_members(locked, std::vector<Member>{ids[0]}, {}).error().code.name, e_locked.name);
  EXPECT_EQ(move_members(locked, std::vector<Member>{ids[3]}, {outer.id, {}}).error().code.name,
            e_locked.name);
  EXPECT_TRUE(set_group_locked(locked, outer.id, false).value() == outer.document);
  // A copy can be moved: it lies outside of the locked group.
  const auto copy = duplicate_object(locked, ids[0]).value();
  EXPECT_FALSE(copy.document.find(copy.id)->locked);
  EXPECT_EQ(copy.document.find(copy.id)->group, GroupId{});
}

TEST(Groups, cannot_lie_in_themselves_nor_too_deep) {
  Document document = row_of_cubes(2);
  std::vector<GroupId> chain;
  for (std::size_t i = 0; i < Group::max_depth; ++i) {
    const auto made = make_group(document, std::vector{cube_id}, "Group " + std::to_string(i));
    ASSERT_TRUE(made) << i;
    document = made->document;
    chain.push_back(made->id);
  }
  EXPECT_EQ(make_group(document, std::vector{cube_id}, "Deep").error().code.name, e_group_depth.name);
  const std::vector<Member> outer{chain.back()};
  EXPECT_EQ(move_members(document, outer, {chain.front(), {}}).error().code.name, e_group_cycle.name);
  EXPECT_EQ(make_group(document, {}, "None").error().code.name, e_group_empty.name);
  EXPECT_EQ(rename_group(document, chain[0], " ").error().code.name, e_name_empty.name);
  EXPECT_EQ(ungroup(document, std::vector{GroupId{999}}).error().code.name, e_unknown_group.name);
}

TEST(Groups, vanish_with_their_last_object_and_come_along_with_their_document) {
  Document document = row_of_cubes(3);
  const auto ids = ids_of(document);
  const auto made = make_group(document, std::vector{ids[1], ids[2]}, "Pair").value();
  document = set_group_colour(made.document, made.id, Colour{1, 2, 3}).value();
  EXPECT_TRUE(delete_objects(document, std::vector{ids[1], ids[2]})->groups->empty());
  const Document twice = append_document(document, document).value();
  ASSERT_EQ(twice.groups->size(), 2U);
  EXPECT_EQ((*twice.groups)[1].name, "Pair");
  EXPECT_EQ(GroupTree(twice).objects_in((*twice.groups)[1].id).size(), 2U);
  expect_sound(twice);
}

TEST(Groups, equality_notices_every_field_and_files_keep_it) {
  const auto inner = make_group(row_of_cubes(3), std::vector{cube_id}, "Inner").value();
  const auto outer = make_group(inner.document, ids_of(inner.document), "Outer").value();
  const auto changed = [&](auto&& change) {
    Groups groups = *outer.document.groups;
    change(groups[0]);
    Document other = outer.document;
    other.groups = groups;
    other = with_group_switches(other);
    EXPECT_FALSE(other == outer.document);
    const auto again = test::must(read_document(write_document(other)));
    EXPECT_TRUE(*again == other);
  };
  changed([](Group& group) { group.name = "Other"; });
  changed([](Group& group) { group.parent = {}; });
  changed([](Group& group) { group.visible = false; });
  changed([](Group& group) { group.locked = true; });
  changed([](Group& group) { group.colour = Colour{0, 0, 1}; });
}

TEST(Groups, of_broken_files_are_refused) {
  const auto made = make_group(row_of_cubes(2), std::vector{cube_id}, "Group").value();
  const std::string text = write_document(made.document);
  const auto broken = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    const std::size_t at = other.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at != std::string::npos) other.replace(at, from.size(), to);
    const auto read = read_document(other);
    return read ? std::string("read") : std::string(read.error().code.name);
  };
  EXPECT_EQ(broken("\"group\": 1", "\"group\": 2"), "E_SCHEMA");
  EXPECT_EQ(broken("\"name\": \"Group\"", "\"name\": \"Group\", \"parent\": 1"), "E_SCHEMA");
  EXPECT_EQ(broken("\"name\": \"Group\"", "\"name\": \"Group\", \"parent\": 7"), "E_SCHEMA");
  EXPECT_EQ(broken("\"name\": \"Group\"", "\"name\": \" \""), "E_NAME_EMPTY");
  EXPECT_EQ(broken("\"id\": 1, \"name\": \"Group\"", "\"id\": 9, \"name\": \"Group\""), "E_SCHEMA");
}

}  // namespace
}  // namespace hariko::test
