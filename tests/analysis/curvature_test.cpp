#include "core/analysis/curvature.hpp"

#include <numbers>

#include "core/analysis/maps.hpp"
#include "core/analysis/statistics.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

void expect_consistent(const Curvature& at) {
  EXPECT_GE(at.k1, at.k2);
  const double size = std::abs(at.k1) + std::abs(at.k2);
  EXPECT_NEAR(at.mean, (at.k1 + at.k2) / 2, 1e-12 * size);
  EXPECT_NEAR(at.gauss, at.k1 * at.k2, 1e-12 * size * size);
  // The tensor has the eigenvalues k1 and k2 in the tangent plane, and 0 across it.
  EXPECT_LE((at.tensor * at.normal).norm(), 1e-11 * size);
  EXPECT_NEAR(at.tensor.trace(), at.k1 + at.k2, 1e-11 * size);
  EXPECT_NEAR(at.tensor.squaredNorm(), at.k1 * at.k1 + at.k2 * at.k2, 1e-11 * size * size);
}

TEST(Curvature, SphereIsPositiveAndRound) {
  const Surface surface = test::sphere(2.5);
  for (Index p = 0; p < 8; ++p)
    for (const Vector2& q : GridPattern{Domain::triangle, 6}.parameters()) {
      const auto at = curvature(surface.patches().evaluate(p, q, Order::second));
      ASSERT_TRUE(at);
      EXPECT_NEAR(at->k1, 0.4, 1e-12);
      EXPECT_NEAR(at->k2, 0.4, 1e-12);
      expect_consistent(*at);
    }
}

TEST(Curvature, TorusHasItsPrincipalCurvatures) {
  const double large = 3, small = 0.75;
  const Index columns = 5, rows = 4;
  const Surface surface = test::torus(large, small, columns, rows);
  for (Index p = 0; p < surface.patch_count(); ++p)
    for (const Vector2& q : GridPattern{Domain::square, 4}.parameters()) {
      const auto at = curvature(surface.patches().evaluate(p, q, Order::second));
      ASSERT_TRUE(at);
      const double v = 2 * std::numbers::pi / rows * (p % rows + q.y());
      EXPECT_NEAR(at->k1, 1 / small, 1e-12);
      EXPECT_NEAR(at->k2, std::cos(v) / (large + small * std::cos(v)), 1e-12);
      const double u = 2 * std::numbers::pi / columns * (p / rows + q.x());
      const Vector3 along(-std::sin(u), std::cos(u), 0);
      EXPECT_LT((at->tensor * along - at->k2 * along).norm(), 1e-11);
      expect_consistent(*at);
    }
}

TEST(Curvature, SaddleIsNegativeAndTroughIsConcave) {
  const auto at = curvature(test::height_patch(test::saddle(), 0, 0, 1, 1)(0, 0));
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->gauss, -1, 1e-15);
  EXPECT_NEAR(at->mean, 0, 1e-15);
  const Vector3 most = Vector3(1, -1, 0).normalized();
  EXPECT_LT((at->tensor * most - at->k1 * most).norm(), 1e-13);
  // A trough bends towards its upper side, which is outside here.
  const auto low = curvature(test::height_patch(test::trough(2), 0, 0, 1, 1)(0.3, 0.5));
  ASSERT_TRUE(low);
  EXPECT_NEAR(low->k1, 0, 1e-14);
  EXPECT_NEAR(low->k2, -0.5, 1e-14);
}

TEST(Curvature, DoesNotDependOnTheParametrisation) {
  test::for_random(21, 300, [](std::mt19937_64& rng) {
    // Second order of a random parametrisation of z = (a x^2 + 2 b x y + c y^2) / 2 at its vertex, scaled and
    // turned.
    const double a = test::uniform(rng, -2, 2), b = test::uniform(rng, -2, 2), c = test::uniform(rng, -2, 2);
    const double size = test::log_uniform(rng, 1e-6, 1e6);
    PatchPoint p;
    const Vector3 ds(test::uniform(rng, 0.5, 2), test::uniform(rng, -1, 1), 0);
    const Vector3 dt(test::uniform(rng, -0.5, 0.2), test::uniform(rng, 1, 3), 0);
    const auto bend = [&](const Vector3& d, const Vector3& e) {
      return a * d.x() * e.x() + b * (d.x() * e.y() + d.y() * e.x()) + c * d.y() * e.y();
    };
    const auto slide = [&] { return Vector3(test::uniform(rng, -1, 1), test::uniform(rng, -1, 1), 0); };
    p.ds = ds;
    p.dt = dt;
    p.dss = slide() + Vector3(0, 0, bend(ds, ds));
    p.dst = slide() + Vector3(0, 0, bend(ds, dt));
    p.dtt = slide() + Vector3(0, 0, bend(dt, dt));
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(test::uniform(rng, 0, 6), test::random_vector(rng).normalized()));
    for (Vector3* d : {&p.ds, &p.dt, &p.dss, &p.dst, &p.dtt}) *d = size * (turn * *d);
    const auto at = curvature(p);
    ASSERT_TRUE(at);
    expect_consistent(*at);
    Matrix3 flat = Matrix3::Zero();
    flat.topLeftCorner<2, 2>() << -a, -b, -b, -c;
    const Matrix3 expected = turn.toRotationMatrix() * flat * turn.toRotationMatrix().transpose() / size;
    EXPECT_LT((at->tensor - expected).norm(), 1e-12 * (1 / size) * 10);
  });
}

