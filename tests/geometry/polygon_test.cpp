#include "core/geometry/polygon.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

std::vector<Vector3> random_polygon(std::mt19937_64& rng) {
  std::vector<Vector3> out;
  for (int i = uniform_int(rng, 4, 12); i > 0; --i) out.emplace_back(uniform(rng), uniform(rng), 0);
  return out;
}

/// A polygon that goes once round its centre at random radii: never crosses itself, often concave.
std::vector<Vector3> star_shaped(std::mt19937_64& rng) {
  std::vector<Vector3> out;
  const int n = uniform_int(rng, 4, 12);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * (i + uniform(rng, -0.3, 0.3)) / n,
                 radius = uniform(rng, 0.2, 1);
    out.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return out;
}

double turn(const Vector3& a, const Vector3& b, const Vector3& c) {
  return (b - a).cross(c - b).z();
}

bool crosses_by_definition(const std::vector<Vector3>& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if ((j + 1) % n == i) continue;
      const Vector3 &a = p[i], &b = p[i + 1], &c = p[j], &d = p[(j + 1) % n];
      if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return true;
    }
  return false;
}

TEST(FaceShape, AgreesWithTheDefinition) {
  int counts[3] = {};
  for_random(811, 3000, [&](std::mt19937_64& rng) {
    const std::vector<Vector3> p = chance(rng, 0.5) ? star_shaped(rng) : random_polygon(rng);
    FaceShape expected = FaceShape::convex;
    const double sign = newell_normal(p).z() > 0 ? 1 : -1;
    for (std::size_t i = 0; i < p.size(); ++i)
      if (sign * turn(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]) < -1e-4 * newell_normal(p).norm())
        expected = FaceShape::concave;
    if (crosses_by_definition(p)) expected = FaceShape::self_crossing;
    EXPECT_EQ(classify_face(p), expected);
    ++counts[static_cast<int>(expected)];
  });
  for (int count : counts) EXPECT_GT(count, 0);
}

TEST(FaceShape, DependsNeitherOnPlaceNorOnFirstCornerNorOnDirection) {
  for_random(812, 1000, [](std::mt19937_64& rng) {
    std::vector<Vector3> p = chance(rng, 0.5) ? star_shaped(rng) : random_polygon(rng);
    const FaceShape shape = classify_face(p);
    std::rotate(p.begin(), p.begin() + uniform_int(rng, 0, static_cast<int>(p.size()) - 1), p.end());
    EXPECT_EQ(classify_face(p), shape);
    std::reverse(p.begin(), p.end());
    EXPECT_EQ(classify_face(p), shape);
    const Eigen::Quaterniond turned =
        Eigen::Quaterniond(uniform(rng, -1, 1), uniform(rng, -1, 1), 0.5, 0.1).normalized();
    const Vector3 shift = random_vector(rng, 1e3);
    for (Vector3& q : p) q = turned * q * 100 + shift;
    EXPECT_EQ(classify_face(p), shape);
  });
}

TEST(FaceShape, NewellNormalIsTwiceTheArea) {
  for (int n : {3, 5, 20}) {
    std::vector<Vector3> p;
    for (int i = 0; i < n; ++i)
      p.emplace_back(1e6 + std::cos(2 * std::numbers::pi * i / n),
                     1e6 + std::sin(2 * std::numbers::pi * i / n), 7);
    const Vector3 normal = newell_normal(p);
    EXPECT_NEAR(normal.z(), n * std::sin(2 * std::numbers::pi / n), 1e-8);
    EXPECT_NEAR(normal.head<2>().norm(), 0, 1e-8);
  }
}

TEST(FaceShape, TrianglesAndPointsAreConvex) {
  EXPECT_EQ(classify_face(std::vector<Vector3>(4, Vector3::Ones())), FaceShape::convex);
  EXPECT_EQ(classify_face(std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), FaceShape::convex);
}

TEST(FaceShape, LargeFacesTakeBoundedTime) {
  // Combs of 100,000 teeth along x and along y: every side overlaps with all the others in one coordinate.
  for (int axis : {0, 1}) {
    std::vector<Vector3> comb;
    for (int i = 0; i < 200000; ++i) {
      Vector3 p(i, i % 2 ? 1e4 : 1, 0);
      if (axis == 1) std::swap(p.x(), p.y());
      comb.push_back(p);
    }
    comb.emplace_back(axis == 0 ? Vector3(200000, -1, 0) : Vector3(-1, 200000, 0));
    comb.emplace_back(-1, -1, 0);
    EXPECT_NE(classify_face(comb), FaceShape::self_crossing);
  }
}

TEST(Polygon, NewellNormalIsTwiceTheAreaAndTheSameWhereverThePolygonLies) {
  for_random(4471, 200, [](std::mt19937_64& rng) {
    const std::vector<Vector3> corners = random_polygon(rng);
    std::vector<Vector2> flat;
    std::vector<Vector3> moved;
    for (const Vector3& p : corners) {
      flat.push_back(p.head<2>());
      moved.push_back(p + Vector3(1 << 20, -(1 << 21), 1 << 19));  // rounds p to 2^-32
    }
    const Vector3 normal = newell_normal(corners);
    EXPECT_NEAR(normal.z(), twice_area(flat), 1e-13);
    EXPECT_EQ(normal.x(), 0);
    EXPECT_EQ(normal.y(), 0);
    EXPECT_LE((newell_normal(moved) - normal).norm(), 1e-7);
    const auto at = [&](std::size_t i) { return corners[i]; };
    EXPECT_EQ(newell_normal(corners.size(), at), normal);
  });
  EXPECT_EQ(newell_normal(std::span<const Vector3>{}), Vector3(0, 0, 0));
}

TEST(Polygon, FlatteningKeepsDistancesAndTheDirectionOfCorners) {
  for_random(4472, 200, [](std::mt19937_64& rng) {
    const Vector3 normal = Vector3(uniform(rng), uniform(rng), uniform(rng)).normalized();
    const Vector3 u = normal.unitOrthogonal(), v = normal.cross(u);
    const Vector3 origin(uniform(rng), uniform(rng), uniform(rng));
    const std::vector<Vector3> triangle{origin, origin + u, origin + 0.3 * u + 2 * v};
    const std::vector<Vector2> flat = flattened(triangle, origin, normal);
    EXPECT_NEAR(twice_area(flat[0], flat[1], flat[2]), 2, 1e-13);
    EXPECT_NEAR(twice_area(flat), 2, 1e-13);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR((flat[i] - flat[(i + 1) % 3]).norm(), (triangle[i] - triangle[(i + 1) % 3]).norm(), 1e-13);
  });
}

TEST(Polygon, APointIsInsideWhereTheWindingIsOdd) {
  for_random(4473, 300, [](std::mt19937_64& rng) {
    std::vector<Vector2> corners;
    for (const Vector3& p : random_polygon(rng)) corners.push_back(p.head<2>());
    const Vector2 point(uniform(rng), uniform(rng));
    double turn = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector2 a = corners[i] - point, b = corners[(i + 1) % corners.size()] - point;
      turn += std::atan2(cross(a, b), a.dot(b));
    }
    const long winding = std::lround(turn / (2 * std::numbers::pi));
    EXPECT_EQ(inside_polygon(corners, point), winding % 2 != 0);
  });
  EXPECT_FALSE(inside_polygon({}, Vector2(0, 0)));
}

}  // namespace
}  // namespace hariko::test
