#include "core/patching/quartic/quartic_basis.hpp"

namespace hariko {

namespace {

/// Monomial u^i v^j w^k 4!/(i! j! k!) of one of the twelve boundary points.
struct Monomial {
  int exponent[3];
  double factor;
};
constexpr Monomial boundary_monomials[12] = {{{4, 0, 0}, 1}, {{0, 4, 0}, 1}, {{0, 0, 4}, 1}, {{3, 1, 0}, 4},
                                             {{2, 2, 0}, 6}, {{1, 3, 0}, 4}, {{0, 3, 1}, 4}, {{0, 2, 2}, 6},
                                             {{0, 1, 3}, 4}, {{1, 0, 3}, 4}, {{2, 0, 2}, 6}, {{3, 0, 1}, 4}};

/// Rational basis function 12 r^2 g(p, q), g = p^2 q / (p + q), of an inner point: it serves the edge q = 0
/// at the corner r = 1.
struct Rational {
  int r, p, q;
};
constexpr Rational rational_terms[6] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

double power(double x, int n) {
  double out = 1;
  for (int i = 0; i < n; ++i) out *= x;
  return out;
}

/// Derivative of a monomial: the product of x_i^(e_i - d_i) times the falling factorials.
double derivative(const Monomial& m, const double x[3], int a, int b) {
  int order[3] = {0, 0, 0};
  if (a >= 0) ++order[a];
  if (b >= 0) ++order[b];
  double out = m.factor;
  for (int i = 0; i < 3; ++i) {
    if (order[i] > m.exponent[i]) return 0;
    for (int k = 0; k < order[i]; ++k) out *= m.exponent[i] - k;
    out *= power(x[i], m.exponent[i] - order[i]);
  }
  return out;
}

}  // namespace

QuarticBasis quartic_basis(double u, double v, double w) {
  const double x[3] = {u, v, w};
  QuarticBasis basis;
  for (std::size_t k = 0; k < 12; ++k) {
    const Monomial& m = boundary_monomials[k];
    basis.value[k] = derivative(m, x, -1, -1);
    for (int i = 0; i < 3; ++i) {
      basis.gradient(Eigen::Index(k), i) = derivative(m, x, i, -1);
      for (int j = 0; j < 3; ++j) basis.hessian[k](i, j) = derivative(m, x, i, j);
    }
  }
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [ri, pi, qi] = rational_terms[k];
    const double r = x[ri], p = x[pi], q = x[qi], s = p + q;
    const double a = s > 0 ? p / s : 0.5, b = s > 0 ? q / s : 0.5;
    const double g = p * q * a, gp = s * a * b * (a + 2 * b), gq = s * a * a * a;
    const double gpp = 2 * b * b * b, gpq = a * a * (a + 3 * b), gqq = -2 * a * a * a;
    const std::size_t at = 12 + k;
    basis.value[at] = 12 * r * r * g;
    basis.gradient(Eigen::Index(at), ri) = 24 * r * g;
    basis.gradient(Eigen::Index(at), pi) = 12 * r * r * gp;
    basis.gradient(Eigen::Index(at), qi) = 12 * r * r * gq;
    Eigen::Matrix3d& hessian = basis.hessian[at];
    hessian(ri, ri) = 24 * g;
    hessian(ri, pi) = hessian(pi, ri) = 24 * r * gp;
    hessian(ri, qi) = hessian(qi, ri) = 24 * r * gq;
    hessian(pi, pi) = 12 * r * r * gpp;
    hessian(pi, qi) = hessian(qi, pi) = 12 * r * r * gpq;
    hessian(qi, qi) = 12 * r * r * gqq;
  }
  return basis;
}

}  // namespace hariko
