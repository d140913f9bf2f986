#include "core/skinning/edit/edit_correspondence.hpp"

#include <algorithm>

#include "core/skinning/columns/skin_plan.hpp"
#include "core/skinning/skin_messages.hpp"
#include "tests/skinning/skin_inputs.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

using Ids = std::vector<std::uint32_t>;

std::uint32_t id(const Skin& skin, int section, int i) {
  return skin.sections[std::size_t(section)].points[std::size_t(i)].id;
}

bool has_line(const Skin& skin, int strip, PointPair line) {
  const auto plan = must(plan_skin(skin));
  const auto& lines = plan->strips[std::size_t(strip)].lines;
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

TEST(EditCorrespondence, ALineJoinsPointsInEitherDirection) {
  const Skin skin = skin_input("fig6a");
  const auto forward = join_points(skin, Ids{id(skin, 0, 2), id(skin, 1, 3)});
  const auto backward = join_points(skin, Ids{id(skin, 1, 3), id(skin, 0, 2)});
  ASSERT_TRUE(forward.ok());
  ASSERT_TRUE(backward.ok());
  EXPECT_EQ(forward->skin, backward->skin);
  EXPECT_EQ(forward->added.size(), 1U);
  EXPECT_TRUE(has_line(forward->skin, 0, {2, 3}));
  const auto again = must(join_points(forward->skin, Ids{id(skin, 0, 2), id(skin, 1, 3)}));
  EXPECT_EQ(again->skin, forward->skin) << "nothing new";
  EXPECT_EQ(join_points(skin, Ids{id(skin, 0, 2), id(skin, 0, 3)}).error().code, e_not_neighbours);
  EXPECT_EQ(join_points(skin, Ids{id(skin, 0, 2), 4711}).error().code, e_skin_index);
}

TEST(EditCorrespondence, ALineOverSeveralSectionsMakesAChain) {
  const Skin skin = skin_input("car_default");
  const auto edit = join_points(skin, Ids{id(skin, 0, 2), id(skin, 1, 4), id(skin, 2, 4), id(skin, 3, 4)});
  ASSERT_TRUE(edit.ok());
  EXPECT_EQ(edit->added.size(), 3U);
  EXPECT_TRUE(has_line(edit->skin, 0, {2, 4}));
  EXPECT_TRUE(has_line(edit->skin, 1, {4, 4}));
  EXPECT_TRUE(has_line(edit->skin, 2, {4, 4}));
  EXPECT_EQ(join_points(skin, Ids{id(skin, 0, 2), id(skin, 2, 4)}).error().code, e_not_neighbours);
}

TEST(EditCorrespondence, NewBeatsOldAndSaysWhatGaveWay) {
  const Skin skin = skin_input("fig6a");
  Skin now = join_points(skin, Ids{id(skin, 0, 2), id(skin, 1, 3)})->skin;
  now = join_points(now, Ids{id(skin, 0, 6), id(skin, 1, 5)})->skin;
  const std::uint32_t first = now.links[0].id, second = now.links[1].id;
  const auto edit = must(join_points(now, Ids{id(skin, 0, 4), id(skin, 1, 2)}));
  EXPECT_EQ(edit->removed, Ids{first}) << "4-2 crosses 2-3, not 6-5";
  EXPECT_EQ(edit->skin.links.size(), 2U);
  EXPECT_EQ(edit->skin.links[0].id, second);
  // A locked one does not give way.
  const Skin locked = set_locked(now, first, true)->skin;
  must_fail(join_points(locked, Ids{id(skin, 0, 4), id(skin, 1, 2)}), e_correspondence_locked);
}

TEST(EditCorrespondence, ACurveGroupsPoints) {
  const Skin skin = skin_input("fig6a");
  const auto edit = group_points(skin, Ids{id(skin, 0, 3), id(skin, 0, 1), id(skin, 1, 3), id(skin, 0, 2)});
  ASSERT_TRUE(edit.ok());
  ASSERT_EQ(edit->skin.links.size(), 1U);
  EXPECT_TRUE(edit->skin.links[0].lasso);
  for (const int i : {1, 2, 3}) EXPECT_TRUE(has_line(edit->skin, 0, {i, 3}));
  EXPECT_EQ(group_points(skin, Ids{id(skin, 0, 1), id(skin, 0, 3), id(skin, 1, 3)}).error().code,
            e_merge_gap);
  EXPECT_EQ(group_points(skin, Ids{id(skin, 0, 1), id(skin, 0, 2)}).error().code, e_not_neighbours);
  const Skin car = skin_input("car_default");
  const auto three = must(group_points(car, Ids{id(car, 1, 4), id(car, 2, 4), id(car, 3, 4), id(car, 3, 5)}));
  EXPECT_EQ(three->added.size(), 2U) << "one link each strip";
  // Two groups are joined at their ends.
  const auto both =
      group_points(skin, Ids{id(skin, 0, 2), id(skin, 0, 3), id(skin, 0, 4), id(skin, 1, 2), id(skin, 1, 3)});
  ASSERT_TRUE(both.ok());
  EXPECT_TRUE(has_line(both->skin, 0, {2, 2}));
  EXPECT_TRUE(has_line(both->skin, 0, {4, 3}));
}

TEST(EditCorrespondence, AWedgeMergesAtItsTip) {
  const Skin skin = skin_input("fig9_interior");
  Skin bare = skin;
  bare.merges.clear();
  const Ids members{id(skin, 0, 2), id(skin, 0, 3), id(skin, 0, 4), id(skin, 0, 5), id(skin, 0, 6)};
  const auto edit = must(merge_points(bare, members, id(skin, 1, 2), 0.5));
  EXPECT_EQ(edit->skin.merges[0].members, skin.merges[0].members);
  EXPECT_EQ(edit->skin.merges[0].target, skin.merges[0].target);
  // With its tip at the other section it is a group.
  const auto at_section = must(merge_points(bare, members, id(skin, 1, 2), 1.0));
  EXPECT_TRUE(at_section->skin.merges.empty());
  EXPECT_EQ(at_section->skin.links.size(), 1U);
  EXPECT_EQ(merge_points(bare, members, id(skin, 1, 2), -0.2).error().code, e_merge_v);
  EXPECT_EQ(merge_points(bare, Ids{members[0]}, id(skin, 1, 2), 0.5).error().code, e_merge_small);
  EXPECT_EQ(merge_points(bare, Ids{members[0], members[2]}, id(skin, 1, 2), 0.5).error().code, e_merge_gap);
  // From the other side.
  const Skin split = skin_input("merge_split");
  Skin cleared = split;
  cleared.merges.clear();
  const auto other = must(merge_points(cleared, split.merges[1].members, split.merges[1].target, 0.5));
  EXPECT_EQ(other->skin.merges[0].side, StripSide::b);
}

TEST(EditCorrespondence, EndsAndDiamondsAreDragged) {
  const Skin skin = skin_input("fig6b");
  const std::uint32_t link = skin.links[0].id;
  const auto moved = must(move_link_end(skin, link, id(skin, 1, 3), id(skin, 1, 2)));
  EXPECT_EQ(moved->skin.links[0].id, link) << "the same link";
  EXPECT_TRUE(has_line(moved->skin, 0, {2, 2}));
  const auto across = must(move_link_end(skin, link, id(skin, 1, 3), id(skin, 1, 6)));
  EXPECT_EQ(across->removed, Ids{skin.links[1].id});
  EXPECT_EQ(move_link_end(skin, link, id(skin, 1, 3), id(skin, 0, 3)).error().code, e_not_neighbours);
  EXPECT_EQ(move_link_end(skin, 99, id(skin, 1, 3), id(skin, 1, 2)).error().code, e_no_correspondence);
  const Skin wedge = skin_input("fig9_interior");
  const auto slid = must(move_merge(wedge, wedge.merges[0].id, 0.25, wedge.merges[0].target));
  EXPECT_EQ(slid->skin.merges[0].v, 0.25);
  const auto sideways = must(move_merge(wedge, wedge.merges[0].id, 0.5, id(wedge, 1, 1)));
  EXPECT_TRUE(has_line(sideways->skin, 0, {4, 1}));
  EXPECT_EQ(move_merge(wedge, wedge.merges[0].id, 1.5, wedge.merges[0].target).error().code, e_merge_v);
}

TEST(EditCorrespondence, LockDeleteReset) {
  const Skin skin = skin_input("fig6a");
  const auto locked = must(lock_line(skin, id(skin, 0, 4), id(skin, 1, 3)));
  EXPECT_TRUE(locked->skin.links[0].locked);
  EXPECT_EQ(lock_line(skin, id(skin, 0, 4), id(skin, 1, 5)).error().code, e_no_correspondence);
  const auto deleted = must(delete_correspondence(locked->skin, locked->skin.links[0].id));
  EXPECT_EQ(deleted->skin, skin);
  EXPECT_EQ(delete_correspondence(skin, 5).error().code, e_no_correspondence);
  const Skin car = skin_input("car_edited");
  const auto reset = reset_strip(car, car.sections[0].id, car.sections[1].id);
  EXPECT_EQ(reset.removed.size(), 5U);
  for (const SkinLink& link : reset.skin.links) EXPECT_NE(link.first, car.sections[0].id);
}

TEST(EditCorrespondence, RandomGesturesNeverLeaveACrossing) {
  for_random(721, 12, [](std::mt19937_64& rng) {
    Skin skin = skin_input(chance(rng, 0.5) ? "car_default" : "tube");
    const auto random_point = [&](int section) {
      return id(skin, section, uniform_int(rng, 0, skin.sections[std::size_t(section)].size() - 1));
    };
    for (int gesture = 0; gesture < 12; ++gesture) {
      const int a = uniform_int(rng, 0, skin.section_count() - 2);
      Result<CorrespondenceEdit> edit = CorrespondenceEdit{skin, {}, {}};
      if (chance(rng, 0.5)) {
        edit = join_points(skin, Ids{random_point(a), random_point(a + 1)});
      } else {
        const auto& section = skin.sections[std::size_t(a)];
        const int at = uniform_int(rng, 0, section.size() - 2);
        edit = merge_points(skin,
                            Ids{section.points[std::size_t(at)].id, section.points[std::size_t(at) + 1].id},
                            random_point(a + 1), uniform(rng, 0.1, 0.9));
      }
      ASSERT_TRUE(edit.ok()) << to_string(edit.error());
      skin = edit->skin;
      ASSERT_TRUE(plan_skin(skin).ok());
    }
  });
}

TEST(EditCorrespondence, MovingPointsRematchesNothing) {
  for (const std::string& name : std::vector<std::string>{"car_edited", "tube", "fig6b"}) {
    Skin skin = skin_input(name);
    const auto before = plan_skin(skin);
    for_random(722, 5, [&](std::mt19937_64& rng) {
      Skin moved = skin;
      for (SkinSection& section : moved.sections)
        for (SectionPoint& p : section.points) p.position += random_vector(rng, 0.5);
      const auto after = must(plan_skin(moved));
      for (std::size_t s = 0; s < before->strips.size(); ++s)
        EXPECT_EQ(after->strips[s].lines, before->strips[s].lines);
    });
  }
}

TEST(EditCorrespondence, EndsOfAnyLineCanBeMoved) {
  const Skin skin = skin_input("fig6a");
  // A line that was matched becomes a link.
  const auto fresh = must(move_line_end(skin, id(skin, 0, 3), id(skin, 1, 2), id(skin, 0, 4)));
  ASSERT_EQ(fresh->skin.links.size(), 1U);
  EXPECT_EQ(fresh->skin.links[0].a, Ids{id(skin, 0, 4)});
  EXPECT_EQ(fresh->skin.links[0].b, Ids{id(skin, 1, 2)});
  // A link keeps its id, on either side.
  const auto moved = must(move_line_end(fresh->skin, id(skin, 1, 2), id(skin, 0, 4), id(skin, 1, 3)));
  ASSERT_EQ(moved->skin.links.size(), 1U);
  EXPECT_EQ(moved->skin.links[0].id, fresh->skin.links[0].id);
  EXPECT_TRUE(has_line(moved->skin, 0, {4, 3}));
  EXPECT_EQ(move_line_end(skin, id(skin, 0, 3), id(skin, 1, 2), id(skin, 0, 3))->skin, skin);
  EXPECT_EQ(move_line_end(skin, id(skin, 0, 3), id(skin, 1, 2), id(skin, 1, 3)).error().code,
            e_not_neighbours);
  EXPECT_EQ(move_line_end(skin, id(skin, 0, 3), 4711, id(skin, 0, 4)).error().code, e_skin_index);
}

TEST(EditCorrespondence, LinesOfAMergeMoveItsTargetOrItsReach) {
  const Skin skin = skin_input("fig6a");
  const Skin merged =
      merge_points(skin, Ids{id(skin, 0, 3), id(skin, 0, 4), id(skin, 0, 5)}, id(skin, 1, 3), 0.4)->skin;
  const std::uint32_t merge = merged.merges.at(0).id;
  const auto target = must(move_line_end(merged, id(skin, 1, 3), id(skin, 0, 4), id(skin, 1, 4)));
  EXPECT_EQ(target->skin.merges.at(0).target, id(skin, 1, 4));
  EXPECT_EQ(target->skin.merges[0].id, merge);
  EXPECT_EQ(target->skin.merges[0].v, 0.4);
  const auto wider = must(move_line_end(merged, id(skin, 0, 3), id(skin, 1, 3), id(skin, 0, 1)));
  EXPECT_EQ(wider->skin.merges.at(0).members,
            (Ids{id(skin, 0, 1), id(skin, 0, 2), id(skin, 0, 3), id(skin, 0, 4), id(skin, 0, 5)}));
  const auto narrower = must(move_line_end(merged, id(skin, 0, 5), id(skin, 1, 3), id(skin, 0, 4)));
  EXPECT_EQ(narrower->skin.merges.at(0).members, (Ids{id(skin, 0, 3), id(skin, 0, 4)}));
  EXPECT_EQ(move_line_end(merged, id(skin, 0, 4), id(skin, 1, 3), id(skin, 0, 2)).error().code, e_merge_gap);
  EXPECT_EQ(move_line_end(narrower->skin, id(skin, 0, 4), id(skin, 1, 3), id(skin, 0, 3)).error().code,
            e_merge_small);
}

}  // namespace
}  // namespace hariko::test
