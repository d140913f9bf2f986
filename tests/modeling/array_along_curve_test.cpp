// Copies along curves: equal arc lengths, turns of rotation-minimising frames, and the curves of objects.

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "core/geometry/angles.hpp"
#include "core/modeling/objects/arrange.hpp"
#include "core/modeling/objects/object_curves.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "tests/modeling/support.hpp"

namespace hariko {
namespace {

constexpr double whole_turn = 2 * std::numbers::pi;

/// Calls run(rng, place, scale): sizes of 1 and 1e6, near zero and a million of units away, turned at will.
template <class Run>
void at_curve_scales(std::uint64_t seed, Run&& run) {
  for (const double scale : {1.0, 1e6})
    for (const bool far : {false, true}) {
      SCOPED_TRACE("scale " + std::to_string(scale) + (far ? ", far away" : ""));
      test::for_random(seed, 6, [&](std::mt19937_64& rng) {
        Similarity place;
        place.rotation = Eigen::AngleAxisd(test::uniform(rng, 0, 6), test::random_vector(rng).normalized());
        place.scale = scale;
        if (far) place.translation = test::random_vector(rng, 1e6);
        run(rng, place, scale);
      });
    }
}

ArcLengthCurve polygon_curve(const std::vector<Vector3>& points, bool closed) {
  std::vector<CurvePiece> pieces;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i)
    pieces.push_back(straight_piece(points[i], points[(i + 1) % points.size()]));
  return ArcLengthCurve::make(std::move(pieces), closed).value();
}

std::vector<Vector3> circle_polygon(int corners, const Similarity& place) {
  std::vector<Vector3> out;
  for (int i = 0; i < corners; ++i)
    out.push_back(place.apply({std::cos(i * whole_turn / corners), std::sin(i * whole_turn / corners), 0}));
  return out;
}

Object skin_with_path(std::vector<Vector3> points, bool closed, const Similarity& place = {}) {
  Skin skin;
  skin.path = {std::move(points), closed, {}};
  const auto added = add_object({}, "Skin", SkinSource{skin, {}}, place).value();
  return *added.document.find(added.id);
}

ArcLengthCurve path_curve(std::vector<Vector3> points, bool closed, const Similarity& place = {}) {
  ObjectCurve curve = curve_of_path(skin_with_path(std::move(points), closed, place)).value();
  return ArcLengthCurve::make(std::move(curve.pieces), curve.closed).value();
}

/// A box, and where a point of it lies after it is arrayed.
struct ArrayedBox {
  Document document = document_from_mesh(test::cube(), "Box").value();
  std::vector<ObjectId> ids{document.objects[0]->id};

  void put(const Similarity& place) { document = set_transform(document, ids[0], place).value(); }
  Result<AddedObjects> along(const ArcLengthCurve& curve, const CurveLayout& layout) const {
    return array_along_curve(document, ids, curve, layout);
  }
};

void expect_curve_refused(const Result<AddedObjects>& result, Code code) {
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, code) << to_string(result.error());
  EXPECT_FALSE(result.error().remedy.empty());
}

/// Angle of the rotation between two orthonormal frames.
double angle_of(const Matrix3& from, const Matrix3& to) {
  return Eigen::AngleAxisd(Eigen::Quaterniond(Matrix3(to * from.transpose()))).angle();
}

TEST(ArrayAlongCurve, PlacesOfACirclePolygonAreAtEqualArcLengths) {
  at_curve_scales(601, [](std::mt19937_64& rng, const Similarity& place, double scale) {
    const int corners = test::uniform_int(rng, 3, 40), count = test::uniform_int(rng, 2, 60);
    const auto polygon = circle_polygon(corners, place);
    const ArcLengthCurve curve = polygon_curve(polygon, true);
    const double side = 2 * std::sin(whole_turn / 2 / corners) * scale, whole = corners * side;
    const double tolerance = 1e-9 * whole + 4e-16 * place.translation.norm();
    EXPECT_NEAR(curve.length(), whole, tolerance);
    CurveLayout layout;
    layout.count = count;
    layout.offset = test::uniform(rng, -2, 2) * whole;
    layout.turning = CurveTurning::none;
    layout.carried = Vector3::Zero();
    ArrayedBox box;
    const auto added = test::must(box.along(curve, layout));
    ASSERT_EQ(added->document.objects.size(), std::size_t(count)) << "n distinct places, none doubled";
    for (int k = 0; k < count; ++k) {
      double way = std::fmod(layout.offset + k * whole / count, whole);
      if (way < 0) way += whole;
      const auto from = std::min(std::size_t(way / side), std::size_t(corners - 1));
      const Vector3 wanted = polygon[from] + (way / side - double(from)) *
                                                 (polygon[(from + 1) % polygon.size()] - polygon[from]);
      const Vector3 found = added->document.objects[std::size_t(k)]->transform.translation;
      EXPECT_LE((found - wanted).norm(), tolerance) << k;
      for (int other = 0; other < k; ++other)
        EXPECT_GT((added->document.objects[std::size_t(other)]->transform.translation - found).norm(),
                  1e-3 * whole / count)
            << k << ", " << other;
    }
  });
}

