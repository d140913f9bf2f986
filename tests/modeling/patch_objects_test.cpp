// Objects of patches are taken apart and put together: where they are, what becomes of them, and what is
// refused.

#include "core/modeling/objects/patch_objects.hpp"

#include <array>
#include <cmath>

#include "core/document/edits/edits.hpp"
#include "core/modeling/edit_result.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "tests/support/must.hpp"

namespace hariko {
namespace {

/// The patch over [x, x + 1] x [0, 1] of z = x^2 / 4 + x y / 3 in degree p by q, at least 2 by 1, by
/// elevation of its exact Bezier points. Weights, if wanted, are those of a reparametrisation: the surface
/// stays.
BezierPatch piece(double x, int p, int q, bool rational = false) {
  // Coefficients of z in the Bernstein basis of degree 2 in s, 1 in t.
  const auto z = [&](int i, int j) {
    const std::array<double, 3> square{x * x, x * (x + 1), (x + 1) * (x + 1)};
    return square[std::size_t(i)] / 4 + (x + 0.5 * i) * j / 3;
  };
  BezierPatch patch;
  patch.degree_s = 2;
  patch.degree_t = 1;
  for (int j = 0; j <= 1; ++j)
    for (int i = 0; i <= 2; ++i) patch.points.emplace_back(x + 0.5 * i, j, z(i, j));
  const auto elevated_s = [](const BezierPatch& from) {
    BezierPatch to = from;
    to.degree_s = from.degree_s + 1;
    to.points.clear();
    for (int j = 0; j <= from.degree_t; ++j)
      for (int i = 0; i <= to.degree_s; ++i) {
        const double a = double(i) / to.degree_s;
        Vector3 point = Vector3::Zero();
        if (i > 0) point += a * from.points[from.index(i - 1, j)];
        if (i <= from.degree_s) point += (1 - a) * from.points[from.index(i, j)];
        to.points.push_back(point);
      }
    return to;
  };
  while (patch.degree_s < p) patch = elevated_s(patch);
  patch = flipped(patch);
  while (patch.degree_s < q) patch = elevated_s(patch);
  patch = flipped(patch);
  for (std::size_t k = 0; rational && k < patch.points.size(); ++k)
    patch.weights.push_back(std::pow(2.0, double(k % std::size_t(patch.degree_s + 1))));
  return patch;
}

/// Three in a row: editable, rational, of degree 5 by 2, the last looking the other way.
Document row() {
  const auto source =
      BezierSource::from_patches({piece(0, 3, 3), piece(1, 3, 3, true), flipped(piece(2, 5, 2))});
  Similarity transform;
  transform.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()));
  transform.scale = 2.5;
  transform.translation = Vector3(10, -4, 3);
  Document document = add_object({}, "before", Source(*source)).value().document;
  document = add_object(document, "row", Source(*source), transform).value().document;
  return add_object(document, "after", Source(*source)).value().document;
}

/// Points and normals of the surfaces of objects in the document's space.
std::vector<std::pair<Vector3, Vector3>> samples(const Document& document,
                                                 std::span<const ObjectId> objects) {
  std::vector<std::pair<Vector3, Vector3>> out;
  for (const ObjectId id : objects) {
    const Object& object = *document.find(id);
    const Surface surface = object_surface(document, object).value().surface;
    for (Index patch = 0; patch < surface.patch_count(); ++patch)
      for (const Vector2& at : {Vector2(0, 0), Vector2(0.5, 0.5), Vector2(1, 1)})
        out.emplace_back(object.transform.apply(surface.origin() +
                                                surface.patches().evaluate(patch, at, Order::first).position),
                         object.transform.rotation * surface.normal(patch, at));
  }
  return out;
}

void expect_same(const std::vector<std::pair<Vector3, Vector3>>& a,
                 const std::vector<std::pair<Vector3, Vector3>>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_LE((a[k].first - b[k].first).norm(), 1e-12) << k;
    EXPECT_LE((a[k].second - b[k].second).norm(), 1e-10) << k;
  }
}

TEST(PatchObjects, SeparatedPatchesStayWhereTheyAreAndLookTheSameWay) {
  const Document document = row();
  const ObjectId id = document.objects[1]->id;
  const auto done = test::must(separate_patches(document, id));
  ASSERT_EQ(done->objects.size(), 3U);
  std::vector<std::string> names;
  for (const auto& object : done->document.objects) names.push_back(object->name);
  EXPECT_EQ(names, (std::vector<std::string>{"before", "row 1", "row 2", "row 3", "after"}));
  expect_same(samples(document, std::span(&id, 1)), samples(done->document, done->objects));
  // Objects that can be edited are control nets now.
  EXPECT_TRUE(done->document.objects[1]->patches());
  EXPECT_TRUE(done->document.objects[2]->bezier());
  EXPECT_TRUE(done->document.objects[3]->bezier());
}

