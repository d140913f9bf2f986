#pragma once

// Preparation: automatic steps between a polyhedron and its surface, beside the designer's own settings.

#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_automatic_tension_range{"E_AUTOMATIC_TENSION_RANGE"};

/// Settings of the preparation. The designer's polyhedron stays as it is; only the input of the surface
/// changes.
struct Preparation {
  /// Concave faces are cut into convex ones (core/modeling/surfacing/convex_faces.hpp).
  bool split_concave = false;
  /// Coplanar triangles are merged (core/modeling/surfacing/merged_faces.hpp), before concave faces are cut.
  bool merge_coplanar = false;
  /// 0 (off) .. 1: the tension of every edge is multiplied by (mean length / its length) to this power
  /// (core/modeling/surfacing/automatic_tension.hpp).
  double automatic_tension = 0;
  friend bool operator==(const Preparation&, const Preparation&) = default;
};

/// Checks a preparation. E_AUTOMATIC_TENSION_RANGE: automatic tension is not a number from 0 to 1.
Result<Done> check_preparation(const Preparation& preparation);

}  // namespace hariko