TEST(ArrayAlongCurve, OnAStraightLineItIsTheRow) {
  at_curve_scales(602, [](std::mt19937_64& rng, const Similarity& place, double scale) {
    const Vector3 from = place.apply(test::random_vector(rng)),
                  to = from + place.apply_to_vector(test::random_vector(rng) + Vector3(3, 0, 0));
    // The line in one piece or in several.
    std::vector<Vector3> points{from};
    const int parts = test::uniform_int(rng, 1, 5);
    for (int i = 1; i < parts; ++i) points.push_back(from + i * (to - from) / parts);
    points.push_back(to);
    ArrayedBox box;
    Similarity at = place;
    at.scale = test::log_uniform(rng, 0.1, 10);
    at.translation += test::random_vector(rng, 10 * scale);
    box.put(at);
    CurveLayout layout;
    layout.count = test::uniform_int(rng, 2, 30);
    layout.turning = CurveTurning(test::uniform_int(rng, 0, 2));
    const auto row = array_in_row(box.document, box.ids, layout.count, (to - from) / (layout.count - 1));
    const auto line = box.along(polygon_curve(points, false), layout);
    ASSERT_TRUE(row.ok() && line.ok());
    ASSERT_EQ(row->document.objects.size(), line->document.objects.size());
    for (std::size_t i = 0; i < row->document.objects.size(); ++i) {
      const Object &wanted = *row->document.objects[i], &found = *line->document.objects[i];
      const double size = wanted.transform.translation.norm() + from.norm() + to.norm();
      EXPECT_LE((found.transform.translation - wanted.transform.translation).norm(), 1e-12 * size);
      EXPECT_LE((found.transform.rotation.coeffs() - wanted.transform.rotation.coeffs()).norm(), 2e-8)
          << "several pieces in line turn it by rounding alone";
      EXPECT_EQ(found.transform.scale, wanted.transform.scale);
      EXPECT_EQ(found.name, wanted.name);
    }
  });
}

TEST(ArrayAlongCurve, FramesAreRotationsAndTheLastOfAClosedCurveIsTheFirst) {
  at_curve_scales(603, [](std::mt19937_64& rng, const Similarity& place, double) {
    const bool closed = test::chance(rng, 0.5), smooth = test::chance(rng, 0.5);
    std::vector<Vector3> points;
    for (int i = test::uniform_int(rng, 4, 9); i > 0; --i) points.push_back(test::random_vector(rng, 3));
    if (!smooth)
      for (Vector3& point : points) point = place.apply(point);
    const ArcLengthCurve curve = smooth ? path_curve(points, closed, place) : polygon_curve(points, closed);
    for (int i = 0; i <= 50; ++i) {
      const Matrix3 frame = curve.at(i * curve.length() / 50).frame;
      EXPECT_NEAR(frame.determinant(), 1, 1e-12);
      EXPECT_LE((frame * frame.transpose() - Matrix3::Identity()).norm(), 1e-12);
    }
    if (!closed) return;
    // The frame goes over the beginning as over any corner: turned no more than the tangent.
    const Matrix3 begin = curve.at(1e-7 * curve.length()).frame, end = curve.at(-1e-7 * curve.length()).frame;
    EXPECT_NEAR(angle_of(end, begin), angle_between(end.col(2), begin.col(2)), 1e-4);
    EXPECT_LE(angle_of(curve.at(0).frame, curve.at(curve.length()).frame), 1e-7);
  });
}

