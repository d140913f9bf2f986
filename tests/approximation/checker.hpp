#pragma once

// Checks of a mesh over a surface without the code under test: distances by brute force over a grid of boxes,
// from dense samples of the surface to the facets and back, and the mesh's edges by sorting.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include <vector>

#include "core/surface/surface.hpp"
#include "core/surface/tessellation.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

/// By the regions of the plane round a triangle (Ericson's case distinction).
inline double check_distance(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return ap.norm();
  const Vector3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return bp.norm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - ab * (d1 / (d1 - d3))).norm();
  const Vector3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return cp.norm();
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - ac * (d2 / (d2 - d6))).norm();
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return (bp - (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)))).norm();
  const double sum = va + vb + vc;
  return (ap - ab * (vb / sum) - ac * (vc / sum)).norm();
}

/// Triangles by the cells of a uniform grid that their boxes touch.
class TriangleGrid {
 public:
  TriangleGrid(const std::vector<Vector3>& points, const std::vector<std::array<Index, 3>>& triangles)
      : points_(points), triangles_(triangles) {
    for (const Vector3& p : points) box_.extend(p);
    const double size = std::max(box_.diagonal().norm(), 1e-300);
    cell_ = size / std::clamp(std::sqrt(double(triangles.size())), 2.0, 200.0);
    for (Index t = 0; t < triangles.size(); ++t) {
      Eigen::AlignedBox3d box;
      for (const Index v : triangles[t]) box.extend(points[v]);
      for_cells(box, [&](const std::array<int, 3>& at) { cells_[at].push_back(t); });
    }
  }
  double distance(const Vector3& p) const {
    for (double radius = cell_;; radius *= 2) {
      Eigen::AlignedBox3d box(p - Vector3::Constant(radius), p + Vector3::Constant(radius));
      double best = std::numeric_limits<double>::infinity();
      const auto look = [&](const std::array<int, 3>& at) {
        if (const auto found = cells_.find(at); found != cells_.end())
          for (const Index t : found->second)
            best = std::min(best, check_distance(p, points_[triangles_[t][0]], points_[triangles_[t][1]],
                                                 points_[triangles_[t][2]]));
      };
      for_cells(box, look);
      if (best <= radius || box.contains(box_)) return best;
    }
  }

 private:
  template <class Each>
  void for_cells(const Eigen::AlignedBox3d& given, const Each& each) const {
    const Eigen::AlignedBox3d box = given.intersection(box_);
    std::array<int, 3> low, high;
    for (int axis = 0; axis < 3; ++axis) {
      low[std::size_t(axis)] = int(std::floor((box.min()[axis] - box_.min()[axis]) / cell_));
      high[std::size_t(axis)] = int(std::floor((box.max()[axis] - box_.min()[axis]) / cell_));
    }
    for (int i = low[0]; i <= high[0]; ++i)
      for (int j = low[1]; j <= high[1]; ++j)
        for (int k = low[2]; k <= high[2]; ++k) each({i, j, k});
  }
  const std::vector<Vector3>& points_;
  const std::vector<std::array<Index, 3>>& triangles_;
  Eigen::AlignedBox3d box_;
  double cell_ = 1;
  std::map<std::array<int, 3>, std::vector<Index>> cells_;
};

struct MeshCheck {
  double surface_to_mesh = 0;
  double mesh_to_surface = 0;  ///< to a dense mesh of the surface, which is off by up to about `slack`
  double slack = 0;
  std::size_t naked_edges = 0, bad_edges = 0, cracks = 0, t_vertices = 0, degenerate = 0;
};

/// The surface as a dense mesh of its own, patch by patch, without welding.
struct DenseSurface {
  std::vector<Vector3> points;
  std::vector<std::array<Index, 3>> triangles;

  DenseSurface(const Surface& surface, int density) {
    const GridPattern pattern{surface.domain(), density};
    const auto count = std::size_t(pattern.point_count());
    std::vector<Vector3> at(count), normals(count);
    for (Index p = 0; p < surface.patch_count(); ++p) {
      surface.patches().evaluate_grid({&p, 1}, pattern, at, normals);
      const Index base = Index(points.size());
      points.insert(points.end(), at.begin(), at.end());
      for (const auto& t : pattern.triangles())
        triangles.push_back({base + Index(t[0]), base + Index(t[1]), base + Index(t[2])});
    }
  }
};

