#include "core/drawing/line_drawing.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/drawing/clip_curves.hpp"
#include "core/drawing/facet_curves.hpp"
#include "core/drawing/page_occlusion.hpp"
#include "core/drawing/space_curves.hpp"

namespace hariko {

namespace {

constexpr std::size_t most_triangles = 2'000'000;
constexpr double sample_spacing = 1.5;  ///< page units
constexpr double shortest_part = 1.5;   ///< page units
constexpr int change_rounds = 8;
constexpr double away_steps = 2;  ///< offset of a point from its surface, in chord errors

struct PagePoint {
  Vector2 page;
  bool hidden;
};

class LineMaker {
 public:
  LineMaker(const DrawingView& view, const LineDrawingSettings& settings, const PageOcclusion& occlusion)
      : view_(view), settings_(settings), occlusion_(occlusion) {}

  void add(const SpaceCurve& whole, double chord_error, std::vector<PageLine>& out) const {
    for (const SpaceCurve& curve : clipped(whole, view_)) add_part(curve, chord_error, out);
  }

 private:
  /// Adds the lines of a clipped curve.
  void add_part(const SpaceCurve& curve, double chord_error, std::vector<PageLine>& out) const {
    std::vector<PagePoint> points;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const PagePoint next = see(curve, i, 0, chord_error);
      if (i > 0) refine(curve, i - 1, chord_error, points.back(), next, points);
      points.push_back(next);
    }
    drop_specks(points);
    cut(curve.kind, points, out);
  }

  /// Page point, with visibility, at a fraction of the segment from point i of the curve to the next.
  PagePoint see(const SpaceCurve& curve, std::size_t i, double share, double chord_error) const {
    Vector3 point = curve.points[i], away = curve.away[i];
    if (share > 0) {
      point += share * (curve.points[i + 1] - point);
      away += share * (curve.away[i + 1] - away);
    }
    const double rounding = depth_rounding(view_, point);
    const Vector3 moved = point + (away_steps * chord_error + rounding) * away;
    return {view_.project(point).head<2>(), occlusion_.hides(moved, rounding)};
  }

  /// Adds points between two points, so that changes of visibility are found.
  void refine(const SpaceCurve& curve, std::size_t i, double chord_error, const PagePoint& from,
              const PagePoint& to, std::vector<PagePoint>& out) const {
    const int count = std::max(1, int(std::ceil((to.page - from.page).norm() / sample_spacing)));
    PagePoint last = from;
    for (int k = 1; k <= count; ++k) {
      const PagePoint next = k == count ? to : see(curve, i, double(k) / count, chord_error);
      if (last.hidden == next.hidden) {
        last = next;
        continue;
      }
      double low = double(k - 1) / count, high = double(k) / count;
      PagePoint before = last, after = next;
      for (int round = 0; round < change_rounds; ++round) {
        const double middle = 0.5 * (low + high);
        const PagePoint p = see(curve, i, middle, chord_error);
        if (p.hidden == last.hidden)
          low = middle, before = p;
        else
          high = middle, after = p;
      }
      out.push_back(before);
      out.push_back(after);
      last = next;
    }
  }

  /// Removes changes of visibility shorter than a pen's width, which are artefacts of the triangles.
  static void drop_specks(std::vector<PagePoint>& points) {
    std::size_t begin = 0;
    while (begin < points.size()) {
      std::size_t end = begin + 1;
      double length = 0;
      while (end < points.size() && points[end].hidden == points[begin].hidden) {
        length += (points[end].page - points[end - 1].page).norm();
        ++end;
      }
      if (begin > 0 && end < points.size() && length < shortest_part)
        for (std::size_t i = begin; i < end; ++i) points[i].hidden = points[begin - 1].hidden;
      begin = end;
    }
  }

  void cut(LineKind kind, const std::vector<PagePoint>& points, std::vector<PageLine>& out) const {
    std::size_t begin = 0;
    while (begin < points.size()) {
      std::size_t end = begin + 1;
      while (end < points.size() && points[end].hidden == points[begin].hidden) ++end;
      if (!points[begin].hidden || settings_.hidden) {
        PageLine line{kind, points[begin].hidden, {}};
        for (std::size_t i = begin; i < end; ++i) line.points.push_back(points[i].page);
        line.points = simplified(line.points);
        if (line.points.size() > 1) out.push_back(std::move(line));
      }
      begin = end;
    }
  }

