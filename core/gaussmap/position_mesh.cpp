#include "core/gaussmap/position_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/gaussmap/sphere/arc_crossings.hpp"
#include "core/gaussmap/sphere/delaunay_refinement.hpp"
#include "core/geometry/curve_places.hpp"
#include "core/geometry/polygon.hpp"

namespace hariko {
namespace {

using Loop2 = std::vector<Vector2>;

bool contains(const Loop2& loop, const Vector2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vector2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()))
      inside = !inside;
  }
  return inside;
}

/// Maps the plane to a part of the sphere so small that it is nearly flat, so that the triangulation on the
/// sphere can be used.
std::vector<std::vector<Vector3>> on_small_cap(const std::vector<Loop2>& loops) {
  Vector2 low = Vector2::Constant(HUGE_VAL), high = -low;
  for (const Loop2& loop : loops)
    for (const Vector2& point : loop) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  constexpr double cap = 0.02;  // radians: circles are round up to 4e-4
  const double scale = cap / (high - low).norm();
  std::vector<std::vector<Vector3>> out;
  for (const Loop2& loop : loops) {
    out.emplace_back();
    for (const Vector2& point : loop) {
      const Vector2 at = scale * (point - (low + high) / 2);
      out.back().push_back(Vector3(at.x(), at.y(), 1).normalized());
    }
  }
  return out;
}

std::vector<Loop2> projected(const Outline& outline) {
  Vector3 axis = Vector3::Zero();
  for (const auto& loop : unit_normals(outline))
    for (const Vector3& normal : loop) axis += normal;
  // Normals in all directions cancel; the loops' vector area still has a direction.
  if (axis.norm() < 0.1 * double(outline.point_count())) {
    axis.setZero();
    for (const OutlineLoop& loop : outline.loops)
      for (std::size_t i = 0; i < loop.points.size(); ++i)
        axis += (loop.points[i] - loop.points[0])
                    .cross(loop.points[(i + 1) % loop.points.size()] - loop.points[0]);
  }
  if (!(axis.norm() > 0)) axis = Vector3::UnitZ();
  axis.normalize();
  const Vector3 u = axis.unitOrthogonal(), w = axis.cross(u);
  std::vector<Loop2> out;
  for (const OutlineLoop& loop : outline.loops) {
    out.emplace_back();
    for (const Vector3& point : loop.points) out.back().emplace_back(point.dot(u), point.dot(w));
  }
  return out;
}

/// Whether one loop is counter-clockwise, the others are clockwise and inside it, and no two cross.
bool is_domain(const std::vector<Loop2>& loops) {
  std::size_t outer = 0, count = 0;
  for (std::size_t l = 0; l < loops.size(); ++l)
    if (twice_area(loops[l]) > 0) {
      outer = l;
      ++count;
    }
  if (count != 1 || crossing_arcs(on_small_cap(loops))) return false;
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t m = 0; m < loops.size(); ++m)
      if (l != m && l != outer && contains(loops[l], loops[m][0])) return false;
  for (std::size_t l = 0; l < loops.size(); ++l)
    if (l != outer && !contains(loops[outer], loops[l][0])) return false;
  return true;
}

/// Points of a circle with the spacing of the loop's points.
Loop2 on_circle(const OutlineLoop& loop) {
  const std::vector<double> length = lengths_along(loop.points, true);
  Loop2 out;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const double turn = 2 * std::numbers::pi * length[i] / length.back();
    out.emplace_back(std::cos(turn), std::sin(turn));
  }
  return out;
}

Result<PositionMesh> planar_mesh(const Outline& outline, const std::vector<Loop2>& layout, double radius,
                                 Index most_points) {
  auto begun = SiteInsertion::begin(on_small_cap(layout));
  if (!begun) return begun.error();
  SiteInsertion insertion = std::move(begun).value();
  const double smallest = radius * insertion.boundary_spacing();
  Index count = 0;
  while (count < most_points && insertion.insert_next(smallest)) ++count;
  const SphereMesh flat = insertion.mesh();
  PositionMesh out;
  out.limited = count == most_points && insertion.largest_radius() >= smallest;
  for (const OutlineLoop& loop : outline.loops)
    out.points.insert(out.points.end(), loop.points.begin(), loop.points.end());
  out.boundary_count = flat.boundary_count();
  for (Index i = 0; i < out.boundary_count; ++i) out.next.push_back(flat.next(i));
  Vector3 middle = Vector3::Zero();
  for (const Vector3& point : out.points) middle += point / double(out.points.size());
  out.points.resize(flat.site_count(), middle);
  out.triangles = flat.triangles();
  // Harmonic over the layout, by relaxation: only an initial guess for the solver that follows.
  for (int round = 0; round < 400; ++round)
    for (Index i = out.boundary_count; i < flat.site_count(); ++i) {
      Vector3 sum = Vector3::Zero();
      for (const Index k : flat.ring(i).neighbours) sum += out.points[k];
      out.points[i] = sum / double(flat.ring(i).neighbours.size());
    }
  return out;
}

