// Closed surfaces, poles, joints, rational patches and the samples.

#include "core/approximation/approximate.hpp"
#include "core/document/file.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "tests/approximation/checker.hpp"
#include "tests/approximation/meshes.hpp"
#include "tests/approximation/surfaces.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/places.hpp"

namespace hariko::test {
namespace {

std::ptrdiff_t euler(const TriangleMesh& mesh) {
  std::set<std::pair<Index, Index>> edges;
  std::set<Index> vertices;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
      vertices.insert(t[k]);
    }
  return std::ptrdiff_t(vertices.size()) - std::ptrdiff_t(edges.size()) +
         std::ptrdiff_t(mesh.triangles.size());
}

TEST(ClosedSurfaces, RationalSphereWithPoles) {
  const Surface surface = weld_patches(Vector3::Zero(), rational_sphere(1)).value();
  EXPECT_EQ(surface.seams().size(), 12U);
  for (const SplitRule rule : {SplitRule::midpoint, SplitRule::gauss}) {
    const MeshApproximation mesh = mesh_of(surface, by_distance(0.01, rule));
    EXPECT_TRUE(mesh.reached());
    EXPECT_TRUE(mesh.distance.certified);
    EXPECT_LE(mesh.distance.bound, 0.01);
    EXPECT_EQ(euler(mesh.mesh), 2);
    const MeshCheck check = check_mesh(surface, mesh.mesh, 24, 0.01);
    expect_sound(check, true);
    expect_close(check, 0.01);
    // A sphere's facets have the sagitta of their circumcircles: none can be larger than the tolerance
    // allows.
    double volume = 0;
    for (const auto& t : mesh.mesh.triangles) {
      const auto& p = mesh.mesh.positions;
      volume += p[t[0]].dot(p[t[1]].cross(p[t[2]])) / 6;
    }
    EXPECT_NEAR(std::abs(volume), 4.18879, 0.12);
    // Three times the least number for vertices on the surface, 2 / (3 sqrt 3) 4 pi / tolerance.
    EXPECT_LT(mesh.mesh.triangles.size(), 1450U);
  }
}

TEST(ClosedSurfaces, TeapotLikeBodyOfRevolution) {
  const Surface surface = weld_patches(Vector3::Zero(), teapot_like()).value();
  for (const double tolerance : {0.05, 0.005}) {
    const MeshApproximation mesh = mesh_of(surface, by_distance(tolerance));
    EXPECT_TRUE(mesh.reached());
    EXPECT_EQ(euler(mesh.mesh), 2);
    const MeshCheck check = check_mesh(surface, mesh.mesh, 48, tolerance);
    expect_sound(check, true);
    expect_close(check, tolerance);
  }
}

TEST(ClosedSurfaces, OnePatchThatClosesOnItself) {
  // A tube: side 1 and side 3 are the same line, so two facets would have two equal corners each.
  BezierPatch tube;
  tube.degree_s = 5;
  tube.degree_t = 1;
  for (const double z : {0.0, 2.0})
    for (const Vector2& p :
         {Vector2(1, 0), Vector2(1, 2), Vector2(-2, 2), Vector2(-2, -2), Vector2(1, -2), Vector2(1, 0)})
      tube.points.emplace_back(p.x(), p.y(), z);
  const Surface surface = weld_patches(Vector3::Zero(), {tube}).value();
  ASSERT_EQ(surface.seams().size(), 1U);
  const MeshApproximation mesh = mesh_of(surface, by_distance(0.01));
  EXPECT_TRUE(mesh.reached());
  EXPECT_EQ(euler(mesh.mesh), 0);
  const MeshCheck check = check_mesh(surface, mesh.mesh, 150, 0.01);
  expect_sound(check, false);
  expect_close(check, 0.01);
}

TEST(ClosedSurfaces, AnalyticTorusIsSampledAndNotCertified) {
  const Surface surface = torus(3, 1, 4, 4);
  const MeshApproximation mesh = mesh_of(surface, by_distance(0.03));
  EXPECT_TRUE(mesh.distance.measured);
  EXPECT_FALSE(mesh.distance.certified);
  EXPECT_EQ(euler(mesh.mesh), 0);
  const MeshCheck check = check_mesh(surface, mesh.mesh, 20, 0.03);
  expect_sound(check, true);
  expect_close(check, 0.03);
}

TEST(TouchingSurfaces, SidesThatMeetAtAT) {
  // One long patch against two short ones, whose common corner lies at 0.37 of the long side.
  const auto strip = [](double x0, double x1, double y0, double y1) {
    BezierPatch patch;
    const auto height = [](double x, double y) { return 0.3 * x * x - 0.1 * x * x * x + 0.2 * y * y; };
    // Degree three in both directions holds the height exactly: interpolation at four points a side.
    Eigen::Matrix4d basis;
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k) {
        const double x = i / 3.0;
        basis(i, k) = (k == 1 || k == 2 ? 3.0 : 1.0) * std::pow(x, k) * std::pow(1 - x, 3 - k);
      }
    const Eigen::Matrix4d inverse = basis.inverse();
    Eigen::Matrix4d values;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) values(i, j) = height(x0 + i / 3.0 * (x1 - x0), y0 + j / 3.0 * (y1 - y0));
    const Eigen::Matrix4d control = inverse * values * inverse.transpose();
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i)
        patch.points.emplace_back(x0 + i / 3.0 * (x1 - x0), y0 + j / 3.0 * (y1 - y0), control(i, j));
    return patch;
  };
  std::vector<BezierPatch> patches = {strip(0, 4, 0, 2), strip(0, 1.48, 2, 4), strip(1.48, 4, 2, 4)};
  for (const bool turned : {false, true}) {
    if (turned) patches[1] = flipped(patches[1]);
    const Surface surface = weld_patches(Vector3::Zero(), patches).value();
    ASSERT_EQ(surface.seams().size(), 3U);
    for (const MeshStart start : {MeshStart::patches, MeshStart::cells}) {
      MeshOptions options = by_distance(0.002);
      options.start = start;
      const MeshApproximation mesh = mesh_of(surface, options);
      EXPECT_TRUE(mesh.reached());
      const MeshCheck check = check_mesh(surface, mesh.mesh, 150, 0.002);
      expect_sound(check, false);
      expect_close(check, 0.002);
      EXPECT_EQ(euler(mesh.mesh), 1);
      // One outside: all facets look up, or all down.
      for (const auto& t : mesh.mesh.triangles) {
        const auto& p = mesh.mesh.positions;
        EXPECT_GT((p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).z(), 0);
      }
    }
  }
}

