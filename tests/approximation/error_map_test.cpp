// Error maps against distances and angles found by brute force.

#include "core/approximation/error_map.hpp"

#include <sstream>

#include "core/approximation/approximate.hpp"
#include "core/approximation/surface_projector.hpp"
#include "core/base/parallel.hpp"
#include "tests/approximation/checker.hpp"
#include "tests/approximation/meshes.hpp"
#include "tests/approximation/surfaces.hpp"

namespace hariko::test {
namespace {

MeshApproximation mesh_with_errors(const Surface& surface, const MeshCriteria& criteria) {
  MeshOptions options;
  options.criteria = criteria;
  options.report = MeshReport::all;
  return approximate(surface, options).value();
}

double nearest_by_force(const TriangleMesh& mesh, const Vector3& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles)
    best =
        std::min(best, check_distance(p, mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]));
  return best;
}

Vector3 normal_of(const TriangleMesh& mesh, Index f) {
  const auto& t = mesh.triangles[f];
  const auto& p = mesh.positions;
  return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).normalized();
}

TEST(TriangleTree, NearestIsThatOfAllTriangles) {
  for_random(51, 20, [](std::mt19937_64& rng) {
    TriangleMesh mesh;
    const int count = uniform_int(rng, 1, 60);
    for (int k = 0; k < 3 * count; ++k) mesh.positions.push_back(random_vector(rng));
    for (Index k = 0; k < Index(count); ++k) mesh.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    // A needle and a point among them.
    mesh.triangles[0] = {0, 1, 1};
    if (count > 1) mesh.triangles[1] = {3, 3, 3};
    const TriangleTree tree(mesh.positions, mesh.triangles);
    for (int k = 0; k < 50; ++k) {
      const Vector3 p = random_vector(rng, 2);
      const auto found = tree.nearest(p);
      const double truth = nearest_by_force(mesh, p);
      ASSERT_NEAR(found.distance, truth, 1e-9);
      EXPECT_NEAR(tree.triangle(found.triangle).distance(p), found.distance, 1e-12);
      EXPECT_EQ(tree.nearest(p, truth * 0.99).triangle, no_index);
    }
  });
}

TEST(SurfaceProjector, AreNearerThanAnySample) {
  for (const char* name : {"wave", "fender", "pair", "quintic"}) {
    SCOPED_TRACE(name);
    const Surface surface = golden_surface(name);
    const SurfaceSampler sampler(surface);
    const SurfaceProjector feet(sampler, 4000);
    const DenseSurface dense(surface, 200);
    const TriangleGrid grid(dense.points, dense.triangles);
    for_random(52, 40, [&](std::mt19937_64& rng) {
      const Vector3 at = dense.points[std::size_t(uniform_int(rng, 0, int(dense.points.size()) - 1))];
      const Vector3 p = at + random_vector(rng, 0.2);
      const SurfaceFoot foot = feet.foot(p);
      EXPECT_NEAR((foot.position - p).norm(), foot.distance, 1e-12);
      EXPECT_LE((sampler.position(foot.patch, foot.parameter) - foot.position).norm(), 1e-12);
      EXPECT_NEAR(foot.distance, grid.distance(p), 2e-3);
    });
    // A point of the surface, also one on its border, is its own foot.
    for (const Vector2& parameter : {Vector2(0.3, 0.61), Vector2(1, 0.37), Vector2(0, 1)})
      EXPECT_LE(feet.foot(sampler.position(0, parameter)).distance, 1e-9);
  }
}

