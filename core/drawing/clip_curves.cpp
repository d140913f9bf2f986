#include "core/drawing/clip_curves.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace hariko {

namespace {

constexpr double least_depth_rounding = 1e-6;  ///< relative to the view's depth at the point

/// Half-space whose function is linear in the point and positive inside.
struct HalfSpace {
  Vector3 normal;
  double offset;
  double at(const Vector3& p) const { return normal.dot(p) + offset; }
};

/// Half-space with the function normal . (p - eye) + offset.
HalfSpace from_eye(const DrawingView& view, const Vector3& normal, double offset) {
  return {normal, offset - normal.dot(view.eye)};
}

std::vector<HalfSpace> visible_space(const DrawingView& view, LineKind kind, double rounding) {
  std::vector<HalfSpace> out;
  for (const auto& [axis, side, ahead] :
       {std::tuple(view.right, view.width, 0.0), std::tuple(view.up, view.height, view.raise())})
    for (const double sign : {1.0, -1.0}) {
      // Distance from the centre of the page, at a depth of one in perspective.
      const double reach = side / 2 + page_margin;
      if (view.orthographic)
        out.push_back(from_eye(view, sign * view.focal * axis, reach));
      else
        out.push_back(from_eye(view, sign * view.focal * axis + (reach - sign * ahead) * view.forward, 0));
    }
  if (!view.orthographic) out.push_back(from_eye(view, view.forward, -view.near_plane));
  if (view.section && kind != LineKind::section)
    out.push_back({-view.section->normal(), rounding - view.section->offset()});
  return out;
}

/// Interval of the segment from a to b, in 0 .. 1, that lies inside all half-spaces; nothing where it is
/// empty.
std::optional<std::pair<double, double>> part_inside(const std::vector<HalfSpace>& spaces, const Vector3& a,
                                                     const Vector3& b) {
  double begin = 0, end = 1;
  for (const HalfSpace& space : spaces) {
    const double from = space.at(a), to = space.at(b);
    if (from < 0 && to < 0) return std::nullopt;
    if (from < 0) begin = std::max(begin, from / (from - to));
    if (to < 0) end = std::min(end, from / (from - to));
  }
  if (!(begin < end)) return std::nullopt;
  return std::pair(begin, end);
}

}  // namespace

double depth_rounding(const DrawingView& view, const Vector3& point) {
  return least_depth_rounding *
         (view.orthographic ? view.height / view.focal : std::abs((point - view.eye).dot(view.forward)));
}

std::vector<SpaceCurve> clipped(const SpaceCurve& curve, const DrawingView& view) {
  if (curve.points.size() < 2) return {};
  const std::vector<HalfSpace> spaces =
      visible_space(view, curve.kind, depth_rounding(view, curve.points.front()));
  std::vector<SpaceCurve> out;
  bool open = false;  // the last part ends where the next segment begins
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const auto part = part_inside(spaces, curve.points[i], curve.points[i + 1]);
    if (!part) {
      open = false;
      continue;
    }
    const auto add = [&](double share) {
      SpaceCurve& last = out.back();
      if (share == 0 || share == 1) {
        last.points.push_back(curve.points[i + std::size_t(share)]);
        last.away.push_back(curve.away[i + std::size_t(share)]);
        return;
      }
      last.points.push_back(curve.points[i] + share * (curve.points[i + 1] - curve.points[i]));
      last.away.push_back(curve.away[i] + share * (curve.away[i + 1] - curve.away[i]));
    };
    if (!open || part->first > 0) {
      out.push_back({curve.kind, {}, {}});
      add(part->first);
    }
    add(part->second);
    open = part->second == 1;
  }
  return out;
}

}  // namespace hariko