TEST(TouchingSurfaces, CreasesDoNotCountAsFolds) {
  BezierPatch floor, wall;
  floor.degree_s = floor.degree_t = wall.degree_s = wall.degree_t = 1;
  floor.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  wall.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}};
  const Surface surface = weld_patches(Vector3::Zero(), {floor, wall}).value();
  ASSERT_EQ(surface.seams().size(), 1U);
  EXPECT_EQ(surface.seams()[0].intended, Continuity::g0);
  MeshOptions options;
  options.criteria.fold_angle = 0.05;
  const MeshApproximation mesh = mesh_of(surface, options);
  EXPECT_TRUE(mesh.reached());
  EXPECT_EQ(mesh.mesh.triangles.size(), 4U);
  EXPECT_EQ(mesh.mesh.positions.size(), 6U);
  EXPECT_EQ(mesh.mesh.normals.size(), 8U) << "normals are split at the crease";
}

/// A smooth patch over a square, of any degree, now and then rational. Sideways so little that it has a
/// normal everywhere: no mesh looks the same way as one that has not.
BezierPatch smooth_patch(std::mt19937_64& rng) {
  BezierPatch patch;
  patch.degree_s = uniform_int(rng, 1, 5);
  patch.degree_t = uniform_int(rng, 1, 5);
  const bool rational = chance(rng, 0.5);
  const double sideways = 0.2 * 3.0 / std::max(patch.degree_s, patch.degree_t);
  for (int j = 0; j <= patch.degree_t; ++j)
    for (int i = 0; i <= patch.degree_s; ++i) {
      patch.points.push_back(Vector3(3.0 * i / patch.degree_s, 3.0 * j / patch.degree_t, 0) +
                             random_vector(rng).cwiseProduct(Vector3(sideways, sideways, 0.5)));
      if (rational) patch.weights.push_back(log_uniform(rng, 0.5, 2));
    }
  return patch;
}

