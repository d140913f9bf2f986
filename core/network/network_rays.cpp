#include "core/network/network_rays.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/parallel.hpp"
#include "core/network/ray_matrix.hpp"

namespace hariko {

namespace {

constexpr std::size_t face_grain = 512;
constexpr double least_share = 1e-3;
/// Least edge length, relative to the mean length: shorter edges count as edges of about this length.
constexpr double least_length = 1e-6;

/// Angle between half-edge h and the split edge of the corner at its origin, in the vertex's fan.
double angle_to_split(const HalfEdgeMesh& mesh, const VertexFrames& frames, Index h) {
  if (frames.half_turn[h]) return frames.step[h] / 2;
  const auto [first, second] = frames.split_factors(mesh, h);
  const double a = frames.length[2 * h], b = frames.length[2 * mesh.previous(h) + 1], step = frames.step[h];
  return std::atan2(second * b * std::sin(step), first * a + second * b * std::cos(step));
}

/// Adds a tangent times a factor; together they depend on at most two basis vectors.
void add_tangent(const TangentCoefficients& from, double factor, TangentCoefficients& to) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (from.basis[i] == no_index) continue;
    std::size_t k = 0;
    while (k < 2 && to.basis[k] != no_index && to.basis[k] != from.basis[i]) ++k;
    HARIKO_ASSERT(k < 2, "two basis vectors are enough for a corner");
    to.basis[k] = from.basis[i];
    to.c[k] += factor * from.c[i];
  }
}

}  // namespace

NetworkWeights network_weights(const HalfEdgeMesh& mesh, const VertexFrames& frames) {
  NetworkWeights out;
  out.edge.assign(mesh.edge_count(), 1.0);
  const FaceCharts& charts = frames.charts;
  if (charts.frames == Frames::equal) return out;
  out.ray.resize(mesh.half_edge_count());
  std::vector<double> share(mesh.edge_count(), 0.0);  // mean over both ends
  const auto by_length = [&](double length) {
    return 1 / std::sqrt(std::hypot(length / charts.mean_length, least_length));
  };
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const double step = frames.step[h], first = angle_to_split(mesh, frames, h);
    out.ray[h] = step / (4 * std::numbers::pi) * by_length(charts.ray_length[h]);
    share[mesh.edge(h)] += first / (8 * std::numbers::pi);
    share[mesh.edge(mesh.previous(h))] += (step - first) / (8 * std::numbers::pi);
  }
  for (Index e = 0; e < mesh.edge_count(); ++e)
    out.edge[e] = std::max(share[e], least_share) * by_length(charts.edge_length[e]);
  return out;
}

NetworkRays::NetworkRays(std::shared_ptr<const HalfEdgeMesh> mesh, const VertexFrames& frames,
                         std::span<const double> alpha, std::span<const double> weight,
                         const BalancedPulls& balanced)
    : mesh_(std::move(mesh)), rays_(mesh_->half_edge_count()), inverse_(mesh_->face_count()) {
  for (Index f = 0; f < mesh_->face_count(); ++f) {
    RayMatrix matrix;
    for (Index h = mesh_->face_begin(f); h < mesh_->face_end(f); ++h) {
      Ray& ray = rays_[h];
      const Vector2& p = frames.charts.corner[h];
      ray.weight = weight[h];
      ray.coupling = balanced.of_split_edge(h);
      ray.alpha = alpha[mesh_->origin(h)];
      ray.place = Vector3(1, p.y(), p.x());
      matrix.add(p, ray.weight);
      if (frames.half_turn[h]) continue;
      const auto [first, second] = frames.split_factors(*mesh_, h);
      add_tangent(frames.ends[2 * h], first, ray.tangent);
      add_tangent(frames.ends[2 * mesh_->previous(h) + 1], second, ray.tangent);
    }
    inverse_[f] = matrix.inverse();
  }
}

template <class Body>
void NetworkRays::for_rays(Index v, const Body& body) const {
  const Index first = mesh_->outgoing(v);
  for (Index h = first; h != no_index;) {
    body(h, rays_[h]);
    h = mesh_->rotate(h);
    if (h == first) break;
  }
}

