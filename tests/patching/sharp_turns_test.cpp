// Networks by measure at sharp turns (kuriyama.md section 12.4): thin rims and deep grooves do not fold.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/analysis/continuity.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

struct ProfilePoint {
  double radius, height;
};

/// A closed cage of revolution with flat ends.
PolygonMesh lathe(Index sides, const std::vector<ProfilePoint>& profile) {
  PolygonMesh mesh;
  for (const auto& [radius, height] : profile)
    for (Index j = 0; j < sides; ++j) {
      const double angle = 2 * std::numbers::pi * j / sides;
      mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  const Index rings = Index(profile.size());
  for (Index i = 0; i + 1 < rings; ++i)
    for (Index j = 0; j < sides; ++j) {
      const Index next = (j + 1) % sides;
      mesh.add_face({i * sides + j, i * sides + next, (i + 1) * sides + next, (i + 1) * sides + j});
    }
  std::vector<Index> bottom, top;
  for (Index j = 0; j < sides; ++j) {
    bottom.push_back(sides - 1 - j);
    top.push_back((rings - 1) * sides + j);
  }
  mesh.add_face(bottom);
  mesh.add_face(top);
  return mesh;
}

PolyhedronSurface surface_of(const PolygonMesh& mesh) {
  PolyhedronSurfaceInput input{Polyhedron::build(mesh).value(), {}, Mode::fair, Vector3::Zero()};
  input.frames = Frames::metric;
  auto made = must(PolyhedronSurfacer().rebuild(input));
  return std::move(made).value();
}

TEST(SharpTurns, RandomZigzagsOfRevolutionDoNotFold) {
  for_random(81, 40, [](std::mt19937_64& rng) {
    const Index sides = Index(uniform_int(rng, 3, 32));
    std::vector<ProfilePoint> profile;
    double height = 0;
    for (int rings = uniform_int(rng, 3, 9); rings > 0; --rings) {
      profile.push_back({uniform(rng, 0.2, 1.5), height});
      height += std::exp(uniform(rng, -2.5, 0.7));
    }
    const PolyhedronSurface made = surface_of(lathe(sides, profile));
    const ContinuityReport report = continuity(made.surface);
    EXPECT_EQ(report.folded_samples, 0U);
    EXPECT_LE(report.largest_normal_jump.value_or(0), 1e-10);
  });
}

TEST(SharpTurns, ARimIsSquareToItsBisector) {
  // A disc over a thin cone: the disc's radius is longer than the cone's side, which must not turn the rim's
  // tangent.
  for (const double size : {1e-3, 1.0, 1e6}) {
    PolygonMesh mesh = lathe(31, {{0.565, 0}, {1.448, 0.268}, {1.387, 0.559}, {0.518, 0.82}, {1.016, 0.915}});
    for (Vector3& p : mesh.positions) p *= size;
    const PolyhedronSurface made = surface_of(mesh);
    const Polyhedron polyhedron = Polyhedron::build(mesh).value();
    const Index rim = 4 * 31, below = 3 * 31;
    const Index h = polyhedron.topology().find_half_edge(rim, below);
    const Vector3 tangent = made.network->start[h].normalized();
    // Both ways inward from the rim, and what is square to their bisector.
    const Vector3 disc(-1, 0, 0), cone = (mesh.positions[below] - mesh.positions[rim]).normalized();
    EXPECT_GT(tangent.dot((cone - disc).normalized()), 0.99) << size;
  }
}

TEST(SharpTurns, TheRimOfADiscOfTwelveSidesIsRound) {
  const PolygonMesh mesh = lathe(12, {{1, 0}, {1.05, 0.1}, {0.35, 0.2}, {0.35, 0.9}, {1.05, 1}, {1, 1.1}});
  const PolyhedronSurface made = surface_of(mesh);
  const Polyhedron polyhedron = Polyhedron::build(mesh).value();
  const HalfEdgeMesh& topology = polyhedron.topology();
  const Index rim = 5 * 12;
  const Vector3 after = made.network->start[topology.find_half_edge(rim, rim + 1)].normalized();
  const Vector3 before = made.network->start[topology.find_half_edge(rim, rim + 11)].normalized();
  const double turn = std::numbers::pi - std::acos(std::clamp(after.dot(before), -1.0, 1.0));
  EXPECT_LT(turn * 180 / std::numbers::pi, 9);  // the polygon turns by 30 degrees
}

}  // namespace
}  // namespace hariko::test
