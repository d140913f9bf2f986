// Refinement that starts with cells as long as their curvature lets them be.

#include "core/approximation/refinement/cell_sizes.hpp"

#include "tests/approximation/checker.hpp"
#include "tests/approximation/meshes.hpp"
#include "tests/approximation/surfaces.hpp"

namespace hariko {
namespace {

using namespace test;

MeshOptions from_cells(MeshOptions options) {
  options.start = MeshStart::cells;
  return options;
}

struct StartCount {
  const char* surface;
  int facets;
};
void PrintTo(const StartCount& count, std::ostream* out) {
  *out << count.surface;
}

class StartCells : public ::testing::TestWithParam<StartCount> {};

TEST_P(StartCells, NeverNeedMoreFacetsThanWholePatches) {
  const auto& [name, facets] = GetParam();
  const Surface surface = golden_surface(name);
  const MeshApproximation whole = mesh_of(surface, by_distance(0.01));
  const MeshApproximation mesh = mesh_of(surface, from_cells(by_distance(0.01)));
  EXPECT_LE(mesh.mesh.triangles.size(), whole.mesh.triangles.size());
  EXPECT_NEAR(double(mesh.mesh.triangles.size()), facets, 0.03 * facets);
  EXPECT_TRUE(mesh.reached());
  EXPECT_TRUE(mesh.distance.certified);
  EXPECT_LE(mesh.distance.bound, 0.01);
  const MeshCheck check = check_mesh(surface, mesh.mesh, 80, 0.01);
  expect_sound(check, false);
  expect_close(check, 0.01);
}

TEST_P(StartCells, ScaleAndReversalKeepTheCount) {
  std::vector<BezierPatch> large, back;
  for (const BezierPatch& patch : golden_patches(GetParam().surface)) {
    large.push_back(scaled(patch, 1000));
    back.push_back(reversed(patch));
  }
  const double count = GetParam().facets;
  const Surface scaled_surface = weld_patches(Vector3::Zero(), large).value();
  EXPECT_NEAR(double(mesh_of(scaled_surface, from_cells(by_distance(10))).mesh.triangles.size()), count,
              0.03 * count);
  const Surface reversed_surface = weld_patches(Vector3::Zero(), back).value();
  const MeshApproximation mesh = mesh_of(reversed_surface, from_cells(by_distance(0.01)));
  EXPECT_NEAR(double(mesh.mesh.triangles.size()), count, 0.03 * count);
  expect_sound(check_mesh(reversed_surface, mesh.mesh, 30, 0.01), false);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, StartCells,
                         ::testing::Values(StartCount{"dome", 264}, StartCount{"saddle", 200},
                                           StartCount{"wave", 458}, StartCount{"quarterpipe", 18},
                                           StartCount{"fender", 515}, StartCount{"ridge", 332},
                                           StartCount{"quintic", 514}, StartCount{"pair", 780}));

TEST(StartMesh, AnglesHaveCellsToo) {
  const Surface pipe = golden_surface("quarterpipe");
  for (const bool fold : {false, true}) {
    SCOPED_TRACE(fold);
    MeshOptions options;
    (fold ? options.criteria.fold_angle : options.criteria.normal_angle) = 10 * degrees;
    const MeshApproximation whole = mesh_of(pipe, options), mesh = mesh_of(pipe, from_cells(options));
    EXPECT_TRUE(mesh.reached());
    EXPECT_LE(fold ? mesh.fold_angle.largest : mesh.normal_angle.largest, 10 * degrees);
    EXPECT_LT(mesh.mesh.triangles.size(), whole.mesh.triangles.size() / 4);
    // A quarter turn in cells of 20 degrees, or of 10, two facets each.
    EXPECT_LE(mesh.mesh.triangles.size(), fold ? 30U : 16U);
  }
}

TEST(StartMesh, ClosedSurfacesAndPolesStayWatertight) {
  for (const auto& patches : {rational_sphere(1), teapot_like()})
    for (const double tolerance : {0.05, 0.005}) {
      SCOPED_TRACE(tolerance);
      const Surface surface = weld_patches(Vector3::Zero(), patches).value();
      const MeshApproximation mesh = mesh_of(surface, from_cells(by_distance(tolerance)));
      EXPECT_TRUE(mesh.reached());
      const MeshCheck check = check_mesh(surface, mesh.mesh, 48, tolerance);
      expect_sound(check, true);
      expect_close(check, tolerance);
      EXPECT_LE(double(mesh.mesh.triangles.size()),
                1.05 * double(mesh_of(surface, by_distance(tolerance)).mesh.triangles.size()));
    }
}

TEST(StartMesh, NeighboursHaveTheSameCells) {
  // Beside a bent patch a flat one: it gets the cuts along their common side, and no others.
  BezierPatch bent = golden_patches("quarterpipe").front(), flat = bent;
  for (int j = 0; j <= bent.degree_t; ++j)
    for (int i = 0; i <= bent.degree_s; ++i) flat.points[bent.index(i, j)].y() -= 6;
  const Surface surface = weld_patches(Vector3::Zero(), {bent, flat}).value();
  ASSERT_EQ(surface.seams().size(), 1U);
  const SurfaceSampler sampler(surface);
  const ParameterMesh start = start_mesh(sampler, from_cells(by_distance(0.01)));
  EXPECT_EQ(start.facets.size(), 36U);
  const MeshApproximation mesh = mesh_of(surface, from_cells(by_distance(0.01)));
  EXPECT_EQ(mesh.mesh.triangles.size(), 36U);
  expect_sound(check_mesh(surface, mesh.mesh, 40, 0.01), false);
}

TEST(StartMesh, PatchesAreTheStartWhereNothingSpeaksForCells) {
  const Surface dome = golden_surface("dome");
  const SurfaceSampler sampler(dome);
  MeshOptions options;
  options.criteria.max_edge = 0.5;
  EXPECT_EQ(start_mesh(sampler, from_cells(options)).facets.size(), 2U);
  options.criteria.max_edge.reset();
  options.criteria.distance = 1e-4;
  EXPECT_EQ(start_mesh(sampler, options).facets.size(), 2U);
  options.facet_limit = 100;
  EXPECT_EQ(start_mesh(sampler, from_cells(options)).facets.size(), 2U)
      << "more cells than facets are allowed";
}

}  // namespace
}  // namespace hariko
