#include "core/skinning/edit/stroke.hpp"
#include "core/geometry/polygon.hpp"

#include <cmath>
#include <numbers>

#include "tests/support/random.hpp"

namespace hariko {
namespace {

using namespace test;

/// Points along a polyline with a trembling hand.
std::vector<Vector2> drawn(std::mt19937_64& rng, const std::vector<Vector2>& corners, double tremble) {
  std::vector<Vector2> out;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const int steps = uniform_int(rng, 5, 40);
    for (int s = 0; s < steps; ++s)
      out.push_back(corners[i] + (corners[i + 1] - corners[i]) * (double(s) / steps) +
                    Vector2(uniform(rng, -tremble, tremble), uniform(rng, -tremble, tremble)));
  }
  out.push_back(corners.back());
  return out;
}

Vector2 turned(double length, double angle) {
  return {length * std::cos(angle), length * std::sin(angle)};
}

TEST(Stroke, HandsDrawTheThreeGestures) {
  for_random(831, 200, [](std::mt19937_64& rng) {
    const Vector2 at(uniform(rng, 0, 1000), uniform(rng, 0, 700));
    const double direction = uniform(rng, 0, 2 * std::numbers::pi), size = uniform(rng, 60, 400);
    const Vector2 end = at + turned(size, direction);
    const Stroke line = classify_stroke(drawn(rng, {at, end}, 1.5));
    ASSERT_EQ(line.kind, StrokeKind::line);
    EXPECT_LT((line.points[0] - at).norm(), 3);
    EXPECT_LT((line.points[1] - end).norm(), 1e-9);
    const double angle = uniform(rng, 15, 100) * std::numbers::pi / 180;
    const Stroke wedge = classify_stroke(
        drawn(rng, {at, end, end - turned(size * uniform(rng, 0.7, 1.3), direction + angle)}, 1));
    ASSERT_EQ(wedge.kind, StrokeKind::wedge);
    EXPECT_LT((wedge.points[1] - end).norm(), 16);
    std::vector<Vector2> ring;
    for (int i = 0; i <= 30; ++i)
      ring.push_back(at + size / 4 * Vector2(std::cos(0.2 * i), 0.6 * std::sin(0.2 * i)));
    const Stroke lasso = classify_stroke(ring);
    ASSERT_EQ(lasso.kind, StrokeKind::lasso);
    EXPECT_TRUE(inside_polygon(lasso.points, at));
    EXPECT_FALSE(inside_polygon(lasso.points, at + Vector2(0, size)));
  });
}

TEST(Stroke, EverythingElseIsNoGesture) {
  EXPECT_EQ(classify_stroke({}).kind, StrokeKind::none);
  EXPECT_EQ(classify_stroke({{3, 4}}).kind, StrokeKind::none);
  EXPECT_EQ(classify_stroke({{0, 0}, {10, 0}}).kind, StrokeKind::none) << "shorter than a line";
  // A half circle has no corner.
  std::vector<Vector2> arc;
  for (int i = 0; i <= 30; ++i)
    arc.push_back(200 * Vector2(std::cos(std::numbers::pi * i / 30), std::sin(std::numbers::pi * i / 30)));
  EXPECT_EQ(classify_stroke(arc).kind, StrokeKind::none);
  // Three legs.
  EXPECT_EQ(classify_stroke({{0, 0}, {200, 0}, {200, 200}, {500, 200}}).kind, StrokeKind::none);
  // Nearly back on itself, or wider than a wedge.
  EXPECT_EQ(classify_stroke({{0, 0}, {300, 0}, {100, 8}}).kind, StrokeKind::none) << "2 degrees";
  EXPECT_EQ(classify_stroke({{0, 0}, {200, 0}, {340, 140}}).kind, StrokeKind::none) << "135 degrees";
}

TEST(Stroke, Crossings) {
  const auto hit = cross_segments({0, 0}, {4, 0}, {1, -1}, {1, 3});
  EXPECT_TRUE(hit.crosses);
  EXPECT_DOUBLE_EQ(hit.along_a, 0.25);
  EXPECT_DOUBLE_EQ(hit.along_b, 0.25);
  EXPECT_FALSE(cross_segments({0, 0}, {4, 0}, {5, -1}, {5, 1}).crosses);
  EXPECT_FALSE(cross_segments({0, 0}, {4, 0}, {0, 1}, {4, 1}).crosses);
  const auto foot = foot_on_segment({0, 0}, {10, 0}, {4, 3});
  EXPECT_DOUBLE_EQ(foot.along, 0.4);
  EXPECT_DOUBLE_EQ(foot.distance, 3);
  EXPECT_DOUBLE_EQ(foot_on_segment({1, 1}, {1, 1}, {4, 5}).distance, 5);
}

}  // namespace
}  // namespace hariko
