// Random scenes of 1 to 20 solids: closed, smooth, and honest about enclosure, folds and tightness. The long
// version of 500 scenes is HARIKO_REPEAT_SCALE=62.5 (500 for tight surfaces, which take some seconds each).

#include <Eigen/Geometry>
#include <iostream>

#include "core/analysis/continuity.hpp"
#include "core/approximation/surface_foot.hpp"
#include "core/envelope/field_envelope.hpp"
#include "tests/envelope/envelope_scenes.hpp"
#include "tests/envelope/network_invariants.hpp"

namespace hariko::test {

namespace {

constexpr double enclosure_tolerance = 1e-4;  ///< of the diagonal

struct Tally {
  int scenes = 0, enclosed = 0, folded = 0, crossing = 0;
  int missed = 0;  ///< enclosed as reported, but not by finer triangles and other points
  std::map<std::pair<std::string, int>, int> levels;  ///< route and level of its ladder
  double deepest_reported = 0, deepest = 0;           ///< of the diagonal
};

/// Relative to the surface's origin.
std::vector<PlacedSolid> placed_for(const EnvelopeSurface& made, const EnvelopeInput& input) {
  std::vector<PlacedSolid> solids = place_solids(input);
  for (PlacedSolid& solid : solids) {
    solid.centre -= made.origin;
    for (Vector3& p : solid.test_points) p -= made.origin;
  }
  return solids;
}

/// How far the solids reach out: by finer triangles and other points than those of the surfacer's own check,
/// each measured to the surface itself.
double finer_miss(const EnvelopeSurface& made, std::span<const PlacedSolid> solids) {
  const EnclosureReport found =
      check_enclosure(made.surface, solids, {20, 1333, 0.0007 * made.diagonal, false}, 0);
  if (!(found.worst > enclosure_tolerance * made.diagonal)) return found.worst;
  const SurfaceSampler sampler(made.surface);
  const SurfaceFeet feet(sampler);
  double worst = 0;
  for (const OutsidePoint& outside : found.points) {
    // What the triangles say is too much by the height of the arcs over them, where the surface bulges.
    const SurfaceFoot foot = feet.foot(outside.point);
    const double height =
        (outside.point - foot.position).dot(made.surface.normal(foot.patch, foot.parameter));
    if (height > 0) worst = std::max(worst, foot.distance);
  }
  return worst;
}

void check_scene(const EnvelopeInput& input, Tally& tally) {
  const auto made = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  const ContinuityReport report = continuity(made->surface);
  if (made->folds == 0) {
    EXPECT_LE(report.largest_normal_jump.value() * degrees, 1e-4);
  }
  EXPECT_LE(report.largest_gap, 1e-12 * made->diagonal);
  EXPECT_TRUE(made->surface.boundary_sides().empty());
  ASSERT_TRUE(made->check);
  const std::vector<PlacedSolid> solids = placed_for(*made, input);
  const double miss = finer_miss(*made, solids);
  EXPECT_EQ(made->enclosed, made->check->worst <= enclosure_tolerance * made->diagonal);
  // Between the points of the surfacer's check more than its tolerance is possible; not much more.
  if (made->enclosed) {
    EXPECT_LE(miss, 2 * enclosure_tolerance * made->diagonal);
  }
  EXPECT_EQ(warned(*made, w_not_enclosed), !made->enclosed);
  EXPECT_EQ(warned(*made, w_envelope_fold), made->folds > 0);
  EXPECT_EQ(warned(*made, w_envelope_crossing), made->check->covered > 0);
  EXPECT_EQ(warned(*made, w_tightness_reduced), made->level == 9);
  EXPECT_EQ(warned(*made, w_tightness_loose), made->route == EnvelopeRoute::field && made->level >= 6);
  if (made->network) {
    const CurveNetwork& network = *made->network;
    EXPECT_EQ(
        long(network.cage.vertices.size()) - long(network.curves.size()) + long(network.cage.faces.size()),
        2);
    EXPECT_GT(network.least_weight(), 0.5);
    check_vertices(network, solids);
  } else {
    const HalfEdgeMesh& mesh = made->cage->topology();
    EXPECT_EQ(long(mesh.vertex_count()) - long(mesh.edge_count()) + long(mesh.face_count()),
              2 * (made->components - made->tunnels));
  }
  ++tally.scenes;
  tally.enclosed += made->enclosed;
  tally.folded += made->folds > 0;
  tally.crossing += made->check->covered > 0;
  const char* const routes[] = {"hull", "valleys", "field"};
  ++tally.levels[{routes[std::size_t(made->route)], made->level}];
  tally.deepest_reported = std::max(tally.deepest_reported, made->check->worst / made->diagonal);
  tally.missed += made->enclosed && miss > enclosure_tolerance * made->diagonal;
  tally.deepest = std::max(tally.deepest, miss / made->diagonal);
}

void print(const char* name, const Tally& tally) {
  std::cout << name << ": " << tally.scenes << " scenes, enclosed " << tally.enclosed << ", with folds "
            << tally.folded << ", into themselves " << tally.crossing << ", deepest point outside "
            << tally.deepest_reported << " of the diagonal as reported, " << tally.deepest
            << " by finer triangles, which find " << tally.missed
            << " of those reported as enclosed above the tolerance\n";
  for (const auto& [place, count] : tally.levels)
    std::cout << "  " << place.first << ", level " << place.second << ": " << count << "\n";
}

}  // namespace

TEST(EnvelopeRandomScenes, HullsAreClosedSmoothAndHonest) {
  Tally tally;
  for_random(1, 8, [&](std::mt19937_64& rng) { check_scene(random_scene(rng), tally); });
  print("hull", tally);
  // Folds are rare (2 of 80 scenes with HARIKO_SEED=2833383932, 1 of them not enclosed), and never silent.
  EXPECT_LE(tally.folded, 1 + tally.scenes / 20);
  EXPECT_GE(tally.enclosed, tally.scenes - 1 - tally.scenes / 20);
}

TEST(EnvelopeRandomScenes, WhereEveryHullFoldsSolidsBeginLarger) {
  std::vector<std::uint64_t> seeds = {2611241146, 2611241189};
  if (repetitions(1) > 1) seeds.insert(seeds.end(), {2611241174, 2611241178, 2611241184, 2611241190});
  for (const std::uint64_t seed : seeds) {
    std::mt19937_64 rng(seed);
    const EnvelopeSurface made = envelope_of(random_scene(rng));
    EXPECT_EQ(made.folds, 0U) << seed;
    EXPECT_TRUE(made.enclosed) << seed;
  }
}

TEST(EnvelopeRandomScenes, CylindersBetweenTheSurfacesSamplesStayInside) {
  // One reached out by 1.6e-4 of the diagonal between all points that were looked at.
  std::mt19937_64 rng(2611241155);
  const EnvelopeInput input = random_scene(rng);
  const EnvelopeSurface made = envelope_of(input);
  EXPECT_TRUE(made.enclosed);
  EXPECT_LE(finer_miss(made, placed_for(made, input)), enclosure_tolerance * made.diagonal);
}

TEST(EnvelopeRandomScenes, TightSurfacesAreClosedSmoothAndHonest) {
  // Cages of crowded scenes take some seconds.
  const bool is_long = repetitions(1) > 1;
  Tally tally;
  for_random(6, 1, [&](std::mt19937_64& rng) {
    EnvelopeInput input = random_scene(rng);
    if (!is_long && input.solids.size() > 3) input.solids.resize(3);
    input.settings.tightness = 1;
    check_scene(input, tally);
  });
  print("tight", tally);
}

}  // namespace hariko::test