  /// Polyline simplification (Douglas, Peucker 1973), to `resolution`.
  std::vector<Vector2> simplified(const std::vector<Vector2>& points) const {
    std::vector<bool> kept(points.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      double farthest = 0;
      std::size_t at = a;
      const Vector2 line = points[b] - points[a];
      for (std::size_t i = a + 1; i < b; ++i) {
        const Vector2 d = points[i] - points[a];
        const double along =
            line.squaredNorm() > 0 ? std::clamp(d.dot(line) / line.squaredNorm(), 0.0, 1.0) : 0;
        if (const double off = (d - along * line).norm(); off > farthest) farthest = off, at = i;
      }
      if (!(farthest > 0.5 * settings_.resolution)) continue;
      kept[at] = true;
      open.emplace_back(a, at);
      open.emplace_back(at, b);
    }
    std::vector<Vector2> out;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (kept[i] && (out.empty() || points[i] != out.back())) out.push_back(points[i]);
    return out;
  }

  const DrawingView& view_;
  const LineDrawingSettings& settings_;
  const PageOcclusion& occlusion_;
};

std::vector<SpaceCurve> curves_of(const SurfaceGrid& grid, const DrawingView& view,
                                  const std::set<LineKind>& kinds, const CancelToken& cancel) {
  std::vector<SpaceCurve> out;
  const auto add = [&](std::vector<SpaceCurve> more) {
    for (SpaceCurve& curve : more)
      if (kinds.contains(curve.kind)) out.push_back(std::move(curve));
  };
  if (kinds.contains(LineKind::section)) add(section_lines(grid, view, cancel));
  if (is_facets(grid.surface())) {
    add(facet_curves(grid, view));
    return out;
  }
  if (kinds.contains(LineKind::silhouette)) add(silhouettes(grid, view, cancel));
  add(seam_curves(grid, view, kinds.contains(LineKind::network)));
  return out;
}

/// Drawing order of a line: more important lines are drawn over others.
int rank(const PageLine& line) {
  const auto at = std::find(std::begin(line_kinds), std::end(line_kinds), line.kind);
  return 2 * int(at - std::begin(line_kinds)) + (line.hidden ? 1 : 0);
}

}  // namespace

std::string_view to_string(LineKind kind) {
  switch (kind) {
    case LineKind::silhouette:
      return "silhouette";
    case LineKind::border:
      return "border";
    case LineKind::crease:
      return "crease";
    case LineKind::section:
      return "section";
    case LineKind::network:
      break;
  }
  return "network";
}

std::optional<LineKind> line_kind_from(std::string_view name) {
  for (const LineKind kind : line_kinds)
    if (to_string(kind) == name) return kind;
  return std::nullopt;
}

Result<LineDrawing> draw_lines(std::span<const DrawnSurface> surfaces, const DrawingView& view,
                               const LineDrawingSettings& settings, const CancelToken& cancel,
                               const Progress& progress) {
  constexpr double grids_share = 0.3;  // share of the progress
  progress.report(0);
  std::vector<SurfaceGrid> grids;
  PageOcclusion occlusion(view);
  for (const DrawnSurface& drawn : surfaces) {
    if (drawn.surface.patch_count() == 0) continue;
    if (cancel.cancelled()) return make_error(e_cancelled, "The drawing was cancelled.");
    grids.emplace_back(drawn, view, most_triangles / surfaces.size());
    const SurfaceGrid& grid = grids.back();
    for (Index patch = 0; patch < grid.surface().patch_count(); ++patch)
      for (const auto& t : grid.triangles())
        occlusion.add({grid.position(patch, t[0]), grid.position(patch, t[1]), grid.position(patch, t[2])});
    progress.report(grids_share * double(grids.size()) / double(surfaces.size()));
  }
  LineDrawing out{view.width, view.height, {}};
  const LineMaker maker(view, settings, occlusion);
  for (std::size_t g = 0; g < grids.size(); ++g) {
    const std::vector<SpaceCurve> curves = curves_of(grids[g], view, settings.kinds, cancel);
    std::vector<std::vector<PageLine>> lines(curves.size());
    parallel_for(curves.size(), 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !cancel.cancelled(); ++i)
        maker.add(curves[i], grids[g].chord_error(), lines[i]);
    });
    if (cancel.cancelled()) return make_error(e_cancelled, "The drawing was cancelled.");
    for (std::vector<PageLine>& own : lines)
      for (PageLine& line : own) out.lines.push_back(std::move(line));
    progress.report(grids_share + (1 - grids_share) * double(g + 1) / double(grids.size()));
  }
  std::stable_sort(out.lines.begin(), out.lines.end(),
                   [](const PageLine& a, const PageLine& b) { return rank(a) < rank(b); });
  if (out.lines.empty())
    return make_error(e_drawing_empty, "There is no line of the chosen kinds in this view.",
                      "Turn the view to the model, move the section, or choose more kinds of lines.");
  return out;
}

}  // namespace hariko
