#include "core/exchange/repair/triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/index_list.hpp"
#include "core/geometry/polygon.hpp"

namespace hariko {
namespace {

/// Number of corners up to which all are tested for each ear. Above it only reflex corners near the ear are:
/// in a simple polygon every triangle that is no ear contains one of them.
constexpr std::size_t largest_for_all = 1000;
/// Limit of steps for a polygon, which one of millions of corners reaches only where it crosses itself; the
/// rest then becomes a fan.
constexpr std::size_t most_steps = 4'000'000'000;

/// Corners projected to a plane in which the polygon runs counter-clockwise.
std::vector<Vector2> project(std::span<const Vector3> corners) {
  const Vector3 normal = newell_normal(corners);
  int drop = 0;
  normal.cwiseAbs().maxCoeff(&drop);
  const int u = (drop + 1) % 3, v = (drop + 2) % 3;
  const double side = normal[drop] < 0 ? -1 : 1;
  std::vector<Vector2> out;
  out.reserve(corners.size());
  for (const Vector3& p : corners) out.emplace_back(p[u] - corners[0][u], side * (p[v] - corners[0][v]));
  return out;
}

bool is_ear(const std::vector<Vector2>& points, const std::vector<Index>& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const Vector2 &a = points[ring[(i + n - 1) % n]], &b = points[ring[i]], &c = points[ring[(i + 1) % n]];
  if (!(twice_area(a, b, c) > 0)) return false;
  for (std::size_t k = 2; k + 1 < n; ++k) {
    const Vector2& p = points[ring[(i + k) % n]];
    if (twice_area(a, b, p) >= 0 && twice_area(b, c, p) >= 0 && twice_area(c, a, p) >= 0) return false;
  }
  return true;
}

/// Clips the ears of a polygon with few corners. The rest in `ring` has no ear.
void cut_ears(const std::vector<Vector2>& points, std::vector<Index>& ring,
              std::vector<std::array<Index, 3>>& out) {
  std::size_t i = 0, failures = 0;
  while (ring.size() > 3 && failures < ring.size()) {
    i %= ring.size();
    if (!is_ear(points, ring, i)) {
      ++i;
      ++failures;
      continue;
    }
    const std::size_t n = ring.size();
    out.push_back({ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    ++i;  // cuts a neighbour later, which gives better triangles
    failures = 0;
  }
}

/// Reflex corners of a polygon in the cells of a uniform grid of about as many cells.
class ReflexGrid {
 public:
  ReflexGrid(const std::vector<Vector2>& points, const std::vector<Index>& reflex)
      : points_(points), place_(points.size(), no_index) {
    if (reflex.empty()) return;
    Vector2 high = points[reflex[0]];
    low_ = high;
    for (const Index i : reflex) {
      low_ = low_.cwiseMin(points[i]);
      high = high.cwiseMax(points[i]);
    }
    count_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(double(reflex.size()))));
    const double least = std::numeric_limits<double>::min();
    size_ = ((high - low_) / double(count_)).cwiseMax(least);
    begin_.assign(count_ * count_ + 1, 0);
    for (const Index i : reflex) ++begin_[cell_of(points[i]) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    end_.assign(begin_.begin(), begin_.end() - 1);
    in_cells_.resize(reflex.size());
    for (const Index i : reflex) {
      place_[i] = static_cast<Index>(end_[cell_of(points[i])]++);
      in_cells_[place_[i]] = i;
    }
  }

  bool holds(Index i) const { return place_[i] != no_index; }

  void remove(Index i) {
    const std::size_t last = --end_[cell_of(points_[i])];
    in_cells_[place_[i]] = in_cells_[last];
    place_[in_cells_[place_[i]]] = place_[i];
    place_[i] = no_index;
  }

  /// Whether `test` holds for a corner in one of the cells that a triangle touches; counts cells and corners.
  template <class Test>
  bool any_near(const std::array<Vector2, 3>& triangle, std::size_t& steps, Test&& test) const {
    if (in_cells_.empty()) return false;
    const auto [least, greatest] = std::minmax({triangle[0].y(), triangle[1].y(), triangle[2].y()});
    for (std::size_t row = number(least, 1), last = number(greatest, 1); row <= last; ++row) {
      const auto [from, to] = columns(triangle, row);
      for (std::size_t column = from; column <= to; ++column) {
        const std::size_t cell = row * count_ + column;
        steps += 1 + end_[cell] - begin_[cell];
        for (std::size_t k = begin_[cell]; k < end_[cell]; ++k)
          if (test(in_cells_[k])) return true;
      }
    }
    return false;
  }

 private:
  /// Number of the row (axis 1) or column of a coordinate; monotone, so that cells of what lies between two
  /// coordinates lie between theirs.
  std::size_t number(double x, int axis) const {
    const double cells = (x - low_[axis]) / size_[axis];
    if (!(cells > 0)) return 0;
    return cells < double(count_) ? static_cast<std::size_t>(cells) : count_ - 1;
  }
  std::size_t cell_of(const Vector2& p) const { return number(p.y(), 1) * count_ + number(p.x(), 0); }

  /// First and last column that a triangle touches in a row, with a margin for rounding.
  std::pair<std::size_t, std::size_t> columns(const std::array<Vector2, 3>& triangle, std::size_t row) const {
    constexpr double margin = 1e-9;
    const double below = low_.y() + (double(row) - margin) * size_.y(),
                 above = low_.y() + (double(row) + 1 + margin) * size_.y();
    double from = std::numeric_limits<double>::infinity(), to = -from;
    const auto take = [&](double x) { from = std::min(from, x), to = std::max(to, x); };
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector2 &a = triangle[k], &b = triangle[(k + 1) % 3];
      // The outermost rows also hold what lies beyond them.
      if ((a.y() >= below || row == 0) && (a.y() <= above || row + 1 == count_)) take(a.x());
      for (const double y : {below, above})
        if ((a.y() < y) != (b.y() < y)) take(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
    if (from > to) return {1, 0};
    return {number(from - margin * size_.x(), 0), number(to + margin * size_.x(), 0)};
  }

  const std::vector<Vector2>& points_;
  Vector2 low_ = Vector2::Zero(), size_ = Vector2::Ones();
  std::size_t count_ = 0;                 ///< number of rows, and of columns
  std::vector<std::size_t> begin_, end_;  ///< range of each cell in in_cells_
  std::vector<Index> in_cells_, place_;   ///< place of each corner in in_cells_, no_index for others
};

/// Clips the ears of a polygon with many corners, in a linked ring. About O(corners ^ 1.5) where it does not
/// cross itself.
class LongPolygon {
 public:
  explicit LongPolygon(const std::vector<Vector2>& points)
      : points_(points),
        next_(points.size()),
        before_(points.size()),
        reflex_(points, linked(points)),
        left_(points.size()) {}

  void cut(std::vector<std::array<Index, 3>>& out) {
    std::size_t failures = 0;
    Index at = 0;
    while (left_ > 3 && failures < left_ && steps_ < most_steps) {
      if (!is_free(at)) {
        at = next_[at];
        ++failures;
        continue;
      }
      out.push_back({before_[at], at, next_[at]});
      next_[before_[at]] = next_[at];
      before_[next_[at]] = before_[at];
      --left_;
      // Neighbours that have become convex stay convex.
      for (const Index i : {before_[at], next_[at]})
        if (reflex_.holds(i) && bends_outward(i)) reflex_.remove(i);
      at = next_[next_[at]];
      failures = 0;
    }
    first_ = before_[next_[at]];
  }
  std::vector<Index> ring() const {
    std::vector<Index> out;
    Index at = first_;
    for (std::size_t k = 0; k < left_; ++k, at = next_[at]) out.push_back(at);
    return out;
  }

 private:
  /// Links the ring; returns its reflex corners.
  std::vector<Index> linked(const std::vector<Vector2>& points) {
    const auto n = static_cast<Index>(points.size());
    for (Index i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      before_[i] = (i + n - 1) % n;
    }
    std::vector<Index> out;
    for (Index i = 0; i < n; ++i)
      if (!bends_outward(i)) out.push_back(i);
    return out;
  }
  bool bends_outward(Index i) const {
    return twice_area(points_[before_[i]], points_[i], points_[next_[i]]) > 0;
  }
  bool is_free(Index i) {
    ++steps_;
    if (!bends_outward(i)) return false;
    const std::array<Vector2, 3> ear{points_[before_[i]], points_[i], points_[next_[i]]};
    const auto holds = [&](const Vector2& p) {
      return twice_area(ear[0], ear[1], p) >= 0 && twice_area(ear[1], ear[2], p) >= 0 &&
             twice_area(ear[2], ear[0], p) >= 0;
    };
    return !reflex_.any_near(ear, steps_,
                             [&](Index k) { return k != before_[i] && k != next_[i] && holds(points_[k]); });
  }

  const std::vector<Vector2>& points_;
  std::vector<Index> next_, before_;
  ReflexGrid reflex_;
  std::size_t left_, steps_ = 0;
  Index first_ = 0;
};

}  // namespace

std::vector<std::array<Index, 3>> triangulate_polygon(std::span<const Vector3> corners) {
  std::vector<std::array<Index, 3>> out;
  if (corners.size() < 3) return out;
  std::vector<Index> ring = ascending_indices(corners.size());
  if (ring.size() > largest_for_all) {
    const std::vector<Vector2> points = project(corners);
    LongPolygon polygon(points);
    polygon.cut(out);
    ring = polygon.ring();
  } else if (ring.size() > 3) {
    cut_ears(project(corners), ring, out);
  }
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) out.push_back({ring[0], ring[i], ring[i + 1]});
  return out;
}

FaceTriangles triangulate(const PolygonMesh& mesh) {
  FaceTriangles out;
  std::vector<Vector3> corners;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (face.size() < 3) continue;
    corners.clear();
    for (const Index v : face) corners.push_back(mesh.positions[v]);
    for (const auto& [a, b, c] : triangulate_polygon(corners)) {
      out.triangles.push_back({face[a], face[b], face[c]});
      out.faces.push_back(Index(f));
    }
  }
  return out;
}

}  // namespace hariko