TEST(ArrayAlongCurve, CopiesDoNotFlipWhereACurveBendsTheOtherWay) {
  at_curve_scales(604, [](std::mt19937_64& rng, const Similarity& place, double) {
    const double height = test::uniform(rng, 0.3, 2);
    const ArcLengthCurve curve = path_curve(
        {{0, 0, 0}, {1, height, 0}, {2, 0, 0}, {3, -height, 0}, {4, 0, 0}, {5, height, 0}}, false, place);
    const Vector3 normal = place.rotation * Vector3::UnitZ();
    const Matrix3 first = curve.at(0).frame;
    Matrix3 before = first;
    for (int i = 1; i <= 200; ++i) {
      const Matrix3 frame = curve.at(i * curve.length() / 200).frame;
      EXPECT_LE((frame * first.transpose() * normal - normal).norm(), 1e-7) << "it turns in the plane alone";
      EXPECT_LT(angle_of(before, frame), 0.2) << i;
      before = frame;
    }
  });
}

/// The frame of a helix turns against that of Frenet by its torsion.
TEST(ArrayAlongCurve, FramesOfAHelixAreRotationMinimising) {
  static constexpr double radius = 2, rise = 0.7, turns = 1.5;
  const double speed = std::hypot(radius, rise), torsion = rise / (speed * speed);
  const CurvePiece helix = [](double x) -> CurveSample {
    const double t = turns * whole_turn * x;
    return {{radius * std::cos(t), radius * std::sin(t), rise * t},
            turns * whole_turn * Vector3(-radius * std::sin(t), radius * std::cos(t), rise)};
  };
  const ArcLengthCurve curve = ArcLengthCurve::make({helix}, false).value();
  EXPECT_NEAR(curve.length(), turns * whole_turn * speed, 1e-9);
  const auto angle_to_normal = [&](double way) {
    const double t = way / speed;
    const Vector3 normal(-std::cos(t), -std::sin(t), 0);
    const Matrix3 frame = curve.at(way).frame;
    return std::atan2(normal.dot(frame.col(1)), normal.dot(frame.col(0)));
  };
  for (int i = 0; i <= 40; ++i) {
    const double way = i * curve.length() / 40;
    const double t = way / speed;
    EXPECT_LE((curve.at(way).position - Vector3(radius * std::cos(t), radius * std::sin(t), rise * t)).norm(),
              1e-9);
    EXPECT_NEAR(std::remainder(angle_to_normal(way) - angle_to_normal(0) - torsion * way, whole_turn), 0,
                2e-4);
  }
}

TEST(ArrayAlongCurve, CopiesStandToTheCurveAsTheOriginalDoes) {
  at_curve_scales(605, [](std::mt19937_64& rng, const Similarity& place, double scale) {
    const int corners = 12;
    const ArcLengthCurve curve = polygon_curve(circle_polygon(corners, place), true);
    ArrayedBox box;
    Similarity at = place;
    at.scale = 1;
    at.translation += test::random_vector(rng, 3 * scale);
    box.put(at);
    CurveLayout layout;
    layout.count = corners;
    const auto added = test::must(box.along(curve, layout));
    EXPECT_EQ(added->document.objects[0], box.document.objects[0]) << "the original stays";
    for (int k = 1; k < corners; ++k) {
      const Eigen::AngleAxisd turn(k * whole_turn / corners, place.rotation * Vector3::UnitZ());
      const Vector3 wanted = place.translation + turn * (at.translation - place.translation);
      const Similarity& found = added->document.objects[std::size_t(k)]->transform;
      EXPECT_LE((found.translation - wanted).norm(), 1e-7 * scale + 1e-14 * wanted.norm())
          << "a ring about the middle";
      EXPECT_LT(found.rotation.angularDistance(turn * at.rotation), 1e-7);
    }
  });
}

