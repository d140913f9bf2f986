#include "app/export_triangles.hpp"

#include <gtest/gtest.h>

#include "app/files/open_file.hpp"
#include "core/document/edits.hpp"
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
    const auto count = count_triangles(document, settings, {});
    ASSERT_TRUE(count.ok()) << to_string(count.error());
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

TEST(ExportTriangles, TolerancesAreLengthsOfTheDocument) {
  const Document document = document_from_mesh(test::torus(8, 6), "Torus").value();
  Similarity large;
  large.scale = 1000;
  const Document scaled = set_transform(document, document.objects.front()->id, large).value();
  ExportSettings settings;
  settings.distance = 0.02;
  const auto small = count_triangles(document, settings, {});
  settings.distance = 20;
  const auto same = count_triangles(scaled, settings, {});
  ASSERT_TRUE(small.ok() && same.ok());
  EXPECT_EQ(small->triangles, same->triangles);
  EXPECT_NEAR(same->distance, 1000 * small->distance, 1e-6);
}

TEST(ExportTriangles, SmallerTolerancesAndAnglesNeedMore) {
  const Document document = document_from_mesh(test::torus(8, 6), "Torus").value();
  ExportSettings settings;
  settings.distance = 0.05;
  const auto coarse = count_triangles(document, settings, {});
  settings.angle = 0.1;
  const auto turned = count_triangles(document, settings, {});
  ASSERT_TRUE(coarse.ok() && turned.ok());
  EXPECT_GT(turned->triangles, coarse->triangles);
  EXPECT_LE(turned->angle, 0.1);
  settings.distance = -1;
  EXPECT_EQ(count_triangles(document, settings, {}).error().code, Code{"E_MESH_TOLERANCE"});
}

TEST(ExportTriangles, CancelledCountsEndAndFilesStay) {
  const test::TemporaryFolder folder;
  const Document document = document_from_mesh(test::torus(12, 9), "Torus").value();
  ExportSettings settings;
  settings.distance = 1e-3;
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  EXPECT_EQ(count_triangles(document, settings, cancel).error().code, e_cancelled);
  const auto file = folder.path() / "a.obj";
  test::spill(file, "old");
  EXPECT_EQ(export_triangles(document, file, settings, cancel, {}).error().code, e_cancelled);
  EXPECT_EQ(test::slurp(file), "old");
}

}  // namespace
}  // namespace hariko
