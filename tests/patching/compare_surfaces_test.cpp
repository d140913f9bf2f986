// Patches that two surfaces have in common.

#include "core/patching/compare_surfaces.hpp"

#include "core/patching/polyhedron_surface.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {
namespace {

constexpr Mode modes[] = {Mode::paper, Mode::target, Mode::fair, Mode::g2};

Surface surface_of(const Polyhedron& polyhedron, Mode mode, const Vector3& origin = Vector3::Zero()) {
  return PolyhedronSurfacer().rebuild({polyhedron, {}, mode, origin}).value().surface;
}

TEST(CompareSurfaces, ASurfaceEqualsItselfMadeAgain) {
  for_random(4801, 8, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_polyhedron(rng)).value();
    for (const Mode mode : modes) {
      const SurfaceComparison same =
          compare_surfaces(surface_of(polyhedron, mode), surface_of(polyhedron, mode));
      EXPECT_EQ(same.unchanged, polyhedron.topology().half_edge_count());
      EXPECT_EQ(same.changed + same.unmatched, 0U);
      EXPECT_EQ(same.largest_distance, 0.0);
    }
  });
}

TEST(CompareSurfaces, AMoveChangesWhatFeelsIt) {
  const Polyhedron polyhedron = Polyhedron::build(torus(40, 20)).value();
  const Index v = 100;
  const Vector3 to = polyhedron.position(v) + Vector3(0.2, 0, 0);
  const Polyhedron moved = polyhedron.with_positions(std::span(&v, 1), std::span(&to, 1)).value();
  for (const Mode mode : modes) {
    const SurfaceComparison c = compare_surfaces(surface_of(moved, mode), surface_of(polyhedron, mode));
    EXPECT_EQ(c.unchanged + c.changed, c.patches);
    EXPECT_GT(c.changed, 0U);
    EXPECT_GT(*c.largest_distance, 1e-3);
    EXPECT_LT(*c.largest_distance, 1);
  }
}

TEST(CompareSurfaces, WhatHasNoPartnerIsCounted) {
  const Polyhedron polyhedron = Polyhedron::build(cube()).value();
  const Surface fair = surface_of(polyhedron, Mode::fair);
  const SurfaceComparison other_mode = compare_surfaces(fair, surface_of(polyhedron, Mode::g2));
  EXPECT_EQ(other_mode.unmatched, 24U);
  EXPECT_FALSE(other_mode.largest_distance.has_value());
  const SurfaceComparison shifted =
      compare_surfaces(fair, surface_of(polyhedron, Mode::fair, Vector3(1, 0, 0)));
  EXPECT_EQ(shifted.changed, 24U);
  EXPECT_GT(*shifted.largest_distance, 0.1);
  // The faces of an octahedron have no fourth side.
  const Surface octahedral = surface_of(Polyhedron::build(octahedron()).value(), Mode::fair);
  EXPECT_EQ(compare_surfaces(fair, octahedral).unmatched, 6U);
  EXPECT_EQ(compare_surfaces(Surface(), fair).patches, 0U);
}

}  // namespace
}  // namespace hariko::test
