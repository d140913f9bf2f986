#include "core/drawing/space_curves.hpp"

#include <algorithm>
#include <map>

#include "core/drawing/plane_curves.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

namespace {

constexpr int seam_oversampling = 2;

/// Zero contours of a function of position and normal, traced patch by patch on the grid's triangles: normals
/// jump at creases, and so do the contours.
class Contours {
 public:
  using Value = std::function<double(const Vector3& position, const Vector3& normal)>;
  using Place = SurfacePlace;
  using Line = PlaceLine;

  /// `noise`: largest rounding error of the function.
  Contours(const SurfaceGrid& grid, Value value, double noise)
      : grid_(grid), value_(std::move(value)), noise_(noise), parameters_(grid.pattern().parameters()) {}

  std::vector<Line> trace(const CancelToken& cancel) {
    for (Index patch = 0; patch < grid_.surface().patch_count() && !cancel.cancelled(); ++patch)
      trace_patch(patch);
    join_lines(lines_);
    return std::move(lines_);
  }

 private:
  /// Sign of the function, with zero and rounding noise counted as positive: every crossing then has two
  /// different signs, and patches agree at the nodes of a common side that a contour runs along (silhouettes
  /// of symmetric shapes).
  bool positive(double x) const { return x >= -noise_; }

  Place cross(Index patch, int a, int b) const {
    const Vector2 begin = parameters_[std::size_t(a)], whole = parameters_[std::size_t(b)] - begin;
    const double edge = (grid_.position(patch, a) - grid_.position(patch, b)).norm();
    const double fraction = crossing_fraction(
        [&](double x) {
          const SurfaceGrid::Point p = grid_.evaluate(patch, begin + x * whole);
          return value_(p.position, p.normal);
        },
        values_[std::size_t(a)], values_[std::size_t(b)], noise_);
    const Vector2 parameter = begin + fraction * whole;
    return {patch, parameter, grid_.evaluate(patch, parameter).position, edge};
  }

  void trace_patch(Index patch) {
    const int count = grid_.pattern().point_count();
    values_.resize(std::size_t(count));
    bool above = false, below = false;
    for (int i = 0; i < count; ++i) {
      const double value = value_(grid_.position(patch, i), grid_.normal(patch, i));
      values_[std::size_t(i)] = value;
      (positive(value) ? above : below) = true;
    }
    if (!above || !below) return;
    // A crossed edge belongs to at most two triangles, and a crossed triangle has two crossed edges.
    std::map<std::pair<int, int>, std::vector<std::pair<int, int>>> next;
    for (const auto& triangle : grid_.triangles()) {
      std::vector<std::pair<int, int>> crossed;
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = triangle[k], b = triangle[(k + 1) % 3];
        if (positive(values_[std::size_t(a)]) != positive(values_[std::size_t(b)]))
          crossed.push_back(std::minmax(a, b));
      }
      if (crossed.size() != 2) continue;
      next[crossed[0]].push_back(crossed[1]);
      next[crossed[1]].push_back(crossed[0]);
    }
    const auto follow = [&](std::pair<int, int> edge) {
      Line line;
      for (;;) {
        line.push_back(cross(patch, edge.first, edge.second));
        auto& ways = next[edge];
        if (ways.empty()) break;
        const std::pair<int, int> other = ways.back();
        ways.pop_back();
        auto& back = next[other];
        back.erase(std::find(back.begin(), back.end(), edge));
        edge = other;
      }
      lines_.push_back(std::move(line));
    };
    // Open contours are traced first, from their ends; the rest is closed.
    std::vector<std::pair<int, int>> edges;
    for (const auto& [edge, ways] : next) edges.push_back(edge);
    for (const auto& edge : edges)
      if (next[edge].size() == 1) follow(edge);
    for (const auto& edge : edges)
      if (!next[edge].empty()) follow(edge);
  }

  const SurfaceGrid& grid_;
  Value value_;
  double noise_;
  std::vector<Vector2> parameters_;
  std::vector<double> values_;  ///< function values on the present patch
  std::vector<Line> lines_;
};

Vector3 facing(const Vector3& normal, const Vector3& towards) {
  return normal.dot(towards) < 0 ? Vector3(-normal) : normal;
}

