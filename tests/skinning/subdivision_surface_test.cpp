#include "core/subdivision/subdivision_surface.hpp"

#include <cstring>
#include <set>

#include "core/surface/adjacency.hpp"
#include "core/surface/tessellation.hpp"
#include "tests/skinning/reference_subdivision.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// A grid of quads with some of them cut into triangles, pentagons beside missing corners, random heights.
ControlMesh random_sheet(std::mt19937_64& rng, bool quads_only) {
  ControlMesh out;
  const Index n = Index(uniform_int(rng, 2, 5)), m = Index(uniform_int(rng, 2, 5));
  for (Index j = 0; j <= m; ++j)
    for (Index i = 0; i <= n; ++i)
      out.mesh.positions.push_back(Vector3(double(i), double(j), 0) + random_vector(rng, 0.3));
  const auto at = [&](Index i, Index j) { return j * (n + 1) + i; };
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (!quads_only && chance(rng, 0.25)) {
        out.mesh.add_face({a, b, c});
        out.mesh.add_face({a, c, d});
      } else {
        out.mesh.add_face({a, b, c, d});
      }
    }
  return out;
}

/// A cube with some faces missing: valence 3, boundaries, and vertices of one face.
ControlMesh random_box(std::mt19937_64& rng, int least_faces = 3) {
  ControlMesh out;
  for (int v = 0; v < 8; ++v)
    out.mesh.positions.push_back(Vector3(v & 1, (v >> 1) & 1, v >> 2) + random_vector(rng, 0.2));
  const std::vector<std::array<Index, 4>> faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const int keep = uniform_int(rng, least_faces, 6);
  for (int f = 0; f < keep; ++f) out.mesh.add_face(std::span<const Index>(faces[std::size_t(f)]));
  return out;
}

ControlMesh random_mesh(std::mt19937_64& rng) {
  const int kind = uniform_int(rng, 0, 2);
  return kind == 2 ? random_box(rng) : random_sheet(rng, kind == 0);
}

/// A crease right through a sheet, from boundary to boundary, so without darts.
void add_crease(ControlMesh& sheet, Index columns, Index rows, Index column, double sharpness) {
  for (Index j = 0; j < rows; ++j)
    sheet.creases.push_back({j * (columns + 1) + column, (j + 1) * (columns + 1) + column, sharpness});
}

/// Largest distance between the surface at the corners of the reference's faces and its limits.
double largest_gap(const ControlMesh& mesh, int levels) {
  ReferenceMesh reference(mesh);
  for (int i = 0; i < levels; ++i) reference = reference.subdivided();
  const std::vector<Vector3> limits = reference.limits();
  const auto surface = must(subdivision_surface(Vector3::Zero(), mesh));
  const int density = mesh.all_quads() ? 1 << levels : 1 << (levels - 1);
  const GridPattern pattern{Domain::square, density};
  std::vector<Index> all(surface->patch_count());
  for (Index p = 0; p < all.size(); ++p) all[p] = p;
  const auto points = std::size_t(pattern.point_count());
  std::vector<Vector3> positions(all.size() * points), normals(positions.size());
  surface->patches().evaluate_grid(all, pattern, positions, normals);
  double gap = 0;
  for (const auto& face : reference.faces)
    for (std::size_t c = 0; c < 4; ++c) {
      const int i = int(std::lround(face.parameter[c].x() * density));
      const int j = int(std::lround(face.parameter[c].y() * density));
      const Vector3& p = positions[face.patch * points + std::size_t(pattern.index(i, j))];
      gap = std::max(gap, (p - limits[face.vertices[c]]).norm());
    }
  return gap;
}

TEST(SubdivisionSurface, AgreesWithIndependentSubdivision) {
  for_random(91, 12, [](std::mt19937_64& rng) { EXPECT_LT(largest_gap(random_mesh(rng), 3), 1e-12); });
}