TEST(ErrorMap, AgreesWithBruteForce) {
  for (const char* name : {"wave", "pair"}) {
    const Surface surface = golden_surface(name);
    MeshCriteria criteria;
    criteria.distance = 0.05;
    const MeshApproximation made = mesh_with_errors(surface, criteria);
    for (const bool with_parts : {true, false}) {
      SCOPED_TRACE(std::string(name) + (with_parts ? " with parts" : " without parts"));
      const auto parts =
          with_parts ? std::span<const ParameterFacet>(made.parts) : std::span<const ParameterFacet>();
      const auto map = must(mesh_error_map(surface, made.mesh, parts));
      ASSERT_EQ(map->distance.points.size(), map->samples.size());
      ASSERT_EQ(map->mesh_distance.points.size(), made.mesh.positions.size());
      ASSERT_EQ(map->fold_angle.facets.size(), made.mesh.triangles.size());
      for (std::size_t s = 0; s < map->samples.size(); s += map->samples.size() / 150) {
        const SurfaceSample& sample = map->samples[s];
        EXPECT_NEAR(map->distance.points[s], nearest_by_force(made.mesh, sample.position), 1e-6);
        const Vector3 own = surface.normal(sample.patch, sample.parameter);
        const double cosine = own.dot(normal_of(made.mesh, sample.facet));
        EXPECT_NEAR(map->normal_angle.points[s], std::acos(std::clamp(cosine, -1.0, 1.0)), 2e-4);
      }
      // The largest is where it is said to be, and no sample is above it.
      EXPECT_NEAR(nearest_by_force(made.mesh, map->distance.place), map->distance.largest, 1e-9);
      for (const float value : map->distance.points) EXPECT_LE(double(value), map->distance.largest + 1e-7);
      EXPECT_LE(map->distance.largest, made.distance.bound * (1 + 1e-6));
      EXPECT_GE(map->distance.largest, made.distance.largest * 0.97);
      EXPECT_LT(map->distance.mean, map->distance.largest);
      EXPECT_GT(map->distance.mean, 0.1 * map->distance.largest);
      // Back: at the most the tolerance too, as it is kept both ways; vertices lie on the surface.
      EXPECT_LE(map->mesh_distance.largest, 0.05);
      for (const float value : map->mesh_distance.points) EXPECT_LE(value, 1e-6F);
      const DenseSurface dense(surface, 100);
      const TriangleGrid grid(dense.points, dense.triangles);
      EXPECT_NEAR(grid.distance(map->mesh_distance.place), map->mesh_distance.largest, 2e-3);
    }
  }
}

TEST(ErrorMap, FoldsAreThoseOfTheFacets) {
  const Surface surface = golden_surface("wave");
  MeshCriteria criteria;
  criteria.normal_angle = 12 * degrees;
  const MeshApproximation made = mesh_with_errors(surface, criteria);
  const auto map = must(mesh_error_map(surface, made.mesh, made.parts));
  EXPECT_NEAR(map->fold_angle.largest, made.fold_angle.largest, 1e-6);
  EXPECT_LE(map->normal_angle.largest, 12 * degrees);
  std::map<std::pair<Index, Index>, Index> first;
  std::vector<double> worst(made.mesh.triangles.size(), 0.0);
  for (Index f = 0; f < worst.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& t = made.mesh.triangles[f];
      const auto [at, fresh] = first.try_emplace(std::minmax(t[k], t[(k + 1) % 3]), f);
      if (fresh) continue;
      const double cosine = normal_of(made.mesh, f).dot(normal_of(made.mesh, at->second));
      for (const Index g : {f, at->second})
        worst[g] = std::max(worst[g], std::acos(std::clamp(cosine, -1.0, 1.0)));
    }
  for (Index f = 0; f < worst.size(); ++f) EXPECT_NEAR(map->fold_angle.facets[f], worst[f], 1e-5);
}

TEST(ErrorMap, CreasesAreNoFolds) {
  // Two squares that meet at a right angle: flat, and creased.
  BezierPatch floor, wall;
  floor.degree_s = floor.degree_t = wall.degree_s = wall.degree_t = 1;
  floor.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  wall.points = {{1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}};
  const Surface surface = weld_patches(Vector3::Zero(), {floor, wall}).value();
  MeshCriteria criteria;
  criteria.max_edge = 0.4;
  const MeshApproximation made = mesh_with_errors(surface, criteria);
  for (const bool with_parts : {true, false}) {
    const auto parts =
        with_parts ? std::span<const ParameterFacet>(made.parts) : std::span<const ParameterFacet>();
    const auto map = mesh_error_map(surface, made.mesh, parts);
    EXPECT_LE(map->fold_angle.largest, 1e-6);
    EXPECT_LE(map->distance.largest, 1e-12);
    EXPECT_LE(map->mesh_distance.largest, 1e-9);
  }
  ErrorMapOptions all{.crease = 2};
  EXPECT_NEAR(mesh_error_map(surface, made.mesh, made.parts, all)->fold_angle.largest, 90 * degrees, 1e-6);
}

