// Copies in rows and around axes, common sides and equal gaps of whole objects.

#include "core/modeling/objects/arrange.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "core/document/edits/edits.hpp"
#include "tests/modeling/support.hpp"

namespace hariko {
namespace {

using ArrangedIds = std::vector<ObjectId>;

Similarity arranged_place(std::mt19937_64& rng, double scale, const Vector3& far) {
  Similarity place;
  place.rotation = Eigen::Quaterniond(test::uniform(rng, 0.1, 1), test::uniform(rng, -1, 1),
                                      test::uniform(rng, -1, 1), test::uniform(rng, -1, 1))
                       .normalized();
  place.scale = test::log_uniform(rng, 0.1, 10);
  place.translation = test::random_vector(rng, 10 * scale) + far;
  return place;
}

/// Polyhedra of about the size `scale`, turned at will, near `far`.
Document arranged_document(std::mt19937_64& rng, int count, double scale, const Vector3& far) {
  Document document;
  for (int i = 0; i < count; ++i) {
    PolygonMesh mesh = test::random_polyhedron(rng);
    for (Vector3& p : mesh.positions) p *= scale;
    document = add_object(document, free_name(document, "Thing"), PolyhedronSource::from_mesh(mesh).value(),
                          arranged_place(rng, scale, far))
                   .value()
                   .document;
  }
  return document;
}

ArrangedIds arranged_ids(const Document& document) {
  ArrangedIds ids;
  for (const auto& object : document.objects) ids.push_back(object->id);
  return ids;
}

double largest_coordinate(const Document& document) {
  Eigen::AlignedBox3d box;
  for (const auto& object : document.objects) box.extend(world_box(*object));
  return std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

/// Calls run(rng, scale, far): sizes from 1e-3 to 1e6, near zero and a million of them away.
template <class Run>
void at_every_scale(std::uint64_t seed, Run&& run) {
  for (const double scale : {1e-3, 1.0, 1e6})
    for (const bool far : {false, true}) {
      SCOPED_TRACE("scale " + std::to_string(scale) + (far ? ", far away" : ""));
      test::for_random(seed, 4, [&](std::mt19937_64& rng) {
        run(rng, scale, far ? test::random_vector(rng, 1e6) : Vector3(Vector3::Zero()));
      });
    }
}

void expect_array_refused(const Result<AddedObjects>& result, Code code) {
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, code) << to_string(result.error());
  EXPECT_FALSE(result.error().remedy.empty());
}

TEST(ArrayInRow, CopiesStandAtEqualSteps) {
  at_every_scale(501, [](std::mt19937_64& rng, double scale, const Vector3& far) {
    const Document before = arranged_document(rng, test::uniform_int(rng, 1, 4), scale, far);
    const ArrangedIds ids = arranged_ids(before);
    const int count = test::uniform_int(rng, 2, 30);
    const Vector3 step = test::random_vector(rng, 3 * scale);
    const auto added = test::must(array_in_row(before, ids, count, step));
    const Document& after = added->document;
    ASSERT_EQ(after.objects.size(), ids.size() * static_cast<std::size_t>(count));
    ASSERT_EQ(added->ids.size(), ids.size() * static_cast<std::size_t>(count - 1));
    std::set<std::string> names;
    std::size_t next = 0;
    for (std::size_t i = 0; i < ids.size(); ++i)
      for (int k = 0; k < count; ++k) {
        const auto& object = after.objects[i * static_cast<std::size_t>(count) + static_cast<std::size_t>(k)];
        const Object& original = *before.objects[i];
        names.insert(object->name);
        if (k == 0) {
          EXPECT_EQ(object, before.objects[i]) << "originals stay shared";
          continue;
        }
        EXPECT_EQ(object->id, added->ids[next++]) << "copies follow their original";
        EXPECT_TRUE(object->source == original.source);
        EXPECT_EQ(object->transform.scale, original.transform.scale);
        EXPECT_EQ(object->transform.rotation.coeffs(), original.transform.rotation.coeffs());
        const Vector3 wanted = original.transform.translation + k * step;
        EXPECT_LE((object->transform.translation - wanted).norm(), 1e-12 * (wanted.norm() + k * step.norm()));
      }
    EXPECT_EQ(names.size(), ids.size() * static_cast<std::size_t>(count)) << "every name is there once";
  });
}

TEST(ArrayInRow, NamesAreCountedOn) {
  Document document = document_from_mesh(test::cube(), "Box").value();
  const ArrangedIds box{document.objects[0]->id};
  const auto three = test::must(array_in_row(document, box, 3, {2, 0, 0}));
  EXPECT_EQ(three->document.objects[1]->name, "Box 2");
  EXPECT_EQ(three->document.objects[2]->name, "Box 3");
  const auto more = test::must(array_in_row(three->document, std::span(three->ids).first(1), 3, {0, 2, 0}));
  EXPECT_EQ(more->document.find(more->ids[0])->name, "Box 4");
  EXPECT_EQ(more->document.find(more->ids[1])->name, "Box 5");
}

TEST(ArrayInRow, CopiesOfLockedObjectsAreFreeAndHiddenOnesStayHidden) {
  Document document = document_from_mesh(test::cube(), "Box").value();
  const ObjectId id = document.objects[0]->id;
  document = set_visible(*set_locked(document, id, true), id, false).value();
  const auto added = test::must(array_in_row(document, ArrangedIds{id, id}, 2, {2, 0, 0}));
  ASSERT_EQ(added->ids.size(), 1U) << "an object that is given twice counts once";
  EXPECT_FALSE(added->document.find(added->ids[0])->locked);
  EXPECT_FALSE(added->document.find(added->ids[0])->visible);
  EXPECT_TRUE(added->document.find(id)->locked);
}

TEST(ArrayInRow, TheLargestIsMade) {
  const Document document = document_from_mesh(test::cube(), "Box").value();
  const auto added = test::must(array_in_row(document, arranged_ids(document), most_places, {2, 0, 0}));
  EXPECT_EQ(added->document.objects.size(), std::size_t(most_places));
  EXPECT_EQ(added->document.objects.back()->name, "Box 10000");
  EXPECT_EQ(added->document.objects.back()->transform.translation.x(), 2.0 * (most_places - 1));
}

TEST(ArrayInRow, AttachedEdgesKeepCopiesOfTheirSides) {
  Document document = document_from_mesh(test::grid(1, 1), "Sheet").value();
  const ObjectId sheet = document.objects[0]->id;
  const BicubicNet net = [] {
    BicubicNet out{1, 1, {}};
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) out.points.emplace_back(-1 + 2 * i / 3.0, -1 - j / 3.0, 0);
    return out;
  }();
  const auto with_patch = add_object(document, "Patch", PatchSource::from_net(net).value()).value();
  const EdgeId edge{VertexId{0}, VertexId{1}};
  const auto side = nearest_side(with_patch.document, *with_patch.document.find(sheet), edge);
  ASSERT_TRUE(side);
  const auto joined = test::must(attach_edge(with_patch.document, sheet, edge, *side));
  const auto added = test::must(array_in_row(*joined, ArrangedIds{sheet}, 3, {0, 0, 5}));
  const auto one = test::must(duplicate_object(*joined, sheet));
  for (const ObjectId id : added->ids)
    EXPECT_TRUE(added->document.find(id)->source == one->document.find(one->id)->source)
        << "as a duplicate has them";
  EXPECT_TRUE(added->document.find(added->ids[0])->polyhedron()->attachments->find(edge)->frozen.has_value());
}

TEST(ArrayInRow, WhatCannotBeIsRefused) {
  const Document document = document_from_mesh(test::cube(), "Box").value();
  const ArrangedIds ids = arranged_ids(document);
  const Vector3 step(1, 0, 0);
  for (const int count : {-3, 0, 1, most_places + 1})
    expect_array_refused(array_in_row(document, ids, count, step), e_array_count);
  expect_array_refused(array_in_row(document, ids, 3, Vector3::Zero()), e_array_step);
  for (const double bad : {test::not_a_number, test::infinity})
    expect_array_refused(array_in_row(document, ids, 3, {0, bad, 0}), e_array_step);
  expect_array_refused(array_in_row(document, ids, 3, {1e308, 0, 0}), e_transform_invalid);
  expect_array_refused(array_in_row(document, {}, 3, step), e_no_objects);
  expect_array_refused(array_in_row(document, ArrangedIds{{77}}, 3, step), e_unknown_object);
  Document full = document;
  full.objects.resize(Document::max_objects - 1, full.objects[0]);
  expect_array_refused(array_in_row(full, ids, 3, step), e_too_many_objects);
}

Vector3 turned_about(const RingAxis& axis, double degrees, const Vector3& point) {
  const Eigen::AngleAxisd turn(degrees * 3.14159265358979323846 / 180, axis.direction.normalized());
  return axis.point + turn * (point - axis.point);
}

TEST(ArrayAroundAxis, AFullTurnReturnsOntoItself) {
  at_every_scale(502, [](std::mt19937_64& rng, double scale, const Vector3& far) {
    const Document before = arranged_document(rng, test::uniform_int(rng, 1, 3), scale, far);
    const RingAxis axis{test::random_vector(rng, 10 * scale) + far, test::random_vector(rng, 5)};
    const int count = test::uniform_int(rng, 2, 12);
    const double whole = test::chance(rng, 0.5) ? 360 : -360;
    const auto added = test::must(array_around_axis(before, arranged_ids(before), count, axis, whole));
    const double tolerance = 1e-12 * (largest_coordinate(added->document) + axis.point.norm());
    for (std::size_t i = 0; i < before.objects.size(); ++i)
      for (int k = 0; k < count; ++k) {
        const auto at = [&](int number) -> const Object& {
          return *added->document.objects[i * static_cast<std::size_t>(count) +
                                          static_cast<std::size_t>(number % count)];
        };
        const Vector3 local = test::random_vector(rng, scale);
        EXPECT_LE((turned_about(axis, whole / count, at(k).transform.apply(local)) -
                   at(k + 1).transform.apply(local))
                      .norm(),
                  20 * tolerance)
            << "the next of the last is the first";
      }
  });
}

TEST(ArrayAroundAxis, APartOfATurnHasCopiesAtBothEnds) {
  at_every_scale(503, [](std::mt19937_64& rng, double scale, const Vector3& far) {
    const Document before = arranged_document(rng, 1, scale, far);
    const RingAxis axis{test::random_vector(rng, 10 * scale) + far, test::random_vector(rng, 5)};
    const int count = test::uniform_int(rng, 2, 9);
    const double degrees = test::uniform(rng, -359, 359);
    const auto added = test::must(array_around_axis(before, arranged_ids(before), count, axis, degrees));
    const double tolerance = 20e-12 * (largest_coordinate(added->document) + axis.point.norm());
    const Vector3 local = test::random_vector(rng, scale);
    const Vector3 start = before.objects[0]->transform.apply(local);
    for (int k = 0; k < count; ++k)
      EXPECT_LE((turned_about(axis, degrees * k / (count - 1), start) -
                 added->document.objects[static_cast<std::size_t>(k)]->transform.apply(local))
                    .norm(),
                tolerance);
  });
}

TEST(ArrayAroundAxis, QuarterTurnsAreExact) {
  Similarity place{.translation = {3, 1, 7}};
  const auto box = add_object({}, "Box", PolyhedronSource::from_mesh(test::cube()).value(), place).value();
  const auto added = test::must(array_around_axis(box.document, ArrangedIds{box.id}, 4, {}, 360));
  EXPECT_EQ(added->document.objects[1]->transform.translation, Vector3(-1, 3, 7));
  EXPECT_EQ(added->document.objects[2]->transform.translation, Vector3(-3, -1, 7));
  EXPECT_EQ(added->document.objects[3]->transform.translation, Vector3(1, -3, 7));
}

TEST(ArrayAroundAxis, WhatCannotBeIsRefused) {
  const Document document = document_from_mesh(test::cube(), "Box").value();
  const ArrangedIds ids = arranged_ids(document);
  expect_array_refused(array_around_axis(document, ids, 1, {}, 360), e_array_count);
  expect_array_refused(array_around_axis(document, ids, most_places + 1, {}, 360), e_array_count);
  expect_array_refused(array_around_axis(document, ids, 3, {{0, 0, 0}, {0, 0, 0}}, 360), e_array_axis);
  for (const double bad : {test::not_a_number, test::infinity}) {
    expect_array_refused(array_around_axis(document, ids, 3, {{0, 0, 0}, {0, bad, 1}}, 360), e_array_axis);
    expect_array_refused(array_around_axis(document, ids, 3, {{bad, 0, 0}, {0, 0, 1}}, 360), e_array_axis);
    expect_array_refused(array_around_axis(document, ids, 3, {}, bad), e_array_angle);
  }
  for (const double degrees : {0.0, 360.001, -720.0})
    expect_array_refused(array_around_axis(document, ids, 3, {}, degrees), e_array_angle);
  expect_array_refused(array_around_axis(document, {}, 3, {}, 360), e_no_objects);
}

std::vector<SizedObject> with_world_boxes(const Document& document) {
  std::vector<SizedObject> out;
  for (const auto& object : document.objects) out.push_back({object->id, world_box(*object)});
  return out;
}

double box_side(const Eigen::AlignedBox3d& box, Axis axis, BoxSide side) {
  const Eigen::Index along = index_of(axis);
  return side == BoxSide::minimum   ? box.min()[along]
         : side == BoxSide::maximum ? box.max()[along]
                                    : (box.min()[along] + box.max()[along]) / 2;
}

TEST(AlignObjects, SidesOfAllBoxesAgree) {
  at_every_scale(504, [](std::mt19937_64& rng, double scale, const Vector3& far) {
    const Document before = arranged_document(rng, test::uniform_int(rng, 2, 6), scale, far);
    const std::size_t fixed = rng() % before.objects.size();
    for (const Axis axis : {Axis::x, Axis::y, Axis::z})
      for (const BoxSide side : {BoxSide::minimum, BoxSide::centre, BoxSide::maximum}) {
        const auto after =
            align_objects(before, with_world_boxes(before), before.objects[fixed]->id, axis, side);
        ASSERT_TRUE(after.ok()) << to_string(after.error());
        EXPECT_EQ(after->objects[fixed], before.objects[fixed]);
        const double tolerance = 1e-14 * largest_coordinate(before) + 1e-12 * scale;
        const double place = box_side(world_box(*before.objects[fixed]), axis, side);
        for (std::size_t i = 0; i < before.objects.size(); ++i) {
          EXPECT_NEAR(box_side(world_box(*after->objects[i]), axis, side), place, 8 * tolerance);
          Vector3 moved = after->objects[i]->transform.translation - before.objects[i]->transform.translation;
          moved[index_of(axis)] = 0;
          EXPECT_EQ(moved, Vector3(Vector3::Zero())) << "along the axis alone";
        }
      }
  });
}

TEST(DistributeObjects, GapsAreEqualAndTheEndsStay) {
  at_every_scale(505, [](std::mt19937_64& rng, double scale, const Vector3& far) {
    const Document before = arranged_document(rng, test::uniform_int(rng, 3, 8), scale, far);
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
      const auto after = test::must(distribute_objects(before, with_world_boxes(before), axis));
      std::vector<std::size_t> order(before.objects.size());
      for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
      std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return box_side(world_box(*before.objects[a]), axis, BoxSide::centre) <
               box_side(world_box(*before.objects[b]), axis, BoxSide::centre);
      });
      EXPECT_EQ(after->objects[order.front()], before.objects[order.front()]);
      EXPECT_EQ(after->objects[order.back()], before.objects[order.back()]);
      const auto gap = [&](std::size_t i) {
        return box_side(world_box(*after->objects[order[i + 1]]), axis, BoxSide::minimum) -
               box_side(world_box(*after->objects[order[i]]), axis, BoxSide::maximum);
      };
      const double tolerance = 1e-13 * largest_coordinate(before) + 1e-12 * scale;
      for (std::size_t i = 1; i + 1 < order.size(); ++i) EXPECT_NEAR(gap(i), gap(0), 8 * tolerance);
    }
  });
}

