// Edits of solids: what they change, what they refuse, what is forgotten with a solid.

#include "core/document/edits/edit_solids.hpp"

#include <array>

#include "core/document/edits/edits.hpp"
#include "tests/support/must.hpp"

namespace hariko::test {

namespace {

struct Made {
  Document document;
  ObjectId id;
};

Made two_solids() {
  EnvelopeInput input;
  Solid box, ball;
  box.id = 3;
  ball.kind = SolidKind::sphere;
  ball.id = 8;
  ball.position = {1, 0, 0};
  input.solids = {box, ball};
  const auto added = add_object(Document{}, "Solids", SolidsSource{std::move(input), {}});
  return {added->document, added->id};
}

const EnvelopeInput& input_of(const Document& document, ObjectId id) {
  return *document.find(id)->solids()->input;
}

}  // namespace

TEST(EditSolids, ANewSolidGetsTheNextId) {
  const auto [document, id] = two_solids();
  Solid cone{.kind = SolidKind::cone};
  const auto added = must(add_solid(document, id, cone));
  ASSERT_EQ(input_of(*added, id).solids.size(), 3U);
  EXPECT_EQ(input_of(*added, id).solids.back().id, 9U);
  EXPECT_EQ(find_solid(*added->find(id), 9)->kind, SolidKind::cone);
  EXPECT_EQ(input_of(document, id).solids.size(), 2U);
}

TEST(EditSolids, OnlyTheNamedSolidsChange) {
  const auto [document, id] = two_solids();
  const std::array<std::uint32_t, 2> ids{8, 77};
  const auto moved = change_solids(document, id, ids, [](Solid& solid) { solid.position.z() += 2; });
  ASSERT_TRUE(moved.ok());
  EXPECT_EQ(find_solid(*moved->find(id), 8)->position, Vector3(1, 0, 2));
  EXPECT_EQ(*find_solid(*moved->find(id), 3), *find_solid(*document.find(id), 3));
  // Edits that change nothing share their object.
  const auto same = must(change_solids(document, id, ids, [](Solid&) {}));
  EXPECT_EQ(*same, document);
}

TEST(EditSolids, TheLastSolidCannotBeRemoved) {
  const auto [document, id] = two_solids();
  const std::array<std::uint32_t, 1> ids{3};
  const auto removed = must(remove_solids(document, id, ids));
  const EnvelopeInput& input = input_of(*removed, id);
  ASSERT_EQ(input.solids.size(), 1U);
  EXPECT_EQ(input.solids[0].id, 8U);
  const std::array<std::uint32_t, 1> last{8};
  EXPECT_EQ(remove_solids(*removed, id, last).error().code, e_last_solid);
}

TEST(EditSolids, BadValuesLocksAndOtherObjectsAreRefused) {
  const auto [document, id] = two_solids();
  const std::array<std::uint32_t, 1> ids{3};
  const auto flat = change_solids(document, id, ids, [](Solid& solid) { solid.size.z() = 0; });
  EXPECT_EQ(flat.error().code, e_solid_size);
  const auto wide = change_envelope(document, id, [](EnvelopeInput& input) { input.settings.roundness = 2; });
  EXPECT_EQ(wide.error().code, e_envelope_setting);
  const auto locked = set_locked(document, id, true);
  EXPECT_EQ(change_solids(*locked, id, ids, [](Solid& solid) { solid.position.x() = 5; }).error().code,
            e_locked);
  EXPECT_EQ(change_envelope(document, ObjectId{77}, [](EnvelopeInput&) {}).error().code, e_unknown_object);
}

TEST(EditSolids, ARowHasCopiesAtEqualDistances) {
  const auto [document, id] = two_solids();
  std::vector<std::uint32_t> added;
  const auto made = must(array_solids(document, id, std::array<std::uint32_t, 1>{8}, 3, {0, 2, 1}, added));
  const EnvelopeInput& input = input_of(*made, id);
  ASSERT_EQ(input.solids.size(), 5U);
  EXPECT_EQ(added, (std::vector<std::uint32_t>{9, 10, 11}));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(input.solids[2 + k].id, added[k]);
    EXPECT_EQ(input.solids[2 + k].kind, SolidKind::sphere);
    EXPECT_EQ(input.solids[2 + k].position, Vector3(1, 2 * double(k + 1), double(k + 1)));
  }
  EXPECT_EQ(array_solids(document, id, std::array<std::uint32_t, 2>{3, 8}, 150, Vector3::UnitX(), added)
                .error()
                .code,
            e_too_many_solids);
}

TEST(EditSolids, ACopiedBridgeJoinsTheCopies) {
  auto [document, id] = two_solids();
  Solid bar{.kind = SolidKind::capsule};
  bar.bridge = Bridge{{3, 8}, 0.5};
  document = add_solid(document, id, bar).value();
  std::vector<std::uint32_t> added;
  const auto all = array_solids(document, id, std::array<std::uint32_t, 3>{3, 8, 9}, 2, {0, 0, 5}, added);
  ASSERT_TRUE(all.ok());
  ASSERT_EQ(added, (std::vector<std::uint32_t>{10, 11, 12, 13, 14, 15}));
  EXPECT_EQ(find_solid(*all->find(id), 9)->bridge, (Bridge{{3, 8}, 0.5}));
  EXPECT_EQ(find_solid(*all->find(id), 12)->bridge, (Bridge{{10, 11}, 0.5}));
  EXPECT_EQ(find_solid(*all->find(id), 15)->bridge, (Bridge{{13, 14}, 0.5}));
  // A solid that is not copied is held by both bars.
  const auto some = must(array_solids(document, id, std::array<std::uint32_t, 2>{8, 9}, 1, {0, 0, 5}, added));
  EXPECT_EQ(find_solid(*some->find(id), 11)->bridge, (Bridge{{3, 10}, 0.5}));
  const auto flat = change_solids(document, id, std::array<std::uint32_t, 1>{9},
                                  [](Solid& s) { s.bridge->ball_radius = 0; });
  EXPECT_EQ(flat.error().code, e_solid_size);
}

}  // namespace hariko::test
