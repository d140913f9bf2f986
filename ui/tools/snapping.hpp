#pragma once

// Snapping: places that a drag jumps to.

#include <optional>

#include "ui/tools/tool.hpp"
#include "ui/tools/transform_target.hpp"

namespace hariko {

struct SnapTarget {
  enum class Kind { vertex, midpoint, grid };
  Kind kind = Kind::grid;
  Vector3 point = Vector3::Zero();  ///< in the document's space
};

/// Design pixels round the pointer within which a vertex or the middle of an edge attracts.
inline constexpr double snap_radius = 14;

/// The vertex or middle of an edge under the pointer that the target does not move; vertices first.
std::optional<SnapTarget> snap_to_elements(const ToolContext& context, const TransformTarget& target,
                                           const Vector2& pixel);

/// A decimal step: mantissa * 10^exponent.
struct DecimalStep {
  int mantissa = 1, exponent = 0;
  double size() const;
  /// The multiple nearest to a value, as near to the decimal number as a double can be.
  double nearest(double value) const;
  DecimalStep tenth() const { return {mantissa, exponent - 1}; }
};

/// A power of ten that covers at least 10 design pixels: the lines of the ground grid or a tenth of them.
DecimalStep grid_step(const ToolContext& context, const Vector3& at);

/// Where a ray of the eye meets the ground, on the grid's steps when it snaps; nothing near the horizon,
/// where places run away from the pointer, and behind the eye.
std::optional<Vector3> point_on_ground(const ToolContext& context, const Ray& ray, bool snaps);

}  // namespace hariko