TEST(SubdivisionSurface, AgreesWithIndependentSubdivisionToLevelSeven) {
  std::mt19937_64 rng(random_seed(92));
  EXPECT_LT(largest_gap(random_box(rng), 7), 1e-12);
}

TEST(SubdivisionSurface, AgreesWithIndependentSubdivisionAtCreases) {
  for_random(93, 8, [](std::mt19937_64& rng) {
    ControlMesh mesh;
    for (Index j = 0; j <= 4; ++j)
      for (Index i = 0; i <= 4; ++i)
        mesh.mesh.positions.push_back(Vector3(double(i), double(j), 0) + random_vector(rng, 0.3));
    for (Index j = 0; j < 4; ++j)
      for (Index i = 0; i < 4; ++i)
        mesh.mesh.add_face({j * 5 + i, j * 5 + i + 1, j * 5 + i + 6, j * 5 + i + 5});
    const double sharpness = std::array{1.0, 2.0, 3.0, infinitely_sharp}[std::size_t(uniform_int(rng, 0, 3))];
    add_crease(mesh, 4, 4, 2, sharpness);
    mesh.corners.push_back({0, infinitely_sharp});
    mesh.corners.push_back({24, infinitely_sharp});
    // Masks hold where a fading crease has faded.
    EXPECT_LT(largest_gap(mesh, 5), 1e-12) << sharpness;
  });
}

TEST(SubdivisionSurface, DerivativesAreThoseOfThePosition) {
  for_random(94, 20, [](std::mt19937_64& rng) {
    const ControlMesh mesh = random_mesh(rng);
    const auto surface = must(subdivision_surface(Vector3::Zero(), mesh));
    const PatchSet& patches = surface->patches();
    for (int k = 0; k < 10; ++k) {
      const Index patch = Index(uniform_int(rng, 0, int(patches.patch_count()) - 1));
      // Not across the lines where the polynomials change, which are at multiples of powers of 1/2.
      const Vector2 p(0.5 + 0.5 * uniform(rng, 0.1, 0.4), 0.25 + 0.25 * uniform(rng, 0.1, 0.9));
      const double h = 1e-5;
      const auto at = [&](double s, double t) {
        return patches.evaluate(patch, p + Vector2(s, t), Order::second);
      };
      const PatchPoint here = at(0, 0);
      EXPECT_LT(((at(h, 0).position - at(-h, 0).position) / (2 * h) - here.ds).norm(), 1e-8);
      EXPECT_LT(((at(0, h).position - at(0, -h).position) / (2 * h) - here.dt).norm(), 1e-8);
      EXPECT_LT(((at(h, 0).ds - at(-h, 0).ds) / (2 * h) - here.dss).norm(), 1e-7);
      EXPECT_LT(((at(0, h).ds - at(0, -h).ds) / (2 * h) - here.dst).norm(), 1e-7);
      EXPECT_LT(((at(0, h).dt - at(0, -h).dt) / (2 * h) - here.dtt).norm(), 1e-7);
    }
  });
}

bool same_bits(const Vector3& a, const Vector3& b) {
  return std::memcmp(a.data(), b.data(), sizeof(double) * 3) == 0;
}

