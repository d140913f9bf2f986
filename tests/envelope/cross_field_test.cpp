// Eq. (1) of the paper: the printed control vectors against products of Bernstein polynomials.

#include <Eigen/Geometry>
#include <array>

#include "core/envelope/network/rational_curve.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

namespace {

RibbonCurve random_ribbon(std::mt19937_64& rng) {
  RibbonCurve out;
  for (Homogeneous& h : out.curve) h = homogeneous(random_vector(rng, 2), uniform(rng, 0.5, 2));
  for (Vector3& a : out.across) a = random_vector(rng);
  return out;
}

}  // namespace

TEST(CrossField, ThePrintedVectorsAreTheProducts) {
  for_random(7, 20, [](std::mt19937_64& rng) {
    const RibbonCurve ribbon = random_ribbon(rng);
    const Vector3 h00 = ribbon.curve[0].head<3>();
    const double w0 = ribbon.curve[0].w();
    Vector3 c[3], raised_field[4];
    double cw[3];
    for (std::size_t i = 0; i < 3; ++i) {
      c[i] = (ribbon.curve[i + 1] - ribbon.curve[i]).head<3>();
      cw[i] = ribbon.curve[i + 1].w() - ribbon.curve[i].w();
    }
    // Three times this is the field of degree 1, raised to degree 3.
    for (int i = 0; i < 4; ++i) raised_field[i] = ((3 - i) * ribbon.across[0] + i * ribbon.across[1]) / 9;
    const double k0 = uniform(rng, -2, 2), k1 = uniform(rng, -2, 2), h0 = uniform(rng, -2, 2),
                 h1 = uniform(rng, -2, 2);
    CrossCoefficients coefficients{{k0, 0.5 * (k0 + k1), k1}, {h0, 0.5 * (h0 + h1), h1}, {0, 0}};
    const HomogeneousSextic b = cross_field(ribbon, coefficients);
    const double Cw0 = cw[0], Cw1 = cw[1], Cw2 = cw[2];
    // By coordinates: of vectors the expressions take the compiler minutes.
    std::array<Vector3, 6> printed;
    for (Eigen::Index d = 0; d < 3; ++d) {
      const double c0 = c[0][d], c1 = c[1][d], c2 = c[2][d], H0 = h0 * h00[d], H1 = h1 * h00[d];
      const std::array a{raised_field[0][d], raised_field[1][d], raised_field[2][d], raised_field[3][d]};
      const std::array<double, 6> coordinates{
          3 * (-Cw0 * H0 + a[0] * k0 + c0 * h0 * w0) / 5,
          -3 *
              (2 * Cw0 * H0 + 2 * Cw1 * H0 + Cw0 * H1 - a[0] * k0 - 3 * a[1] * k0 - a[0] * k1 -
               2 * c0 * h0 * w0 - 2 * c1 * h0 * w0 - c0 * h1 * w0) /
              25,
          -3 *
              (-3 * c1 * Cw0 * h0 + 3 * c0 * Cw1 * h0 + Cw0 * H0 + 4 * Cw1 * H0 + Cw2 * H0 + 2 * Cw0 * H1 +
               2 * Cw1 * H1 - 3 * a[1] * k0 - 3 * a[2] * k0 - a[0] * k1 - 3 * a[1] * k1 - c0 * h0 * w0 -
               4 * c1 * h0 * w0 - c2 * h0 * w0 - 2 * c0 * h1 * w0 - 2 * c1 * h1 * w0) /
              50,
          3 *
              (2 * c1 * Cw0 * h0 + 2 * c2 * Cw0 * h0 - 2 * c0 * Cw1 * h0 - 2 * c0 * Cw2 * h0 - 2 * Cw1 * H0 -
               2 * Cw2 * H0 + 3 * c1 * Cw0 * h1 - 3 * c0 * Cw1 * h1 - Cw0 * H1 - 4 * Cw1 * H1 - Cw2 * H1 +
               3 * a[2] * k0 + a[3] * k0 + 3 * a[1] * k1 + 3 * a[2] * k1 + 2 * c1 * h0 * w0 +
               2 * c2 * h0 * w0 + c0 * h1 * w0 + 4 * c1 * h1 * w0 + c2 * h1 * w0) /
              50,
          3 *
              (c2 * Cw0 * h0 + c2 * Cw1 * h0 - c0 * Cw2 * h0 - c1 * Cw2 * h0 - Cw2 * H0 + 2 * c1 * Cw0 * h1 +
               2 * c2 * Cw0 * h1 - 2 * c0 * Cw1 * h1 - 2 * c0 * Cw2 * h1 - 2 * Cw1 * H1 - 2 * Cw2 * H1 +
               a[3] * k0 + 3 * a[2] * k1 + a[3] * k1 + c2 * h0 * w0 + 2 * c1 * h1 * w0 + 2 * c2 * h1 * w0) /
              25,
          -3 *
              (-c2 * Cw0 * h1 - c2 * Cw1 * h1 + c0 * Cw2 * h1 + c1 * Cw2 * h1 + Cw2 * H1 - a[3] * k1 -
               c2 * h1 * w0) /
              5};
      for (std::size_t i = 0; i < 6; ++i) printed[i][d] = coordinates[i];
    }
    for (std::size_t i = 0; i < 7; ++i) {
      // Raised from degree 5 to 6.
      const double x = double(i) / 6;
      const Vector3 raised = x * printed[i > 0 ? i - 1 : 0] + (1 - x) * printed[i < 6 ? i : 5];
      EXPECT_LT((b[i].head<3>() / 5 - raised).norm(), 1e-12 * (1 + raised.norm())) << "b" << i;
      EXPECT_EQ(b[i].w(), 0);
    }
  });
}

