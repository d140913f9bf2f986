// Cages from distances: holes, separate parts, concave arrangements.

#include <Eigen/Geometry>

#include "core/analysis/continuity.hpp"
#include "core/analysis/measures.hpp"
#include "core/envelope/contour.hpp"
#include "core/envelope/field_envelope.hpp"
#include "core/envelope/network_cage.hpp"
#include "core/envelope/scene_symmetry.hpp"
#include "core/surface/tessellation.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

namespace {

struct ExpectedField {
  const char* name;
  int level;
  Index vertices, faces;
  int tunnels;
};

void check_cage(const EnvelopeSurface& made) {
  ASSERT_TRUE(made.cage);
  const HalfEdgeMesh& mesh = made.cage->topology();
  EXPECT_EQ(mesh.border_loop_count(), 0U);
  EXPECT_EQ(long(mesh.vertex_count()) - long(mesh.edge_count()) + long(mesh.face_count()),
            2 * (made.components - made.tunnels));
  const ContinuityReport report = continuity(made.surface);
  EXPECT_LE(report.largest_normal_jump.value(), 1e-10);
  EXPECT_LE(report.largest_gap, 1e-13 * made.diagonal);
  EXPECT_EQ(made.folds, 0U);
  ASSERT_TRUE(made.check);
  EXPECT_LE(made.check->worst, 1e-4 * made.diagonal);
  EXPECT_TRUE(made.enclosed);
}

}  // namespace

TEST(FieldCage, ConcaveArrangementsAndHolesHaveTheMeasuredCages) {
  for (const ExpectedField& expected : {ExpectedField{"ell_tight", 0, 24, 22, 0},
                                        {"tee", 0, 38, 36, 0},
                                        {"car", 0, 54, 52, 0},
                                        {"dryer", 0, 92, 90, 0},
                                        {"camera", 0, 126, 124, 0},
                                        {"ring6", 0, 100, 100, 1}}) {
    SCOPED_TRACE(expected.name);
    EnvelopeInput input = golden_scene(expected.name);
    input.settings.method = EnvelopeMethod::field;
    const auto made = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(made.ok()) << to_string(made.error());
    check_cage(*made);
    EXPECT_EQ(made->route, EnvelopeRoute::field);
    EXPECT_EQ(made->level, expected.level);
    EXPECT_EQ(made->cage->vertex_count(), expected.vertices);
    EXPECT_EQ(made->cage->face_count(), expected.faces);
    EXPECT_EQ(made->components, 1);
    EXPECT_EQ(made->tunnels, expected.tunnels);
    EXPECT_TRUE(made->warnings.empty());
  }
}

TEST(FieldCage, TheTopologyIsThatOfTheMesh) {
  FlagGrid grid;
  for (auto& planes : grid.planes) planes = {0, 1, 2, 3};
  // Two nodes across the middle of a face, then beside each other.
  for (const bool beside : {false, true}) {
    grid.inside.assign(64, 0);
    grid.inside[grid.index(1, 1, 1)] = grid.inside[grid.index(2, beside ? 1 : 2, 1)] = 1;
    const GridTopology found = topology_of(contour(grid, [](const Vector3&) { return false; }));
    EXPECT_EQ(found.components, beside ? 1 : 2);
    EXPECT_EQ(found.tunnels, 0);
  }
  // A ring of eight nodes.
  for (auto& planes : grid.planes) planes = {0, 1, 2, 3, 4};
  grid.inside.assign(125, 0);
  for (int i = 1; i <= 3; ++i)
    for (int j = 1; j <= 3; ++j) grid.inside[grid.index(i, j, 2)] = i != 2 || j != 2;
  const GridTopology ring = topology_of(contour(grid, [](const Vector3&) { return false; }));
  EXPECT_EQ(ring.components, 1);
  EXPECT_EQ(ring.tunnels, 1);
}

TEST(FieldCage, SolidsFarApartGetPartsOfTheirOwn) {
  EnvelopeInput input = golden_scene("two_apart");
  input.solids[1].position.x() = 4;
  input.settings.tightness = 1;
  const auto made = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->components, 2);
  check_cage(*made);
}