NetworkRays::Workspace NetworkRays::make_workspace(std::span<const Index> vertices) const {
  Workspace work;
  if (empty()) return work;
  work.tangent.assign(mesh_->half_edge_count(), Vector3::Zero());
  work.split_point.assign(mesh_->face_count(), Matrix3::Zero());
  std::vector<bool> near(mesh_->face_count(), false);
  for (const Index v : vertices) for_rays(v, [&](Index h, const Ray&) { near[mesh_->face(h)] = true; });
  for (Index f = 0; f < mesh_->face_count(); ++f)
    if (near[f]) work.faces.push_back(f);
  return work;
}

void NetworkRays::add_diagonal(Index v, Index first, Eigen::MatrixXd& block) const {
  if (empty()) return;
  for_rays(v, [&](Index h, const Ray& ray) {
    if (ray.known()) return;
    const double answer = ray.place.dot(inverse_[mesh_->face(h)] * ray.place);
    const double weight =
        ray.weight * (2 * (1 + ray.alpha) - ray.coupling * ray.coupling * ray.weight * answer);
    const TangentCoefficients& t = ray.tangent;
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t b = 0; b < 2; ++b)
        if (t.basis[a] != no_index && t.basis[b] != no_index)
          block(t.basis[a] - first, t.basis[b] - first) += weight * t.c[a] * t.c[b];
  });
}

void NetworkRays::set_tangents(Index v, const std::vector<Vector3>& x, Workspace& work) const {
  for_rays(v, [&](Index h, const Ray& ray) {
    if (ray.known()) return;
    work.tangent[h] = tangent_image(ray.tangent, x);
  });
}

void NetworkRays::answer(std::size_t begin, std::size_t end, Workspace& work) const {
  for (std::size_t k = begin; k < end; ++k) {
    const Index f = work.faces[k];
    Matrix3 sum = Matrix3::Zero();
    for (Index h = mesh_->face_begin(f); h < mesh_->face_end(f); ++h)
      sum += (rays_[h].coupling * rays_[h].weight * rays_[h].place) * work.tangent[h].transpose();
    work.split_point[f] = inverse_[f] * sum;
  }
}

void NetworkRays::add_product(Index v, const Workspace& work, std::vector<Vector3>& y) const {
  for_rays(v, [&](Index h, const Ray& ray) {
    if (ray.known()) return;
    const Vector3 end = work.split_point[mesh_->face(h)].transpose() * ray.place;
    const Vector3 gradient = ray.weight * (2 * (1 + ray.alpha) * work.tangent[h] - ray.coupling * end);
    add_to_basis(ray.tangent, gradient, y);
  });
}

void NetworkRays::add_right_side(std::span<const Index> vertices, std::span<const Vector3> positions,
                                 std::vector<Vector3>& b) const {
  if (empty()) return;
  Workspace work = make_workspace(vertices);
  std::vector<Vector3> middle(mesh_->face_count());
  parallel_for(work.faces.size(), face_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index f = work.faces[k];
      // Relative to the mean of the face, so that no digits are lost far from the origin.
      const Vector3& reference = positions[mesh_->origin(mesh_->face_begin(f))];
      Vector3 mean = Vector3::Zero();
      for (const Index v : mesh_->face_vertices(f)) mean += positions[v] - reference;
      middle[f] = reference + mean / double(mesh_->side_count(f));
      Matrix3 sum = Matrix3::Zero();
      for (Index h = mesh_->face_begin(f); h < mesh_->face_end(f); ++h) {
        const Ray& ray = rays_[h];
        const Vector3 reach = positions[mesh_->origin(h)] - middle[f];
        const Vector3 tangent = ray.known() ? Vector3(-reach / 3) : Vector3::Zero();
        sum += (ray.weight * ray.place) * (reach + tangent).transpose();
        sum.row(0) -= ray.weight / 3 * reach.transpose();
      }
      work.split_point[f] = inverse_[f] * sum;
    }
  });
  for (const Index v : vertices)
    for_rays(v, [&](Index h, const Ray& ray) {
      if (ray.known()) return;
      const Index f = mesh_->face(h);
      const Vector3 reach = middle[f] - positions[v];
      const Vector3 pull =
          ray.weight * (ray.coupling * (work.split_point[f].transpose() * ray.place + reach) +
                        (1 - ray.coupling) * 2 / 3 * reach);
      add_to_basis(ray.tangent, pull, b);
    });
}

}  // namespace hariko
