#include "core/gaussmap/sphere/lloyd_relaxed_sites.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/gaussmap/sphere/edge_flips.hpp"
#include "core/geometry/angles.hpp"
#include "core/geometry/orientation.hpp"

namespace hariko {
namespace {

using Triangle = SphereMesh::Triangle;

/// Flips edges to a Delaunay triangulation. Each flip adds volume under the triangles, so the flips
/// terminate.
std::vector<Triangle> delaunay(const std::vector<Vector3>& sites, std::vector<Triangle> triangles) {
  const auto outward = [&](Index a, Index b, Index c) {
    return side_of_plane(Vector3::Zero(), sites[a], sites[b], sites[c]) > 0;
  };
  return flip_edges(std::move(triangles), Index(sites.size()), 2, [&](Index p, Index q, Index r, Index s) {
    return side_of_plane(sites[p], sites[q], sites[r], sites[s]) > 0 && outward(p, s, r) && outward(s, q, r);
  });
}

Vector3 centroid(const SphereMesh& mesh, Index site) {
  const std::vector<Vector3> corners = mesh.cell(site);
  Vector3 sum = Vector3::Zero();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector3 &a = corners[k], &b = corners[(k + 1) % corners.size()];
    sum += solid_angle(mesh.site(site), a, b) * (mesh.site(site) + a + b);
  }
  return sum.normalized();
}

/// Whether a site lies in the circle over the arc of a loop from a boundary site, where no site may be
/// (gaussmap.md 3).
bool in_cap(const SphereMesh& mesh, Index from, const Vector3& site) {
  if (!mesh.is_boundary(from)) return false;
  const Vector3 &a = mesh.site(from), &b = mesh.site(mesh.next(from));
  return site.dot((a + b).normalized()) > std::cos(angle_between(a, b) / 2);
}

}  // namespace

SphereMesh relaxed(const SphereMesh& mesh, int rounds) {
  constexpr double reach = 1.5;  // step relative to that to the centroid: as even in half the rounds
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
    std::vector<Triangle> triangles = delaunay(sites, now.triangles());
    now = SphereMesh(std::move(sites), next, std::move(triangles));
  }
  return now;
}

}  // namespace hariko