TEST(ArrayAlongCurve, UprightCopiesTurnAboutTheVerticalAlone) {
  const ArcLengthCurve curve = path_curve({{0, 0, 0}, {2, 0, 1}, {4, 2, 3}, {4, 5, 1}, {1, 6, 0}}, false);
  ArrayedBox box;
  CurveLayout layout{.count = 9, .turning = CurveTurning::upright};
  const auto added = test::must(box.along(curve, layout));
  const auto heading = [&](double way) {
    const Vector3 tangent = curve.at(way).frame.col(2);
    return std::atan2(tangent.y(), tangent.x());
  };
  for (int k = 0; k < layout.count; ++k) {
    const auto& rotation = added->document.objects[std::size_t(k)]->transform.rotation;
    EXPECT_LE((rotation * Vector3::UnitZ() - Vector3::UnitZ()).norm(), 1e-14);
    const Vector3 x = rotation * Vector3::UnitX();
    const double turned = heading(k * curve.length() / 8) - heading(0);
    EXPECT_NEAR(std::remainder(std::atan2(x.y(), x.x()) - turned, whole_turn), 0, 1e-12);
  }
  // A post that goes straight up first has no direction there.
  const auto bent = box.along(polygon_curve({{0, 0, 0}, {0, 0, 3}, {0, 3, 3}, {-3, 3, 3}}, false), layout);
  ASSERT_TRUE(bent.ok());
  EXPECT_EQ(bent->document.objects[1]->transform.rotation.coeffs(), Eigen::Quaterniond::Identity().coeffs());
  EXPECT_LE((bent->document.objects[8]->transform.rotation * Vector3::UnitX() - Vector3::UnitY()).norm(),
            1e-12);
}