TEST(PatchObjects, WeldedAgainTheyAreOneSurface) {
  const Document document = row();
  const auto parts = test::must(separate_patches(document, document.objects[1]->id));
  const auto before = samples(parts->document, parts->objects);
  const auto done = test::must(weld_patch_objects(parts->document, parts->objects));
  ASSERT_EQ(done->document.objects.size(), 3U);
  const Object& object = *done->document.objects[1];
  EXPECT_EQ(object.id, done->object);
  EXPECT_EQ(object.name, "row 1");
  expect_same(before, samples(done->document, std::span(&done->object, 1)));
  const Surface surface = object_surface(done->document, object).value().surface;
  EXPECT_EQ(surface.seams().size(), 2U);
  for (const Seam& seam : surface.seams()) EXPECT_EQ(seam.intended, Continuity::g1);
}

TEST(PatchObjects, ObjectsInDifferentPlacesAreWeldedWhereTheyAre) {
  Similarity moved;
  moved.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(-1.1, Vector3(3, -1, 2).normalized()));
  moved.scale = 0.4;
  moved.translation = Vector3(1, 2, 3);
  // The grid stands at [2, 4] x [0, 1] only by its transform.
  BicubicNet net{2, 1, {}};
  const BezierPatch left = piece(2, 3, 3), right = piece(3, 3, 3);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 7; ++i)
      net.points.push_back(
          moved.inverse().apply(i < 4 ? left.points[left.index(i, j)] : right.points[right.index(i - 3, j)]));
  const auto first = BezierSource::from_patches({piece(0, 2, 1), piece(1, 2, 4)});
  Document document = add_object({}, "first", Source(*first)).value().document;
  document = add_object(document, "grid", Source(PatchSource::from_net(net).value()), moved).value().document;
  const std::vector<ObjectId> both{document.objects[0]->id, document.objects[1]->id};
  const auto before = samples(document, both);
  const auto done = test::must(weld_patch_objects(document, both));
  ASSERT_EQ(done->document.objects.size(), 1U);
  expect_same(before, samples(done->document, std::span(&done->object, 1)));
  EXPECT_EQ(object_surface(done->document, *done->document.objects[0]).value().surface.seams().size(), 3U);
}

TEST(PatchObjects, LongNamesAreCutAtACharacter) {
  const Document document = rename_object(row(), row().objects[1]->id, std::string(254, 'x') + "é").value();
  const auto done = test::must(separate_patches(document, document.objects[1]->id));
  for (const auto& object : done->document.objects)
    EXPECT_TRUE(check_name(object->name).ok()) << object->name;
  EXPECT_EQ(done->document.objects[1]->name, std::string(254, 'x') + " 1");
}

TEST(PatchObjects, WhatCannotBeDoneIsSaid) {
  const Document document = row();
  const ObjectId id = document.objects[1]->id;
  EXPECT_EQ(separate_patches(document, ObjectId{77}).error().code, e_unknown_object);
  EXPECT_EQ(separate_patches(set_locked(document, id, true).value(), id).error().code, e_locked);
  const auto parts = separate_patches(document, id);
  EXPECT_EQ(separate_patches(parts->document, parts->objects[0]).error().code, e_wrong_kind);
  EXPECT_EQ(separate_patches(parts->document, parts->objects[1]).error().code, e_wrong_kind);
  const auto welded = [](const Document& from, std::vector<ObjectId> objects) {
    const auto done = weld_patch_objects(from, objects);
    return done.ok() ? Code{"none"} : done.error().code;
  };
  EXPECT_EQ(welded(document, {id, id}), e_wrong_selection);
  EXPECT_EQ(welded(document, {id, ObjectId{77}}), e_unknown_object);
  EXPECT_EQ(welded(set_locked(document, id, true).value(), {document.objects[0]->id, id}), e_locked);
  PolygonMesh triangle;
  triangle.positions = {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0)};
  triangle.add_face({0, 1, 2});
  const auto mesh = add_object(document, "mesh", Source(MeshSource::from_mesh(triangle).value()));
  EXPECT_EQ(welded(mesh->document, {id, mesh->id}), e_wrong_kind);
}

}  // namespace
}  // namespace hariko