/// Closed polyline parametrised by its share of the length, starting at a given place.
class Ring {
 public:
  Ring(std::vector<Vector3> points, double begin)
      : points_(std::move(points)), begin_(begin), length_(lengths_along(points_, true)) {}
  double length() const { return length_.back(); }
  Vector3 at(double share) const {
    double s = share + begin_;
    s = (s - std::floor(s)) * length_.back();
    const auto above = std::upper_bound(length_.begin() + 1, length_.end() - 1, s);
    const auto i = std::size_t(above - length_.begin()) - 1;
    return points_[i] + (points_[(i + 1) % points_.size()] - points_[i]) *
                            ((s - length_[i]) / (length_[i + 1] - length_[i]));
  }
  double share(std::size_t i) const {
    const double s = length_[i] / length_.back() - begin_;
    return s - std::floor(s);
  }

 private:
  std::vector<Vector3> points_;
  double begin_;
  std::vector<double> length_;
};

struct Row {
  std::vector<Index> vertices;
  std::vector<double> shares;  ///< ascending, 0 .. 1
};

/// Triangles between two rows with the same direction, with `high` on the left of `low`.
void stitch(const Row& low, const Row& high, std::vector<std::array<Index, 3>>& triangles) {
  std::size_t i = 0, j = 0;
  const std::size_t m = low.vertices.size(), n = high.vertices.size();
  const auto share = [](const Row& row, std::size_t k) {
    return row.shares[k % row.shares.size()] + double(k / row.shares.size());
  };
  while (i < m || j < n) {
    const bool lower =
        j == n || (i < m && share(low, i + 1) + share(low, i) <= share(high, j + 1) + share(high, j));
    const Index a = low.vertices[i % m], b = high.vertices[j % n];
    if (lower)
      triangles.push_back({a, low.vertices[++i % m], b});
    else
      triangles.push_back({a, high.vertices[++j % n], b});
  }
}

/// Mesh of a strip: the two loops as rings with the same direction, the second beginning at the nearest
/// place.
Result<PositionMesh> strip_mesh(const Outline& outline, double radius, Index most_points) {
  const auto& first = outline.loops[0].points;
  std::vector<Vector3> second(outline.loops[1].points.rbegin(), outline.loops[1].points.rend());
  const Ring low(first, 0);
  double begin = 0, least = HUGE_VAL;
  for (std::size_t k = 0; k < second.size(); ++k) {
    const double shift = Ring(second, 0).share(k);
    const Ring turned(second, shift);
    double sum = 0;
    for (int i = 0; i < 32; ++i) sum += (low.at(i / 32.0) - turned.at(i / 32.0)).squaredNorm();
    if (sum < least) {
      least = sum;
      begin = shift;
    }
  }
  const Ring high(second, begin);
  const double step = 0.5 * (low.length() / double(first.size()) + high.length() / double(second.size()));
  // Rows of equilateral triangles with circumcircles of radius `radius` in mean steps; at the default radius
  // their sides equal the mean step.
  const double wanted = step * radius / 0.6;
  const double distance = std::sqrt(least / 32);
  const auto rows = std::size_t(std::clamp(std::round(distance / (wanted * std::sqrt(0.75))), 1.0, 1e4));
  PositionMesh out;
  out.in_rows = true;
  out.points = first;
  out.points.insert(out.points.end(), outline.loops[1].points.begin(), outline.loops[1].points.end());
  const auto m = Index(first.size()), n = Index(second.size());
  out.boundary_count = m + n;
  for (Index i = 0; i < m; ++i) out.next.push_back((i + 1) % m);
  for (Index i = 0; i < n; ++i) out.next.push_back(m + (i + 1) % n);
  Row below;
  for (Index i = 0; i < m; ++i) {
    below.vertices.push_back(i);
    below.shares.push_back(low.share(i));
  }
  for (std::size_t r = 1; r < rows; ++r) {
    const double height = double(r) / double(rows);
    const double length = (1 - height) * low.length() + height * high.length();
    const auto count = std::size_t(std::max(3.0, std::round(length / wanted)));
    if (out.points.size() + count > std::size_t(out.boundary_count) + most_points) {
      out.limited = true;
      break;
    }
    Row row;
    for (std::size_t k = 0; k < count; ++k) {
      const double share = (double(k) + (r % 2 ? 0.5 : 0.0)) / double(count);
      row.vertices.push_back(Index(out.points.size()));
      row.shares.push_back(share);
      out.points.push_back((1 - height) * low.at(share) + height * high.at(share));
    }
    stitch(below, row, out.triangles);
    below = std::move(row);
  }
  Row top;
  std::vector<std::pair<double, Index>> order;
  for (Index k = 0; k < n; ++k) order.emplace_back(high.share(k), m + n - 1 - k);
  std::sort(order.begin(), order.end());
  for (const auto& [share, vertex] : order) {
    top.shares.push_back(share);
    top.vertices.push_back(vertex);
  }
  stitch(below, top, out.triangles);
  return out;
}

}  // namespace

Result<PositionMesh> position_mesh(const Outline& outline, double radius, Index most_points) {
  if (outline.loops.size() == 2) return strip_mesh(outline, radius, most_points);
  std::vector<Loop2> layout = projected(outline);
  if (!is_domain(layout)) {
    if (outline.loops.size() > 1)
      return make_error(e_no_layout,
                        "The loops do not lie one inside the other, seen along their mean normal.",
                        "Use another mode, or make the surface from parts with one or two loops.");
    layout = {on_circle(outline.loops[0])};
  }
  return planar_mesh(outline, layout, radius, most_points);
}

}  // namespace hariko
