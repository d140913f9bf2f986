// The surface over the control points: it runs through the outline with its normals; how far it is from the
// true one.

#include <gtest/gtest.h>

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "core/gaussmap/outline_polyhedron.hpp"
#include "core/gaussmap/sphere_mesh.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "tests/gaussmap/truths.hpp"

namespace hariko {
namespace {

using namespace test;

struct SurfaceErrors {
  double outline_points = 0;   ///< largest distance of an outline point from its node, relative to the size
  double outline_normals = 0;  ///< largest angle between given and evaluated normal there, radians
  double boundary = 0;         ///< largest distance of the boundary curve from the true surface
  double inside = 0;           ///< largest distance of the surface from the true one
};

SurfaceErrors surface_errors(const Surface& surface, const OutlinePolyhedron& polyhedron,
                             const GroundTruth& truth) {
  SurfaceErrors out;
  const HalfEdgeMesh& mesh = polyhedron.polyhedron.topology();
  constexpr int density = 4;  // samples a side of a patch
  // Each half-edge has a patch: its corner 0 is the face's centre, its side 1 runs along the half-edge.
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    for (const int corner : {1, 2}) {
      const Index number = corner == 1 ? mesh.origin(h) : mesh.target(h);
      if (number >= truth.outline.point_count()) continue;
      const OutlinePoint at = outline_point(truth.outline, number);
      const OutlineLoop& loop = truth.outline.loops[at.loop];
      const PatchPoint point =
          surface.patches().evaluate(h, corner_parameter(surface.domain(), corner), Order::first);
      out.outline_points =
          std::max(out.outline_points, (point.position + surface.origin() - loop.points[at.place]).norm());
      // The normal of the patch itself, not of the node.
      out.outline_normals =
          std::max(out.outline_normals, angle_between(point.ds.cross(point.dt), loop.normals[at.place]));
    }
    if (mesh.twin(h) != no_index) continue;
    for (int i = 0; i <= density; ++i) {
      const auto at = side_parameter(surface.domain(), 1, grid_fraction(i, density));
      const Vector3 point = surface.patches().evaluate(h, at, Order::first).position + surface.origin();
      out.boundary = std::max(out.boundary, (point - truth.truth.foot(point).point).norm());
    }
  }
  const GridPattern pattern{surface.domain(), density};
  std::vector<Vector3> positions(std::size_t(pattern.point_count())), normals = positions;
  for (Index f = 0; f < surface.patch_count(); ++f) {
    surface.patches().evaluate_grid(std::span(&f, 1), pattern, positions, normals);
    for (const Vector3& position : positions) {
      const Vector3 point = position + surface.origin();
      out.inside = std::max(out.inside, (point - truth.truth.foot(point).point).norm());
    }
  }
  out.outline_points /= truth.outline.size();
  return out;
}

void check(const GroundTruth& truth, GaussMode gauss_mode, Mode mode) {
  GaussOptions options;
  options.mode = gauss_mode;
  const auto points = control_points(truth.outline, options);
  ASSERT_TRUE(points.ok()) << to_string(points.error());
  const auto polyhedron = outline_polyhedron(*points);
  ASSERT_TRUE(polyhedron.ok()) << to_string(polyhedron.error());
  PolyhedronSurfaceInput input{polyhedron->polyhedron, polyhedron->shaping, mode, polyhedron->origin};
  const auto made = PolyhedronSurfacer().rebuild(input);
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  const SurfaceErrors errors = surface_errors(made->surface, *polyhedron, truth);
  const double inserted = point_errors(*points, truth.truth).distance;
  if (std::getenv("HARIKO_SHOW_NUMBERS")) {
    std::ostringstream line;
    line << std::scientific << std::setprecision(1) << (mode == Mode::g2 ? "g2" : "fair") << " | "
         << truth.name << " | outline points " << errors.outline_points << " | normals "
         << errors.outline_normals << " | boundary " << errors.boundary << " | inserted points " << inserted
         << " | surface " << errors.inside << " | warnings " << made->warnings.size();
    std::cout << line.str() << std::endl;
  }
  EXPECT_LE(errors.outline_points, 1e-12);
  EXPECT_LE(errors.outline_normals, 1e-9);
  // Smooth pieces between points that are no further off than these: the surface adds what patches of a mesh
  // of this width leave between its vertices, far below the width squared.
  EXPECT_LE(errors.inside, inserted + 0.02 * truth.outline.size());
  EXPECT_LE(errors.boundary, 0.01 * truth.outline.size());
  for (const Message& warning : made->warnings) EXPECT_FALSE(warning.code == w_fold) << to_string(warning);
}

std::vector<std::pair<GroundTruth, GaussMode>> cases() {
  const auto golden = [](const char* name, const Truth& truth) {
    return GroundTruth{name, golden_outline(name), truth};
  };
  return {{golden("sphere_cap", ellipsoid(Vector3::Constant(2))), GaussMode::curvature},
          {golden("ellipsoid_cap", ellipsoid({2, 1.5, 1})), GaussMode::curvature},
          {golden("paraboloid", paraboloid()), GaussMode::curvature},
          {golden("sphere_band", ellipsoid(Vector3::Ones())), GaussMode::curvature},
          {golden("three_holes", ellipsoid(Vector3::Ones())), GaussMode::curvature},
          {golden("ell_three_holes", ellipsoid({1.3, 1.1, .9})), GaussMode::curvature},
          {golden("catenoid", catenoid()), GaussMode::umbilic},
          {golden("saddle", saddle()), GaussMode::umbilic},
          {golden("catenoid", catenoid()), GaussMode::position},
          {golden("saddle", saddle()), GaussMode::position}};
}

TEST(OutlineSurface, FairRunsThroughTheOutlineWithItsNormals) {
  for (const auto& [truth, mode] : cases()) {
    SCOPED_TRACE(truth.name);
    check(truth, mode, Mode::fair);
  }
}

TEST(OutlineSurface, G2RunsThroughTheOutlineWithItsNormals) {
  for (const auto& [truth, mode] : cases()) {
    SCOPED_TRACE(truth.name);
    check(truth, mode, Mode::g2);
  }
}

}  // namespace
}  // namespace hariko
