// Changes of derivatives to other coordinates of a chart.

#include <cmath>

#include "core/g2/faces/corner_side.hpp"
#include "core/g2/faces/opened_chart.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// Polynomial of the third degree with random coefficients, at a point.
Jet3 random_cubic(std::mt19937_64& rng, const Jet3& x, const Jet3& y) {
  Jet3 out = Jet3::constant(uniform(rng, -1, 1));
  for (const Jet3& term : {x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y})
    out += uniform(rng, -1, 1) * term;
  return out;
}

/// A function of the new coordinates, seen through the chart, has its own derivatives again.
TEST(OpenedChart, DerivativesComeBack) {
  for_random(520, 50, [](std::mt19937_64& rng) {
    const Jet3 x = Jet3::linear(uniform(rng, -1, 1), 1, 0), y = Jet3::linear(uniform(rng, -1, 1), 0, 1);
    const Jet3 first = x + 0.2 * random_cubic(rng, x, y), second = y + 0.2 * random_cubic(rng, x, y);
    const CoordinateChange change(first, second);
    if (change.area < 0.2) return;
    const std::mt19937_64 again = rng;
    std::mt19937_64 here = again, there = again;
    const Jet3 seen = change(random_cubic(here, first, second));
    const Jet3 own = random_cubic(there, Jet3::linear(first.v, 1, 0), Jet3::linear(second.v, 0, 1));
    const double largest = 1e-10 / std::pow(change.area, 5);
    for (const auto& [a, b] : {std::pair{seen.v, own.v},
                               {seen.x, own.x},
                               {seen.y, own.y},
                               {seen.xx, own.xx},
                               {seen.xy, own.xy},
                               {seen.yy, own.yy},
                               {seen.xxx, own.xxx},
                               {seen.xxy, own.xxy},
                               {seen.xyy, own.xyy},
                               {seen.yyy, own.yyy}})
      EXPECT_NEAR(a, b, largest);
  });
}

/// The rotated map of a corner keeps distances from the corner and multiplies angles from its side.
TEST(OpenedChart, CornersTurnInProportionToTheAngle) {
  for_random(530, 50, [](std::mt19937_64& rng) {
    CornerSide side;
    side.along = {1, 0};
    side.across = {0, 1};
    side.turn = uniform(rng, -0.3, 0.3);
    const double angle = uniform(rng, 0.05, 2.3), radius = uniform(rng, 0.01, 2);
    const auto [t, s] = side.operator()<Jet3>({radius * std::cos(angle), radius * std::sin(angle)});
    EXPECT_NEAR(std::hypot(t.v, s.v), radius, 1e-13);
    EXPECT_NEAR(std::atan2(s.v, t.v), (1 + side.turn) * angle, 1e-12);
    // Along the ray the map is linear.
    const Vector2 ray(std::cos(angle), std::sin(angle));
    for (const Jet3& f : {t, s}) {
      EXPECT_NEAR(f.x * ray.x() + f.y * ray.y(), f.v / radius, 1e-11);
      EXPECT_NEAR(f.xx * ray.x() * ray.x() + 2 * f.xy * ray.x() * ray.y() + f.yy * ray.y() * ray.y(), 0,
                  1e-10 / (radius * radius));
    }
  });
}

}  // namespace
}  // namespace hariko::test
