#include "core/gaussmap/outlines/drawn_loop.hpp"

#include <algorithm>
#include <cmath>

#include "core/gaussmap/outlines/interpolate_normals.hpp"
#include "core/gaussmap/outlines/loop_curve.hpp"
#include "core/gaussmap/outlines/outline_check.hpp"
#include "core/gaussmap/outlines/resample_loop.hpp"

namespace hariko {

Result<OutlineLoop> drawn_loop(std::span<const Vector3> corners, const DrawnLoop& settings) {
  if (corners.size() < 3)
    return make_error(e_outline_too_few, "A loop needs at least three corners.", "Click more corners.");
  OutlineLoop drawn;
  drawn.points.assign(corners.begin(), corners.end());
  drawn.normals.assign(corners.size(), settings.axis);
  const double size = Outline{{drawn}}.size();
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (!corners[i].allFinite() || !(size < 1e100))
      return make_error(e_outline_not_finite, "A corner of the loop is not at a finite place.",
                        "Click elsewhere.", element_of(VertexId{Index(i)}));
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (!((corners[i] - corners[(i + 1) % corners.size()]).norm() > 1e-6 * size))
      return make_error(e_same_point, "Two corners of the loop lie in one place.", "Leave one of them out.",
                        element_of(VertexId{Index(i)}));
  // Seen from the tip of the axis the surface must lie on the left.
  if ((vector_area(drawn.points).dot(settings.axis) < 0) != settings.hole) {
    drawn = reversed(drawn);
    std::rotate(drawn.points.rbegin(), drawn.points.rbegin() + 1, drawn.points.rend());
  }
  const LoopCurve curve(drawn);
  constexpr int pieces = 24;  // samples per side, from which the even points are taken
  OutlineLoop fine;
  for (std::size_t i = 0; i < curve.piece_count(); ++i)
    for (int k = 0; k < pieces; ++k) fine.points.push_back(curve.at(i, double(k) / pieces).point);
  fine.normals = tilted_normals(fine.points, settings.axis, settings.hole ? -settings.tilt : settings.tilt);
  auto made =
      resample_loop(fine, settings.count, settings.tilt == 0 ? LoopMeasure::arc : LoopMeasure::gauss_arc);
  if (!made) return made;
  OutlineLoop out = *std::move(made);
  // Perpendicular to the chords of the resampled points.
  out.normals = tilted_normals(out.points, settings.axis, settings.hole ? -settings.tilt : settings.tilt);
  return out;
}

}  // namespace hariko
