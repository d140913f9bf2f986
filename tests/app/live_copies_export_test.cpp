// Files of objects with live copies hold what stands at every place.

#include <algorithm>
#include <cmath>

#include "app/commands/object_info.hpp"
#include "app/files/export_cad.hpp"
#include "app/files/export_surfaces.hpp"
#include "app/files/mesh_surfaces.hpp"
#include "app/files/model_facets.hpp"
#include "core/document/edits/edit_copies.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/modeling/objects/arrange.hpp"
#include "tests/offset/walls.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"

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

/// A cup and its mirror image in an oblique plane.
Document cup_and_image() {
  const Document document = grid_of_cups(false);
  return set_copies(document, document.objects[0]->id, {MirrorOfCopies{{3, 0, 1}, {1, 0.5, -0.25}}}).value();
}

/// Whether the normals of a mesh lie on the side from which its triangles are counter-clockwise.
bool normals_look_outward(const TriangleMesh& mesh) {
  if (mesh.normal_triangles.size() != mesh.triangles.size()) return false;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vector3 outward =
        (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    for (const Index normal : mesh.normal_triangles[t])
      if (!(outward.dot(mesh.normals[normal]) > 0)) return false;
  }
  return true;
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

TEST(LiveCopiesInFiles, TrianglesOfMirrorImagesLookOutward) {
  const auto meshes = test::must(density_meshes(cup_and_image(), 4)),
             objects = test::must(density_meshes(as_objects(cup_and_image()), 4));
  ASSERT_EQ(meshes->size(), 2U);
  const TriangleMesh &own = (*meshes)[0].mesh, &image = (*meshes)[1].mesh;
  EXPECT_GT(test::volume(own), 0);
  EXPECT_NEAR(test::volume(image), test::volume(own), 1e-9 * test::volume(own));
  EXPECT_NEAR(test::volume((*objects)[1].mesh), test::volume(own), 1e-6 * test::volume(own));
  EXPECT_TRUE(normals_look_outward(own));
  EXPECT_TRUE(normals_look_outward(image));
  const Similarity place = places_of(*cup_and_image().objects[0])[1],
                   back = places_of(*cup_and_image().objects[0])[0].inverse();
  for (std::size_t v = 0; v < own.positions.size(); ++v) {
    const Vector3 wanted = place.apply(back.apply(own.origin + own.positions[v]));
    EXPECT_LT((image.origin + image.positions[v] - wanted).norm(), 1e-9);
  }
}

TEST(LiveCopiesInFiles, SquaresAreTwoTrianglesForTheLimit) {
  BicubicNet net{1, 1, {}};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) net.points.emplace_back(i, j, 0);
  const auto added = test::must(add_object(Document{}, "Square", PatchSource::from_net(net).value()));
  const auto row_of = [&](int count) {
    return test::must(set_copies(added->document, added->id, {RowOfCopies{count, {4, 0, 0}}}));
  };
  const auto few = test::must(density_meshes(*row_of(2), 4));
  EXPECT_EQ((*few)[0].mesh.triangles.size(), 32U);
  test::must_fail(density_meshes(*row_of(200), 256), e_too_many_triangles);  // 26 million
}

TEST(LiveCopiesInFiles, MirrorImagesKeepTheTolerance) {
  MeshRequest request;
  request.options.criteria.distance = 0.05;
  request.errors = true;
  const auto made = test::must(mesh_surfaces(cup_and_image(), request));
  ASSERT_EQ(made->size(), 2U);
  const MeshedObject &own = (*made)[0], &image = (*made)[1];
  EXPECT_GT(own.result.distance.largest, 0);
  EXPECT_EQ(image.result.distance.largest, own.result.distance.largest);
  EXPECT_EQ(image.result.longest_edge, own.result.longest_edge);
  ASSERT_TRUE(own.errors && image.errors);
  EXPECT_EQ(image.errors->distance.largest, own.errors->distance.largest);
  EXPECT_NEAR(test::volume(image.result.mesh), test::volume(own.result.mesh),
              1e-9 * test::volume(own.result.mesh));
  ASSERT_EQ(image.result.parts.size(), image.result.mesh.triangles.size());
  for (std::size_t t = 0; t < image.result.parts.size(); ++t)
    EXPECT_EQ(image.result.parts[t].vertex, image.result.mesh.triangles[t]);
}

TEST(LiveCopiesInFiles, TrianglesUnderTolerances) {
  MeshRequest request;
  request.options.criteria.distance = 0.05;
  const auto one = test::must(mesh_surfaces(grid_of_cups(false), request)),
             all = test::must(mesh_surfaces(grid_of_cups(true), request));
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

TEST(LiveCopiesInFiles, MirrorImagesAreSolidsOfCadFiles) {
  const auto one = count_cad(grid_of_cups(false), {0.05}), both = count_cad(cup_and_image(), {0.05});
  ASSERT_TRUE(one.ok() && both.ok());
  EXPECT_EQ(both->faces, 2 * one->faces);
  EXPECT_EQ(both->distance, one->distance);
  if (why_no_cad_files()) return;
  const test::TemporaryFolder folder;
  for (const char* name : {"cups.step", "cups.igs"}) {
    const auto written = export_cad(cup_and_image(), folder.path() / name, {0.05}, "2026-11-27T12:00:00");
    ASSERT_TRUE(written.ok()) << to_string(written.error());
    EXPECT_TRUE(written->file.valid) << name;
    EXPECT_EQ(written->file.solids, 2U) << name;
    EXPECT_EQ(written->file.open_shells, 0U) << name;
  }
}

TEST(LiveCopiesInFiles, FacetsOfMirrorImagesLookOutwardOnPaper) {
  const Document document = cup_and_image();
  const ObjectId id = document.objects[0]->id;
  FacetOptions options;
  options.distance = 0.3;
  const auto volume = [](const PolygonMesh& mesh) {
    double out = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const auto corners = mesh.face(f);
      for (std::size_t i = 2; i < corners.size(); ++i)
        out +=
            mesh.positions[corners[0]].dot(mesh.positions[corners[i - 1]].cross(mesh.positions[corners[i]])) /
            6;
    }
    return out;
  };
  for (const bool of_polyhedra : {false, true}) {
    options.of_polyhedra = of_polyhedra;
    const auto one = test::must(document_facets(grid_of_cups(false), std::span(&id, 1), options)),
               both = test::must(document_facets(document, std::span(&id, 1), options));
    EXPECT_GT(volume(one->mesh), 0);
    EXPECT_NEAR(volume(both->mesh), 2 * volume(one->mesh), 1e-9 * volume(one->mesh));
  }
}

TEST(LiveCopiesInFiles, FacetsOfPaperModelsHaveNamesOfTheirOwn) {
  const Document document = grid_of_cups(true);
  const ObjectId id = document.objects[0]->id;
  FacetOptions options;
  options.distance = 0.3;
  for (const bool of_polyhedra : {false, true}) {
    options.of_polyhedra = of_polyhedra;
    const auto one = test::must(document_facets(grid_of_cups(false), std::span(&id, 1), options)),
               all = test::must(document_facets(document, std::span(&id, 1), options));
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
