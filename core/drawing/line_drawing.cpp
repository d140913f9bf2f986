#include "core/drawing/line_drawing.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/drawing/facet_curves.hpp"
#include "core/drawing/occlusion.hpp"
#include "core/drawing/space_curves.hpp"

namespace hariko {

namespace {

constexpr std::size_t most_triangles = 2'000'000;
constexpr double sample_spacing = 1.5;  ///< of the page
constexpr int most_samples = 64;        ///< between two points of a curve
constexpr double shortest_part = 1.5;   ///< of the page
constexpr int change_rounds = 8;
constexpr double away_steps = 2;     ///< chord errors that a point is moved away from its surface
constexpr double least_away = 1e-6;  ///< of the view's depth at the point, so that rounding hides nothing

struct PagePoint {
  Vector2 page;
  bool drawn, hidden;
};

class StrokeMaker {
 public:
  StrokeMaker(const DrawingView& view, const LineDrawingSettings& settings, const Occlusion& occlusion)
      : view_(view), settings_(settings), occlusion_(occlusion) {}

  void add(const SpaceCurve& curve, double chord_error, std::vector<Stroke>& out) const {
    std::vector<PagePoint> points;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const PagePoint next = see(curve, i, 0, chord_error);
      if (i > 0) refine(curve, i - 1, chord_error, points.back(), next, points);
      points.push_back(next);
    }
    drop_specks(points);
    cut(curve.kind, points, out);
  }

 private:
  /// The point at a share of the way from point i of the curve to the next.
  PagePoint see(const SpaceCurve& curve, std::size_t i, double share, double chord_error) const {
    Vector3 point = curve.points[i], away = curve.away[i];
    if (share > 0) {
      point += share * (curve.points[i + 1] - point);
      away += share * (curve.away[i + 1] - away);
    }
    const Vector3 page = view_.project(point);
    const double rounding = least_away * (view_.orthographic ? view_.height / view_.focal : page.z());
    const bool cut_away =
        curve.kind != StrokeKind::section && view_.section && view_.section->signedDistance(point) > rounding;
    if (!view_.in_front(page.z()) || cut_away) return {Vector2::Zero(), false, false};
    const Vector3 moved = point + (away_steps * chord_error + rounding) * away;
    return {page.head<2>(), true, occlusion_.hides(moved, rounding)};
  }

  /// The points between two: where it changes whether they are seen.
  void refine(const SpaceCurve& curve, std::size_t i, double chord_error, const PagePoint& from,
              const PagePoint& to, std::vector<PagePoint>& out) const {
    double length = from.drawn && to.drawn ? (to.page - from.page).norm() : sample_spacing * 4;
    const int count = std::clamp(int(std::ceil(length / sample_spacing)), 1, most_samples);
    PagePoint last = from;
    for (int k = 1; k <= count; ++k) {
      const PagePoint next = k == count ? to : see(curve, i, double(k) / count, chord_error);
      if (same(last, next)) {
        last = next;
        continue;
      }
      double low = double(k - 1) / count, high = double(k) / count;
      PagePoint before = last, after = next;
      for (int round = 0; round < change_rounds; ++round) {
        const double middle = 0.5 * (low + high);
        const PagePoint p = see(curve, i, middle, chord_error);
        if (same(p, last))
          low = middle, before = p;
        else
          high = middle, after = p;
      }
      out.push_back(before);
      out.push_back(after);
      last = next;
    }
  }

  static bool same(const PagePoint& a, const PagePoint& b) {
    return a.drawn == b.drawn && a.hidden == b.hidden;
  }

  /// Changes of visibility that are shorter than a pen's width are noise of the triangles.
  static void drop_specks(std::vector<PagePoint>& points) {
    std::size_t begin = 0;
    while (begin < points.size()) {
      std::size_t end = begin + 1;
      double length = 0;
      while (end < points.size() && same(points[end], points[begin])) {
        length += (points[end].page - points[end - 1].page).norm();
        ++end;
      }
      if (begin > 0 && end < points.size() && points[begin].drawn && points[begin - 1].drawn &&
          points[end].drawn && length < shortest_part)
        for (std::size_t i = begin; i < end; ++i) points[i].hidden = points[begin - 1].hidden;
      begin = end;
    }
  }

