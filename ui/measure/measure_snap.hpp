#pragma once

// Places under the pointer that can be measured from.

#include <optional>

#include "core/document/dimension.hpp"
#include "ui/view/snapping.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

struct MeasurePlace {
  enum class Kind { vertex, middle, edge, surface, space, caught };
  Kind kind = Kind::space;
  Anchor anchor;
  Vector3 point = Vector3::Zero();               ///< in the document's space
  SnapTarget::Kind as = SnapTarget::Kind::grid;  ///< kind of a caught place
};

/// Target that a place lies on, for its mark and its name; nothing for a point of space.
std::optional<SnapTarget> target_of(const MeasurePlace& place);

/// Settings of the pointer's search for a place.
struct MeasureAim {
  Vector2 pixel = Vector2::Zero();
  bool middles = false;  ///< Ctrl: middles of edges instead of vertices, and the grid of the working plane
  std::optional<Vector3> last = std::nullopt;  ///< the point before
  const SnapPlaces* snaps = nullptr;           ///< centres, intersections and so on; null: none are caught
};

/// Finds what would hold a point of a dimension: a place of `snaps` of the kinds that the settings name, else
/// a vertex, else a point of an edge (on its curve where that is shown), else a point of a surface, a face or
/// a reference picture, else a point of the working plane, or where the view looks along that of the plane
/// through `last` (or the view's target) that faces the viewer.
MeasurePlace place_to_measure(const ToolContext& context, const MeasureAim& aim);

/// The point of a surface under the pointer; nothing where there is none with a curvature of its own.
std::optional<MeasurePlace> surface_to_measure(const ToolContext& context, const Vector2& pixel);

/// Modal: two clicks make a distance, three an angle (the second is its corner), one on a surface a radius. A
/// complete one becomes a dimension at once, one step each, and the next one can begin; Enter, Esc or a right
/// click end. Backspace takes the last point back. While it runs the value follows the pointer.
std::unique_ptr<Tool> make_measure_tool(DimensionKind kind);

}  // namespace hariko
