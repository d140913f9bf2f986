// Arrays as live copies stand where arrays of objects stand, and what works on whole objects counts them.

#include <Eigen/Geometry>
#include <algorithm>

#include "core/modeling/objects/arrange.hpp"
#include "core/modeling/objects/patch_objects.hpp"
#include "core/modeling/operations/join.hpp"
#include "core/polyhedron/volume.hpp"
#include "tests/modeling/support.hpp"

namespace hariko {
namespace {

/// Two polyhedra, turned and scaled at will.
Document two_things(std::mt19937_64& rng) {
  Document document;
  for (int i = 0; i < 2; ++i) {
    Similarity place;
    place.rotation = Eigen::AngleAxisd(test::uniform(rng, 0, 6),
                                       (test::random_vector(rng) + Vector3(0, 0, 2)).normalized());
    place.scale = test::log_uniform(rng, 0.1, 10);
    place.translation = test::random_vector(rng, 10);
    document = add_object(document, free_name(document, "Thing"),
                          PolyhedronSource::from_mesh(test::random_polyhedron(rng)).value(), place)
                   .value()
                   .document;
  }
  return document;
}

std::vector<ObjectId> ids_of_things(const Document& document) {
  std::vector<ObjectId> ids;
  for (const auto& object : document.objects) ids.push_back(object->id);
  return ids;
}

/// The live copies, made objects, against objects that were made at once.
void expect_same_things(const Result<Document>& live, const Result<AddedObjects>& arrayed,
                        const std::vector<ObjectId>& ids) {
  ASSERT_TRUE(live.ok()) << to_string(live.error());
  ASSERT_TRUE(arrayed.ok()) << to_string(arrayed.error());
  EXPECT_EQ(live->objects.size(), ids.size()) << "no object is added";
  const auto made = test::must(copies_to_objects(*live, ids));
  ASSERT_EQ(made->document.objects.size(), arrayed->document.objects.size());
  for (std::size_t i = 0; i < made->document.objects.size(); ++i) {
    const Object &own = *made->document.objects[i], &wanted = *arrayed->document.objects[i];
    EXPECT_EQ(own.name, wanted.name);
    EXPECT_TRUE(own.source == wanted.source);
    for (const Vector3& p : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0)})
      EXPECT_LT((own.transform.apply(p) - wanted.transform.apply(p)).norm(), 1e-9) << own.name;
  }
}

TEST(LiveArrays, OfRowsAndRingsAreTheArraysOfObjects) {
  test::for_random(821, 10, [](std::mt19937_64& rng) {
    const Document before = two_things(rng);
    const auto ids = ids_of_things(before);
    const int count = test::uniform_int(rng, 2, 9);
    const Vector3 step = test::random_vector(rng, 5);
    expect_same_things(add_live_copies(before, ids, row_of_copies(count, step).value()),
                       array_in_row(before, ids, count, step), ids);
    const RingAxis axis{test::random_vector(rng, 5), test::random_vector(rng) + Vector3(0, 0, 2)};
    for (const double degrees : {360.0, -360.0, 75.0})
      expect_same_things(add_live_copies(before, ids, ring_of_copies(count, axis, degrees).value()),
                         array_around_axis(before, ids, count, axis, degrees), ids);
  });
}

TEST(LiveArrays, AlongCurvesAreTheArraysOfObjects) {
  test::for_random(822, 10, [](std::mt19937_64& rng) {
    const Document before = two_things(rng);
    const auto ids = ids_of_things(before);
    std::vector<Vector3> points;
    for (int i = 0; i < 5; ++i) points.push_back(Vector3(4 * i, 0, 0) + test::random_vector(rng, 3));
    std::vector<CurvePiece> pieces;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      pieces.push_back(straight_piece(points[i], points[i + 1]));
    const auto curve = ArcLengthCurve::make(std::move(pieces), false).value();
    for (const CurveTurning turning : {CurveTurning::with_curve, CurveTurning::upright, CurveTurning::none})
      for (const bool carried : {false, true}) {
        CurveLayout layout{.count = 6};
        layout.turning = turning;
        if (carried) layout.carried = Vector3(1, 2, 3);
        expect_same_things(live_copies_along_curve(before, ids, curve, layout),
                           array_along_curve(before, ids, curve, layout), ids);
      }
  });
}