/// `density` samples a patch side; every facet is sampled at corners, middles of sides and its centre. Cracks
/// are naked edges whose middle is farther than `tolerance` from the surface's boundary.
inline MeshCheck check_mesh(const Surface& surface, const TriangleMesh& mesh, int density, double tolerance) {
  MeshCheck out;
  const TriangleGrid grid(mesh.positions, mesh.triangles);
  const DenseSurface dense(surface, density);
  const TriangleGrid to_surface(dense.points, dense.triangles);
  for (const Vector3& sample : dense.points)
    out.surface_to_mesh = std::max(out.surface_to_mesh, grid.distance(sample));
  // Distance of the dense mesh itself from the surface.
  std::mt19937_64 rng(7);
  for (int k = 0; k < 1000; ++k) {
    const double u = uniform(rng),
                 v = surface.domain() == Domain::square ? uniform(rng) : (1 - u) * uniform(rng);
    const Index patch = Index(uniform_int(rng, 0, int(surface.patch_count()) - 1));
    const Vector3 p = surface.patches().evaluate(patch, {u, v}, Order::first).position;
    out.slack = std::max(out.slack, to_surface.distance(p));
    out.surface_to_mesh = std::max(out.surface_to_mesh, grid.distance(p));
  }
  std::map<std::pair<Index, Index>, std::array<int, 2>> edges;
  Eigen::AlignedBox3d box;
  for (const Vector3& p : mesh.positions) box.extend(p);
  const double size = box.diagonal().norm();
  for (const auto& t : mesh.triangles) {
    const Vector3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || (b - a).cross(c - a).norm() < 1e-14 * size * size)
      ++out.degenerate;
    for (const Vector3& p : {a, b, c, Vector3((a + b) / 2), Vector3((b + c) / 2), Vector3((c + a) / 2),
                             Vector3((a + b + c) / 3)})
      out.mesh_to_surface = std::max(out.mesh_to_surface, to_surface.distance(p));
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = t[k], to = t[(k + 1) % 3];
      ++edges[std::minmax(from, to)][from < to ? 0 : 1];
    }
  }
  // Border of the surface as dense polylines.
  std::vector<std::array<Index, 3>> segments;
  std::vector<Vector3> border;
  for (const PatchSide& side : surface.boundary_sides())
    for (int i = 0; i <= 400; ++i) {
      border.push_back(
          surface.patches()
              .evaluate(side.patch, side_parameter(surface.domain(), side.side, i / 400.0), Order::first)
              .position);
      const Index at = Index(border.size() - 1);
      if (i > 0) segments.push_back({at - 1, at, at});
    }
  std::vector<std::pair<Index, Index>> naked;
  for (const auto& [edge, uses] : edges) {
    if (uses[0] + uses[1] == 1) naked.push_back(edge);
    if (uses[0] > 1 || uses[1] > 1) ++out.bad_edges;
  }
  out.naked_edges = naked.size();
  if (!naked.empty()) {
    if (segments.empty()) {
      out.cracks = naked.size();
    } else {
      const TriangleGrid lines(border, segments);
      for (const auto& [a, b] : naked)
        if (lines.distance((mesh.positions[a] + mesh.positions[b]) / 2) > tolerance * 1.01) ++out.cracks;
    }
    std::set<Index> ends;
    for (const auto& [a, b] : naked) ends.insert({a, b});
    for (const Index v : ends)
      for (const auto& [a, b] : naked)
        if (v != a && v != b &&
            check_distance(mesh.positions[v], mesh.positions[a], mesh.positions[b], mesh.positions[b]) <
                1e-9 * size)
          ++out.t_vertices;
  }
  return out;
}

/// Everything that must hold whatever the criterion.
inline void expect_sound(const MeshCheck& check, bool closed) {
  EXPECT_EQ(check.bad_edges, 0U);
  EXPECT_EQ(check.cracks, 0U);
  EXPECT_EQ(check.t_vertices, 0U);
  EXPECT_EQ(check.degenerate, 0U);
  if (closed) {
    EXPECT_EQ(check.naked_edges, 0U);
  }
}

inline void expect_close(const MeshCheck& check, double tolerance) {
  EXPECT_LE(check.surface_to_mesh, tolerance * (1 + 1e-9));
  EXPECT_LT(check.slack, 0.2 * tolerance) << "the check needs more samples";
  EXPECT_LE(check.mesh_to_surface, tolerance + 1.5 * check.slack);
}

}  // namespace hariko::test
