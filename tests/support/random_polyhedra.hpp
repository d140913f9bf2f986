#pragma once

// Polyhedra for tests: well-known ones by name, and random ones that are manifold by construction.

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <tuple>
#include <vector>

#include "core/polyhedron/half_edge_mesh.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/polyhedron/polyhedron.hpp"
#include "core/polyhedron/repair.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

/// Cube with corners (+-1, +-1, +-1), numbered as in tests/golden/cube.obj.
inline PolygonMesh cube() {
  PolygonMesh mesh;
  mesh.positions = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                    {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  mesh.add_face({0, 3, 2, 1});
  mesh.add_face({4, 5, 6, 7});
  mesh.add_face({0, 1, 5, 4});
  mesh.add_face({1, 2, 6, 5});
  mesh.add_face({2, 3, 7, 6});
  mesh.add_face({3, 0, 4, 7});
  return mesh;
}

/// Octahedron with corners on the unit axes, numbered as in tests/golden/octahedron.obj.
inline PolygonMesh octahedron() {
  PolygonMesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.add_face({0, 2, 4});
  mesh.add_face({2, 1, 4});
  mesh.add_face({1, 3, 4});
  mesh.add_face({3, 0, 4});
  mesh.add_face({2, 0, 5});
  mesh.add_face({1, 2, 5});
  mesh.add_face({3, 1, 5});
  mesh.add_face({0, 3, 5});
  return mesh;
}

/// Prism with n >= 3 sides, radius 1, z = -1 .. 1. Vertices: bottom ring, then top ring. Faces: bottom, top,
/// sides. prism(6) is tests/golden/prism6.obj.
inline PolygonMesh prism(int n) {
  PolygonMesh mesh;
  for (double z : {-1.0, 1.0})
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      mesh.positions.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  const auto at = [n](int ring, int i) { return static_cast<Index>(ring * n + i % n); };
  std::vector<Index> bottom, top;
  for (int i = 0; i < n; ++i) {
    bottom.push_back(at(0, n - 1 - i));
    top.push_back(at(1, i));
  }
  mesh.add_face(bottom);
  mesh.add_face(top);
  for (int i = 0; i < n; ++i) mesh.add_face({at(0, i), at(0, i + 1), at(1, i + 1), at(1, i)});
  return mesh;
}

/// Torus with radii 2 and 1, n >= 3 steps round the axis and m >= 3 round the tube; torus(8, 4) is
/// tests/golden/torus.obj.
inline PolygonMesh torus(int n, int m) {
  PolygonMesh mesh;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * j / m;
      mesh.positions.emplace_back((2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a),
                                  std::sin(b));
    }
  const auto at = [n, m](int i, int j) { return static_cast<Index>((i % n) * m + j % m); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) mesh.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return mesh;
}

/// Grid of n x m quads over [-1, 1]^2 with z = x y / 2; grid(3, 3) is tests/golden/grid3.obj.
inline PolygonMesh grid(int n, int m) {
  PolygonMesh mesh;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = -1 + 2.0 * i / n, y = -1 + 2.0 * j / m;
      mesh.positions.emplace_back(x, y, x * y / 2);
    }
  const auto at = [n](int i, int j) { return static_cast<Index>(j * (n + 1) + i); };
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) mesh.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return mesh;
}

/// Boundary of unit cells: filled(x, y, z) for cells of nx x ny x nz, centred. Cells that touch only along an
/// edge or in a corner give a mesh that is not manifold.
inline PolygonMesh cells(int nx, int ny, int nz, const std::function<bool(int, int, int)>& filled) {
  PolygonMesh mesh;
  std::map<std::tuple<int, int, int>, Index> vertices;
  const auto vertex = [&](int x, int y, int z) {
    const auto [it, fresh] = vertices.try_emplace({x, y, z}, static_cast<Index>(mesh.positions.size()));
    if (fresh) mesh.positions.emplace_back(x - nx / 2.0, y - ny / 2.0, z - nz / 2.0);
    return it->second;
  };
  const auto inside = [&](int x, int y, int z) {
    return x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz && filled(x, y, z);
  };
  // Corners of the face towards -x, -y, -z, +x, +y, +z, counter-clockwise seen from outside.
  static constexpr int sides[6][4][3] = {
      {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}, {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}},
      {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}, {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}},
      {{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z)
        for (int side = 0; inside(x, y, z) && side < 6; ++side) {
          const int step = side < 3 ? -1 : 1, axis = side % 3;
          if (inside(x + (axis == 0 ? step : 0), y + (axis == 1 ? step : 0), z + (axis == 2 ? step : 0)))
            continue;
          std::vector<Index> face;
          for (const auto& c : sides[side]) face.push_back(vertex(x + c[0], y + c[1], z + c[2]));
          mesh.add_face(face);
        }
  return mesh;
}

/// Slab of (2g + 1) x 3 unit cells with g holes; genus_box(3) is the shape of tests/golden/genus3.obj.
inline PolygonMesh genus_box(int g) {
  return cells(2 * g + 1, 3, 1, [](int x, int y, int) { return y != 1 || x % 2 == 0; });
}

