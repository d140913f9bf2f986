#include "core/g2/g2_given.hpp"

#include <cmath>

namespace hariko {

namespace {

/// Tangents (g1, g2) of the corner at a half-edge's origin, from the network; g2 is zero at straight corners.
std::array<Vector3, 2> network_frame(const G2Layout& layout, Index h, const Network& network) {
  const CornerShape& at = layout.corner(h);
  const Vector3 g1 = 3 / at.out * network.start[h];
  if (is_straight(at.angle)) return {g1, Vector3::Zero()};
  // The edge that closes the corner lies at its angle: 3 T = cos g1 + sin g2.
  const Vector3 closing = 3 / at.in * network.end[layout.mesh().previous(h)];
  return {g1, (closing - std::cos(at.angle) * g1) / std::sin(at.angle)};
}

}  // namespace

Vector3 face_mean(const HalfEdgeMesh& mesh, Index face, const G2Given& given) {
  Vector3 sum = Vector3::Zero();
  for (const Index v : mesh.face_vertices(face)) sum += given.positions[v];
  return sum / double(mesh.side_count(face));
}

void given_controls(const G2Layout& layout, Index face, const G2Given& given, const Vector3& origin,
                    Vector3* out) {
  const FaceChart& of = layout.chart(face);
  for (int j = 0; j < of.sides(); ++j)
    *out++ = given.positions[layout.mesh().origin(layout.half_edge(face, j))] - origin;
  for (int j = 0; j < of.sides(); ++j) {
    if (!of.joined(j)) continue;
    const GivenSides::Side* side = given.sides ? given.sides->find(layout.half_edge(face, j)) : nullptr;
    for (int i = 0; i < side_departure_count; ++i)
      *out++ = side ? side->departure[std::size_t(i)] : Vector3(Vector3::Zero());
  }
}

void add_tangents(const G2Layout& layout, const FaceWeights& weights, Index face, const Network& network,
                  Vector3* local) {
  const FaceChart& of = layout.chart(face);
  const int n = of.sides();
  for (int j = 0; j < n; ++j) {
    const Index h = layout.half_edge(face, j);
    const auto at = static_cast<std::size_t>(j);
    const Vector3 out = 3 * weights.tangent_out[at] * of.corner(j).out * network.start[h];
    const Vector3 in = 3 * weights.tangent_in[at] * of.corner(j).in * network.end[layout.mesh().previous(h)];
    local[8 * n + 2 * j] += out + of.cosine(j) * in;
    local[8 * n + 2 * j + 1] += of.sine(j) * in;
  }
}

std::vector<std::pair<Index, Vector3>> known_unknowns(const G2Layout& layout, const std::vector<bool>& fixed,
                                                      const G2Given& given) {
  const HalfEdgeMesh& mesh = layout.mesh();
  std::vector<std::pair<Index, Vector3>> out;
  if (given.sides) out = given.sides->unknowns;
  for (Index h = 0; !fixed.empty() && h < mesh.half_edge_count(); ++h) {
    if (!fixed[mesh.origin(h)]) continue;
    const CornerUnknowns& corner = layout.unknowns().corner[h];
    const Eigen::Matrix2d& inverse = layout.inverse_tangent_turn(h);
    const auto [g1, g2] = network_frame(layout, h, *given.network);
    if (is_straight(layout.frames().step[h])) {
      out.emplace_back(corner.tangent[0], inverse(0, 0) * g1);
      continue;
    }
    for (int i = 0; i < 2; ++i)
      out.emplace_back(corner.tangent[std::size_t(i)], inverse(i, 0) * g1 + inverse(i, 1) * g2);
  }
  return out;
}

}  // namespace hariko
