// Objects of Bezier patches of any degree: their surface, and what is done to them as a whole.

#include "core/document/convert_unit.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/document/object_box.hpp"
#include "core/modeling/objects/transformation.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "tests/support/must.hpp"

namespace hariko {
namespace {

/// A quarter of a cylinder round z, of radius 1 and height 2, which looks outwards.
BezierPatch quarter() {
  BezierPatch patch;
  patch.degree_s = 2;
  patch.degree_t = 1;
  for (const double z : {0.0, 2.0})
    for (const auto& [x, y] : {std::pair(1.0, 0.0), std::pair(1.0, 1.0), std::pair(0.0, 1.0)})
      patch.points.emplace_back(x, y, z);
  for (int j = 0; j < 2; ++j)
    for (const double w : {1.0, std::sqrt(0.5), 1.0}) patch.weights.push_back(w);
  return patch;
}

BezierPatch turned(BezierPatch patch) {
  for (Vector3& p : patch.points) p = Vector3(-p.y(), p.x(), p.z());
  return patch;
}

Document half_cylinder() {
  const auto source = BezierSource::from_patches({quarter(), turned(quarter())});
  return add_object({}, "half", Source(source.value())).value().document;
}

/// Middle of a patch, and the surface's normal there.
std::pair<Vector3, Vector3> middle(const Document& document, Index patch) {
  const Object& object = *document.objects[0];
  const Surface surface = object_surface(document, object).value().surface;
  const Vector3 point =
      surface.origin() + surface.patches().evaluate(patch, {0.5, 0.5}, Order::first).position;
  return {object.transform.apply(point), object.transform.rotation * surface.normal(patch, {0.5, 0.5})};
}

TEST(BezierObject, PatchesAreWeldedAndExact) {
  const Document document = half_cylinder();
  const Object& object = *document.objects[0];
  EXPECT_TRUE(object.has_surface());
  EXPECT_EQ(object.cage(), nullptr);
  const auto built = test::must(object_surface(document, object));
  EXPECT_EQ(built->surface.seams().size(), 1U);
  for (const Index patch : {0U, 1U}) {
    const auto [point, normal] = middle(document, patch);
    EXPECT_NEAR(point.head<2>().norm(), 1, 1e-12);
    EXPECT_NEAR(normal.head<2>().dot(point.head<2>()), 1, 1e-12);
  }
  EXPECT_TRUE(world_box(object).contains(Vector3(0, 1, 2)));
}

TEST(BezierObject, StretchedAndMirroredTheOutsideStaysOutside) {
  const Document document = half_cylinder();
  Transformation mirror;
  mirror.factors = Vector3(-3, 1, 1);
  const auto mirrored = transform_object(document, document.objects[0]->id, mirror, Vector3::Zero());
  ASSERT_TRUE(mirrored.ok());
  for (const Index patch : {0U, 1U}) {
    const auto [point, normal] = middle(*mirrored, patch);
    EXPECT_NEAR(std::hypot(point.x() / 3, point.y()), 1, 1e-12);
    EXPECT_GT(normal.dot(Vector3(point.x(), point.y(), 0)), 0);
  }
}

TEST(BezierObject, UnitsScaleIt) {
  const Document document = half_cylinder();
  const auto inches = test::must(convert_unit(document, Unit::inch));
  EXPECT_NEAR(middle(*inches, 0).first.head<2>().norm(), 1 / 25.4, 1e-12);
}

TEST(BezierObject, WhatIsWrongIsSaid) {
  const auto code = [](std::vector<BezierPatch> patches) {
    const auto source = BezierSource::from_patches(std::move(patches));
    return source.ok() ? Code{"none"} : source.error().code;
  };
  EXPECT_EQ(code({}), e_patch_points);
  BezierPatch patch = quarter();
  patch.weights[1] = -1;
  EXPECT_EQ(code({patch}), e_patch_weights);
  patch = quarter();
  patch.points.pop_back();
  EXPECT_EQ(code({quarter(), patch}), e_patch_points);
}

}  // namespace
}  // namespace hariko
