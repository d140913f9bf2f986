// Files of objects with live copies hold what stands at every place.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/commands/object_info.hpp"
#include "app/files/export_cad.hpp"
#include "app/files/export_surfaces.hpp"
#include "app/files/mesh_surfaces.hpp"
#include "app/files/model_facets.hpp"
#include "core/document/edits/edits.hpp"
#include "tests/offset/walls.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko {
namespace {

constexpr std::size_t places_of_cups = 6;

/// A grid of two rows of three, turned and scaled.
Document grid_of_cups(bool live) {
  Document document = document_from_mesh(test::prism(5), "Cup").value();
  const ObjectId id = document.objects[0]->id;
  Similarity place;
  place.rotation = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized());
  place.scale = 3;
  place.translation = {5, -4, 2};
  document = set_transform(document, id, place).value();
  if (live)
    document = set_copies(document, id, {RowOfCopies{3, {4, 0, 0}}, RowOfCopies{2, {0, 5, 0}}}).value();
  return document;
}

Document as_objects(const Document& document) {
  const ObjectId id = document.objects[0]->id;
  return copies_to_objects(document, std::span(&id, 1)).value().document;
}

TEST(LiveCopiesInFiles, TrianglesAtADensity) {
  const auto one = density_meshes(grid_of_cups(false), 4), all = density_meshes(grid_of_cups(true), 4),
             objects = density_meshes(as_objects(grid_of_cups(true)), 4);
  ASSERT_TRUE(one.ok() && all.ok() && objects.ok());
  ASSERT_EQ(one->size(), 1U);
  ASSERT_EQ(all->size(), places_of_cups);
  ASSERT_EQ(objects->size(), places_of_cups);
  for (std::size_t k = 0; k < places_of_cups; ++k) {
    const TriangleMesh &mesh = (*all)[k].mesh, &object = (*objects)[k].mesh;
    EXPECT_EQ((*all)[k].name, k == 0 ? "Cup" : "Cup (" + std::to_string(k + 1) + ")");
    EXPECT_EQ(mesh.triangles.size(), one->front().mesh.triangles.size());
    const double volume = test::volume(one->front().mesh);
    EXPECT_NEAR(test::volume(mesh), volume, 1e-9 * std::abs(volume));
    ASSERT_EQ(mesh.positions.size(), object.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      EXPECT_LT((mesh.origin + mesh.positions[v] - object.origin - object.positions[v]).norm(), 1e-9);
  }
}

TEST(LiveCopiesInFiles, TrianglesUnderTolerances) {
  MeshRequest request;
  request.options.criteria.distance = 0.05;
  const auto one = mesh_surfaces(grid_of_cups(false), request),
             all = mesh_surfaces(grid_of_cups(true), request);
  ASSERT_TRUE(one.ok() && all.ok());
  ASSERT_EQ(all->size(), places_of_cups);
  for (const MeshedObject& place : *all) {
    EXPECT_EQ(place.result.mesh.triangles.size(), one->front().result.mesh.triangles.size());
    EXPECT_EQ(place.result.distance.largest, one->front().result.distance.largest);
    EXPECT_EQ(place.most_rounding, one->front().most_rounding);
  }
}

TEST(LiveCopiesInFiles, FacesOfCadFiles) {
  const auto one = count_cad(grid_of_cups(false), {0.05}), all = count_cad(grid_of_cups(true), {0.05});
  ASSERT_TRUE(one.ok() && all.ok());
  EXPECT_GT(one->faces, 0U);
  EXPECT_EQ(all->faces, places_of_cups * one->faces);
  EXPECT_EQ(all->distance, one->distance);
}

TEST(LiveCopiesInFiles, FacetsOfPaperModelsHaveNamesOfTheirOwn) {
  const Document document = grid_of_cups(true);
  const ObjectId id = document.objects[0]->id;
  FacetOptions options;
  options.distance = 0.3;
  for (const bool of_polyhedra : {false, true}) {
    options.of_polyhedra = of_polyhedra;
    const auto one = document_facets(grid_of_cups(false), std::span(&id, 1), options),
               all = document_facets(document, std::span(&id, 1), options);
    ASSERT_TRUE(one.ok() && all.ok());
    EXPECT_EQ(all->mesh.face_count(), places_of_cups * one->mesh.face_count());
    ASSERT_EQ(all->names.size(), places_of_cups * one->names.size());
    EXPECT_TRUE(std::equal(one->names.begin(), one->names.end(), all->names.begin()))
        << "cuts that were chosen before there were copies stay";
    std::vector<PaperVertex> names = all->names;
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  }
}

TEST(LiveCopiesInFiles, InfoCountsAllPlaces) {
  const Document single = grid_of_cups(false), document = grid_of_cups(true);
  const ObjectInfo one = inspect(single, *single.objects[0]), all = inspect(document, *document.objects[0]);
  ASSERT_TRUE(one.area && all.area && one.volume && all.volume);
  EXPECT_FALSE(one.places);
  EXPECT_EQ(all.places, places_of_cups);
  EXPECT_DOUBLE_EQ(*all.area, double(places_of_cups) * *one.area);
  EXPECT_DOUBLE_EQ(*all.volume, double(places_of_cups) * *one.volume);
}

}  // namespace
}  // namespace hariko
