#pragma once

// Places under the pointer that can be measured from.

#include <optional>

#include "core/document/dimension.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

struct MeasurePlace {
  enum class Kind { vertex, middle, edge, surface, space };
  Kind kind = Kind::space;
  Anchor anchor;
  Vector3 point = Vector3::Zero();  ///< in the document's space
};

/// Finds what would hold a point of a dimension: a vertex, else a point of an edge (on its curve where that
/// is shown), else a point of a surface, a face or a reference picture, else a point of the ground, or where
/// the view looks along it of the plane through `last` (or the view's target) that faces the viewer.
/// `middles` takes middles of edges instead of vertices, and snaps points of the ground to the grid.
MeasurePlace place_to_measure(const ToolContext& context, const Vector2& pixel, bool middles,
                              const std::optional<Vector3>& last);

/// The point of a surface under the pointer; nothing where there is none with a curvature of its own.
std::optional<MeasurePlace> surface_to_measure(const ToolContext& context, const Vector2& pixel);

}  // namespace hariko