TEST(FieldCage, ItIsCloserToTheSolidsThanTheirHull) {
  EnvelopeInput input = golden_scene("ell_tight");
  input.settings.method = EnvelopeMethod::field;
  const auto tight = EnvelopeSurfacer().rebuild(input);
  input.settings.tightness = 0;
  input.settings.method = EnvelopeMethod::network;
  const auto hull = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(tight.ok() && hull.ok());
  EXPECT_TRUE(hull->network);
  EXPECT_LT(*measure(tight->surface).volume, 0.75 * *measure(hull->surface).volume);
}

TEST(FieldLadder, CrowdsEndInASurfaceThatContainsThem) {
  // Of all of these the closest surface folds or leaves tips of solids outside.
  std::vector<std::uint64_t> seeds{8, 20264172};
  // Edges reached out between points of the check, or the surface ran into itself, in those with long names.
  if (repetitions(1) > 1) seeds = {1, 2, 4, 7, 8, 10, 20264172, 20267129, 20267155, 20267169};
  for (const std::uint64_t seed : seeds) {
    SCOPED_TRACE(seed);
    std::mt19937_64 rng(seed);
    EnvelopeInput input = random_scene(rng);
    input.settings.tightness = 1;
    const auto made = EnvelopeSurfacer().rebuild(input);
    ASSERT_TRUE(made.ok()) << to_string(made.error());
    EXPECT_EQ(made->route, EnvelopeRoute::field);
    check_cage(*made);
    // Nor do other points of the solids, and finer triangles, show what the surfacer's own check has missed.
    const EnvelopedScene scene = enveloped_scene(input);
    const EnclosureEffort finer{20, 1333, 0.0007 * made->diagonal, true};
    const EnclosureReport found = check_enclosure(made->surface, scene.placed, finer, 0);
    EXPECT_LE(found.worst, 1.5e-4 * made->diagonal);
    EXPECT_EQ(found.covered, 0U);
  }
}

TEST(FieldLadder, TheLastLevelsKeepAwayFromTheSolids) {
  for (const char* name : {"tee", "ring6"}) {
    const EnvelopedScene scene = enveloped_scene(golden_scene(name));
    const double diagonal = scene_diagonal(scene.placed);
    double before = 0;
    for (int level = 6; level <= 8; ++level) {
      SCOPED_TRACE(std::string(name) + ", level " + std::to_string(level));
      // While dragging the surface stays on its level.
      const auto base = field_base(scene.input, scene.placed, scene.origin, Quality::drag, {level});
      ASSERT_TRUE(base.ok()) << to_string(base.error());
      const FieldEnvelope* made = &base->envelope;
      EXPECT_EQ(made->level, level);
      EXPECT_GT(made->distance, before);
      before = made->distance;
      for (Index v = 0; v < made->surface.cage.vertex_count(); ++v)
        for (const Solid& solid : scene.input.solids)
          EXPECT_GE(SolidDistance(solid, 0, scene.origin)(made->surface.cage.position(v)),
                    0.95 * made->distance * diagonal);
    }
  }
}

TEST(FieldCage, TheFairSurfaceOverTheHullsPolygonsContainsTheSolids) {
  EnvelopeInput input = golden_scene("two_apart");
  input.settings.patches = EnvelopePatches::fair;
  const auto made = EnvelopeSurfacer().rebuild(input);
  ASSERT_TRUE(made.ok());
  EXPECT_TRUE(made->network);
  check_cage(*made);
}

TEST(FieldCage, TheFairSurfaceOverUnevenPolygonsDoesNotFold) {
  // Over the base of the cone it bends by more than a right angle, which is no fold; over the usual hulls of
  // the others it does fold.
  for (const char* name : {"cone", "camera", "dryer", "four_boxes"}) {
    SCOPED_TRACE(name);
    EnvelopeInput input = golden_scene(name);
    input.settings.tightness = 0;
    input.settings.patches = EnvelopePatches::fair;
    const EnvelopeSurface made = envelope_of(input);
    EXPECT_EQ(made.folds, 0U);
    EXPECT_TRUE(made.enclosed);
    EXPECT_FALSE(warned(made, w_envelope_fold));
    check_cage(made);
    // Facets of the surface's own mesh look where the surface does.
    const TriangleMesh mesh = tessellate(made.surface, 12);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const Vector3 facet =
          (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
      for (const Index n : mesh.normal_triangles[t]) EXPECT_GT(facet.dot(mesh.normals[n]), 0);
    }
  }
}

}  // namespace hariko::test
