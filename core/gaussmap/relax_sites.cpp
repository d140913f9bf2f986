#include "core/gaussmap/relax_sites.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "core/gaussmap/orientation.hpp"

namespace hariko {
namespace {

using Triangle = SphereMesh::Triangle;

/// A triangulation whose edges are flipped to a Delaunay one. Side k of a triangle runs from corner k to
/// corner k + 1.
class Flipping {
 public:
  Flipping(const std::vector<Vector3>& sites, std::vector<Triangle> triangles)
      : sites_(sites), triangles_(std::move(triangles)), beyond_(triangles_.size()) {
    std::unordered_map<std::uint64_t, Index> left_of;
    left_of.reserve(3 * triangles_.size());
    for (Index t = 0; t < triangles_.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) left_of[key(corner(t, k), corner(t, k + 1))] = t;
    for (Index t = 0; t < triangles_.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto found = left_of.find(key(corner(t, k + 1), corner(t, k)));
        beyond_[t][k] = found == left_of.end() ? no_index : found->second;
      }
  }

  std::vector<Triangle> run() {
    for (Index t = 0; t < triangles_.size(); ++t) waiting_.push_back(t);
    while (!waiting_.empty()) {
      const Index t = waiting_.back();
      waiting_.pop_back();
      for (std::size_t k = 0; k < 3; ++k)
        if (flip(t, k)) break;
    }
    return std::move(triangles_);
  }

 private:
  static std::uint64_t key(Index a, Index b) { return (std::uint64_t(a) << 32) | b; }
  Index corner(Index t, std::size_t k) const { return triangles_[t][k % 3]; }
  std::size_t side(Index t, Index from) const {
    return triangles_[t][0] == from ? 0 : triangles_[t][1] == from ? 1 : 2;
  }
  bool faces_outward(Index a, Index b, Index c) const {
    return side_of_plane(Vector3::Zero(), sites_[a], sites_[b], sites_[c]) > 0;
  }
  void join(Index t, std::size_t k, Index beyond) {
    beyond_[t][k] = beyond;
    if (beyond != no_index) beyond_[beyond][side(beyond, corner(t, k + 1))] = t;
  }

  /// Puts the other diagonal where the far corner lies in the circle. Each flip adds volume under the
  /// triangles, so there is an end to it.
  bool flip(Index t, std::size_t k) {
    const Index u = beyond_[t][k];
    if (u == no_index) return false;
    const Index p = corner(t, k), q = corner(t, k + 1), r = corner(t, k + 2);
    const std::size_t j = side(u, q);
    const Index s = corner(u, j + 2);
    if (side_of_plane(sites_[p], sites_[q], sites_[r], sites_[s]) <= 0) return false;
    if (!faces_outward(p, s, r) || !faces_outward(s, q, r)) return false;
    const Index after_q = beyond_[t][(k + 1) % 3], after_r = beyond_[t][(k + 2) % 3];
    const Index after_p = beyond_[u][(j + 1) % 3], after_s = beyond_[u][(j + 2) % 3];
    triangles_[t] = {p, s, r};
    triangles_[u] = {s, q, r};
    join(t, 0, after_p);
    join(t, 2, after_r);
    join(u, 0, after_s);
    join(u, 1, after_q);
    join(t, 1, u);
    waiting_.push_back(t);
    waiting_.push_back(u);
    return true;
  }

  const std::vector<Vector3>& sites_;
  std::vector<Triangle> triangles_;
  std::vector<std::array<Index, 3>> beyond_;  ///< the triangle over each side
  std::vector<Index> waiting_;
};

Vector3 centroid(const SphereMesh& mesh, Index site) {
  const std::vector<Vector3> corners = mesh.cell(site);
  Vector3 sum = Vector3::Zero();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector3 &a = corners[k], &b = corners[(k + 1) % corners.size()];
    sum += solid_angle(mesh.site(site), a, b) * (mesh.site(site) + a + b);
  }
  return sum.normalized();
}

/// Within the circle over the arc of a loop from a boundary site, where no site may be (gaussmap.md 3.4).
bool in_cap(const SphereMesh& mesh, Index from, const Vector3& site) {
  if (!mesh.is_boundary(from)) return false;
  const Vector3 &a = mesh.site(from), &b = mesh.site(mesh.next(from));
  return site.dot((a + b).normalized()) > std::cos(angle_between(a, b) / 2);
}

}  // namespace

SphereMesh relaxed(const SphereMesh& mesh, int rounds) {
  constexpr double reach = 1.5;  // beyond the centroid: as even in half the rounds
  std::vector<Index> next;
  for (Index i = 0; i < mesh.boundary_count(); ++i) next.push_back(mesh.next(i));
  SphereMesh now = mesh;
  for (int round = 0; round < rounds; ++round) {
    std::vector<Vector3> sites = now.sites();
    for (Index i = now.boundary_count(); i < now.site_count(); ++i) {
      const Vector3 old = sites[i];
      sites[i] = (old + reach * (centroid(now, i) - old)).normalized();
      const auto& ring = now.ring(i);
      bool fits = sites[i].allFinite();
      for (const Index t : ring.triangles) {
        const auto& [a, b, c] = now.triangles()[t];
        fits = fits && side_of_plane(Vector3::Zero(), sites[a], sites[b], sites[c]) > 0;
      }
      for (std::size_t k = 0; fits && k < ring.neighbours.size(); ++k)
        fits = !in_cap(now, ring.neighbours[k], sites[i]);
      if (!fits) sites[i] = old;
    }
    std::vector<Triangle> triangles = Flipping(sites, now.triangles()).run();
    now = SphereMesh(std::move(sites), next, std::move(triangles));
  }
  return now;
}

}  // namespace hariko
