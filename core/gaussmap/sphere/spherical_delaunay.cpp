#include "core/gaussmap/sphere/spherical_delaunay.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/assert.hpp"

namespace hariko {

Vector3 sphere_circumcentre(const Vector3& a, const Vector3& b, const Vector3& c) {
  return (b - a).cross(c - a).normalized();
}

double solid_angle(const Vector3& a, const Vector3& b, const Vector3& c) {
  return 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

Index nearest_boundary(const std::vector<Vector3>& sites, Index boundary_count, Index of) {
  Index nearest = 0;
  for (Index i = 1; i < boundary_count; ++i)
    if (sites[i].dot(sites[of]) > sites[nearest].dot(sites[of])) nearest = i;
  return nearest;
}

SphereMesh::SphereMesh(std::vector<Vector3> sites, std::vector<Index> next, std::vector<Triangle> triangles)
    : sites_(std::move(sites)), next_(std::move(next)), triangles_(std::move(triangles)) {
  previous_.resize(next_.size());
  for (Index i = 0; i < next_.size(); ++i) previous_[next_[i]] = i;
  centres_.reserve(triangles_.size());
  std::vector<std::vector<Index>> around(sites_.size());
  for (Index t = 0; t < triangles_.size(); ++t) {
    const auto& [a, b, c] = triangles_[t];
    centres_.push_back(sphere_circumcentre(sites_[a], sites_[b], sites_[c]));
    for (const Index v : triangles_[t]) around[v].push_back(t);
  }
  rings_.resize(sites_.size());
  const auto corner_after = [&](Index triangle, Index site, std::size_t step) {
    const Triangle& v = triangles_[triangle];
    return v[(std::size_t(v[0] == site ? 0 : v[1] == site ? 1 : 2) + step) % 3];
  };
  for (Index i = 0; i < sites_.size(); ++i) {
    Ring& ring = rings_[i];
    std::vector<Index>& left = around[i];
    if (left.empty()) continue;
    Index from = is_boundary(i) ? next_[i] : corner_after(left.front(), i, 1);
    ring.neighbours.push_back(from);
    while (!left.empty()) {
      const auto found =
          std::find_if(left.begin(), left.end(), [&](Index t) { return corner_after(t, i, 1) == from; });
      HARIKO_ASSERT(found != left.end(), "the triangles around a site make one fan");
      ring.triangles.push_back(*found);
      from = corner_after(*found, i, 2);
      left.erase(found);
      if (!left.empty() || is_boundary(i)) ring.neighbours.push_back(from);
    }
  }
}

std::vector<Vector3> SphereMesh::cell(Index i) const {
  std::vector<Vector3> out;
  const auto middle = [&](Index k) { return (sites_[i] + sites_[k]).normalized(); };
  if (is_boundary(i)) {
    out.push_back(sites_[i]);
    out.push_back(middle(next_[i]));
  }
  for (const Index t : rings_[i].triangles) out.push_back(centres_[t]);
  if (is_boundary(i)) out.push_back(middle(previous_[i]));
  return out;
}

double SphereMesh::solid_angle(Index i) const {
  const std::vector<Vector3> corners = cell(i);
  double sum = 0;
  for (std::size_t k = 0; k < corners.size(); ++k)
    sum += hariko::solid_angle(sites_[i], corners[k], corners[(k + 1) % corners.size()]);
  return sum;
}

}  // namespace hariko
