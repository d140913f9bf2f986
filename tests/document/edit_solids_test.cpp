// Edits of solids: what they change, what they refuse, what is forgotten with a solid.

#include "core/document/edit_solids.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "core/document/edits.hpp"

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
  input.settings.waists.set(SolidPair::of(3, 8), 0.5);
  input.settings.offsets.set({3, 1}, Vector3::UnitX());
  input.settings.fullness.set(NetworkEdgeKey::of({3, 1}, {8, 0}), 2);
  const auto added = add_object(Document{}, "Solids", SolidsSource{std::move(input), {}});
  return {added->document, added->id};
}

const EnvelopeInput& input_of(const Document& document, ObjectId id) {
  return *document.find(id)->solids()->input;
}

}  // namespace

TEST(EditSolids, ANewSolidGetsTheNextId) {
  const auto [document, id] = two_solids();
  Solid cone;
  cone.kind = SolidKind::cone;
  const auto added = add_solid(document, id, cone);
  ASSERT_TRUE(added.ok());
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
  // What changes nothing shares its object.
  const auto same = change_solids(document, id, ids, [](Solid&) {});
  ASSERT_TRUE(same.ok());
  EXPECT_EQ(*same, document);
}

TEST(EditSolids, SettingsThatNameARemovedSolidGoWithIt) {
  const auto [document, id] = two_solids();
  const auto pulled = change_network_vertex(document, id, {3, 12345, 8}, Vector3::UnitX());
  ASSERT_TRUE(pulled.ok());
  const std::array<std::uint32_t, 1> ids{3};
  const auto removed = remove_solids(*pulled, id, ids);
  ASSERT_TRUE(removed.ok());
  const EnvelopeInput& input = input_of(*removed, id);
  ASSERT_EQ(input.solids.size(), 1U);
  EXPECT_EQ(input.solids[0].id, 8U);
  EXPECT_TRUE(input.settings.waists.empty());
  EXPECT_TRUE(input.settings.offsets.empty());
  EXPECT_TRUE(input.settings.fullness.empty());
  const std::array<std::uint32_t, 1> last{8};
  EXPECT_EQ(remove_solids(*removed, id, last).error().code, e_last_solid);
}

TEST(EditSolids, WaistsOfBridgesAreSetAndForgotten) {
  const auto [document, id] = two_solids();
  const auto taut = change_waist(document, id, SolidPair::of(8, 3), 0.2);
  ASSERT_TRUE(taut.ok());
  EXPECT_EQ(input_of(*taut, id).settings.waists.get_or(SolidPair::of(3, 8), 1), 0.2);
  const auto usual = change_waist(*taut, id, SolidPair::of(3, 8), 1);
  ASSERT_TRUE(usual.ok());
  EXPECT_TRUE(input_of(*usual, id).settings.waists.empty());
  EXPECT_EQ(change_waist(document, id, SolidPair::of(3, 8), 2.5).error().code, e_envelope_setting);
}

TEST(EditSolids, BadValuesLocksAndOtherObjectsAreRefused) {
  const auto [document, id] = two_solids();
  const std::array<std::uint32_t, 1> ids{3};
  const auto flat = change_solids(document, id, ids, [](Solid& solid) { solid.size.z() = 0; });
  EXPECT_EQ(flat.error().code, e_solid_size);
  const auto wide = change_envelope(document, id, [](EnvelopeInput& input) { input.settings.waist = 2; });
  EXPECT_EQ(wide.error().code, e_envelope_setting);
  const auto locked = set_locked(document, id, true);
  EXPECT_EQ(change_solids(*locked, id, ids, [](Solid& solid) { solid.position.x() = 5; }).error().code,
            e_locked);
  EXPECT_EQ(change_envelope(document, ObjectId{77}, [](EnvelopeInput&) {}).error().code, e_unknown_object);
}

TEST(EditSolids, ARowHasCopiesAtEqualDistances) {
  const auto [document, id] = two_solids();
  std::vector<std::uint32_t> added;
  const auto made = array_solids(document, id, std::array<std::uint32_t, 1>{8}, 3, {0, 2, 1}, added);
  ASSERT_TRUE(made.ok());
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

TEST(EditSolids, VerticesAndCurvesArePulledAndPutBack) {
  const auto [document, id] = two_solids();
  const NetworkVertexKey vertex{8, 2};
  const NetworkEdgeKey curve = NetworkEdgeKey::of({8, 2}, {8, 1});
  const auto moved = change_network_vertex(document, id, vertex, {0, 0.5, -1});
  ASSERT_TRUE(moved.ok());
  const auto fuller = change_network_curve(*moved, id, curve, 1.5);
  ASSERT_TRUE(fuller.ok());
  const EnvelopeSettings& settings = input_of(*fuller, id).settings;
  EXPECT_EQ(settings.offsets.size(), 2U);
  EXPECT_EQ(settings.offsets.get_or(vertex, Vector3::Zero()), Vector3(0, 0.5, -1));
  EXPECT_EQ(settings.fullness.size(), 2U);
  EXPECT_EQ(settings.fullness.get_or(curve, 1.0), 1.5);
  // What is as the solids have it is not kept.
  const auto back = change_network_vertex(*fuller, id, vertex, Vector3::Zero());
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(input_of(*back, id).settings.offsets.size(), 1U);
  const auto usual = change_network_curve(*back, id, curve, 1);
  ASSERT_TRUE(usual.ok());
  EXPECT_EQ(input_of(*usual, id).settings, input_of(document, id).settings);
  const auto reset = reset_network(*fuller, id);
  ASSERT_TRUE(reset.ok());
  EXPECT_TRUE(input_of(*reset, id).settings.offsets.empty());
  EXPECT_TRUE(input_of(*reset, id).settings.fullness.empty());
  EXPECT_EQ(input_of(*reset, id).settings.waists.size(), 1U);
  EXPECT_FALSE(change_network_curve(document, id, curve, 4).ok()) << "fuller than a curve may be";
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(change_network_vertex(document, id, vertex, {infinite, 0, 0}).ok());
}

}  // namespace hariko::test
