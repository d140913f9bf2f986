// Places on curves: feet, points of tangency and crossings by their definitions, on circles, lines and
// polygons at random places.

#include "core/geometry/curve_places.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/polygon.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

Vector3 point_within(std::mt19937_64& rng, double size) {
  return {size * uniform(rng, -1, 1), size * uniform(rng, -1, 1), size * uniform(rng, -1, 1)};
}

Matrix3 random_axes(std::mt19937_64& rng) {
  Eigen::Quaterniond q(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, 0.1, 1));
  return q.normalized().toRotationMatrix();
}

/// A circle by points at uneven distances.
struct Circle {
  Vector3 centre;
  Matrix3 axes;
  double radius;
  int count;
  SampledCurve curve;

  /// Largest error of a place, of the radius: of third order in the distance of the points.
  double tolerance() const { return 0.6 * std::pow(2 * std::numbers::pi / count, 3); }
  Vector3 at(double x, double y) const { return centre + axes * Vector3(x, y, 0); }
};

Circle random_circle(std::mt19937_64& rng) {
  Circle out{point_within(rng, 100), random_axes(rng), uniform(rng, 0.1, 50), uniform_int(rng, 24, 120), {}};
  out.curve.closed = true;
  const double begin = uniform(rng, 0, 7);
  for (int i = 0; i < out.count; ++i) {
    const double angle = begin + 2 * std::numbers::pi * (i + uniform(rng, -0.3, 0.3)) / out.count;
    out.curve.points.push_back(out.at(out.radius * std::cos(angle), out.radius * std::sin(angle)));
  }
  return out;
}

TEST(CurvePlaces, FeetOnACircleAreItsNearestAndItsFarthestPoint) {
  for_random(4201, 300, [](std::mt19937_64& rng) {
    const Circle circle = random_circle(rng);
    const double angle = uniform(rng, 0, 7), way = circle.radius * uniform(rng, 1.1, 6);
    const Vector3 from = circle.at(way * std::cos(angle), way * std::sin(angle));
    const std::vector<Vector3> feet = perpendicular_feet(circle.curve, from);
    ASSERT_EQ(feet.size(), 2U);
    const Vector3 towards = (from - circle.centre).normalized();
    for (const double side : {1.0, -1.0}) {
      const Vector3 wanted = circle.centre + side * circle.radius * towards;
      const double error = std::min((feet[0] - wanted).norm(), (feet[1] - wanted).norm());
      EXPECT_LT(error, circle.tolerance() * circle.radius);
    }
  });
}

TEST(CurvePlaces, EveryPointOfACircleIsAtRightAnglesFromItsCentreSoNoneIsTaken) {
  for_random(4202, 50, [](std::mt19937_64& rng) {
    SampledCurve curve;
    curve.closed = true;
    const int count = uniform_int(rng, 24, 200);
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      curve.points.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    EXPECT_TRUE(perpendicular_feet(curve, Vector3::Zero()).empty());
  });
}

TEST(CurvePlaces, TangentsOfACircleAreAtRightAnglesToItsRadii) {
  for_random(4203, 300, [](std::mt19937_64& rng) {
    const Circle circle = random_circle(rng);
    const double angle = uniform(rng, 0, 7), way = circle.radius * uniform(rng, 1.2, 6);
    const Vector3 from = circle.at(way * std::cos(angle), way * std::sin(angle));
    const std::vector<Vector3> places = tangent_places(circle.curve, from, circle.axes.col(2));
    ASSERT_EQ(places.size(), 2U);
    for (const Vector3& place : places) {
      const Vector3 radius = place - circle.centre, line = place - from;
      EXPECT_NEAR(radius.norm(), circle.radius, circle.tolerance() * circle.radius);
      EXPECT_NEAR(radius.dot(line) / (radius.norm() * line.norm()), 0, circle.tolerance());
    }
    EXPECT_GT((places[0] - places[1]).norm(), 0.1 * circle.radius) << "one on each side";
    EXPECT_TRUE(tangent_places(circle.curve, circle.centre, circle.axes.col(2)).empty()) << "from inside";
  });
}

TEST(CurvePlaces, TheFootOnAStraightLineIsExact) {
  for_random(4204, 500, [](std::mt19937_64& rng) {
    const Vector3 a = point_within(rng, 1000), along = point_within(rng, 10);
    const double share = uniform(rng, 0.02, 0.98);
    const Vector3 foot = a + share * along;
    const Vector3 from = foot + uniform(rng, 0.5, 100) * along.cross(point_within(rng, 1)).normalized();
    SampledCurve line;
    for (const double s : {0.0, uniform(rng, 0.1, 0.4), uniform(rng, 0.5, 0.9), 1.0})
      line.points.push_back(a + s * along);
    const std::vector<Vector3> feet = perpendicular_feet(line, from);
    ASSERT_EQ(feet.size(), 1U);
    EXPECT_LT((feet[0] - foot).norm(), 1e-9 * 1000);
    EXPECT_TRUE(tangent_places(line, from, along.cross(from - a)).empty()) << "a line is touched nowhere";
    EXPECT_TRUE(perpendicular_feet(line, from + 3 * along).empty()) << "beyond its end";
  });
}

