// Maps of making on display meshes: the same bits on any number of threads, values of the world, and reasons.

#include <cmath>
#include <cstring>

#include "core/base/parallel.hpp"
#include "render/picking.hpp"
#include "render/surface_maps.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/must.hpp"

namespace hariko {
namespace {

std::vector<float> all_values(const DisplayMesh& mesh) {
  std::vector<float> out;
  for (const auto& chunk : mesh.chunks()) out.insert(out.end(), chunk->values.begin(), chunk->values.end());
  return out;
}

std::shared_ptr<const DisplayMesh> mapped(const Surface& surface, SurfaceMap map, const MapPlace& place,
                                          int density = 6) {
  const auto options = map_options(surface, map, density, place);
  EXPECT_TRUE(options.ok());
  return options ? DisplayMesh::build(surface, *options) : nullptr;
}

TEST(MakingMapsOnMeshes, AreTheSameBitsOnAnyNumberOfThreads) {
  const Surface ring = test::torus(3, 1, 16, 12);
  for (const SurfaceMap map :
       {SurfaceMap::draft, SurfaceMap::radius, SurfaceMap::thickness, SurfaceMap::deviation}) {
    std::vector<float> first;
    for (const int threads : {1, 2, 4}) {
      const ParallelLimit limit(threads);
      MapPlace place;
      place.pull = {0.3, 0, 1};
      place.reference =
          std::make_shared<const DeviationReference>(test::sphere(3), DeviationReference::Kind::smooth);
      const auto values = all_values(*mapped(ring, map, place));
      ASSERT_GT(values.size(), 5000U);
      if (first.empty()) first = values;
      ASSERT_EQ(values.size(), first.size());
      EXPECT_EQ(std::memcmp(values.data(), first.data(), values.size() * sizeof(float)), 0)
          << word_of(map) << " " << threads;
    }
  }
}

TEST(MakingMapsOnMeshes, ValuesAreThoseOfTheWorld) {
  MapPlace place;
  place.transform.scale = 2.5;
  place.transform.rotation = Eigen::AngleAxisd(std::acos(-1) / 2, Vector3::UnitX());
  place.transform.translation = {1e3, -2e3, 5e2};
  const Surface ball = test::sphere(2);
  for (const float radius : all_values(*mapped(ball, SurfaceMap::radius, place)))
    EXPECT_NEAR(radius, 5, 1e-5);
  for (const float wall : all_values(*mapped(ball, SurfaceMap::thickness, place, 8)))
    EXPECT_NEAR(wall, 10, 0.02);
  // A plate that looks to its own z looks against the world's y when it is turned about x.
  const Surface plate = test::height_field(1, 1, [](Index, Index) { return test::plane(); });
  place.pull = -3 * Vector3::UnitY();
  for (const float draft : all_values(*mapped(plate, SurfaceMap::draft, place))) EXPECT_NEAR(draft, 90, 1e-4);
  place.pull = Vector3::UnitZ();
  for (const float draft : all_values(*mapped(plate, SurfaceMap::draft, place))) EXPECT_NEAR(draft, 0, 1e-4);
}

TEST(MakingMapsOnMeshes, AMovedCopyDeviatesByTheWay) {
  for (const double moved : {0.0, 1e6})
    for (const double scale : {1e-3, 1.0, 1e3}) {
      SCOPED_TRACE(std::to_string(moved) + " " + std::to_string(scale));
      const Surface plate = test::height_field(2, 2, [](Index, Index) { return test::plane(); });
      MapPlace place;
      place.reference = std::make_shared<const DeviationReference>(plate, DeviationReference::Kind::smooth);
      place.reference_transform.scale = place.transform.scale = scale;
      place.reference_transform.rotation = place.transform.rotation =
          Eigen::AngleAxisd(0.4, Vector3(1, 2, 3).normalized());
      place.reference_transform.translation = Vector3::Constant(moved);
      const Vector3 up = place.transform.rotation * Vector3::UnitZ();
      place.transform.translation = place.reference_transform.translation + 0.25 * scale * up;
      for (const float way : all_values(*mapped(plate, SurfaceMap::deviation, place)))
        EXPECT_NEAR(way, 0.25 * scale, 1e-6 * scale + 1e-8);
    }
}

TEST(MakingMapsOnMeshes, WhatCannotBeSaysWhyAndWhatToDo) {
  const Surface open = test::height_field(1, 1, [](Index, Index) { return test::plane(); });
  const auto walls = map_options(open, SurfaceMap::thickness, 4, {});
  test::must_fail(walls, e_map_open);
  EXPECT_FALSE(walls.error().remedy.empty());
  MapPlace facets;
  facets.facets = true;
  test::must_fail(map_options(open, SurfaceMap::radius, 4, facets), e_map_facets);
  MapPlace alone;
  alone.no_reference = make_error(e_map_reference, "There is none.", "Choose one.");
  const auto deviation = map_options(open, SurfaceMap::deviation, 4, alone);
  ASSERT_FALSE(deviation);
  EXPECT_EQ(deviation.error().text, "There is none.");
  EXPECT_TRUE(map_options(open, SurfaceMap::draft, 4, {}));
  EXPECT_TRUE(map_options(open, SurfaceMap::mean, 4, {}));
}

TEST(MakingMapsOnMeshes, LargeFacetsAreMeasuredInside) {
  EXPECT_EQ(facet_density(SurfaceMap::shaded, 12), 1);
  EXPECT_EQ(facet_density(SurfaceMap::thickness, 12), 32);
  EXPECT_EQ(facet_density(SurfaceMap::thickness, 50'000), 2);
  EXPECT_EQ(facet_density(SurfaceMap::thickness, 5'000'000), 1);
}

TEST(MakingMapsOnMeshes, InfiniteRadiiArePickedAsSuch) {
  const Surface flat = test::height_field(1, 1, [](Index, Index) { return test::plane(); });
  SceneObject object;
  object.mesh = mapped(flat, SurfaceMap::radius, {}, 3);
  object.map = SurfaceMap::radius;
  Scene scene;
  scene.objects.push_back(object);
  // Inside of a triangle, on a side, and at a corner of the grid.
  for (const Vector3& at : {Vector3(0.4, 0.2, 0), Vector3(0.5, 0, 0), Vector3(1.0 / 3, 1.0 / 3, 0)}) {
    const auto hit = pick_surface(scene, {at + Vector3(0, 0, 5), -Vector3::UnitZ()});
    ASSERT_TRUE(hit);
    EXPECT_TRUE(std::isinf(hit->value)) << at.transpose();
  }
}

}  // namespace
}  // namespace hariko