TEST(ArrayAlongCurve, ASpacingGivesAsManyAsThereIsRoomFor) {
  const ArcLengthCurve line = polygon_curve({{0, 0, 0}, {10, 0, 0}}, false),
                       square = polygon_curve({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, true);
  const auto count = [](const ArcLengthCurve& curve, double spacing, double offset) {
    return ways_along(curve, {.spacing = spacing, .offset = offset}).value().size();
  };
  EXPECT_EQ(count(line, 2, 0), 6U) << "both ends";
  EXPECT_EQ(count(line, 0.1, 0), 101U);
  EXPECT_EQ(count(line, 3, 0), 4U);
  EXPECT_EQ(count(line, 2, 1), 5U);
  EXPECT_EQ(count(square, 4, 0), 10U) << "the beginning is not there twice";
  EXPECT_EQ(count(square, 0.1, 7), 400U);
  EXPECT_EQ(count(square, 6, -3), 7U);
  EXPECT_EQ(ways_along(line, {.count = 5, .offset = 2}).value(), (std::vector<double>{2, 4, 6, 8, 10}));
}

TEST(ArrayAlongCurve, APointOfTheObjectsIsCarriedOntoTheCurve) {
  ArrayedBox box;
  Similarity at{.translation = {50, 60, 70}};
  box.put(at);
  const ArcLengthCurve curve = polygon_curve({{1, 2, 3}, {5, 2, 3}, {5, 8, 3}}, false);
  CurveLayout layout{.count = 3};
  layout.carried = Vector3(50, 60, 69);
  const auto added = test::must(box.along(curve, layout));
  const auto point = [&](std::size_t i) { return added->document.objects[i]->transform.apply({0, 0, -1}); };
  EXPECT_LE((point(0) - Vector3(1, 2, 3)).norm(), 1e-12) << "the original is moved";
  EXPECT_LE((point(1) - Vector3(5, 3, 3)).norm(), 1e-12);
  EXPECT_LE((point(2) - Vector3(5, 8, 3)).norm(), 1e-12);
  box.document = set_locked(box.document, box.ids[0], true).value();
  expect_curve_refused(box.along(curve, layout), e_locked);
  layout.carried.reset();
  EXPECT_TRUE(box.along(curve, layout).ok()) << "copies of what is locked are free";
}

TEST(ArrayAlongCurve, WhatCannotBeIsRefused) {
  ArrayedBox box;
  const ArcLengthCurve line = polygon_curve({{0, 0, 0}, {10, 0, 0}}, false),
                       triangle = polygon_curve({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, true);
  for (const int count : {-1, 0, 1, most_places + 1})
    expect_curve_refused(box.along(line, {.count = count}), e_array_count);
  for (const double spacing : {0.0, -1.0, test::not_a_number, test::infinity, 1e-6})
    expect_curve_refused(box.along(line, {.spacing = spacing}), e_array_spacing);
  for (const double offset : {-0.1, test::not_a_number, test::infinity})
    expect_curve_refused(box.along(line, {.offset = offset}), e_array_offset);
  for (const double offset : {10.0, 11.0})
    expect_curve_refused(box.along(line, {.offset = offset}), e_curve_short);
  expect_curve_refused(box.along(line, {.spacing = 10.1}), e_curve_short);
  expect_curve_refused(box.along(line, {.spacing = 6, .offset = 5}), e_curve_short);
  expect_curve_refused(box.along(triangle, {.spacing = 4}), e_curve_short);
  expect_curve_refused(array_along_curve(box.document, {}, line, {}), e_no_objects);
  const std::vector<ObjectId> unknown{{77}};
  expect_curve_refused(array_along_curve(box.document, unknown, line, {}), e_unknown_object);
  EXPECT_EQ(ArcLengthCurve::make({}, false).error().code, e_curve_length);
  EXPECT_EQ(ArcLengthCurve::make({straight_piece({1, 2, 3}, {1, 2, 3})}, false).error().code, e_curve_length);
}

Vector3 place_on(const ObjectCurve& curve, std::size_t piece, double x) {
  return curve.pieces[piece](x).position;
}

TEST(ObjectCurves, EdgesAreFollowedFromTheEndWithTheLowerVertex) {
  const Document document = document_from_mesh(test::cube(), "Box").value();
  const Object& box = *document.objects[0];
  const Polyhedron& cage = *box.cage();
  const std::vector<EdgeId> open{test::edge(1, 2), test::edge(3, 2), test::edge(0, 1)};
  const ObjectCurve chain = curve_of_edges(box, open, nullptr).value();
  EXPECT_FALSE(chain.closed);
  ASSERT_EQ(chain.pieces.size(), 3U);
  for (Index v = 0; v < 3; ++v) {
    EXPECT_EQ(place_on(chain, v, 0), cage.position(v));
    EXPECT_LE((place_on(chain, v, 1) - cage.position(v + 1)).norm(), 1e-15);
  }
  const std::vector<EdgeId> loop{test::edge(2, 3), test::edge(1, 2), test::edge(0, 3), test::edge(0, 1)};
  const ObjectCurve closed = curve_of_edges(box, loop, nullptr).value();
  EXPECT_TRUE(closed.closed);
  ASSERT_EQ(closed.pieces.size(), 4U);
  const auto back = run_backward(closed.pieces);
  EXPECT_LE((back[0](0).position - place_on(closed, 0, 0)).norm(), 1e-15) << "the beginning stays";
  EXPECT_LE((back[0](1).position - place_on(closed, 3, 0)).norm(), 1e-15);
  EXPECT_EQ(back[1](0.25).along, Vector3(-closed.pieces[2](0.75).along));
}

TEST(ObjectCurves, EdgesThatAreNoChainAreRefused) {
  const Document document = document_from_mesh(test::cube(), "Box").value();
  const Object& box = *document.objects[0];
  const auto code = [&](const std::vector<EdgeId>& edges) {
    const auto curve = curve_of_edges(box, edges, nullptr);
    return curve ? Code{"none"} : curve.error().code;
  };
  EXPECT_EQ(code({}), e_edge_chain);
  EXPECT_EQ(code({test::edge(0, 6)}), e_edge_chain) << "no edge of the box";
  EXPECT_EQ(code({test::edge(0, 1), test::edge(2, 3)}), e_edge_chain) << "two chains";
  EXPECT_EQ(code({test::edge(0, 1), test::edge(0, 3), test::edge(0, 4)}), e_edge_chain) << "a branch";
  EXPECT_EQ(code({test::edge(0, 1), test::edge(1, 2), test::edge(2, 3), test::edge(3, 0), test::edge(4, 5)}),
            e_edge_chain)
      << "a loop and an edge";
}

TEST(ObjectCurves, OverASurfaceEdgesAreItsCurves) {
  test::for_random(606, 10, [](std::mt19937_64& rng) {
    Document document = document_from_mesh(test::cube(), "Box").value();
    Similarity place;
    place.rotation = Eigen::AngleAxisd(test::uniform(rng, 0, 3), test::random_vector(rng).normalized());
    place.scale = test::log_uniform(rng, 1e-2, 1e6);
    place.translation = test::random_vector(rng, 1e6);
    document = set_transform(document, document.objects[0]->id, place).value();
    const Object& box = *document.objects[0];
    const Surface surface = object_surface(document, box).value().surface;
    const std::vector<EdgeId> loop{test::edge(0, 1), test::edge(1, 2), test::edge(2, 3), test::edge(0, 3)};
    const ObjectCurve curve = curve_of_edges(box, loop, &surface).value();
    const ObjectCurve straight = curve_of_edges(box, loop, nullptr).value();
    ASSERT_EQ(curve.pieces.size(), 4U);
    const double tolerance = 1e-9 * (place.scale + place.translation.norm());
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LE((place_on(curve, i, 1) - place_on(curve, (i + 1) % 4, 0)).norm(), tolerance);
      EXPECT_LE((place_on(curve, i, 0) - place_on(straight, i, 0)).norm(), tolerance);
      EXPECT_GT((place_on(curve, i, 0.5) - place_on(straight, i, 0.5)).norm(), 0.1 * place.scale)
          << "the curve bulges out";
      const double h = 1e-4;
      const Vector3 difference = (place_on(curve, i, 0.4 + h) - place_on(curve, i, 0.4 - h)) / (2 * h);
      EXPECT_LE((curve.pieces[i](0.4).along - difference).norm(), 1e-6 * place.scale + 1e4 * 1e-9 * 1e3);
    }
    const double length = ArcLengthCurve::make(curve.pieces, true)->length();
    EXPECT_GT(length, 8 * place.scale);
    EXPECT_LT(length, 16 * place.scale);
  });
}

TEST(ObjectCurves, LoopsOfOutlinesAreSmoothAndClosed) {
  OutlineSource source;
  Outline outline;
  outline.loops.emplace_back();
  constexpr int points = 48;
  for (int i = 0; i < points; ++i) {
    const double angle = i * whole_turn / points;
    outline.loops[0].points.emplace_back(std::cos(angle), std::sin(angle), 0);
    outline.loops[0].normals.emplace_back(std::cos(angle), std::sin(angle), 0.2);
  }
  source.outline = outline;
  const auto added = add_object({}, "Loop", source).value();
  const ObjectCurve loop = curve_of_loop(*added.document.find(added.id), 0).value();
  const ArcLengthCurve curve = ArcLengthCurve::make(loop.pieces, loop.closed).value();
  EXPECT_TRUE(curve.closed());
  EXPECT_NEAR(curve.length(), whole_turn, 1e-4);
  for (int i = 0; i < 30; ++i) {
    const auto place = curve.at(i * curve.length() / 30);
    EXPECT_NEAR(place.position.norm(), 1, 1e-4);
    EXPECT_NEAR(place.frame.col(2).dot(place.position), 0, 5e-3);
  }
}

TEST(ObjectCurves, APathOfOnePointIsUnfinished) {
  EXPECT_EQ(curve_of_path(skin_with_path({{0, 0, 0}}, false)).error().code, e_unfinished_curve);
  const Object bent = skin_with_path({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, false);
  const ObjectCurve path = curve_of_path(bent).value();
  EXPECT_EQ(place_on(path, 0, 0), Vector3(0, 0, 0));
  EXPECT_EQ(place_on(path, 1, 1), Vector3(1, 1, 0));
}

TEST(ObjectCurves, APointTellsWhichOfTheDrawnCurvesItBelongsTo) {
  OutlineSource source;
  Outline outline;
  for (const double shift : {0.0, 5.0}) {
    OutlineLoop& loop = outline.loops.emplace_back();
    for (const Vector3& corner : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0)}) {
      loop.points.push_back(corner + Vector3(shift, 0, 0));
      loop.normals.emplace_back(0, 0, 1);
    }
  }
  source.outline = outline;
  const auto added = add_object({}, "Loops", source).value();
  const Object& loops = *added.document.find(added.id);
  EXPECT_EQ(drawn_curve_count(loops).value_or(0), 2U);
  EXPECT_EQ(drawn_curve_at(loops, VertexId{2}).value_or(9), 0U);
  EXPECT_EQ(drawn_curve_at(loops, VertexId{3}).value_or(9), 1U);
  EXPECT_FALSE(drawn_curve_at(loops, VertexId{6}).has_value());
  EXPECT_EQ(place_on(drawn_curve_of(loops, 1).value(), 0, 0), Vector3(5, 0, 0));
  const Object skin = skin_with_path({{0, 0, 0}, {1, 0, 0}}, false);
  EXPECT_EQ(drawn_curve_count(skin).value_or(0), 1U);
  EXPECT_EQ(drawn_curve_at(skin, VertexId{7}).value_or(9), 0U);
  EXPECT_EQ(place_on(drawn_curve_of(skin, 0).value(), 0, 0), Vector3(0, 0, 0));
}

}  // namespace
}  // namespace hariko
