#include "core/g2/faces/corner_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/g2/faces/chart_polygon.hpp"

namespace hariko {

namespace {

/// Least distance across an edge, relative to the edge's length.
constexpr double least_across = 0.02;

/// Extents of the corners' faces: per corner, across the edge that opens it and the one that closes it.
struct Extents {
  std::vector<double> over_out, over_in;
};

/// Extents of a corner's face across the corner's two edges, in the chart of its vertex: the heights of the
/// other edge.
std::pair<double, double> heights(const CornerShape& at) {
  if (is_straight(at.angle)) return {at.out, at.in};
  return {at.in * std::sin(at.angle), at.out * std::sin(at.angle)};
}

/// The same as the depths of the face's chart, by its scale in the corner.
std::pair<double, double> depths(const CornerShape& at, const Vector2& corner, const Vector2& next,
                                 const Vector2& previous) {
  const Vector2 forward = next - corner, back = previous - corner;
  const double twice = cross(forward, back), out = 2 * cross(corner, next), in = 2 * cross(previous, corner);
  const auto [over_out, over_in] = heights(at);
  if (!is_straight(at.angle)) {
    const double angle = linear_angle(at, corner, next, previous), over = std::sin(angle) * at.angle / angle;
    return {at.in * over * out / twice, at.out * over * in / twice};
  }
  if (!lies_straight(previous, corner, next)) return {over_out, over_in};
  return {at.out * out / forward.squaredNorm(), at.in * in / back.squaredNorm()};
}

Extents extents(const HalfEdgeMesh& mesh, const FaceCharts& charts, const std::vector<CornerShape>& corners) {
  Extents out{std::vector<double>(corners.size()), std::vector<double>(corners.size())};
  std::vector<Vector2> polygon;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index begin = mesh.face_begin(f), n = mesh.side_count(f);
    const bool metric = charts.frames == Frames::metric;
    if (metric)
      polygon =
          chart_polygon(std::span(charts.corner).subspan(begin, n), std::span(corners).subspan(begin, n));
    for (Index j = 0; j < n; ++j) {
      const CornerShape& at = corners[begin + j];
      const auto [over_out, over_in] =
          metric ? depths(at, polygon[j], polygon[(j + 1) % n], polygon[(j + n - 1) % n]) : heights(at);
      out.over_out[begin + j] = std::max(over_out, least_across * at.out);
      out.over_in[begin + j] = std::max(over_in, least_across * at.in);
    }
  }
  return out;
}

/// Distances of the faces' centres from their corners, by the scale of the corner's edges.
void set_centre_distances(const HalfEdgeMesh& mesh, const FaceCharts& charts,
                          std::vector<CornerShape>& corners) {
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Vector2& at = charts.corner[h];
    const double forward = (charts.corner[mesh.next(h)] - at).norm();
    const double back = (charts.corner[mesh.previous(h)] - at).norm();
    if (!(forward > 0 && back > 0)) continue;
    corners[h].centre_distance = at.norm() * std::sqrt(corners[h].out / forward * corners[h].in / back);
  }
}

}  // namespace

std::vector<double> fan_units(const HalfEdgeMesh& mesh, const VertexFrames& frames) {
  std::vector<double> sum(mesh.vertex_count(), 0.0), count(mesh.vertex_count(), 0.0);
  const auto add = [&](Index v, double length) {
    sum[v] += length;
    count[v] += 1;
  };
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    add(mesh.origin(h), frames.length[2 * h]);
    if (mesh.twin(h) == no_index) add(mesh.target(h), frames.length[2 * h + 1]);
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) sum[v] = count[v] > 0 ? sum[v] / count[v] : 1;
  return sum;
}

std::vector<CornerShape> corner_shapes(const HalfEdgeMesh& mesh, const VertexFrames& frames) {
  const std::vector<double> unit = fan_units(mesh, frames);
  std::vector<CornerShape> out(mesh.half_edge_count());
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const double scale = 1 / unit[mesh.origin(h)];
    out[h].angle = frames.step[h];
    out[h].out = scale * frames.length[2 * h];
    out[h].in = scale * frames.length[2 * mesh.previous(h) + 1];
  }
  if (frames.charts.frames == Frames::metric) set_centre_distances(mesh, frames.charts, out);
  const auto [over_out, over_in] = extents(mesh, frames.charts, out);
  const auto shared = [&](Index edge_of) {
    return mesh.twin(edge_of) != no_index && !frames.sharp[mesh.edge(edge_of)];
  };
  // Beside borders and creases nothing has to agree, and joined sides are given by heights.
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index closing = mesh.previous(h);
    CornerShape& at = out[h];
    const auto [height_out, height_in] = heights(at);
    at.across_out = shared(h) ? std::sqrt(over_out[h] * over_in[mesh.next(mesh.twin(h))])
                              : std::max(height_out, least_across * at.out);
    at.across_in = shared(closing) ? std::sqrt(over_in[h] * over_out[mesh.twin(closing)])
                                   : std::max(height_in, least_across * at.in);
  }
  return out;
}

}  // namespace hariko
