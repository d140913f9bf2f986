#pragma once

// Surfaces whose offsets and shells have closed forms, and what a mesh of them must be.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <numbers>

#include "core/surface/tessellation.hpp"
#include "tests/support/analytic_patches.hpp"

namespace hariko::test {

/// Part of a cylinder round the z axis with outward normals: `columns` x `rows` patches over an angle, open.
inline Surface tube(double radius, double length, double angle, Index columns, Index rows) {
  std::vector<PatchFormula> formulas;
  std::vector<Index> nodes;
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index n = j * (columns + 1) + i;
      for (const Index node : {n, n + 1, n + columns + 2, n + columns + 1}) nodes.push_back(node);
      formulas.push_back([=](double s, double t) {
        const double step = angle / columns, height = length / rows, u = step * (i + s);
        PatchPoint p;
        p.position = {radius * std::cos(u), radius * std::sin(u), height * (j + t)};
        p.ds = step * radius * Vector3(-std::sin(u), std::cos(u), 0);
        p.dt = {0, 0, height};
        p.dss = -step * step * radius * Vector3(std::cos(u), std::sin(u), 0);
        return p;
      });
    }
  return make_surface(Domain::square, std::move(formulas), nodes);
}

/// Cube with sharp edges about the origin, of squares or of two triangles a side. `open`: without its top.
inline Surface cube(double side, Domain domain, bool open = false) {
  const auto corner = [&](Index k) -> Vector3 {
    return side * Vector3((k & 1) - 0.5, ((k >> 1) & 1) - 0.5, ((k >> 2) & 1) - 0.5);
  };
  std::vector<std::array<Index, 4>> faces{
      {0, 2, 3, 1}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
  if (!open) faces.push_back({4, 5, 7, 6});
  std::vector<PatchFormula> formulas;
  std::vector<Index> nodes;
  const auto add = [&](Index a, Index b, Index last) {
    const Vector3 origin = corner(a), along = corner(b) - origin, up = corner(last) - origin;
    formulas.push_back([=](double s, double t) {
      PatchPoint p;
      p.position = origin + s * along + t * up;
      p.ds = along;
      p.dt = up;
      return p;
    });
  };
  for (const auto& f : faces) {
    if (domain == Domain::square) {
      add(f[0], f[1], f[3]);
      nodes.insert(nodes.end(), f.begin(), f.end());
      continue;
    }
    add(f[0], f[1], f[2]);
    add(f[0], f[2], f[3]);
    for (const Index node : {f[0], f[1], f[2], f[0], f[2], f[3]}) nodes.push_back(node);
  }
  AnalyticOptions options;
  options.continuity = Continuity::g0;
  return make_surface(domain, std::move(formulas), nodes, options);
}

/// Every edge has two triangles, which run along it in opposite directions, where vertices at one place count
/// as one, as in files. (Sides shrunk to a point have several in `tessellate`.)
inline void expect_watertight(const TriangleMesh& mesh) {
  std::map<std::array<double, 3>, Index> places;
  const auto place = [&](Index v) {
    const Vector3& p = mesh.positions[v];
    return places.emplace(std::array{p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}, Index(places.size()))
        .first->second;
  };
  std::map<std::pair<Index, Index>, int> edges;
  for (const auto& t : mesh.triangles) {
    const std::array<Index, 3> v{place(t[0]), place(t[1]), place(t[2])};
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) ++edges[{v[k], v[(k + 1) % 3]}];
  }
  std::size_t wrong = 0;
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    wrong += count != 1 || back == edges.end() || back->second != 1;
  }
  EXPECT_GT(edges.size(), 0U);
  EXPECT_EQ(wrong, 0U) << "of " << edges.size();
}

inline double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += mesh.positions[a].cross(mesh.positions[b]).dot(mesh.positions[c]) / 6;
  return sum;
}

}  // namespace hariko::test
