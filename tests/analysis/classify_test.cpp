// Classes of continuity on surfaces whose answer is known.

#include <numbers>
#include <set>

#include "core/analysis/continuity.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko {
namespace {

std::set<Continuity> classes_of(const Surface& surface, const ContinuityTolerance& tolerance = {}) {
  const auto classes = classify(surface, continuity(surface), tolerance);
  EXPECT_EQ(classes.size(), surface.seams().size());
  return {classes.begin(), classes.end()};
}

TEST(Classify, QuadricsAndTorusAreG2) {
  for (const double size : {1e-3, 1.0, 1e6}) {
    EXPECT_EQ(classes_of(test::sphere(size)), std::set{Continuity::g2});
    EXPECT_EQ(classes_of(test::torus(3 * size, size, 6, 5)), std::set{Continuity::g2});
  }
  EXPECT_EQ(classes_of(test::height_field(3, 2,
                                          [](Index, Index) -> test::Height {
                                            return
                                                [](double x, double y) { return test::trough(4)(x - 1, y); };
                                          })),
            std::set{Continuity::g2})
      << "a cylinder";
  EXPECT_EQ(classes_of(test::height_field(3, 2, [](Index, Index) { return test::plane(0.3, -0.2); })),
            std::set{Continuity::g2})
      << "rounding of a plane is no jump";
}

TEST(Classify, AKinkIsG0AboveTheTolerance) {
  for (const double degrees : {0.05, 0.2, 5.0, 120.0}) {
    const double slope = std::tan(degrees * std::numbers::pi / 360);
    const Surface roof = test::height_field(2, 1, [&](Index i, Index) {
      return i == 0 ? test::plane(slope) : test::plane(-slope, 0, 2 * slope);
    });
    EXPECT_EQ(classes_of(roof, {1.001 * degrees, 0.1}), std::set{Continuity::g2});
    EXPECT_EQ(classes_of(roof, {0.999 * degrees, 0.1}), std::set{Continuity::g0});
  }
}

TEST(Classify, AJumpOfCurvatureIsG1AboveTheTolerance) {
  // Troughs of radii 2 and 3 meet at their lowest line: tensors 1/2 and 1/3, jump 1/6 of mean 5/12: 0.4.
  const Surface surface = test::height_field(2, 1, [](Index i, Index) -> test::Height {
    return [radius = i == 0 ? 2.0 : 3.0](double x, double y) { return test::trough(radius)(x - 1, y); };
  });
  EXPECT_EQ(classes_of(surface, {0.1, 0.399}), std::set{Continuity::g1});
  EXPECT_EQ(classes_of(surface, {0.1, 0.401}), std::set{Continuity::g2});
}

TEST(Classify, CreasesOfACubeAreG0AndTheOtherEdgesG1) {
  PolygonMesh mesh = test::cube();
  // Crooked: across edges in a plane of symmetry curvature is continuous.
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    mesh.positions[v] =
        mesh.positions[v].cwiseProduct(Vector3(1, 1.7, 2.9)) +
        0.3 * Vector3(std::sin(double(v)), std::cos(2.0 * double(v)), std::sin(3.0 * double(v)));
  const Polyhedron cube = Polyhedron::build(mesh).value();
  PolyhedronSurfaceInput input{cube, {}};
  for (Index f = 0; f < cube.face_count(); ++f) {
    const auto corners = cube.topology().face_vertices(f);
    if (corners.size() != 4 || f > 0) continue;
    for (std::size_t i = 0; i < 4; ++i)
      input.shaping.crease.set(EdgeId::of(cube.vertex_id(corners[i]), cube.vertex_id(corners[(i + 1) % 4])),
                               true);
  }
  const auto built = test::must(PolyhedronSurfacer().rebuild(input));
  const Surface& surface = built->surface;
  const auto classes = classify(surface, continuity(surface), {0.1, 0.001});
  std::size_t creases = 0, smooth = 0;
  for (std::size_t s = 0; s < classes.size(); ++s) {
    const Seam& seam = surface.seams()[s];
    const bool crease = seam.source.kind == Element::Kind::edge &&
                        input.shaping.crease.contains(EdgeId::from_packed(seam.source.id));
    (crease ? creases : smooth) += 1;
    EXPECT_EQ(classes[s] == Continuity::g0, crease) << "built to be tangent-continuous but for creases";
    if (!crease && seam.source.kind == Element::Kind::edge) {
      EXPECT_EQ(classes[s], Continuity::g1);
    }
  }
  EXPECT_EQ(creases, 4U);
  EXPECT_EQ(smooth, 8U + 24U);
}

}  // namespace
}  // namespace hariko