TEST(CrossField, TheEndsAreTheSidesDerivatives) {
  for_random(8, 20, [](std::mt19937_64& rng) {
    const RibbonCurve ribbon = random_ribbon(rng);
    // Side derivatives lie in the plane of the curve's tangent and the field, as at a vertex of a network.
    Homogeneous rate[2];
    for (std::size_t e = 0; e < 2; ++e) {
      const Homogeneous& at = ribbon.curve[3 * e];
      const Vector3 tangent = e == 0 ? ribbon.start_derivative() : ribbon.end_derivative();
      const double mu = uniform(rng, -1, 1);
      rate[e] = mu * at;
      rate[e].head<3>() += uniform(rng, 0.5, 2) * ribbon.across[e] + uniform(rng, -1, 1) * tangent;
    }
    const HomogeneousSextic b =
        cross_field(ribbon, cross_coefficients(ribbon, rate[0], rate[1], random_vector(rng)));
    EXPECT_LT((b[0] - rate[0]).norm(), 1e-10 * rate[0].norm());
    EXPECT_LT((b[6] - rate[1]).norm(), 1e-10 * rate[1].norm());
  });
}

TEST(CrossField, TheMiddleIsTheWantedDerivative) {
  for_random(10, 20, [](std::mt19937_64& rng) {
    // A parallelogram with slow ends: without h of degree 2 the middle slides along the curve.
    const Vector3 along = random_vector(rng),
                  to = random_vector(rng).cross(along) + uniform(rng, -1, 1) * along;
    const double slow = uniform(rng, 0.05, 0.4);
    RibbonCurve ribbon;
    ribbon.curve = {homogeneous(Vector3::Zero()), homogeneous(slow * along), homogeneous((1 - slow) * along),
                    homogeneous(along)};
    const Vector3 across = (to - to.dot(along) / along.squaredNorm() * along).normalized();
    ribbon.across = {across, across};
    const double f = uniform(rng, 0.2, 1);
    const Homogeneous rate = homogeneous(f * to, 1) - homogeneous(Vector3::Zero());
    const HomogeneousSextic b = cross_field(ribbon, cross_coefficients(ribbon, rate, rate, f * to));
    const Homogeneous middle = (b[0] + 6 * b[1] + 15 * b[2] + 20 * b[3] + 15 * b[4] + 6 * b[5] + b[6]) / 64;
    EXPECT_LT((middle.head<3>() - f * to).norm(), 1e-9 * to.norm());
  });
}

TEST(CrossField, HalvesOfTheReversedCurveAreTheReversedHalvesBitForBit) {
  for_random(9, 20, [](std::mt19937_64& rng) {
    const RibbonCurve ribbon = random_ribbon(rng);
    const auto [first, second] = ribbon.halves();
    const auto [last, before] = ribbon.reversed().halves();
    EXPECT_EQ(last.reversed().curve, second.curve);
    EXPECT_EQ(before.reversed().curve, first.curve);
    EXPECT_EQ(before.reversed().across, first.across);
  });
}

}  // namespace hariko::test