TEST(SubdivisionSurface, BothSidesOfASeamHaveTheSameBits) {
  for_random(95, 12, [](std::mt19937_64& rng) {
    const auto surface = must(subdivision_surface(Vector3::Zero(), random_mesh(rng)));
    const PatchSet& patches = surface->patches();
    const int density = uniform_int(rng, 1, 9);
    const GridPattern pattern{Domain::square, density};
    std::vector<Index> all(surface->patch_count());
    for (Index p = 0; p < all.size(); ++p) all[p] = p;
    const auto points = std::size_t(pattern.point_count());
    std::vector<Vector3> positions(all.size() * points), normals(positions.size());
    patches.evaluate_grid(all, pattern, positions, normals);
    std::vector<PatchPoint> full(positions.size());
    patches.evaluate_grid(all, pattern, full);
    const std::vector<Vector2> parameters = pattern.parameters();
    for (const Seam& seam : surface->seams()) {
      ASSERT_TRUE(is_full(seam));
      const std::vector<int> a = pattern.side(seam.first.side), b = pattern.side(seam.second.side);
      for (int i = 0; i <= density; ++i) {
        const std::size_t at = seam.first.patch * points + std::size_t(a[std::size_t(i)]);
        const std::size_t other = seam.second.patch * points + std::size_t(b[std::size_t(density - i)]);
        ASSERT_TRUE(same_bits(positions[at], positions[other]));
        ASSERT_TRUE(same_bits(positions[at], full[at].position));
        const Vector3 single =
            patches.evaluate(seam.first.patch, parameters[std::size_t(a[std::size_t(i)])], Order::first)
                .position;
        ASSERT_TRUE(same_bits(positions[at], single));
      }
    }
    // No edge of the triangles is used twice in one direction.
    const TriangleMesh mesh = tessellate(*surface, density);
    std::set<std::pair<Index, Index>> seen;
    for (const auto& t : mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k) ASSERT_TRUE(seen.insert({t[k], t[(k + 1) % 3]}).second);
  });
}

TEST(SubdivisionSurface, EveryPatchHasAHullOnlyWhereItIsOnePolynomial) {
  std::mt19937_64 rng(random_seed(96));
  const ControlMesh mesh = random_sheet(rng, true);
  const auto surface = must(subdivision_surface(Vector3::Zero(), mesh));
  for (Index p = 0; p < surface->patch_count(); ++p)
    EXPECT_EQ(surface->patches().hull_degree(p), 6) << "regular grids are splines";
  const auto box = must(subdivision_surface(Vector3::Zero(), random_box(rng, 6)));
  int without = 0;
  for (Index p = 0; p < box->patch_count(); ++p) without += box->patches().hull_degree(p) == 0;
  EXPECT_GT(without, 0);
}

TEST(SubdivisionSurface, EqualTopologyIsShared) {
  std::mt19937_64 rng(random_seed(97));
  const ControlMesh mesh = random_sheet(rng, false);
  const auto topology = must(SubdivisionTopology::make(mesh));
  std::vector<Vector3> moved = mesh.mesh.positions;
  for (Vector3& p : moved) p += Vector3(1, 2, 3);
  const Surface a = subdivision_surface(Vector3::Zero(), *topology, mesh.mesh.positions);
  const Surface b = subdivision_surface(Vector3::Zero(), *topology, moved);
  EXPECT_TRUE(a.same_adjacency(b));
  for (Index p = 0; p < a.patch_count(); ++p) {
    const Vector2 at(0.3, 0.8);
    const Vector3 shift = b.patches().evaluate(p, at, Order::first).position -
                          a.patches().evaluate(p, at, Order::first).position;
    EXPECT_LT((shift - Vector3(1, 2, 3)).norm(), 1e-12);
  }
}

TEST(SubdivisionSurface, BadMeshesAreRefused) {
  ControlMesh mesh;
  EXPECT_EQ(subdivision_surface(Vector3::Zero(), mesh).error().code, e_control_mesh);
  mesh.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.mesh.add_face({0, 1, 2, 7});
  EXPECT_EQ(subdivision_surface(Vector3::Zero(), mesh).error().code, e_control_mesh);
  mesh.mesh = {mesh.mesh.positions, {0}, {}};
  mesh.mesh.add_face({0, 1, 2});
  mesh.mesh.add_face({0, 1, 3});
  EXPECT_EQ(subdivision_surface(Vector3::Zero(), mesh).error().code, e_control_mesh);
  mesh.mesh = {mesh.mesh.positions, {0}, {}};
  mesh.mesh.add_face({0, 1, 2, 3});
  mesh.mesh.positions[2].x() = std::nan("");
  EXPECT_EQ(subdivision_surface(Vector3::Zero(), mesh).error().code, e_control_mesh);
}

}  // namespace
}  // namespace hariko::test
