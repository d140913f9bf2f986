// Frames by measure with tensions and creases: bending beside that of an independent prototype.

#include "core/analysis/measures.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "tests/support/golden.hpp"

namespace hariko::test {
namespace {

double bending(const char* mesh, const Shaping& shaping) {
  PolyhedronSurfaceInput input{Polyhedron::build(golden_obj(mesh)).value(), shaping, Mode::fair,
                               Vector3::Zero()};
  input.frames = Frames::metric;
  const auto made = PolyhedronSurfacer().rebuild(input);
  EXPECT_TRUE(made.ok());
  return made.ok() ? measure(made->surface).bending : 0;
}

/// The same tensions at all vertices and edges.
Shaping everywhere(const char* mesh, double alpha, double beta) {
  const Polyhedron polyhedron = Polyhedron::build(golden_obj(mesh)).value();
  Shaping shaping;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) shaping.alpha.set(polyhedron.vertex_id(v), alpha);
  for (Index e = 0; e < polyhedron.edge_count(); ++e) shaping.beta.set(polyhedron.edge_id(e), beta);
  return shaping;
}

void expect_within_a_percent(double value, double expected) {
  EXPECT_NEAR(value, expected, 0.01 * expected);
}

TEST(MetricTensions, OfThePapersFigures) {
  expect_within_a_percent(bending("fig2.obj", golden_tension("fig5c.tension.json")), 29.91);
  expect_within_a_percent(bending("fig2.obj", golden_tension("fig5d.tension.json")), 47.71);
}

TEST(MetricTensions, ACreasedCube) {
  expect_within_a_percent(bending("cube.obj", golden_tension("cube_crease.tension.json")), 20.2);
}

TEST(MetricTensions, AlphaAndBetaEverywhere) {
  expect_within_a_percent(bending("cube.obj", everywhere("cube.obj", 1, 1)), 40.5);
  expect_within_a_percent(bending("cube.obj", everywhere("cube.obj", 0, 10)), 31.5);
  expect_within_a_percent(bending("fig2.obj", everywhere("fig2.obj", 1, 1)), 43.9);
  expect_within_a_percent(bending("fig2.obj", everywhere("fig2.obj", 0, 10)), 35.2);
  expect_within_a_percent(bending("car.obj", everywhere("car.obj", 1, 1)), 271);
  expect_within_a_percent(bending("car.obj", everywhere("car.obj", 0, 10)), 171);
}

}  // namespace
}  // namespace hariko::test
