#pragma once

// BezierPatch: a tensor-product Bezier patch of any degree, polynomial or rational, as control points and
// weights.

#include <optional>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"

namespace hariko {

inline constexpr Code e_patch_degree{"E_PATCH_DEGREE"};
inline constexpr Code e_patch_points{"E_PATCH_POINTS"};
inline constexpr Code e_patch_weights{"E_PATCH_WEIGHTS"};
inline constexpr int max_bezier_degree = 15;

/// Tensor-product Bezier patch. Control point (i, j), i = 0 .. degree_s along s, is points[j (degree_s + 1) +
/// i].
struct BezierPatch {
  int degree_s = 3, degree_t = 3;
  std::vector<Vector3> points;
  std::vector<double> weights;  ///< one per point, positive; empty for a polynomial patch

  bool rational() const { return !weights.empty(); }
  std::size_t index(int i, int j) const { return std::size_t(j * (degree_s + 1) + i); }
  friend bool operator==(const BezierPatch&, const BezierPatch&) = default;
};

/// Validity of a patch. Errors: E_PATCH_DEGREE outside 1 .. 15, E_PATCH_POINTS (wrong number, not finite),
/// E_PATCH_WEIGHTS (wrong number, not positive). `number`, from 0, names the patch in the message.
std::optional<Message> check_patch(const BezierPatch& patch, std::size_t number);

/// The same patch with s and t swapped, so that its normals point to the other side.
BezierPatch flipped(const BezierPatch& patch);

}  // namespace hariko
