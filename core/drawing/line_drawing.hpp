#pragma once

// Line drawings of surfaces: silhouettes, borders, creases, network curves and the line of a section, with
// hidden parts told apart.

#include <Eigen/Geometry>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/result.hpp"
#include "core/drawing/drawing_view.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

inline constexpr Code e_drawing_empty{"E_DRAWING_EMPTY"};

enum class StrokeKind : std::uint8_t { silhouette, border, crease, section, network };
inline constexpr StrokeKind stroke_kinds[] = {StrokeKind::network, StrokeKind::crease, StrokeKind::border,
                                              StrokeKind::section, StrokeKind::silhouette};
/// "silhouette", ...
std::string_view to_string(StrokeKind kind);

struct DrawnSurface {
  Surface surface;
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();  ///< to the world
};

/// A line on the page.
struct Stroke {
  StrokeKind kind;
  bool hidden = false;
  std::vector<Vector2> points;  ///< at least two; the first again at the end where it is closed
};

struct LineDrawing {
  double width = 1, height = 1;  ///< of the page, in its unit
  std::vector<Stroke> strokes;
};

struct LineDrawingSettings {
  bool network = true;      ///< curves of the network: seams that lie on edges of the source
  bool hidden = false;      ///< hidden parts as well
  double resolution = 0.1;  ///< of the page: lines are as close to the true ones
};

/// Strokes of all surfaces, by kinds, visible ones before hidden ones. Curves lie on the surfaces themselves;
/// what hides them are triangles of the surfaces, about four units of the page large, at most two million.
/// Parts shorter than 1.5 units of the page between changes of visibility are not told apart. What lies
/// beyond the near plane or the section is not drawn; strokes may leave the page. Errors: E_DRAWING_EMPTY
/// where nothing is left, E_CANCELLED. The same on any number of threads. O(triangles + points of curves).
Result<LineDrawing> draw_lines(std::span<const DrawnSurface> surfaces, const DrawingView& view,
                               const LineDrawingSettings& settings, const CancelToken& cancel = {});

}  // namespace hariko
