// Walls in exports: closed bodies of the objects of a document in its own unit, and what is refused.

#include "app/files/walled_surface.hpp"

#include "app/files/export_cad.hpp"
#include "app/files/export_surfaces.hpp"
#include "app/files/mesh_surfaces.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "tests/offset/walls.hpp"
#include "tests/support/must.hpp"

namespace hariko {
namespace {

/// Flat open plate of 3 x 2 as one patch, ten times as large in the document.
Document plate() {
  BezierPatch patch;
  patch.degree_s = patch.degree_t = 1;
  patch.points = {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {3, 2, 0}};
  Document out = add_object({}, "Plate", BezierSource::from_patches({patch}).value())->document;
  Object object = *out.objects[0];
  object.transform.scale = 10;
  out.objects[0] = std::make_shared<const Object>(object);
  return out;
}

/// Part of a parabolic trough along y: z = x^2 / 2, whose radius of curvature at the bottom is 1 on the side
/// of its normals.
Document trough() {
  BezierPatch patch;
  patch.degree_s = 2;
  patch.degree_t = 1;
  patch.points = {{-1, 0, 0.5}, {0, 0, -0.5}, {1, 0, 0.5}, {-1, 1, 0.5}, {0, 1, -0.5}, {1, 1, 0.5}};
  return add_object({}, "Trough", BezierSource::from_patches({patch}).value())->document;
}

TEST(WalledSurface, LengthsAreTheDocuments) {
  MeshRequest request;
  request.options.criteria.distance = 0.01;
  request.wall = {0, 0.5, WallSide::both};
  const auto made = test::must(mesh_surfaces(plate(), request));
  test::expect_watertight(made->front().result.mesh);
  EXPECT_NEAR(test::volume(made->front().result.mesh), 30 * 20 * 0.5, 1e-6);
  const auto dense = test::must(density_meshes(plate(), 3, {}, {}, request.wall));
  test::expect_watertight(dense->front().mesh);
  EXPECT_NEAR(test::volume(dense->front().mesh), 30 * 20 * 0.5, 1e-6);
  const auto counted = test::must(count_cad(plate(), {1e-3}, {}, request.wall));
  EXPECT_EQ(counted->faces, 6U);
  EXPECT_LE(counted->distance, 1e-3);
}

TEST(WalledSurface, FoldsAreRefusedUnderTolerancesAndToldOtherwise) {
  MeshRequest request;
  request.options.criteria.distance = 0.01;
  for (const double offset : {0.99, 1.01}) {
    request.wall.offset = offset;
    const bool folds = offset > 1;
    const auto made = mesh_surfaces(trough(), request);
    const auto counted = count_cad(trough(), {1e-2}, {}, request.wall);
    const auto dense = test::must(density_meshes(trough(), 8, {}, {}, request.wall));
    EXPECT_EQ(made.ok(), !folds);
    EXPECT_EQ(counted.ok(), !folds);
    EXPECT_EQ(dense->front().warnings.size(), folds ? 1U : 0U);
    if (!folds) continue;
    EXPECT_EQ(made.error().code, e_offset_folds);
    EXPECT_NE(made.error().text.find("Trough"), std::string::npos);
    EXPECT_NE(made.error().remedy.find("below 1 "), std::string::npos) << made.error().remedy;
    EXPECT_EQ(counted.error().code, e_offset_folds);
    EXPECT_EQ(dense->front().warnings[0].code, w_offset_folds);
  }
}

}  // namespace
}  // namespace hariko
