// Summits between the nodes of a grid.

#include "core/envelope/grid_summit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>

#include "tests/support/random.hpp"

namespace hariko::test {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

template <class Function>
NeighbourValues values_of(const Function& function) {
  NeighbourValues out;
  for (int k = 0; k < 9; ++k) out[std::size_t(k)] = function(Vector2(k % 3 - 1, k / 3 - 1));
  return out;
}

}  // namespace

TEST(GridSummit, OfAParaboloidIsExact) {
  for_random(41, 50, [](std::mt19937_64& rng) {
    Eigen::Matrix2d root;
    root << uniform(rng, 0.5, 2), uniform(rng, -0.3, 0.3), uniform(rng, -0.3, 0.3), uniform(rng, 0.5, 2);
    const Eigen::Matrix2d bend = root.transpose() * root;
    const Vector2 top(uniform(rng, -0.9, 0.9), uniform(rng, -0.9, 0.9));
    const double height = uniform(rng, -3, 3);
    const auto value = [&](const Vector2& at) { return height - (at - top).dot(bend * (at - top)); };
    const Summit found = summit_beside(values_of(value));
    EXPECT_LE((found.offset - top).norm(), 1e-12);
    EXPECT_NEAR(found.rise, height - value(Vector2::Zero()), 1e-12);
  });
}

TEST(GridSummit, OnABorderIsThatAlongIt) {
  const auto value = [](const Vector2& at) { return -(at.x() - 0.4) * (at.x() - 0.4); };
  // Of a row.
  const Summit on_row =
      summit_beside(values_of([&](const Vector2& at) { return at.y() < 0 ? missing : value(at); }));
  EXPECT_LE((on_row.offset - Vector2(0.4, 0)).norm(), 1e-15);
  EXPECT_NEAR(on_row.rise, 0.16, 1e-15);
  // Of the long side of a triangle.
  const Summit on_long_side =
      summit_beside(values_of([&](const Vector2& at) { return at.sum() > 0 ? missing : value(at); }));
  EXPECT_LE((on_long_side.offset - Vector2(0.4, -0.4)).norm(), 1e-15);
  // Of a corner there is none.
  const Summit at_corner =
      summit_beside(values_of([&](const Vector2& at) { return at.minCoeff() < 0 ? missing : value(at); }));
  EXPECT_EQ(at_corner.rise, 0);
  EXPECT_EQ(at_corner.offset, Vector2::Zero());
}

TEST(GridSummit, SaddlesPlanesAndWhatLiesFartherAwayHaveNone) {
  const auto none = [](const auto& value) {
    const Summit found = summit_beside(values_of(value));
    return found.rise == 0 && found.offset.isZero(0);
  };
  EXPECT_TRUE(none([](const Vector2&) { return 1.0; }));
  EXPECT_TRUE(none([](const Vector2& at) { return at.x() + 2 * at.y(); }));
  EXPECT_TRUE(none([](const Vector2& at) { return at.squaredNorm(); }));
  EXPECT_TRUE(none([](const Vector2& at) { return -(at - Vector2(1.5, 0.2)).squaredNorm(); }));
}

}  // namespace hariko::test
