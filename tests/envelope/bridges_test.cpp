// Bridges: what the designer drags when a waist changes.

#include "core/envelope/network_bridges.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

TEST(EnvelopeBridges, MiddlesGoTheWayThatIsTold) {
  for (const char* name : {"two_apart", "four", "four_boxes"}) {
    SCOPED_TRACE(name);
    EnvelopeInput input = golden_scene(name);
    input.settings.tightness = 0;
    EnvelopeSurfacer surfacer;
    const auto before = surfacer.rebuild(input);
    ASSERT_TRUE(before.ok());
    ASSERT_FALSE(before->bridges.empty());
    constexpr double step = 1e-3;
    for (std::size_t i = 0; i < before->bridges.size(); i += 5) {
      const EnvelopeBridge& bridge = before->bridges[i];
      EXPECT_LT(bridge.solids.low, bridge.solids.high);
      EXPECT_NEAR(bridge.outward.norm(), 1, 1e-12);
      // The same network with another factor: the search for enclosure is left out.
      std::vector<PlacedSolid> solids = place_solids(input);
      for (PlacedSolid& solid : solids) solid.centre -= before->origin;
      std::map<std::pair<Index, Index>, double> cuts;
      for (Index a = 0; a < solids.size(); ++a)
        for (Index b = a + 1; b < solids.size(); ++b)
          if (SolidPair::of(solids[a].id, solids[b].id) == bridge.solids) cuts[{a, b}] = 1;
      CurveSettings settings;
      settings.solids = solids;
      settings.waist = input.settings.waist;
      settings.cuts = &cuts;
      const auto middles = [&](double factor) {
        for (auto& [pair, cut] : cuts) cut = factor;
        FlatMap<SolidPair, double> waists;
        waists.set(bridge.solids, factor);
        return bridges_of(curve_network(before->network->cage, settings), solids, waists);
      };
      const auto from = middles(1), to = middles(1 + step);
      ASSERT_EQ(from.size(), before->bridges.size());
      const Vector3 told = step * from[i].way, gone = to[i].middle - from[i].middle;
      EXPECT_LE((told - gone).norm(), 1e-9 * before->diagonal);
      EXPECT_LE((from[i].way - to[i].way).norm(), 1e-9 * before->diagonal);
    }
  }
}

TEST(EnvelopeBridges, ImagesShareTheWaistOfTheirSolids) {
  EnvelopeInput input = golden_scene("two_apart");
  input.settings.symmetry = SymmetryPlane::z;
  for (Solid& solid : input.solids) solid.position.z() += 3;
  const auto before = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(before.ok());
  bool to_image = false;
  for (const EnvelopeBridge& bridge : before->bridges)
    to_image = to_image || bridge.solids.low == bridge.solids.high;
  EXPECT_TRUE(to_image) << "a solid and its image have a bridge, too";
  input.settings.waists.set(SolidPair::of(input.solids[0].id, input.solids[1].id), 0.5);
  const auto after = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(after.ok());
  EXPECT_TRUE(after->symmetric);
}

}  // namespace hariko::test
