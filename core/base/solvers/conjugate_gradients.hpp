#pragma once

// Preconditioned conjugate gradients, for one coordinate or three at once.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/base/cancellation.hpp"

namespace hariko {

/// Scalars of a step, one per coordinate. Three coordinates are three systems with the same matrix.
using Coefficients3 = Eigen::Array3d;

namespace conjugate_gradients_detail {

/// Quotient a / b, 0 where b is 0: a coordinate without a residual stays as it is.
inline Coefficients3 ratio(const Coefficients3& a, const Coefficients3& b) {
  return (b.abs() > 0).select(a / (b.abs() > 0).select(b, 1.0), 0.0);
}
inline double ratio(double a, double b) {
  return std::abs(b) > 0 ? a / b : 0.0;
}
/// Squared norm at which the iteration stops. A coordinate in which the object is flat needs no digits beyond
/// the rounding of the largest one.
inline Coefficients3 enough(const Coefficients3& energy, double tolerance) {
  return (tolerance * tolerance * energy).max(1e-32 * energy.maxCoeff());
}
inline double enough(double energy, double tolerance) {
  return std::max(tolerance * tolerance, 1e-32) * energy;
}
inline bool exceeds(const Coefficients3& a, const Coefficients3& b) {
  return (a > b).any();
}
inline bool exceeds(double a, double b) {
  return a > b;
}
inline Coefficients3 one(const Coefficients3&) {
  return Coefficients3::Ones();
}
inline double one(double) {
  return 1;
}

}  // namespace conjugate_gradients_detail

/// Options of a solve: the state at its start, and when it ends.
struct ConjugateGradientsOptions {
  bool warm = false;  ///< x holds an initial guess; otherwise it is zero
  /// Residual in the preconditioner's norm, relative to that of the right-hand side.
  double tolerance = 1e-13;
  int max_steps = 600;
  bool resumed = false;  ///< x and the workspace are as an earlier call left them; its tolerance holds
  /// x holds an initial guess and room.residual its residual; room.square is x^T A x, which saves
  /// preconditioning the right-hand side itself.
  bool begun = false;
  /// x and the workspace are as an earlier call left them, but room.residual was computed anew: restarts from
  /// there with the earlier tolerance.
  bool corrected = false;
};
/// Outcome of a solve.
struct ConjugateGradientsReport {
  int iterations = 0;
  bool converged = true;
  bool cancelled = false;
};

/// Workspace of a solve; all zero at the beginning except `residual`, which is the right-hand side. A solve
/// that ran out of steps continues from it without losing its search directions; restarted it would need many
/// more.
template <class Field, class Coefficient = Coefficients3>
struct ConjugateGradientsWorkspace {
  Field residual, preconditioned, direction, image;
  /// Squared norm of the residual in the preconditioner's norm: now, and where to stop.
  Coefficient square{}, enough{};
  /// Image of `preconditioned` under the matrix, where the preconditioner gives it.
  Field preconditioned_image{};
};

/// Solves a symmetric positive definite system by preconditioned conjugate gradients. `system` has apply(x,
/// y) and precondition(r, z), both symmetric and positive definite; dot(a, b), one number per coordinate,
/// summed in a fixed order; combine(y, a, b, x): y = a y + b x. A system whose preconditioner also gives A z
/// has precondition(r, z, A z) instead; its steps need no apply.
template <class System, class Field, class Coefficient>
ConjugateGradientsReport conjugate_gradients(System& system, Field& x,
                                             ConjugateGradientsWorkspace<Field, Coefficient>& room,
                                             const ConjugateGradientsOptions& options,
                                             const CancelToken& cancel) {
  namespace detail = conjugate_gradients_detail;
  Field &r = room.residual, &z = room.preconditioned, &p = room.direction, &q = room.image;
  Field& w = room.preconditioned_image;
  Coefficient &rz = room.square, &enough = room.enough;
  constexpr bool gives_image = requires {
    system.precondition(r, z, w);
  };
  const auto precondition = [&] {
    if constexpr (gives_image)
      system.precondition(r, z, w);
    else
      system.precondition(r, z);
    return system.dot(r, z);
  };
  const auto turn = [&](const Coefficient& kept, const Coefficient& one) {
    system.combine(p, kept, one, z);
    if constexpr (gives_image) system.combine(q, kept, one, w);
  };
  if (!options.resumed) {
    const Coefficient start = rz;
    rz = precondition();
    const auto one = detail::one(rz);
    if (!options.corrected) enough = detail::enough(options.begun ? start + rz : rz, options.tolerance);
    if (options.warm) {
      system.apply(x, q);
      system.combine(r, one, -one, q);
      rz = precondition();
    }
    turn(0 * one, one);
  }
  const auto one = detail::one(rz);
  ConjugateGradientsReport report;
  while (detail::exceeds(rz, enough)) {
    if (report.iterations == options.max_steps) {
      report.converged = false;
      break;
    }
    if (cancel.cancelled()) {
      report.cancelled = true;
      break;
    }
    if constexpr (!gives_image) system.apply(p, q);
    const auto step = detail::ratio(rz, system.dot(p, q));
    system.combine(x, one, step, p);
    system.combine(r, one, -step, q);
    const Coefficient next = precondition();
    turn(detail::ratio(next, rz), one);
    rz = next;
    ++report.iterations;
  }
  return report;
}

}  // namespace hariko