TEST(RandomSurfaces, RandomTolerancesOnRandomPatches) {
  for_random(4100, 12, [](std::mt19937_64& rng) {
    const Surface surface = weld_patches(Vector3::Zero(), {smooth_patch(rng)}).value();
    const double tolerance = log_uniform(rng, 0.003, 0.3);
    const SplitRule rule = SplitRule(uniform_int(rng, 0, 2));
    MeshOptions options = by_distance(tolerance, rule);
    options.start = MeshStart(uniform_int(rng, 0, 1));
    const MeshApproximation mesh = mesh_of(surface, options);
    EXPECT_TRUE(mesh.reached());
    EXPECT_TRUE(mesh.distance.certified);
    EXPECT_LE(mesh.distance.bound, tolerance);
    MeshCheck check = check_mesh(surface, mesh.mesh, 40, tolerance);
    // The paper's rule makes needles where curvature vanishes along a border (approximation.md).
    if (rule == SplitRule::halving) check.degenerate = 0;
    expect_sound(check, false);
    EXPECT_LE(check.surface_to_mesh, tolerance);
  });
}

/// The paper's rule makes needles on these: longest edges cut in their middle end that.
TEST(RandomSurfaces, TheRuleOfThePaperEndsOnNeedles) {
  for (const std::uint64_t seed : {2230638326U, 2230638342U}) {
    std::mt19937_64 rng(seed);
    const Surface surface = weld_patches(Vector3::Zero(), {smooth_patch(rng)}).value();
    const double tolerance = log_uniform(rng, 0.003, 0.3);
    MeshOptions options = by_distance(tolerance, SplitRule::halving);
    options.facet_limit = 1000;
    const MeshApproximation mesh = mesh_of(surface, options);
    EXPECT_TRUE(mesh.reached()) << seed;
    EXPECT_LE(mesh.distance.bound, tolerance) << seed;
    MeshCheck check = check_mesh(surface, mesh.mesh, 40, tolerance);
    check.degenerate = 0;
    expect_sound(check, false);
  }
}

class Samples : public ::testing::TestWithParam<const char*> {};

TEST_P(Samples, EverySurfaceOfTheSample) {
  const auto document = load_document(test::source_folder() + "/assets/samples/" + GetParam() + ".hariko");
  ASSERT_TRUE(document.ok());
  for (const auto& object : document->objects) {
    const auto built = object_surface(*document, *object);
    if (!built.ok()) continue;
    const Surface& surface = built->surface;
    double size = 0;
    for (Index p = 0; p < surface.patch_count(); ++p)
      size = std::max(size, surface.patches().evaluate(p, {0.3, 0.3}, Order::first).position.norm());
    const double tolerance = 0.004 * size;
    const MeshApproximation mesh = mesh_of(surface, by_distance(tolerance));
    EXPECT_TRUE(mesh.reached());
    const bool closed = surface.boundary_sides().empty();
    const MeshCheck check = check_mesh(surface, mesh.mesh, surface.patch_count() > 200 ? 10 : 28, tolerance);
    expect_sound(check, closed);
    expect_close(check, tolerance);
    // Mode G2 has no certain bound; every other mode has.
    const auto* source = object->polyhedron();
    EXPECT_EQ(mesh.distance.certified, !(source && source->mode == Mode::g2));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Samples,
                         ::testing::Values("car", "concave", "concave_split", "cube", "cube_crease", "fig2",
                                           "fig2_open", "fig5c", "fig5d", "genus3", "grid3", "knot", "torus",
                                           "wheel_arch"));

}  // namespace
}  // namespace hariko::test
