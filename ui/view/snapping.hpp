#pragma once

// Snapping: places that a drag jumps to.

#include <optional>
#include <vector>

#include "ui/view/tool.hpp"
#include "ui/view/transform_target.hpp"

namespace hariko {

struct SnapTarget {
  enum class Kind { vertex, midpoint, grid };
  Kind kind = Kind::grid;
  Vector3 point = Vector3::Zero();  ///< in the document's space
};

/// Design pixels round the pointer within which a vertex or the middle of an edge attracts.
inline constexpr double snap_radius = 14;

/// Vertices and middles of edges that a drag can jump to, as they are when it begins: what moves is not
/// looked at, and where it snaps does not depend on how far it was dragged before. The middle of an edge is
/// where the edge is shown: on its curve on the surface, on the straight line of the polyhedron, or both.
class SnapPlaces {
 public:
  SnapPlaces() = default;
  /// Of the committed document, which the scene shows. O(elements).
  explicit SnapPlaces(const ToolContext& context);
  /// The one under the pointer that the target does not move; vertices first.
  std::optional<SnapTarget> nearest(const ToolContext& context, const TransformTarget& target,
                                    const Vector2& pixel) const;

 private:
  struct Place {
    ObjectId object;
    VertexId a, b;  ///< the vertex twice, or the ends of the edge
    Vector3 point;  ///< in the document's space
  };
  void add_middles(const ToolContext& context, std::size_t scene_object, const Object& object);

  std::vector<Place> vertices_, middles_;
};

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