TEST(CurvePlaces, APlaceWhereTheGestureBeganIsNoFoot) {
  const SampledCurve line{{{0, 0, 0}, {10, 0, 0}}, false};
  EXPECT_TRUE(perpendicular_feet(line, {4, 0, 0}).empty());
  EXPECT_EQ(perpendicular_feet(line, {4, 1, 0}).size(), 1U);
}

TEST(CurvePlaces, CornersStayStraightSidesBesideThem) {
  const SampledCurve square{{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, true};
  const std::vector<Vector3> feet = perpendicular_feet(square, {3, 4, 0});
  ASSERT_EQ(feet.size(), 4U);
  for (const Vector3& wanted : {Vector3(3, 0, 0), Vector3(10, 4, 0), Vector3(3, 10, 0), Vector3(0, 4, 0)})
    EXPECT_TRUE(std::any_of(feet.begin(), feet.end(), [&](const Vector3& foot) {
      return (foot - wanted).norm() < 1e-12;
    })) << wanted.transpose();
  EXPECT_LT((point_of(square, 3, 0.25) - Vector3(0, 7.5, 0)).norm(), 1e-12) << "the closing side";
  EXPECT_LT((derivative_of(square, 3, 0.25) - Vector3(0, -10, 0)).norm(), 1e-12);
}

TEST(CurvePlaces, SegmentsCrossWhereBothAre) {
  for_random(4205, 2000, [](std::mt19937_64& rng) {
    const auto point = [&] { return Vector2(uniform(rng, -9, 9), uniform(rng, -9, 9)); };
    const Vector2 a = point(), b = point(), c = point(), d = point();
    const auto side = [](const Vector2& p, const Vector2& q, const Vector2& r) {
      return twice_area(p, q, r);
    };
    const bool wanted = side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
    const auto shares = where_segments_cross(a, b, c, d);
    ASSERT_EQ(shares.has_value(), wanted);
    if (!shares) return;
    const Vector2 on_first = a + shares->x() * (b - a), on_second = c + shares->y() * (d - c);
    EXPECT_LT((on_first - on_second).norm(), 1e-8);
    EXPECT_TRUE(where_segments_cross(a, on_first, c, d)) << "the end belongs to it";
    EXPECT_FALSE(where_segments_cross(a, b, Vector2(a + Vector2(1, 1)), Vector2(b + Vector2(1, 1))));
  });
}

TEST(LengthsAlong, AddUpTheSidesAndCloseTheRing) {
  const std::vector<Vector3> points{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}};
  EXPECT_EQ(lengths_along(points), (std::vector<double>{0, 3, 7}));
  EXPECT_EQ(lengths_along(points, true), (std::vector<double>{0, 3, 7, 12}));
  EXPECT_EQ(lengths_along({}), std::vector<double>{0});
}

TEST(PolygonCentre, IsThatOfTheAreaWhereverThePolygonLies) {
  for_random(4206, 300, [](std::mt19937_64& rng) {
    const Matrix3 axes = random_axes(rng);
    const Vector3 zero = point_within(rng, 1000);
    const double w = uniform(rng, 1, 9), h = uniform(rng, 1, 9), u = w * uniform(rng, 0.1, 0.9),
                 v = h * uniform(rng, 0.1, 0.9);
    // An L: a rectangle less one of its corners.
    std::vector<Vector3> corners;
    for (const Vector2& p :
         {Vector2(0, 0), Vector2(w, 0), Vector2(w, v), Vector2(u, v), Vector2(u, h), Vector2(0, h)})
      corners.push_back(zero + axes * Vector3(p.x(), p.y(), 0));
    std::rotate(corners.begin(), corners.begin() + uniform_int(rng, 0, 5), corners.end());
    const double whole = w * h, missing = (w - u) * (h - v);
    const Vector2 centre =
        (whole * Vector2(w / 2, h / 2) - missing * Vector2((u + w) / 2, (v + h) / 2)) / (whole - missing);
    EXPECT_LT((polygon_centre(corners) - (zero + axes * Vector3(centre.x(), centre.y(), 0))).norm(), 1e-9);
  });
  const std::vector<Vector3> line{{0, 0, 0}, {1, 0, 0}, {5, 0, 0}};
  EXPECT_LT((polygon_centre(line) - Vector3(2, 0, 0)).norm(), 1e-15) << "without area the mean";
}

}  // namespace
}  // namespace hariko::test