TEST(AlignObjects, WhatCannotBeIsRefused) {
  std::mt19937_64 rng(506);
  const Document three = arranged_document(rng, 3, 1, Vector3::Zero());
  const auto boxes = with_world_boxes(three);
  const auto code = [](const Result<Document>& result) {
    return result.ok() ? Code{"none"} : result.error().code;
  };
  const ObjectId first = boxes[0].id;
  EXPECT_EQ(code(align_objects(three, std::span(boxes).first(1), first, Axis::x, BoxSide::centre)),
            e_few_objects);
  EXPECT_EQ(code(distribute_objects(three, std::span(boxes).first(2), Axis::x)), e_few_objects);
  auto empty = boxes;
  empty[1].box = {};
  EXPECT_EQ(code(align_objects(three, empty, first, Axis::x, BoxSide::centre)), e_object_extent);
  EXPECT_EQ(code(distribute_objects(three, empty, Axis::x)), e_object_extent);
  auto unknown = boxes;
  unknown[2].id = {77};
  EXPECT_EQ(code(align_objects(three, unknown, first, Axis::x, BoxSide::centre)), e_unknown_object);
  const Document locked = set_locked(three, boxes[1].id, true).value();
  EXPECT_EQ(code(align_objects(locked, boxes, first, Axis::x, BoxSide::centre)), e_locked);
  const Document fixed = set_locked(three, first, true).value();
  EXPECT_TRUE(align_objects(fixed, boxes, first, Axis::x, BoxSide::centre).ok())
      << "what stays may be locked";
}

}  // namespace
}  // namespace hariko