/// Closed pyramid over an n-gon, n >= 3.
inline PolygonMesh pyramid(int n) {
  PolygonMesh mesh;
  std::vector<Index> base;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    base.push_back(static_cast<Index>((n - i) % n));
  }
  mesh.positions.emplace_back(0, 0, 1);
  mesh.add_face(base);
  for (int i = 0; i < n; ++i)
    mesh.add_face({static_cast<Index>(i), static_cast<Index>((i + 1) % n), static_cast<Index>(n)});
  return mesh;
}

/// Length of the shortest side of a face.
inline double shortest_edge(const PolygonMesh& mesh) {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i)
      shortest =
          std::min(shortest, (mesh.positions[face[i]] - mesh.positions[face[(i + 1) % face.size()]]).norm());
  }
  return shortest;
}

/// Moves every vertex by up to `amount` times the shortest edge in each coordinate.
inline void perturb(PolygonMesh& mesh, std::mt19937_64& rng, double amount) {
  const double radius = amount * shortest_edge(mesh);
  for (Vector3& p : mesh.positions) p += random_vector(rng, radius);
}

/// Mesh without one of its faces; vertices stay.
inline PolygonMesh without_face(const PolygonMesh& mesh, std::size_t gone) {
  PolygonMesh out;
  out.positions = mesh.positions;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    if (f != gone) out.add_face(mesh.face(f));
  return out;
}

/// Removes random faces in `attempts` attempts; reverts those that leave no manifold. Unused vertices are
/// removed.
inline PolygonMesh remove_random_faces(PolygonMesh mesh, std::mt19937_64& rng, int attempts) {
  for (int i = 0; i < attempts && mesh.face_count() > 1; ++i) {
    PolygonMesh smaller = without_face(mesh, rng() % mesh.face_count());
    if (HalfEdgeMesh::build(smaller).ok()) mesh = std::move(smaller);
  }
  return remove_isolated_vertices(mesh);
}

/// Mesh with both meshes as components.
inline PolygonMesh together(const PolygonMesh& a, const PolygonMesh& b, const Vector3& shift_of_b) {
  PolygonMesh out = a;
  const Index first = static_cast<Index>(a.positions.size());
  for (const Vector3& p : b.positions) out.positions.push_back(p + shift_of_b);
  for (std::size_t f = 0; f < b.face_count(); ++f) {
    std::vector<Index> face;
    for (Index v : b.face(f)) face.push_back(v + first);
    out.add_face(face);
  }
  return out;
}

/// Random blob of 1 .. 18 unit cells; manifold (non-manifold blobs are drawn again).
inline PolygonMesh random_cells(std::mt19937_64& rng) {
  while (true) {
    const int nx = uniform_int(rng, 1, 3), ny = uniform_int(rng, 1, 3), nz = uniform_int(rng, 1, 2);
    std::vector<char> filled(static_cast<std::size_t>(nx * ny * nz));
    for (char& cell : filled) cell = chance(rng, 0.75);
    const PolygonMesh mesh = cells(nx, ny, nz, [&](int x, int y, int z) {
      return filled[static_cast<std::size_t>((x * ny + y) * nz + z)] != 0;
    });
    if (HalfEdgeMesh::build(mesh).ok()) return mesh;
  }
}

/// Closed mesh without random displacements: faces with 3 .. 20 sides, genus 0 .. 6.
inline PolygonMesh random_closed_shape(std::mt19937_64& rng) {
  switch (uniform_int(rng, 0, 6)) {
    case 0:
      return prism(uniform_int(rng, 3, 20));
    case 1: {
      const int n = uniform_int(rng, 3, 9);
      return torus(n, uniform_int(rng, 3, 7));
    }
    case 2:
      return genus_box(uniform_int(rng, 0, 6));
    case 3:
      return cube();
    case 4:
      return octahedron();
    case 5:
      return pyramid(uniform_int(rng, 3, 20));
    default:
      return random_cells(rng);
  }
}

/// Closed, perturbed mesh.
inline PolygonMesh random_closed_polyhedron(std::mt19937_64& rng) {
  PolygonMesh mesh = random_closed_shape(rng);
  perturb(mesh, rng, uniform(rng, 0, 0.15));
  return mesh;
}

/// Random mesh as a designer may have it: closed or open, one or two components, perturbed. Always manifold
/// and finite, without isolated vertices.
inline PolygonMesh random_polyhedron(std::mt19937_64& rng) {
  const bool is_grid = chance(rng, 0.2);
  const int n = uniform_int(rng, 1, 7), m = uniform_int(rng, 1, 7);
  PolygonMesh mesh = is_grid ? grid(n, m) : random_closed_shape(rng);
  if (chance(rng, 0.5)) mesh = remove_random_faces(std::move(mesh), rng, uniform_int(rng, 1, 6));
  if (chance(rng, 0.15)) mesh = together(mesh, random_closed_shape(rng), {0, 0, 10});
  perturb(mesh, rng, uniform(rng, 0, 0.15));
  return mesh;
}

/// Diagonal of the bounding box.
inline double size_of(const Polyhedron& polyhedron) {
  Eigen::AlignedBox3d box;
  for (const Vector3& p : polyhedron.positions()) box.extend(p);
  return box.diagonal().norm();
}

}  // namespace hariko::test