  void cut(StrokeKind kind, const std::vector<PagePoint>& points, std::vector<Stroke>& out) const {
    std::size_t begin = 0;
    while (begin < points.size()) {
      std::size_t end = begin + 1;
      while (end < points.size() && same(points[end], points[begin])) ++end;
      if (points[begin].drawn && (!points[begin].hidden || settings_.hidden)) {
        Stroke stroke{kind, points[begin].hidden, {}};
        for (std::size_t i = begin; i < end; ++i) stroke.points.push_back(points[i].page);
        stroke.points = simplified(stroke.points);
        if (stroke.points.size() > 1) out.push_back(std::move(stroke));
      }
      begin = end;
    }
  }

  /// Without the points that the line stays close to (Douglas, Peucker).
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
  const Occlusion& occlusion_;
};

std::vector<SpaceCurve> curves_of(const SurfaceGrid& grid, const DrawingView& view,
                                  const LineDrawingSettings& settings, const CancelToken& cancel) {
  std::vector<SpaceCurve> out = section_lines(grid, view, cancel);
  const auto add = [&](std::vector<SpaceCurve> more) {
    std::move(more.begin(), more.end(), std::back_inserter(out));
  };
  if (is_facets(grid.surface())) {
    add(facet_curves(grid, view));
    return out;
  }
  add(silhouettes(grid, view, cancel));
  add(seam_curves(grid, view, settings.network));
  return out;
}

/// Of the strokes in the file: lines that matter more are drawn over others.
int rank(const Stroke& stroke) {
  const auto at = std::find(std::begin(stroke_kinds), std::end(stroke_kinds), stroke.kind);
  return 2 * int(at - std::begin(stroke_kinds)) + (stroke.hidden ? 1 : 0);
}

}  // namespace

std::string_view to_string(StrokeKind kind) {
  switch (kind) {
    case StrokeKind::silhouette:
      return "silhouette";
    case StrokeKind::border:
      return "border";
    case StrokeKind::crease:
      return "crease";
    case StrokeKind::section:
      return "section";
    case StrokeKind::network:
      break;
  }
  return "network";
}

Result<LineDrawing> draw_lines(std::span<const DrawnSurface> surfaces, const DrawingView& view,
                               const LineDrawingSettings& settings, const CancelToken& cancel) {
  std::vector<SurfaceGrid> grids;
  Occlusion occlusion(view);
  for (const DrawnSurface& drawn : surfaces) {
    if (drawn.surface.patch_count() == 0) continue;
    if (cancel.cancelled()) return make_error(e_cancelled, "The drawing was cancelled.");
    grids.emplace_back(drawn, view, most_triangles / surfaces.size());
    const SurfaceGrid& grid = grids.back();
    for (Index patch = 0; patch < grid.surface().patch_count(); ++patch)
      for (const auto& t : grid.triangles())
        occlusion.add({grid.position(patch, t[0]), grid.position(patch, t[1]), grid.position(patch, t[2])});
  }
  LineDrawing out{view.width, view.height, {}};
  const StrokeMaker maker(view, settings, occlusion);
  for (const SurfaceGrid& grid : grids) {
    const std::vector<SpaceCurve> curves = curves_of(grid, view, settings, cancel);
    std::vector<std::vector<Stroke>> strokes(curves.size());
    parallel_for(curves.size(), 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !cancel.cancelled(); ++i)
        maker.add(curves[i], grid.chord_error(), strokes[i]);
    });
    if (cancel.cancelled()) return make_error(e_cancelled, "The drawing was cancelled.");
    for (std::vector<Stroke>& own : strokes)
      for (Stroke& stroke : own) out.strokes.push_back(std::move(stroke));
  }
  std::stable_sort(out.strokes.begin(), out.strokes.end(),
                   [](const Stroke& a, const Stroke& b) { return rank(a) < rank(b); });
  if (out.strokes.empty())
    return make_error(e_drawing_empty, "There is no line in this view: nothing lies before the camera.",
                      "Turn the view to the model, or move the section.");
  return out;
}

}  // namespace hariko
