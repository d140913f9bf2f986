#pragma once

// Line drawings of surfaces: silhouettes, borders, creases, network curves and the line of a section, with
// hidden parts told apart.

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

enum class LineKind : std::uint8_t { silhouette, border, crease, section, network };
inline constexpr LineKind line_kinds[] = {LineKind::network, LineKind::crease, LineKind::border,
                                          LineKind::section, LineKind::silhouette};
/// "silhouette", ...
std::string_view to_string(LineKind kind);
std::optional<LineKind> line_kind_from(std::string_view name);

struct DrawnSurface {
  Surface surface;
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();  ///< to the world
};

/// A line on the page.
struct PageLine {
  LineKind kind;
  bool hidden = false;
  std::vector<Vector2> points;  ///< at least two; the first again at the end where it is closed
};

struct LineDrawing {
  double width = 1, height = 1;  ///< of the page, in its unit
  std::vector<PageLine> lines;
};

struct LineDrawingSettings {
  /// What is drawn. The network: seams that lie on edges of the source.
  std::set<LineKind> kinds{std::begin(line_kinds), std::end(line_kinds)};
  bool hidden = false;      ///< hidden parts as well
  double resolution = 0.1;  ///< of the page: lines are as close to the true ones
};

/// Lines of all surfaces, by kinds, visible ones before hidden ones. Curves lie on the surfaces themselves;
/// what hides them are triangles of the surfaces, about four units of the page large, at most two million.
/// Parts shorter than 1.5 units of the page between changes of visibility are not told apart. What lies
/// before the near plane, beyond the section or more than four units beside the page is not drawn. Errors:
/// E_DRAWING_EMPTY where nothing is left, E_CANCELLED. The same on any number of threads. O(triangles +
/// points of curves).
Result<LineDrawing> draw_lines(std::span<const DrawnSurface> surfaces, const DrawingView& view,
                               const LineDrawingSettings& settings, const CancelToken& cancel = {},
                               const Progress& progress = {});

}  // namespace hariko
