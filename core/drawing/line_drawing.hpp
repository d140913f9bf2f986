#pragma once

// Line drawings of surfaces, with hidden lines: silhouettes, borders, creases, network curves and section
// lines.

#include <Eigen/Geometry>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/drawing/drawing_view.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

inline constexpr Code e_drawing_empty{"E_DRAWING_EMPTY"};

/// Kinds of lines.
enum class LineKind : std::uint8_t { silhouette, border, crease, section, network };
/// All kinds in drawing order: later ones are drawn over earlier ones.
inline constexpr LineKind line_kinds[] = {LineKind::network, LineKind::crease, LineKind::border,
                                          LineKind::section, LineKind::silhouette};
/// Name of a kind: "silhouette", ...
std::string_view to_string(LineKind kind);
/// Kind by its name; nothing for other names.
std::optional<LineKind> line_kind_from(std::string_view name);

/// Surface with its placement.
struct DrawnSurface {
  Surface surface;
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();  ///< from the surface's space to the world
};

/// Line on the page.
struct PageLine {
  LineKind kind;
  bool hidden = false;
  std::vector<Vector2> points;  ///< at least two; a closed line repeats the first at the end
};

/// Drawing of surfaces on a page.
struct LineDrawing {
  /// Size of the page, in its unit.
  double width = 1, height = 1;
  std::vector<PageLine> lines;
};

/// Choice of lines and their precision.
struct LineDrawingSettings {
  /// Kinds to draw. The network consists of the seams that lie on edges of the source.
  std::set<LineKind> kinds{std::begin(line_kinds), std::end(line_kinds)};
  bool hidden = false;      ///< also draws hidden parts
  double resolution = 0.1;  ///< largest deviation of lines from the true ones, page units
};

/// Line drawing of all surfaces with hidden-line removal; lines are ordered by kind, visible ones before
/// hidden ones. Curves lie on the surfaces themselves; occluders are triangles of the surfaces, about four
/// page units large, at most two million. Parts shorter than 1.5 page units between changes of visibility
/// take the visibility of the part before. Parts nearer than the near plane, beyond the section or more than
/// four page units outside the page are not drawn. Errors: E_DRAWING_EMPTY where no line remains,
/// E_CANCELLED. Deterministic on any number of threads. O(triangles + points of curves).
Result<LineDrawing> draw_lines(std::span<const DrawnSurface> surfaces, const DrawingView& view,
                               const LineDrawingSettings& settings, const CancelToken& cancel = {},
                               const Progress& progress = {});

}  // namespace hariko
