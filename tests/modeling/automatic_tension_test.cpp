// Automatic tension from the lengths of edges.

#include "core/modeling/surfacing/automatic_tension.hpp"

#include "core/document/edits/edits.hpp"
#include "tests/modeling/support.hpp"

namespace hariko::test {
namespace {

double longest_tangent(const PolyhedronSource& source) {
  const auto made = PolyhedronSurfacer().rebuild(surface_input(source).value()).value();
  const HalfEdgeMesh& mesh = source.polyhedron.topology();
  double longest = 0;
  for (Index h = 0; h < mesh.half_edge_count(); ++h)
    longest = std::max(
        longest,
        made.network->start[h].norm() /
            (source.polyhedron.position(mesh.target(h)) - source.polyhedron.position(mesh.origin(h))).norm());
  return longest;
}

TEST(AutomaticTension, EqualEdgesStayAsTheyAre) {
  const PolyhedronSource cube = source_of(test::cube());
  EXPECT_EQ(with_automatic_tension(cube.polyhedron, *cube.shaping, 1), *cube.shaping);
}

TEST(AutomaticTension, FollowsTheLengthsAndTheDesigner) {
  PolygonMesh box = test::cube();
  for (Vector3& p : box.positions) p.x() *= 3;
  PolyhedronSource source = source_of(box);
  const EdgeId long_edge = EdgeId::of({0}, {1}), short_edge = EdgeId::of({0}, {3});
  Shaping shaping;
  shaping.beta.set(long_edge, 5);
  const Shaping out = with_automatic_tension(source.polyhedron, shaping, 0.5);
  const double mean = (4 * 6.0 + 8 * 2.0) / 12;
  EXPECT_NEAR(out.beta.get_or(long_edge, 1), 5 * std::sqrt(mean / 6), 1e-14);
  EXPECT_NEAR(out.beta.get_or(short_edge, 1), std::sqrt(mean / 2), 1e-14);
  EXPECT_EQ(with_automatic_tension(source.polyhedron, shaping, 0), shaping);
}

TEST(AutomaticTension, StaysWithinTheLimitsAndDoesNotDependOnTheScale) {
  for_random(4111, 50, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = random_shape_source(rng);
    const double exponent = uniform(rng, 0, 1);
    const Shaping out = with_automatic_tension(source.polyhedron, *source.shaping, exponent);
    for (const auto& [id, beta] : out.beta) EXPECT_TRUE(check_beta(beta)) << beta;
    PolygonMesh doubled = source.polyhedron.to_mesh();
    for (Vector3& p : doubled.positions) p *= 1024;
    const Polyhedron larger = source.polyhedron
                                  .with_positions(
                                      [&] {
                                        std::vector<Index> all(source.polyhedron.vertex_count());
                                        for (Index v = 0; v < all.size(); ++v) all[v] = v;
                                        return all;
                                      }(),
                                      doubled.positions)
                                  .value();
    EXPECT_EQ(with_automatic_tension(larger, *source.shaping, exponent), out);
  });
}

TEST(AutomaticTension, ShortensTheLongestTangents) {
  // A slab with one thin band of short edges.
  PolygonMesh box = test::prism(6);
  for (Vector3& p : box.positions) p.z() *= 0.15;
  PolyhedronSource source = source_of(box);
  const double before = longest_tangent(source);
  source.preparation.automatic_tension = 1;
  EXPECT_LT(longest_tangent(source), 0.8 * before);
}

TEST(AutomaticTension, RestsInADragAndFollowsOnRelease) {
  PolyhedronSource source = source_of(test::prism(5));
  source.preparation.automatic_tension = 0.7;
  SurfaceInputCache kept;
  const Shaping before = surface_input(source, Quality::final, &kept)->shaping;
  const Index v = 2;
  const Vector3 to = source.polyhedron.position(v) * 1.5;
  source.polyhedron = source.polyhedron.with_positions(std::span(&v, 1), std::span(&to, 1)).value();
  EXPECT_EQ(surface_input(source, Quality::drag, &kept)->shaping, before);
  const Shaping released = surface_input(source, Quality::final, &kept)->shaping;
  EXPECT_NE(released, before);
  EXPECT_EQ(released, surface_input(source)->shaping);
}

}  // namespace
}  // namespace hariko::test