TEST(ErrorMap, OfAMeshThatKnowsNothingOfTheSurface) {
  // A plane through the middle of the dome, and the same shifted: the map must show the dome's own height.
  const Surface surface = golden_surface("dome");
  const DenseSurface dense(surface, 60);
  Eigen::AlignedBox3d box;
  for (const Vector3& p : dense.points) box.extend(p);
  TriangleMesh plane;
  plane.origin = Vector3(7, -3, 2);
  const double level = box.min().z() - 1;
  for (const Vector3& corner :
       {Vector3(-50, -50, level), Vector3(50, -50, level), Vector3(50, 50, level), Vector3(-50, 50, level)})
    plane.positions.emplace_back(corner - plane.origin);
  plane.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto map = must(mesh_error_map(surface, plane));
  EXPECT_NEAR(map->distance.largest, box.max().z() - level, 1e-3);
  EXPECT_NEAR(map->distance.place.z(), box.max().z(), 1e-3);
  // The plane's corners are far from the dome.
  EXPECT_GT(map->mesh_distance.largest, 50);
}

TEST(ErrorMap, SameOnAnyNumberOfThreads) {
  const Surface surface = golden_surface("fender");
  MeshCriteria criteria;
  criteria.distance = 0.01;
  const MeshApproximation made = mesh_with_errors(surface, criteria);
  std::vector<MeshErrorMap> maps;
  for (const int threads : {1, 2}) {
    const ParallelLimit limit(threads);
    maps.push_back(mesh_error_map(surface, made.mesh, made.parts).value());
  }
  EXPECT_EQ(maps[0].distance.points, maps[1].distance.points);
  EXPECT_EQ(maps[0].mesh_distance.facets, maps[1].mesh_distance.facets);
  EXPECT_EQ(maps[0].distance.largest, maps[1].distance.largest);
  EXPECT_EQ(maps[0].fold_angle.mean, maps[1].fold_angle.mean);
}

TEST(ErrorMap, TextHasALineForEveryFacetVertexAndSample) {
  const Surface surface = golden_surface("quarterpipe");
  MeshCriteria criteria;
  criteria.distance = 0.05;
  const MeshApproximation made = mesh_with_errors(surface, criteria);
  const auto map = mesh_error_map(surface, made.mesh, made.parts);
  const std::string text = error_csv(*map, made.mesh, surface.origin(), "a \"pipe\"", true);
  std::istringstream lines(text);
  std::string line;
  std::size_t count = 0;
  while (std::getline(lines, line)) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 10) << line;
    if (count > 0) {
      EXPECT_EQ(line.substr(0, 13), "\"a \"\"pipe\"\"\",");
    }
    ++count;
  }
  EXPECT_EQ(count, 1 + made.mesh.triangles.size() + made.mesh.positions.size() + map->samples.size());
  EXPECT_EQ(error_csv(*map, made.mesh, surface.origin(), "", false).find("object"), std::string::npos);
}

TEST(ErrorMap, RefusalsAndCancel) {
  const Surface surface = golden_surface("dome");
  EXPECT_EQ(mesh_error_map(surface, {}).error().code, e_mesh_nothing);
  MeshCriteria criteria;
  criteria.distance = 0.05;
  const MeshApproximation made = mesh_with_errors(surface, criteria);
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  EXPECT_EQ(mesh_error_map(surface, made.mesh, made.parts, {}, cancel).error().code, e_cancelled);
}

}  // namespace
}  // namespace hariko::test
