// Random scenes of 1 to 20 solids with the network of curves: closed, smooth, and honest about what it
// misses. The long version of 500 scenes is HARIKO_REPEAT_SCALE=62.5.

#include <Eigen/Geometry>
#include <iostream>

#include "core/analysis/continuity.hpp"
#include "tests/envelope/envelope_scenes.hpp"
#include "tests/envelope/network_invariants.hpp"

namespace hariko::test {

namespace {

struct Tally {
  int scenes = 0, enclosed = 0, folded = 0, crossing = 0;
};

void check_scene(const EnvelopeInput& input, Tally& tally) {
  const EnvelopeSurface made = envelope_of(input);
  ASSERT_TRUE(made.network && made.check);
  const ContinuityReport report = continuity(made.surface);
  if (made.folds == 0) {
    EXPECT_LE(report.largest_normal_jump.value() * degrees, 1e-4);
  }
  EXPECT_LE(report.largest_gap, 1e-12 * made.diagonal);
  EXPECT_TRUE(made.surface.boundary_sides().empty());
  EXPECT_EQ(warned(made, w_not_enclosed), !made.enclosed);
  EXPECT_EQ(warned(made, w_envelope_fold), made.folds > 0);
  EXPECT_EQ(warned(made, w_envelope_crossing), made.check->covered > 0);
  const CurveNetwork& network = *made.network;
  EXPECT_EQ(
      long(network.cage.vertices.size()) - long(network.curves.size()) + long(network.cage.faces.size()), 2);
  check_vertices(network, network_solids(input, made.origin));
  ++tally.scenes;
  tally.enclosed += made.enclosed;
  tally.folded += made.folds > 0;
  tally.crossing += made.check->covered > 0;
}

}  // namespace

TEST(EnvelopeRandomScenes, NetworksAreClosedSmoothAndHonest) {
  Tally tally;
  for_random(1, 8, [&](std::mt19937_64& rng) {
    EnvelopeInput input = random_scene(rng);
    input.settings.method = EnvelopeMethod::network;
    check_scene(input, tally);
  });
  std::cout << tally.scenes << " scenes, enclosed " << tally.enclosed << ", with folds " << tally.folded
            << ", into themselves " << tally.crossing << "\n";
}

}  // namespace hariko::test
