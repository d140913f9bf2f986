// Polygons under the charts of mode G2.

#include "core/g2/faces/chart_polygon.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// Corners that have in their vertices the shape which they have in the polygon.
std::vector<CornerShape> corners_of(const std::vector<Vector2>& polygon) {
  std::vector<CornerShape> out;
  const std::size_t n = polygon.size();
  for (std::size_t j = 0; j < n; ++j) {
    const Vector2 forward = polygon[(j + 1) % n] - polygon[j], back = polygon[(j + n - 1) % n] - polygon[j];
    CornerShape at;
    at.angle = std::atan2(cross(forward, back), forward.dot(back));
    if (at.angle <= 0) at.angle += 2 * std::numbers::pi;
    at.out = forward.norm();
    at.in = back.norm();
    out.push_back(at);
  }
  return out;
}

double turn_at(const std::vector<Vector2>& polygon, std::size_t j) {
  const std::size_t n = polygon.size();
  const Vector2 before = polygon[j] - polygon[(j + n - 1) % n], after = polygon[(j + 1) % n] - polygon[j];
  return std::atan2(cross(before, after), before.dot(after));
}

void expect_same(const std::vector<Vector2>& a, const std::vector<Vector2>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t j = 0; j < a.size(); ++j) EXPECT_LT((a[j] - b[j]).norm(), tolerance) << j;
}

TEST(ChartPolygon, AffineImagesOfRegularPolygonsAreRegular) {
  for_random(1330255801, 100, [](std::mt19937_64& rng) {
    Eigen::Matrix2d image;
    do image << uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1);
    while (image.determinant() < 0.05);
    const std::vector<Vector2> regular = regular_chart_polygon(uniform_int(rng, 3, 20));
    std::vector<Vector2> face;
    for (const Vector2& p : regular) face.push_back(image * p);
    // In their vertices corners turn as in the regular polygon.
    expect_same(chart_polygon(face, corners_of(regular)), regular, 1e-9);
  });
}

TEST(ChartPolygon, AVertexOnASideLiesOnTheSideOfTheSquare) {
  for (const double at : {0.05, 0.3, 0.5, 0.95}) {
    const std::vector<Vector2> face{{-3, -1}, {-3 + 6 * at, -1}, {3, -1}, {3, 1}, {-3, 1}};
    const std::vector<Vector2> out = chart_polygon(face, corners_of(face));
    const Vector2 side = out[2] - out[0];
    EXPECT_LT((out[1] - (out[0] + at * side)).norm(), 1e-9 * side.norm());
    for (const std::size_t j : {std::size_t(0), std::size_t(2), std::size_t(3), std::size_t(4)})
      EXPECT_NEAR(turn_at(out, j), std::numbers::pi / 2, 1e-9) << j;
    EXPECT_NEAR((out[3] - out[2]).norm(), side.norm(), 1e-9);
  }
}

/// The vertex's chart need not be flat where the face's is: a fan is scaled to the whole turn.
TEST(ChartPolygon, AlmostStraightCornersTurnAsTheirVerticesDo) {
  const std::vector<Vector2> face{{-1, -1}, {-0.8, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::vector<CornerShape> corners = corners_of(face);
  for (const double turn : {0.0, 1e-6, 0.01, 0.1, 0.19}) {
    corners[1].angle = std::numbers::pi - turn;
    const std::vector<Vector2> out = chart_polygon(face, corners);
    EXPECT_NEAR(turn_at(out, 1), turn, 1e-9);
    EXPECT_NEAR((out[2] - out[1]).norm() / (out[1] - out[0]).norm(), 9, 1e-9);
  }
}

TEST(ChartPolygon, IsConvexAroundItsCentreWhateverTheFace) {
  for_random(1330255802, 300, [](std::mt19937_64& rng) {
    const int sides = uniform_int(rng, 3, 16);
    std::vector<Vector2> face;
    for (int j = 0; j < sides; ++j) {
      const double turn = 2 * std::numbers::pi * j / sides, radius = log_uniform(rng, 0.2, 5);
      face.emplace_back(radius * std::cos(turn), radius * std::sin(turn));
    }
    std::vector<CornerShape> corners = corners_of(face);
    for (CornerShape& at : corners) at.angle = uniform(rng, 0.1, std::numbers::pi);
    const std::vector<Vector2> out = chart_polygon(face, corners);
    for (std::size_t j = 0; j < out.size(); ++j) {
      EXPECT_GT(cross(out[j], out[(j + 1) % out.size()]), 0);
      EXPECT_GT(turn_at(out, j), -1e-6);
    }
  });
}

/// A corner that begins to turn takes its neighbours with it without a jump, also where it becomes one of
/// those that straighter ones lie between.
TEST(ChartPolygon, IsContinuousInTheTurnsOfVertices) {
  const std::vector<Vector2> face{{-1, -1}, {-0.4, -1.1}, {0.3, -1.15}, {1, -1}, {1, 1}, {-1, 1}};
  std::vector<CornerShape> corners = corners_of(face);
  std::vector<Vector2> before;
  constexpr double step = 1e-4;
  for (double turn = 0; turn < 0.7; turn += step) {
    corners[1].angle = std::numbers::pi - turn;
    corners[2].angle = std::numbers::pi - 0.05;
    const std::vector<Vector2> out = chart_polygon(face, corners);
    for (std::size_t j = 0; j < before.size(); ++j) EXPECT_LT((out[j] - before[j]).norm(), 20 * step) << turn;
    before = out;
  }
}

/// The choice of the first corner turns the polygon and nothing else.
TEST(ChartPolygon, DoesNotDependOnTheFirstCorner) {
  const std::vector<Vector2> face{{-3, -1}, {-1, -1.2}, {2, -1}, {3, 1}, {-2, 2}};
  const std::vector<CornerShape> corners = corners_of(face);
  const std::vector<Vector2> out = chart_polygon(face, corners);
  for (std::size_t shift = 1; shift < face.size(); ++shift) {
    std::vector<Vector2> turned;
    std::vector<CornerShape> shapes;
    for (std::size_t j = 0; j < face.size(); ++j) {
      turned.push_back(face[(j + shift) % face.size()]);
      shapes.push_back(corners[(j + shift) % face.size()]);
    }
    const std::vector<Vector2> other = chart_polygon(turned, shapes);
    for (std::size_t j = 0; j < face.size(); ++j)
      for (std::size_t k = 0; k < j; ++k)
        EXPECT_NEAR((other[j] - other[k]).norm(),
                    (out[(j + shift) % face.size()] - out[(k + shift) % face.size()]).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace hariko::test