TEST(Curvature, IsUndefinedWithoutANormal) {
  EXPECT_FALSE(curvature(PatchPoint{}));
  PatchPoint p;
  p.ds = p.dt = {1, 0, 0};
  EXPECT_FALSE(curvature(p));
}

TEST(Statistics, RangesOfATorus) {
  const double large = 3, small = 1;
  const auto range = curvature_statistics(test::torus(large, small, 6, 4));
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->gauss.least, -1 / (large - small), 1e-12);
  EXPECT_NEAR(range->gauss.greatest, 1 / (large + small), 1e-12);
  EXPECT_NEAR(range->k1.least, 1, 1e-12);
  EXPECT_NEAR(range->k1.greatest, 1, 1e-12);
  EXPECT_NEAR(range->mean.greatest, (1 + 1 / (large + small)) / 2, 1e-12);
}

/// z = x^3 / 6 + y^3 / 6: flat in second order at the corner (0, 0), nowhere else.
test::Height cubic() {
  return [](double x, double y) {
    return std::array<double, 6>{(x * x * x + y * y * y) / 6, x * x / 2, y * y / 2, x, 0, y};
  };
}

TEST(Statistics, SkipCornersWhereSecondOrderIsNotExact) {
  test::AnalyticOptions options;
  const auto all = curvature_statistics(test::height_field(
      1, 1, [](Index, Index) { return cubic(); }, options));
  options.corners = CornerSecondOrder::direction_dependent;
  const auto some = curvature_statistics(test::height_field(
      1, 1, [](Index, Index) { return cubic(); }, options));
  ASSERT_TRUE(all && some);
  EXPECT_EQ(all->mean.greatest, 0);
  EXPECT_LT(some->mean.greatest, -0.05);
  EXPECT_FALSE(curvature_statistics(Surface()));
}

TEST(Maps, GiveCurvatureAndNothingAtCornersWithoutSecondDerivatives) {
  test::AnalyticOptions options;
  const GridPattern pattern{Domain::triangle, 4};
  const Index patches[] = {3, 5};
  for (const MapKind kind : {MapKind::gauss, MapKind::mean, MapKind::k1, MapKind::k2})
    for (const float value : map_values(test::sphere(2), kind, pattern, patches))
      EXPECT_FLOAT_EQ(value, kind == MapKind::gauss ? 0.25F : 0.5F);
  options.corners = CornerSecondOrder::undefined;
  const auto values = map_values(test::sphere(2, options), MapKind::mean, pattern, patches);
  ASSERT_EQ(values.size(), 30U);
  int undefined = 0;
  for (const float value : values) undefined += std::isnan(value) ? 1 : 0;
  EXPECT_EQ(undefined, 6);
  EXPECT_TRUE(std::isnan(values[0]) && std::isnan(values[4]) && std::isnan(values[14]));
}

TEST(Maps, WhereItDependsOnTheDirectionACornerHasTheMeanOfTheLimits) {
  test::AnalyticOptions options;
  options.corners = CornerSecondOrder::direction_dependent;
  const GridPattern pattern{Domain::triangle, 4};
  const Index patches[] = {3, 5};
  for (const float value : map_values(test::sphere(2, options), MapKind::mean, pattern, patches))
    EXPECT_FLOAT_EQ(value, 0.5F);
  // Limits are the values themselves where the corners are exact after all.
  const GridPattern squares{Domain::square, 4};
  const Index first[] = {0};
  const auto field = [](const test::AnalyticOptions& with) {
    return test::height_field(
        1, 1, [](Index, Index) { return cubic(); }, with);
  };
  const auto exact = map_values(field({}), MapKind::mean, squares, first);
  const auto limit = map_values(field(options), MapKind::mean, squares, first);
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(limit[i], exact[i], 2e-3) << i;
}

TEST(Maps, AlongSeams) {
  const auto roof = [](Index i, Index) { return test::plane(i == 0 ? 1.0 : -1.0, 0, i == 0 ? 0.0 : 2.0); };
  std::vector<float> values(5);
  seam_curvature_jumps(test::height_field(2, 1, roof), 0, 4, values);
  for (const float value : values) EXPECT_TRUE(std::isnan(value)) << "flat on both sides";
  seam_curvature_jumps(test::sphere(2), 3, 4, values);
  for (const float value : values) EXPECT_NEAR(value, 0, 1e-6);
  test::AnalyticOptions options;
  options.corners = CornerSecondOrder::direction_dependent;
  seam_curvature_jumps(test::sphere(2, options), 3, 4, values);
  for (const float value : values) EXPECT_NEAR(value, 0, 1e-6) << "the limit along the seam";
  options.corners = CornerSecondOrder::undefined;
  seam_curvature_jumps(test::sphere(2, options), 3, 4, values);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(std::isnan(values[i]), i == 0 || i == 4);
}

}  // namespace
}  // namespace hariko
