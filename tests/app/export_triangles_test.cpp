#include "app/jobs/export_triangles.hpp"

#include <numbers>

#include "app/files/open_file.hpp"
#include "core/approximation/mesh_options.hpp"
#include "core/document/edits/edits.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/polyhedron/validation.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

std::size_t triangles_in(const std::filesystem::path& file) {
  const OpenedFile opened = open_file(file);
  if (!opened.document) return 0;
  const Object& object = *opened.document->objects.front();
  return object.mesh() ? object.mesh()->mesh->face_count() : object.polyhedron()->polyhedron.face_count();
}

TEST(ExportTriangles, WhatWasCountedIsWritten) {
  const test::TemporaryFolder folder;
  const Document document = document_from_mesh(test::torus(8, 6), "Torus").value();
  for (const auto by : {ExportSettings::By::tolerance, ExportSettings::By::density}) {
    ExportSettings settings;
    settings.by = by;
    settings.distance = 0.02;
    settings.density = 5;
    const auto count = test::must(count_triangles(document, "a.ply", settings, {}));
    const auto file = folder.path() / "a.ply";
    ASSERT_TRUE(export_triangles(document, file, settings, {}, {}).ok());
    EXPECT_EQ(triangles_in(file), count->triangles);
    EXPECT_GT(count->triangles, 48U);
    if (by == ExportSettings::By::density) continue;
    EXPECT_TRUE(count->reached);
    EXPECT_LE(count->distance, 0.02);
    EXPECT_GT(count->distance, 0.002);
    EXPECT_GT(count->angle, 0.01);
  }
}

TEST(ExportTriangles, WallsAreCountedAndWritten) {
  const test::TemporaryFolder folder;
  const Document document = document_from_mesh(test::torus(8, 6), "Torus").value();
  for (const auto by : {ExportSettings::By::tolerance, ExportSettings::By::density}) {
    ExportSettings settings;
    settings.by = by;
    settings.distance = 0.05;
    settings.density = 4;
    const auto bare = test::must(count_triangles(document, "a.ply", settings, {}));
    settings.wall.thickness = 0.01;
    const auto walled = test::must(count_triangles(document, "a.ply", settings, {}));
    EXPECT_GT(walled->triangles, bare->triangles);
    if (by == ExportSettings::By::density) EXPECT_EQ(walled->triangles, 2 * bare->triangles);
    const auto report = test::must(export_triangles(document, folder.path() / "a.ply", settings, {}, {}));
    EXPECT_EQ(report->triangles, walled->triangles);
  }
}

TEST(ExportTriangles, TolerancesAreLengthsOfTheDocument) {
  const Document document = document_from_mesh(test::torus(8, 6), "Torus").value();
  Similarity large{.scale = 1000};
  const Document scaled = set_transform(document, document.objects.front()->id, large).value();
  ExportSettings settings{.distance = 0.02};
  const auto small = test::must(count_triangles(document, "a.ply", settings, {}));
  settings.distance = 20;
  const auto same = test::must(count_triangles(scaled, "a.ply", settings, {}));
  EXPECT_EQ(small->triangles, same->triangles);
  EXPECT_NEAR(same->distance, 1000 * small->distance, 1e-6);
}

TEST(ExportTriangles, SmallerTolerancesAndAnglesNeedMore) {
  const Document document = document_from_mesh(test::torus(8, 6), "Torus").value();
  ExportSettings settings{.distance = 0.05};
  const auto coarse = test::must(count_triangles(document, "a.ply", settings, {}));
  settings.angle = 0.1;
  const auto turned = test::must(count_triangles(document, "a.ply", settings, {}));
  EXPECT_GT(turned->triangles, coarse->triangles);
  EXPECT_LE(turned->angle, 0.1);
  settings.distance = -1;
  EXPECT_EQ(count_triangles(document, "a.ply", settings, {}).error().code, Code{"E_MESH_TOLERANCE"});
}

TEST(ExportTriangles, AToleranceThatIsNotReachedIsTold) {
  const test::TemporaryFolder folder;
  // The points of the rim turn their normals at once.
  const OpenedFile opened = open_file(test::source_folder() + "/assets/samples/fig5d.hariko");
  ASSERT_TRUE(opened.document);
  ExportSettings settings{.distance = 10};
  settings.angle = std::numbers::pi / 180;
  const auto report =
      test::must(export_triangles(*opened.document, folder.path() / "a.obj", settings, {}, {}));
  ASSERT_EQ(report->warnings.size(), 1U);
  EXPECT_EQ(report->warnings[0].code, w_mesh_unreached);
}

TEST(ExportTriangles, CancelledCountsEndAndFilesStay) {
  const test::TemporaryFolder folder;
  const Document document = document_from_mesh(test::torus(12, 9), "Torus").value();
  ExportSettings settings{.distance = 1e-3};
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  EXPECT_EQ(count_triangles(document, "a.ply", settings, cancel).error().code, e_cancelled);
  const auto file = folder.path() / "a.obj";
  test::spill(file, "old");
  EXPECT_EQ(export_triangles(document, file, settings, cancel, {}).error().code, e_cancelled);
  EXPECT_EQ(test::slurp(file), "old");
}