TEST(LiveArrays, WithNumbersThatCannotBeAreRefusedAsArraysAre) {
  EXPECT_EQ(row_of_copies(1, {1, 0, 0}).error().code, e_array_count);
  EXPECT_EQ(row_of_copies(3, {0, 0, 0}).error().code, e_array_step);
  EXPECT_EQ(ring_of_copies(3, {{0, 0, 0}, {0, 0, 0}}, 90).error().code, e_array_axis);
  EXPECT_EQ(ring_of_copies(3, {}, 0).error().code, e_array_angle);
}

TEST(LiveArrays, OfMirroredCopiesAreMirrored) {
  test::for_random(823, 10, [](std::mt19937_64& rng) {
    const Document things = two_things(rng);
    const ObjectId id = things.objects[0]->id;
    const RingAxis axis{test::random_vector(rng, 5), test::random_vector(rng) + Vector3(0, 0, 2)};
    const Document before =
        add_live_copies(things, std::span(&id, 1), ring_of_copies(4, axis, 360).value()).value();
    const auto after = test::must(mirrored_copies(before, std::span(&id, 1), {0, 2}));
    const Object &own = *before.find(id), &image = *after->document.find(after->ids[0]);
    const auto from = places_of(own), to = places_of(image);
    ASSERT_EQ(from.size(), to.size());
    for (std::size_t k = 0; k < from.size(); ++k)
      for (Index v = 0; v < own.polyhedron()->polyhedron.vertex_count(); ++v) {
        Vector3 wanted = from[k].apply(own.cage_origin() + own.polyhedron()->polyhedron.position(v));
        wanted.x() = 4 - wanted.x();
        const Polyhedron& shape = image.polyhedron()->polyhedron;
        const Vector3 there = to[k].apply(
            image.cage_origin() + shape.position(shape.find(own.polyhedron()->polyhedron.vertex_id(v))));
        EXPECT_LT((there - wanted).norm(), 1e-9);
      }
  });
}

/// A live copy of one mirror image, made an object, is the object that a mirrored copy makes.
TEST(LiveArrays, OfMirrorsAreMirroredCopies) {
  test::for_random(824, 10, [](std::mt19937_64& rng) {
    const Document before = two_things(rng);
    const auto ids = ids_of_things(before);
    for (int axis = 0; axis < 3; ++axis) {
      const MirrorPlane plane{axis, test::uniform(rng, -5, 5)};
      expect_same_things(add_live_copies(before, ids, mirror_of_copies(plane)),
                         mirrored_copies(before, ids, plane), ids);
    }
  });
}

/// Faces of joined mirror images look outward: the volumes of all parts are positive.
TEST(LiveArrays, OfMirrorsThatAreJoinedBecomeReflectedParts) {
  const Document prism = document_from_mesh(test::prism(5), "Prism").value();
  const auto second = duplicate_object(prism, prism.objects[0]->id).value();
  const std::vector<ObjectId> ids = ids_of_things(second.document);
  Document document = set_copies(second.document, ids[0], {MirrorOfCopies{{5, 0, 0}, {1, 0, 0}}}).value();
  document =
      set_copies(document, ids[1], {RowOfCopies{2, {0, 9, 0}}, MirrorOfCopies{{0, 0, 7}, {0, 1, 2}}}).value();
  const Eigen::AlignedBox3d before =
      world_box(*document.find(ids[0])).merged(world_box(*document.find(ids[1])));
  const auto joined = test::must(join_objects(document, ids));
  const Object& all = *joined->objects[0];
  const Polyhedron& shape = all.polyhedron()->polyhedron;
  EXPECT_EQ(shape.face_count(), 6U * 7U);
  EXPECT_LT((world_box(all).max() - before.max()).norm(), 1e-12);
  EXPECT_LT((world_box(all).min() - before.min()).norm(), 1e-12);
  const Polyhedron& single = prism.objects[0]->polyhedron()->polyhedron;
  const double one = closed_component_volumes(single.topology(), single.positions()).front();
  const std::vector<double> volumes = closed_component_volumes(shape.topology(), shape.positions());
  ASSERT_EQ(volumes.size(), 6U);
  for (const double volume : volumes) EXPECT_NEAR(volume, one, 1e-9);
}

