#include "core/network/face_charts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "core/base/parallel.hpp"

namespace hariko {

namespace {

/// Least size of a chart, relative to the mean edge length, so that faces without size keep a chart.
constexpr double least_chart_size = 1e-6;
/// Least opening of a face, that of a rectangle 4000 times as long as wide; narrower faces count as
/// flattened. With twice this value, the sides of a prism of 128 sides and height 100 would.
constexpr double short_side = 0.01;  ///< relative to the mean side of a face
constexpr double least_opening = 5e-4;
/// Least share of the side between its neighbours that a corner on a side keeps from both.
constexpr double least_part = 0.005;

double det(const Vector2& a, const Vector2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Chart of one face, from its corners in space.
class PolygonChart {
 public:
  PolygonChart(std::span<const Vector3> corners, double least_size)
      : n_(corners.size()), p_(n_, Vector2::Zero()), regular_(p_), affine_(p_) {
    project(corners, least_size);
    find_regular();
    if (!flat_) unfold();
    widen();
    lift();
    for (std::size_t j = 0; j < n_; ++j)
      if (!(area(j) > 1e-12 * size_ * size_)) {
        p_ = regular_;
        break;
      }
  }

  const std::vector<Vector2>& corners() const { return p_; }
  double area(std::size_t j) const { return det(p_[j], p_[(j + 1) % n_]) / 2; }

  void make_regular_of_same_area() {
    double sum = 0;
    for (std::size_t j = 0; j < n_; ++j) sum += area(j);
    const double radius = std::sqrt(2 * sum / (double(n_) * std::sin(2 * std::numbers::pi / double(n_))));
    for (std::size_t j = 0; j < n_; ++j) p_[j] = radius * direction(j);
  }

 private:
  Vector2 direction(std::size_t j) const {
    const double angle = 2 * std::numbers::pi * double(j) / double(n_);
    return {std::cos(angle), std::sin(angle)};
  }

  /// Projects along the mean normal, from the mean of the sides weighted by length.
  void project(std::span<const Vector3> corners, double least_size) {
    const Vector3& first = corners[0];
    Vector3 centre = Vector3::Zero(), mean = Vector3::Zero();
    double length = 0;
    for (std::size_t j = 0; j < n_; ++j) {
      const Vector3 a = corners[j] - first, b = corners[(j + 1) % n_] - first;
      const double side = (b - a).norm();
      centre += side * (a + b) / 2;
      mean += a / double(n_);
      length += side;
    }
    centre = length > 0 ? Vector3(centre / length) : mean;
    std::vector<Vector3> r(n_);
    double square = 0;
    Vector3 normal = Vector3::Zero();
    for (std::size_t j = 0; j < n_; ++j) {
      r[j] = corners[j] - first - centre;
      square += r[j].squaredNorm() / double(n_);
    }
    for (std::size_t j = 0; j < n_; ++j) normal += r[j].cross(r[(j + 1) % n_]);
    size_ = std::max(std::sqrt(square), least_size);
    flat_ = !(normal.norm() > 1e-9 * size_ * size_);
    if (flat_) return;
    normal.normalize();
    // Any axes of the plane would do; these depend on the longest arm.
    const auto longest = std::max_element(r.begin(), r.end(), [](const Vector3& a, const Vector3& b) {
      return a.squaredNorm() < b.squaredNorm();
    });
    const Vector3 e = (*longest - normal * normal.dot(*longest)).normalized(), f = normal.cross(e);
    for (std::size_t j = 0; j < n_; ++j) p_[j] = Vector2(r[j].dot(e), r[j].dot(f));
  }

  void find_regular() {
    for (std::size_t j = 0; j < n_; ++j) {
      affine_[j].setZero();
      for (std::size_t i = 0; i < n_; ++i)
        affine_[j] +=
            2 / double(n_) * std::cos(2 * std::numbers::pi * (double(i) - double(j)) / double(n_)) * p_[i];
    }
    const double length = affine_[0].norm();
    const Vector2 axis = length > 0 ? Vector2(affine_[0] / length) : Vector2(1, 0);
    for (std::size_t j = 0; j < n_; ++j) {
      const Vector2 d = direction(j);
      regular_[j] = size_ * Vector2(axis.x() * d.x() - axis.y() * d.y(), axis.y() * d.x() + axis.x() * d.y());
    }
    if (flat_) p_ = affine_ = regular_;
  }

  /// Moves a face whose affine part has no area, or is inverted, towards the regular polygon.
  void unfold() {
    const double opening =
        det(affine_[0], affine_[1]) / (size_ * size_ * std::sin(2 * std::numbers::pi / double(n_)));
    const double share = std::clamp(1 - opening / least_opening, 0.0, 1.0);
    if (share == 0) return;
    for (std::size_t j = 0; j < n_; ++j) {
      p_[j] += share * (regular_[j] - p_[j]);
      affine_[j] += share * (regular_[j] - affine_[j]);
    }
  }

  /// Moves the corners towards the affine part as soon as a patch gets flat, its height far below the mean
  /// height. Sides far shorter than the others do not count, since their height is arbitrary.
  void widen() {
    double sum = 0, length = 0;
    for (std::size_t j = 0; j < n_; ++j) {
      sum += area(j);
      length += side(j);
    }
    const double mean = length > 0 ? sum / length : 0;
    double least = INFINITY;
    for (std::size_t j = 0; j < n_; ++j) {
      const double gap = std::max(0.0, short_side * length / double(n_) - side(j));
      least = std::min(least, (area(j) + gap * mean) / (side(j) + gap));
    }
    const double s = mean > 0 ? std::clamp(least / mean / 0.1, 0.0, 1.0) : 0.0;
    blend(1 - s * s * (3 - 2 * s));
  }

  /// Keeps the areas at short sides above zero, as fan_length keeps the lengths at vertices.
  void lift() {
    double least = INFINITY, sum = 0;
    for (std::size_t j = 0; j < n_; ++j) {
      least = std::min(least, area(j));
      sum += area(j);
    }
    if (sum > 0) blend(short_side * std::clamp(1 - least * double(n_) / (short_side * sum), 0.0, 1.0));
  }

  double side(std::size_t j) const { return (p_[(j + 1) % n_] - p_[j]).norm(); }
  void blend(double share) {
    if (share == 0) return;
    for (std::size_t j = 0; j < n_; ++j) p_[j] += share * (affine_[j] - p_[j]);
  }

  std::size_t n_;
  std::vector<Vector2> p_, regular_, affine_;
  double size_ = 0;
  bool flat_ = false;
};

}  // namespace

double split_factor(Index sides) {
  const double s = std::sin(std::numbers::pi / double(sides));
  return 1 / (4 * s * s);
}

FaceCharts equal_charts(const HalfEdgeMesh& mesh) {
  FaceCharts out;
  const Index count = mesh.half_edge_count();
  out.corner.resize(count);
  out.square.assign(count, 1.0);
  out.dot.resize(count);
  out.area.resize(count);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const double step = 2 * std::numbers::pi / double(mesh.side_count(f)),
                 area = split_factor(mesh.side_count(f));
    for (Index h = mesh.face_begin(f), j = 0; h < mesh.face_end(f); ++h, ++j) {
      out.corner[h] = Vector2(std::cos(step * j), std::sin(step * j));
      out.dot[h] = std::cos(step);
      out.area[h] = area;
    }
  }
  return out;
}

namespace {

/// Corners of a face's chart: those of `polygon` (by their numbers in the face), and the others on its sides,
/// where corner j divides the part of the side between its neighbours at share[j].
std::vector<Vector2> with_corners_on_sides(const std::vector<Vector2>& polygon,
                                           const std::vector<std::size_t>& numbers,
                                           std::span<const double> share) {
  const std::size_t n = share.size();
  std::vector<Vector2> out(n);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t from = numbers[i], to = numbers[(i + 1) % numbers.size()];
    const Vector2 &a = polygon[i], &b = polygon[(i + 1) % numbers.size()];
    const std::size_t between = (to + n - from - 1) % n;
    std::vector<double> gap(between + 1, 1.0);
    for (std::size_t k = 0; k < between; ++k) {
      const double s = std::clamp(share[(from + 1 + k) % n], least_part, 1 - least_part);
      gap[k + 1] = gap[k] * (1 - s) / s;
    }
    const double whole = std::accumulate(gap.begin(), gap.end(), 0.0);
    double along = 0;
    out[from] = a;
    for (std::size_t k = 0; k < between; ++k) {
      along += gap[k];
      out[(from + 1 + k) % n] = a + along / whole * (b - a);
    }
  }
  return out;
}

/// Chart of one face. Its polygon has the corners of the face except those that lie on sides.
std::vector<Vector2> metric_chart(std::span<const Vector3> corners, std::span<const double> share,
                                  bool regular, double least_size) {
  std::vector<std::size_t> numbers;
  for (std::size_t j = 0; j < corners.size(); ++j)
    if (share[j] == 0) numbers.push_back(j);
  if (numbers.size() < 3) {
    numbers.resize(corners.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  }
  std::vector<Vector3> polygon;
  for (const std::size_t j : numbers) polygon.push_back(corners[j]);
  PolygonChart chart(polygon, least_size);
  if (regular) chart.make_regular_of_same_area();
  return numbers.size() == corners.size() ? chart.corners()
                                          : with_corners_on_sides(chart.corners(), numbers, share);
}

}  // namespace

FaceCharts metric_charts(const Polyhedron& polyhedron, const std::vector<bool>& half_turn,
                         std::span<const double> side_share) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  FaceCharts out;
  out.frames = Frames::metric;
  out.edge_length.resize(mesh.edge_count());
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    out.edge_length[e] = (polyhedron.position(mesh.target(h)) - polyhedron.position(mesh.origin(h))).norm();
    out.mean_length += out.edge_length[e] / double(mesh.edge_count());
  }
  if (!(out.mean_length > 0)) out.mean_length = 1;  // all vertices in one place: no scale of its own
  const Index count = mesh.half_edge_count();
  out.corner.resize(count);
  out.square.resize(count);
  out.dot.resize(count);
  out.area.resize(count);
  out.ray_length.resize(count);
  parallel_for(mesh.face_count(), 256, [&](std::size_t begin, std::size_t end) {
    std::vector<Vector3> corners;
    std::vector<double> share;
    for (Index f = Index(begin); f < Index(end); ++f) {
      corners.clear();
      share.clear();
      bool regular = false;
      for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
        corners.push_back(polyhedron.position(mesh.origin(h)));
        share.push_back(side_share.empty() ? 0.0 : side_share[h]);
        regular = regular || half_turn[h];
      }
      Vector3 mean = Vector3::Zero();
      for (const Vector3& corner : corners) mean += (corner - corners[0]) / double(corners.size());
      const std::vector<Vector2> chart =
          metric_chart(corners, share, regular, least_chart_size * out.mean_length);
      const std::size_t n = corners.size();
      for (std::size_t j = 0; j < n; ++j) {
        const Index h = mesh.face_begin(f) + Index(j);
        const Vector2 &p = chart[j], &q = chart[(j + 1) % n];
        out.corner[h] = p;
        out.square[h] = p.squaredNorm();
        out.dot[h] = p.dot(q);
        out.area[h] = det(p, q) / 2;
        out.ray_length[h] = (mean - (corners[j] - corners[0])).norm();
      }
    }
  });
  return out;
}

}  // namespace hariko