/// A torus and a closed box of facets that stands apart.
Document torus_and_facets(const Vector3& place) {
  PolygonMesh box;
  for (int k = 0; k < 8; ++k) box.positions.push_back(place + Vector3(k & 1, (k >> 1) & 1, 3 * (k >> 2)));
  for (const std::initializer_list<Index> face : {std::initializer_list<Index>{0, 2, 3, 1},
                                                  {4, 5, 7, 6},
                                                  {0, 1, 5, 4},
                                                  {2, 6, 7, 3},
                                                  {0, 4, 6, 2},
                                                  {1, 3, 7, 5}})
    box.add_face(face);
  const Document document = document_from_mesh(test::torus(8, 6), "Torus").value();
  return add_object(document, "Box", MeshSource::from_mesh(box).value())->document;
}

TEST(ExportTriangles, ReferenceFacetsGoOutAsTheyAreBesideSurfaces) {
  const test::TemporaryFolder folder;
  const Document document = torus_and_facets({10.3, 0, 0});
  for (const auto by : {ExportSettings::By::tolerance, ExportSettings::By::density})
    for (const char* name : {"a.stl", "a.obj", "a.glb", "a.3mf", "a.ply", "a.off"}) {
      SCOPED_TRACE(name);
      ExportSettings settings;
      settings.by = by;
      settings.distance = 0.05;
      settings.density = 2;
      const auto file = folder.path() / name;
      const auto count = test::must(count_triangles(document, file, settings, {}));
      const auto report = test::must(export_triangles(document, file, settings, {}, {}));
      EXPECT_TRUE(report->warnings.empty());
      EXPECT_EQ(report->triangles, count->triangles);
      const auto read = test::must(read_mesh_file(file));
      EXPECT_EQ(read->mesh.face_count(), count->triangles);
      std::size_t of_box = 0;
      for (std::size_t f = 0; f < read->mesh.face_count(); ++f)
        of_box += read->mesh.positions[read->mesh.face(f)[0]].x() > 10 ? 1 : 0;
      EXPECT_EQ(of_box, 12U);
      EXPECT_TRUE(validate(read->mesh).empty());
      if (by == ExportSettings::By::tolerance) EXPECT_LE(count->distance, 0.05);
    }
}

TEST(ExportTriangles, KindsFromElsewhereAreLeftOutWithACount) {
  const test::TemporaryFolder folder;
  Document document = torus_and_facets({10, 0, 0});
  for (const char* name : {"one", "two"})
    document =
        add_object(document, name, UnknownSource{"dream", std::string("{\"kind\":\"dream\"}")})->document;
  ExportSettings settings{.distance = 0.05};
  const auto report = test::must(export_triangles(document, folder.path() / "a.obj", settings, {}, {}));
  ASSERT_EQ(report->warnings.size(), 1U);
  EXPECT_EQ(report->warnings[0].code, Code{"W_NOT_WRITTEN"});
  EXPECT_TRUE(report->warnings[0].text.starts_with("Objects left out: 2 (\"one\", \"two\")"))
      << report->warnings[0].text;
  document = set_visible(document, document.objects.back()->id, false).value();
  EXPECT_TRUE(export_triangles(document, folder.path() / "a.obj", settings, {}, {})
                  ->warnings[0]
                  .text.starts_with("Objects left out: 1 (\"one\")"));
}

TEST(ExportTriangles, ThePromiseHoldsForTheDigitsOfTheFile) {
  const test::TemporaryFolder folder;
  ExportSettings settings{.distance = 0.01};
  Similarity far{.translation = {500000.123, 5123456.789, 0}};
  const Document at_zero = document_from_mesh(test::torus(8, 6), "Torus").value();
  const Document document = set_transform(at_zero, at_zero.objects.front()->id, far).value();
  const auto stl = folder.path() / "a.stl";
  EXPECT_EQ(count_triangles(document, stl, settings, {}).error().code, Code{"E_FILE_DIGITS"});
  EXPECT_EQ(export_triangles(document, stl, settings, {}, {}).error().code, Code{"E_FILE_DIGITS"});
  EXPECT_FALSE(std::filesystem::exists(stl));
  EXPECT_TRUE(count_triangles(document, folder.path() / "a.obj", settings, {}).ok());
  settings.choices.to_zero = true;
  const auto count = test::must(count_triangles(document, stl, settings, {}));
  EXPECT_LE(count->distance, 0.01);
  EXPECT_GT(count->rounding, 0);
  const auto report = test::must(export_triangles(document, stl, settings, {}, {}));
  EXPECT_NEAR((report->moved - far.translation).norm(), 0, 0.1);
  // Near enough to zero the digits are a part of what is promised.
  Similarity near = far;
  near.translation = {4000.3, 0, 0};
  settings.choices.to_zero = false;
  const Document nearer = set_transform(at_zero, at_zero.objects.front()->id, near).value();
  const auto counted = test::must(count_triangles(nearer, stl, settings, {}));
  EXPECT_LE(counted->distance, 0.01);
  EXPECT_GT(counted->rounding, 1e-5);
}

}  // namespace
}  // namespace hariko
