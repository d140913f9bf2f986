#pragma once

// Minimum-norm curve network over a polyhedron's edges (Kuriyama 1991, section 2.1; kuriyama.md section 2).

#include <memory>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/result.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

inline constexpr Code e_tension_negative{"E_TENSION_NEGATIVE"};
inline constexpr Code e_tension_nonfinite{"E_TENSION_NONFINITE"};
inline constexpr Code e_singular_vertex{"E_SINGULAR_VERTEX"};
inline constexpr Code e_corner_needs_crease{"E_CORNER_NEEDS_CREASE"};
inline constexpr Code e_pin_mismatch{"E_PIN_MISMATCH"};

/// Tangents of the curve network. The cubic along half-edge h from a to b has the Bezier points P_a, P_a +
/// start(h), P_b + end(h), P_b: tangents are a third of the derivative.
struct Network {
  std::vector<Vector3> start;  ///< per half-edge: T(a -> b)
  std::vector<Vector3> end;    ///< per half-edge: T(b -> a)
  /// Unit normal Tc x Ts of the tangent plane, per vertex; zero at corners and isolated vertices.
  std::vector<Vector3> normal;
  /// Energy of the edges, the sigma of equation (3) times their weights, scaled as in kuriyama.md section 1.
  /// Split edges and ties are not counted.
  double energy = 0;
  int iterations = 0;  ///< conjugate-gradient steps of the solve
};

}  // namespace hariko
