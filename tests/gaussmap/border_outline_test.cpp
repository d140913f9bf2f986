#include "core/gaussmap/outlines/border_outline.hpp"

#include "core/gaussmap/outline_polyhedron.hpp"
#include "core/gaussmap/outlines/resample_loop.hpp"
#include "core/geometry/angles.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "core/surface/bicubic_patch.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/must.hpp"

namespace hariko::test {
namespace {

/// The surface over the control points of an outline.
Surface surface_over(const Outline& outline, Mode mode) {
  GaussOptions options = in_mode(GaussMode::umbilic);
  const auto points = control_points(outline, options);
  HARIKO_ASSERT(points.ok(), "a good outline");
  const auto made = outline_polyhedron(*points);
  const auto surface = PolyhedronSurfacer().rebuild({made->polyhedron, made->shaping, mode, made->origin});
  HARIKO_ASSERT(surface.ok(), "a good polyhedron");
  return surface->surface;
}

TEST(BorderOutline, OfACapIsTheOutlineItWasMadeFrom) {
  const GroundTruth cap = sphere_cap(24);
  for (const Mode mode : {Mode::fair, Mode::g2}) {
    const auto made = must(border_outline(surface_over(cap.outline, mode), BorderSide::same, 48));
    ASSERT_EQ(made->loops.size(), 1u);
    const OutlineLoop& loop = made->loops[0];
    ASSERT_EQ(loop.points.size(), 48u);
    ASSERT_EQ(loop.curvature.size(), 48u);
    // Its points are among the new ones, in the same direction.
    const OutlineLoop& given = cap.outline.loops[0];
    std::size_t first = 0;
    while (first < 48 && (loop.points[first] - given.points[0]).norm() > 1e-9) ++first;
    ASSERT_LT(first, 48u);
    for (std::size_t i = 0; i < 24; ++i) {
      const std::size_t k = (first + 2 * i) % 48;
      EXPECT_LE((loop.points[k] - given.points[i]).norm(), 1e-12);
      EXPECT_LE(angle_between(loop.normals[k], given.normals[i]), 1e-9);
    }
    for (std::size_t i = 0; i < 48; ++i) {
      EXPECT_NEAR(loop.points[i].norm(), 2, 2e-3);
      EXPECT_LE(angle_between(loop.normals[i], loop.points[i]), 0.06);
    }
    const auto beyond = must(border_outline(surface_over(cap.outline, mode), BorderSide::beyond, 48));
    EXPECT_EQ(beyond->loops[0], reversed(loop));
  }
}

TEST(BorderOutline, OfABandHasTwoLoopsAndClosesItsHole) {
  const Surface band = surface_over(sphere_band(32).outline, Mode::g2);
  const auto made = must(border_outline(band, BorderSide::beyond, 32));
  ASSERT_EQ(made->loops.size(), 2u);
  // The upper loop alone: the rest of the sphere.
  const std::size_t upper = made->loops[0].points[0].z() > 0 ? 0 : 1;
  Outline hole{{made->loops[upper]}};
  hole.loops[0].curvature.clear();
  GaussOptions options = in_mode(GaussMode::umbilic);
  const auto points = must(control_points(hole, options));
  EXPECT_GT(points->points.size(), points->boundary_count);
  for (const Vector3& point : points->points) EXPECT_NEAR(point.norm(), 1, 5e-3);
}

TEST(BorderOutline, HolesOfSpheresAreFilledByDomes) {
  for (const auto& [truth, mode] : {std::pair{sphere_band(20), Mode::fair},
                                    {sphere_band(40), Mode::g2},
                                    {three_holes(Vector3::Ones(), 14, "three holes"), Mode::fair}}) {
    SCOPED_TRACE(truth.name);
    const auto made = must(border_outline(surface_over(truth.outline, mode), BorderSide::beyond));
    int inside = 0;
    for (const OutlineLoop& loop : made->loops) {
      const BorderFill fill = border_fill(loop);
      EXPECT_EQ(fill.settings.mode, GaussMode::umbilic);
      EXPECT_EQ(curvature_sign(fill.outline, fill.settings.sign), CurvatureSign::positive);
      const auto points = must(control_points(fill.outline, gauss_options(fill.settings)));
      // The hole, not the rest of the sphere: all of it lies beyond the loop.
      Vector3 middle = Vector3::Zero();
      for (const Vector3& point : loop.points) middle += point / double(loop.points.size());
      for (Index i = points->boundary_count; i < points->points.size(); ++i) {
        const Vector3& point = points->points[i];
        EXPECT_NEAR(point.norm(), 1, 2e-2);
        EXPECT_GT(point.dot(middle), middle.squaredNorm());
        ++inside;
      }
    }
    EXPECT_GT(inside, 10);
  }
}

TEST(BorderOutline, ASaddleIsFilledByASaddle) {
  OutlineLoop loop = saddle_disc(32).outline.loops[0];
  BorderFill fill = border_fill(loop);
  EXPECT_EQ(fill.settings.sign, CurvatureSign::negative);
  EXPECT_EQ(fill.settings.mode, GaussMode::umbilic);
  EXPECT_EQ(fill.outline.loops[0], loop);
  loop.curvature[3] = 1;  // both signs
  EXPECT_EQ(border_fill(loop).settings.mode, GaussMode::position);
  loop.curvature.clear();
  EXPECT_EQ(border_fill(loop).settings.mode, GaussMode::position);
}

TEST(BorderOutline, CurvatureOfABicubicGridIsItsOwn) {
  // z = x^2 / 2 + y^2 / 4 over [-1, 1]^2: one bicubic patch, exactly. Its outer side is up.
  BicubicNet net{1, 1, {}};
  const auto height = [](double s, int power_index) {  // Bezier form of (2 s - 1)^2
    constexpr double values[] = {1, -1.0 / 3, -1.0 / 3, 1};
    (void)s;
    return values[power_index];
  };
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      net.points.emplace_back(2 * i / 3.0 - 1, 2 * j / 3.0 - 1, height(0, i) / 2 + height(0, j) / 4);
  const auto made = must(border_outline(bicubic_surface(Vector3(5, 6, 7), net), BorderSide::same, 40));
  ASSERT_EQ(made->loops.size(), 1u);
  ASSERT_EQ(made->loops[0].points.size(), 40u);
  for (std::size_t i = 0; i < 40; ++i) {
    const Vector3 p = made->loops[0].points[i] - Vector3(5, 6, 7);
    EXPECT_NEAR(p.z(), p.x() * p.x() / 2 + p.y() * p.y() / 4, 1e-12);
    EXPECT_LE(angle_between(made->loops[0].normals[i], Vector3(-p.x(), -p.y() / 2, 1)), 1e-9);
    if (i % 10 == 0) continue;  // corners have the mean of their neighbours
    const double w = 1 + p.x() * p.x() + p.y() * p.y() / 4;
    EXPECT_NEAR(made->loops[0].curvature[i], 0.5 / (w * w), 1e-9);
  }
}

TEST(BorderOutline, AClosedSurfaceHasNone) {
  PolygonMesh tetrahedron;
  tetrahedron.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const auto& face : std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}})
    tetrahedron.add_face(face);
  const auto polyhedron = must(Polyhedron::build(tetrahedron));
  const auto surface = must(PolyhedronSurfacer().rebuild({*polyhedron, {}, Mode::fair, Vector3::Zero()}));
  EXPECT_EQ(border_outline(surface->surface, BorderSide::same).error().code, e_no_border);
  EXPECT_EQ(border_outline(Surface(), BorderSide::same).error().code, e_no_border);
}

}  // namespace
}  // namespace hariko::test