TEST(LiveArrays, ThatAreJoinedBecomeParts) {
  const Document box = document_from_mesh(test::cube(), "Box").value();
  const auto second = duplicate_object(box, box.objects[0]->id).value();
  const std::vector<ObjectId> ids = ids_of_things(second.document);
  Document document = set_copies(second.document, ids[0], {RowOfCopies{3, {5, 0, 0}}}).value();
  document = set_copies(document, ids[1], {RowOfCopies{2, {0, 9, 0}}}).value();
  const Eigen::AlignedBox3d before =
      world_box(*document.find(ids[0])).merged(world_box(*document.find(ids[1])));
  const auto joined = test::must(join_objects(document, ids));
  ASSERT_EQ(joined->objects.size(), 1U);
  const Object& all = *joined->objects[0];
  EXPECT_TRUE(all.copies->empty());
  EXPECT_EQ(all.polyhedron()->polyhedron.face_count(), 5U * 6U);
  EXPECT_LT((world_box(all).max() - before.max()).norm(), 1e-12);
  EXPECT_LT((world_box(all).min() - before.min()).norm(), 1e-12);
}

TEST(LiveArrays, ThatAreWeldedBecomePatches) {
  BezierPatch patch;
  patch.degree_s = patch.degree_t = 1;
  patch.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const auto first = add_object({}, "Plate", BezierSource::from_patches({patch}).value()).value();
  const auto second = duplicate_object(first.document, first.id).value();
  const std::vector<ObjectId> ids{first.id, second.id};
  Document document = set_copies(second.document, ids[0], {RowOfCopies{3, {1, 0, 0}}}).value();
  Similarity above{.translation = {0, 1, 0}};
  document = set_transform(document, ids[1], above).value();
  const auto welded = test::must(weld_patch_objects(document, ids));
  const Object& all = *welded->document.find(welded->object);
  EXPECT_EQ(all.bezier()->patches->size(), 4U);
  EXPECT_TRUE(all.copies->empty());
}

/// The mirror image of a plate in a plane across it looks to the same side, as the plate goes on there.
TEST(LiveArrays, OfMirrorsThatAreWeldedLookToTheSameSide) {
  BezierPatch patch;
  patch.degree_s = patch.degree_t = 1;
  patch.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const auto first = add_object({}, "Plate", BezierSource::from_patches({patch}).value()).value();
  const auto second = duplicate_object(first.document, first.id).value();
  const std::vector<ObjectId> ids{first.id, second.id};
  Document document = set_copies(second.document, ids[0], {MirrorOfCopies{{1, 0, 0}, {1, 0, 0}}}).value();
  Similarity above{.translation = {0, 1, 0}};
  document = set_transform(document, ids[1], above).value();
  const auto welded = test::must(weld_patch_objects(document, ids));
  const BezierSource& source = *welded->document.find(welded->object)->bezier();
  const std::vector<BezierPatch>& patches = *source.patches;
  ASSERT_EQ(patches.size(), 3U);
  double farthest = 0;
  for (const BezierPatch& one : patches) {
    const Vector3 ds = one.points[1] - one.points[0], dt = one.points[2] - one.points[0];
    EXPECT_GT(ds.cross(dt).z(), 0.5);
    for (const Vector3& point : one.points) farthest = std::max(farthest, source.origin.x() + point.x());
  }
  EXPECT_NEAR(farthest, 2, 1e-12);
}

}  // namespace
}  // namespace hariko
