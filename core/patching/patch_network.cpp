#include "core/patching/patch_network.hpp"

#include "core/base/parallel.hpp"
#include "core/network/ray_matrix.hpp"

namespace hariko {

namespace {

constexpr std::size_t split_face_grain = 512;

/// Right-hand side of the G1 condition at an end P of an edge: R - P = [(3 - 2 c_P - c_Q) T_P + 2 c_P (Q - P
/// + T_Q)] / 3.
Vector3 right_side(const Vector3& p, const Vector3& tp, const Vector3& q, const Vector3& tq, double cp,
                   double cq) {
  return p + ((3 - 2 * cp - cq) * tp + 2 * cp * (q - p + tq)) / 3;
}

/// Inner quartic points of a cubic by degree elevation; symmetric, so that both neighbours get the same bits.
void elevate(const Vector3& v0, const Vector3& v1, const Vector3& v2, const Vector3& v3, Vector3& first,
             Vector3& middle, Vector3& last) {
  first = (3 * v1 + v0) / 4;
  middle = (v1 + v2) / 2;
  last = (3 * v2 + v3) / 4;
}

Vector3 face_mean(const HalfEdgeMesh& mesh, std::span<const Vector3> positions, Index face) {
  Vector3 sum = Vector3::Zero();
  for (const Index v : mesh.face_vertices(face)) sum += positions[v];
  return sum / double(mesh.side_count(face));
}

}  // namespace

Vector3 PatchBuilder::right_side_at_origin(Index h) const {
  return right_side(positions_[mesh_.origin(h)], network_.start[h], positions_[mesh_.target(h)],
                    network_.end[h], constants_.c_origin[h], constants_.c_target[h]);
}

Vector3 PatchBuilder::right_side_at_target(Index h) const {
  return right_side(positions_[mesh_.target(h)], network_.end[h], positions_[mesh_.origin(h)],
                    network_.start[h], constants_.c_target[h], constants_.c_origin[h]);
}

Vector3 PatchBuilder::right_side_at_vertex(Index h) const {
  return right_side(positions_[mesh_.origin(h)], split_.split_tangent[h], split_.centre[mesh_.face(h)],
                    split_.centre_tangent[h], constants_.c_split[h], constants_.c_centre[h]);
}

Vector3 PatchBuilder::right_side_at_centre(Index h) const {
  return right_side(split_.centre[mesh_.face(h)], split_.centre_tangent[h], positions_[mesh_.origin(h)],
                    split_.split_tangent[h], constants_.c_centre[h], constants_.c_split[h]);
}

QuarticPatch PatchBuilder::base_patch(Index h) const {
  using namespace quartic;
  const Index f = mesh_.face(h), following = mesh_.next(h);
  const Vector3 &o = split_.centre[f], &a = positions_[mesh_.origin(h)], &b = positions_[mesh_.target(h)];
  QuarticPatch patch;
  auto& d = patch.control;
  d[d400] = o;
  d[d040] = a;
  d[d004] = b;
  elevate(o, o + split_.centre_tangent[h], a + split_.split_tangent[h], a, d[d310], d[d220], d[d130]);
  elevate(a, a + network_.start[h], b + network_.end[h], b, d[d031], d[d022], d[d013]);
  elevate(b, b + split_.split_tangent[following], o + split_.centre_tangent[following], o, d[d103], d[d202],
          d[d301]);
  d[d211w] = right_side_at_centre(h);
  d[d211v] = right_side_at_centre(following);
  d[d121w] = right_side_at_vertex(h);
  d[d121u] = right_side_at_origin(h);
  d[d112v] = right_side_at_vertex(following);
  d[d112u] = right_side_at_target(h);
  return patch;
}

void fill_split_tangents(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                         const PatchConstants& constants, std::span<const Vector3> positions,
                         const Network& network, std::span<const Index> faces, PatchNetwork& out) {
  const auto free_tangent = [&](Index h) -> Vector3 {
    const Index v = mesh.origin(h);
    const Vector3& p = positions[v];
    if (frames.kind[v] != FrameKind::straight) return (face_mean(mesh, positions, mesh.face(h)) - p) / 3;
    // Valence 2: tau = sum of sign x (c - P) / 3 over sum of x^2; the first corner of the fan counts as left.
    const Index left = mesh.outgoing(v), right = mesh.rotate(left);
    const Index left_face = mesh.face(left), right_face = mesh.face(right);
    const double xl = constants.x[left], xr = constants.x[right];
    const Vector3 tau = (xl * (face_mean(mesh, positions, left_face) - p) -
                         xr * (face_mean(mesh, positions, right_face) - p)) /
                        (3 * (xl * xl + xr * xr));
    return h == left ? Vector3(xl * tau) : Vector3(-xr * tau);
  };
  parallel_for(faces.size(), split_face_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      for (Index h = mesh.face_begin(faces[k]); h < mesh.face_end(faces[k]); ++h) {
        if (constants.free_split[h]) {
          out.split_tangent[h] = free_tangent(h);
          continue;
        }
        const auto [first, second] = frames.split_factors(mesh, h);
        out.split_tangent[h] = first * network.start[h] + second * network.end[mesh.previous(h)];
      }
  });
}

void fill_split_points(const HalfEdgeMesh& mesh, const FaceCharts& charts, std::span<const Vector3> positions,
                       std::span<const Index> faces, PatchNetwork& out) {
  parallel_for(faces.size(), split_face_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index f = faces[k], first = mesh.face_begin(f), n = mesh.side_count(f);
      const Vector3 mean = face_mean(mesh, positions, f);
      RayMatrix rays;
      Matrix3 right = Matrix3::Zero();  // one row per unknown
      for (Index j = 0; j < n; ++j) {
        const Vector2& p = charts.corner[first + j];
        const Vector3& tangent = out.split_tangent[first + j];
        const Vector3 reach = positions[mesh.origin(first + j)] - mean;
        rays.add(p, 1);
        right.row(0) += (2 * reach / 3 + tangent).transpose();
        right.row(1) += p.y() * (reach + tangent).transpose();
        right.row(2) += p.x() * (reach + tangent).transpose();
      }
      const Matrix3 solution = rays.inverse() * right;
      out.centre[f] = mean + solution.row(0).transpose();
      for (Index j = 0; j < n; ++j) {
        const Vector2& p = charts.corner[first + j];
        out.centre_tangent[first + j] = (p.y() * solution.row(1) + p.x() * solution.row(2)).transpose();
      }
    }
  });
}

}  // namespace hariko
