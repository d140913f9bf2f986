#pragma once

// Triangle meshes to unfold: those of the specification, and others of any size.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "core/exchange/mesh_file.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

/// tests/golden/unfolding
inline PolygonMesh golden_facets(const std::string& name) {
  auto mesh = read_mesh_file(test::source_folder() + "/tests/golden/unfolding/" + name + ".obj");
  EXPECT_TRUE(mesh.ok()) << name;
  return mesh.ok() ? std::move(mesh).value().mesh : PolygonMesh{};
}

/// n x m quads in two triangles each.
inline PolygonMesh torus_facets(int n, int m, double large = 2, double small = 0.8) {
  PolygonMesh mesh;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < m; ++k) {
      const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * k / m;
      const double r = large + small * std::cos(b);
      mesh.positions.emplace_back(r * std::cos(a), r * std::sin(a), small * std::sin(b));
    }
  const auto at = [&](int i, int k) { return static_cast<Index>((i % n) * m + k % m); };
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < m; ++k) {
      mesh.add_face({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.add_face({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  return mesh;
}

/// An icosahedron whose facets are cut in four `level` times, on the unit sphere: 20 4^level facets.
inline PolygonMesh icosphere(int level) {
  const double t = std::numbers::phi;
  PolygonMesh mesh;
  for (const Vector3& v : {Vector3(-1, t, 0), Vector3(1, t, 0), Vector3(-1, -t, 0), Vector3(1, -t, 0),
                           Vector3(0, -1, t), Vector3(0, 1, t), Vector3(0, -1, -t), Vector3(0, 1, -t),
                           Vector3(t, 0, -1), Vector3(t, 0, 1), Vector3(-t, 0, -1), Vector3(-t, 0, 1)})
    mesh.positions.push_back(v / v.norm());
  std::vector<std::array<Index, 3>> facets = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                              {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                              {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                              {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int round = 0; round < level; ++round) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [place, added] =
          middles.emplace(std::minmax(a, b), static_cast<Index>(mesh.positions.size()));
      if (added) {
        const Vector3 m = mesh.positions[a] + mesh.positions[b];
        mesh.positions.push_back(m / m.norm());
      }
      return place->second;
    };
    std::vector<std::array<Index, 3>> finer;
    for (const auto& [a, b, c] : facets) {
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    facets = std::move(finer);
  }
  for (const auto& facet : facets) mesh.add_face(facet);
  return mesh;
}

/// A sheet of n x n quads in two triangles each over [0, 1]^2, z = height(x, y), without the facets that
/// `left_out` names.
template <class Height, class LeftOut>
PolygonMesh sheet_facets(int n, Height&& height, LeftOut&& left_out) {
  PolygonMesh mesh;
  for (int k = 0; k <= n; ++k)
    for (int i = 0; i <= n; ++i) {
      const double x = double(i) / n, y = double(k) / n;
      mesh.positions.emplace_back(x, y, height(x, y));
    }
  const auto at = [&](int i, int k) { return static_cast<Index>(k * (n + 1) + i); };
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < n; ++i)
      for (int half = 0; half < 2; ++half) {
        if (left_out(i, k, half)) continue;
        if (half == 0)
          mesh.add_face({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
        else
          mesh.add_face({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
      }
  return mesh;
}

/// A rough sheet with holes, in one or several components; vertices are moved at random.
inline PolygonMesh random_sheet(std::mt19937_64& rng) {
  const int n = uniform_int(rng, 2, 9);
  const double roughness = uniform(rng, 0, 0.3), holes = chance(rng, 0.5) ? uniform(rng, 0, 0.4) : 0;
  PolygonMesh mesh = sheet_facets(
      n, [&](double x, double y) { return 0.3 * std::sin(5 * x) * std::cos(4 * y); },
      [&](int i, int k, int half) { return i + k + half > 0 && chance(rng, holes); });
  const double size = log_uniform(rng, 0.1, 100);
  for (Vector3& p : mesh.positions) p = size * (p + random_vector(rng, roughness / n));
  return mesh;
}

/// The meshes one beside the other, as components of one.
inline PolygonMesh side_by_side(const std::vector<PolygonMesh>& meshes) {
  PolygonMesh out;
  double x = 0;
  for (const PolygonMesh& mesh : meshes) {
    const auto first = static_cast<Index>(out.positions.size());
    for (const Vector3& p : mesh.positions) out.positions.push_back(p + Vector3(x, 0, 0));
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      out.add_face({first + face[0], first + face[1], first + face[2]});
    }
    x += 10;
  }
  return out;
}

}  // namespace hariko::test