/// Appends points and away directions along one side of a seam. Returns, for each point, whether that side's
/// surface faces the viewer.
std::vector<bool> add_side(const SurfaceGrid& grid, const DrawingView& view, const PatchSide& side,
                           double begin, double end, std::vector<Vector3>* points,
                           std::vector<Vector3>& away) {
  const int count = seam_oversampling * grid.pattern().density;
  away.resize(std::size_t(count) + 1, Vector3::Zero());
  std::vector<bool> front;
  for (int i = 0; i <= count; ++i) {
    const double x = begin + (end - begin) * grid_fraction(i, count);
    const SurfaceGrid::Point p =
        grid.evaluate(side.patch, side_parameter(grid.surface().domain(), side.side, x));
    if (points) points->push_back(p.position);
    const Vector3 towards = view.towards_eye(p.position);
    front.push_back(p.normal.dot(towards) >= 0);
    away[std::size_t(i)] += facing(p.normal, towards);
  }
  return front;
}

/// Curves of a crease: the whole crease, and as silhouettes the parts where exactly one side faces the
/// viewer.
std::vector<SpaceCurve> crease_curves(const SurfaceGrid& grid, const DrawingView& view, const Seam& seam) {
  SpaceCurve whole{LineKind::crease, {}, {}};
  const std::vector<bool> first = add_side(grid, view, seam.first, seam.first_begin, seam.first_end,
                                           &whole.points, whole.away),
                          second = add_side(grid, view, seam.second, seam.second_begin, seam.second_end,
                                            nullptr, whole.away);
  std::vector<SpaceCurve> out;
  for (std::size_t i = 0; i < whole.points.size(); ++i) {
    const LineKind kind = first[i] != second[i] ? LineKind::silhouette : LineKind::crease;
    if (!out.empty()) {
      out.back().points.push_back(whole.points[i]);
      out.back().away.push_back(whole.away[i]);
    }
    const bool last = i + 1 == whole.points.size();
    if (!last && (out.empty() || out.back().kind != kind))
      out.push_back({kind, {whole.points[i]}, {whole.away[i]}});
  }
  return out;
}

}  // namespace

std::vector<SpaceCurve> silhouettes(const SurfaceGrid& grid, const DrawingView& view,
                                    const CancelToken& cancel) {
  constexpr double noise = 1e-9;  // rounding error of a cosine
  Contours contours(
      grid,
      [&view](const Vector3& position, const Vector3& normal) {
        return normal.dot(view.towards_eye(position).stableNormalized());
      },
      noise);
  std::vector<SpaceCurve> out;
  for (const Contours::Line& line : contours.trace(cancel)) {
    SpaceCurve curve{LineKind::silhouette, {}, {}};
    for (const Contours::Place& place : line) {
      const Vector3 normal = grid.evaluate(place.patch, place.parameter).normal;
      // A surface that bends towards its normal is seen past its other side.
      const bool inside = grid.bending(place.patch, place.parameter, view.towards_eye(place.position)) > 0;
      curve.points.push_back(place.position);
      curve.away.push_back(inside ? Vector3(-normal) : normal);
    }
    out.push_back(std::move(curve));
  }
  return out;
}

std::vector<SpaceCurve> section_lines(const SurfaceGrid& grid, const DrawingView& view,
                                      const CancelToken& cancel) {
  if (!view.section) return {};
  const double noise = 1e-9 * (view.width + view.height) / view.focal;
  std::vector<SpaceCurve> out;
  const GridMesh mesh(grid);
  for (const PlaceLine& line : plane_places(grid, mesh, *view.section, noise, cancel)) {
    SpaceCurve curve{LineKind::section, {}, {}};
    for (const SurfacePlace& place : line) {
      curve.points.push_back(place.position);
      // Section lines are seen from the side that is cut away.
      curve.away.push_back(view.section->normal());
    }
    out.push_back(std::move(curve));
  }
  return out;
}

std::vector<SpaceCurve> seam_curves(const SurfaceGrid& grid, const DrawingView& view, bool network) {
  std::vector<SpaceCurve> out;
  const Surface& surface = grid.surface();
  for (const PatchSide& side : surface.boundary_sides()) {
    SpaceCurve curve{LineKind::border, {}, {}};
    add_side(grid, view, side, 0, 1, &curve.points, curve.away);
    out.push_back(std::move(curve));
  }
  for (const Seam& seam : surface.seams()) {
    if (seam.intended == Continuity::g0) {
      for (SpaceCurve& curve : crease_curves(grid, view, seam)) out.push_back(std::move(curve));
      continue;
    }
    if (!network || seam.source.kind == Element::Kind::none) continue;
    SpaceCurve curve{LineKind::network, {}, {}};
    add_side(grid, view, seam.first, seam.first_begin, seam.first_end, &curve.points, curve.away);
    out.push_back(std::move(curve));
  }
  for (SpaceCurve& curve : out)
    for (Vector3& a : curve.away) a = a.stableNormalized();
  return out;
}

}  // namespace hariko
