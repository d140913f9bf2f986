#include "core/g2/faces/corner_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

/// Least distance across an edge, relative to the edge's length.
constexpr double least_across = 0.02;

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
  // Extent of each corner across its two edges.
  std::vector<double> over_out(out.size()), over_in(out.size());
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    CornerShape& at = out[h];
    const double scale = 1 / unit[mesh.origin(h)];
    at.angle = frames.step[h];
    at.out = scale * frames.length[2 * h];
    at.in = scale * frames.length[2 * mesh.previous(h) + 1];
    const double sine = is_straight(at.angle) ? 0 : std::sin(at.angle);
    over_out[h] = is_straight(at.angle) ? at.out : std::max(at.in * sine, least_across * at.out);
    over_in[h] = is_straight(at.angle) ? at.in : std::max(at.out * sine, least_across * at.in);
  }
  const auto shared = [&](Index edge_of) {
    return mesh.twin(edge_of) != no_index && !frames.sharp[mesh.edge(edge_of)];
  };
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index closing = mesh.previous(h);
    const double beside_out = shared(h) ? over_in[mesh.next(mesh.twin(h))] : over_out[h];
    const double beside_in = shared(closing) ? over_out[mesh.twin(closing)] : over_in[h];
    out[h].across_out = std::sqrt(over_out[h] * beside_out);
    out[h].across_in = std::sqrt(over_in[h] * beside_in);
  }
  return out;
}

}  // namespace hariko
