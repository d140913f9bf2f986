// The surface over the control points: it runs through the outline with its normals; how far it is from the
// true one.

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "core/gaussmap/outline_polyhedron.hpp"
#include "core/geometry/angles.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/must.hpp"

namespace hariko::test {
namespace {

struct SurfaceErrors {
  double outline_points = 0;   ///< largest distance of an outline point from its node, relative to the size
  double outline_normals = 0;  ///< largest angle between given and evaluated normal there, radians
  double boundary = 0;         ///< largest distance of the boundary curve from the true surface
  double inside = 0;           ///< largest distance of the surface from the true one
  /// Angles between the surface's normals and the true ones: median, 99th percentile and largest, degrees.
  double median_angle = 0, usual_angle = 0, largest_angle = 0;
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
  std::vector<double> angles;
  for (Index f = 0; f < surface.patch_count(); ++f) {
    surface.patches().evaluate_grid(std::span(&f, 1), pattern, positions, normals);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Vector3 point = positions[i] + surface.origin();
      const Truth::Foot foot = truth.truth.foot(point);
      out.inside = std::max(out.inside, (point - foot.point).norm());
      angles.push_back(angle_between(normals[i], foot.normal) * 180 / pi);
    }
  }
  std::sort(angles.begin(), angles.end());
  out.median_angle = angles[angles.size() / 2];
  out.usual_angle = angles[angles.size() * 99 / 100];
  out.largest_angle = angles.back();
  out.outline_points /= truth.outline.size();
  return out;
}

PolyhedronSurface surface_of(const OutlinePolyhedron& polyhedron, Mode mode) {
  auto made =
      PolyhedronSurfacer().rebuild({polyhedron.polyhedron, polyhedron.shaping, mode, polyhedron.origin});
  EXPECT_TRUE(made.ok());
  return std::move(made).value();
}

void check(const GroundTruth& truth, GaussMode gauss_mode, Mode mode) {
  GaussOptions options = in_mode(gauss_mode);
  const auto points = must(control_points(truth.outline, options));
  const auto polyhedron = must(outline_polyhedron(*points));
  const PolyhedronSurface made = surface_of(*polyhedron, mode);
  const SurfaceErrors errors = surface_errors(made.surface, *polyhedron, truth);
  const double inserted = point_errors(*points, truth.truth).distance;
  if (std::getenv("HARIKO_SHOW_NUMBERS")) {
    std::ostringstream line;
    line << std::scientific << std::setprecision(1) << (mode == Mode::g2 ? "g2" : "fair") << " | "
         << truth.name << " | outline points " << errors.outline_points << " | normals "
         << errors.outline_normals << " | boundary " << errors.boundary << " | inserted points " << inserted
         << " | surface " << errors.inside << " | degrees " << std::fixed << std::setprecision(3)
         << errors.median_angle << " " << errors.usual_angle << " " << errors.largest_angle << " | warnings "
         << made.warnings.size();
    std::cout << line.str() << std::endl;
  }
  EXPECT_LE(errors.outline_points, 1e-12);
  EXPECT_LE(errors.outline_normals, 1e-9);
  // Smooth pieces between points that are no further off than these: the surface adds what patches of a mesh
  // of this width leave between its vertices, far below the width squared.
  EXPECT_LE(errors.inside, inserted + 0.02 * truth.outline.size());
  EXPECT_LE(errors.boundary, 0.01 * truth.outline.size());
  for (const Message& warning : made.warnings) EXPECT_FALSE(warning.code == w_fold) << to_string(warning);
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
          {golden("saddle", saddle_truth()), GaussMode::umbilic},
          {golden("catenoid", catenoid()), GaussMode::position},
          {golden("saddle", saddle_truth()), GaussMode::position}};
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

/// Points of all borders of a surface.
std::vector<Vector3> border_points(const Surface& surface, const HalfEdgeMesh& mesh) {
  std::vector<Vector3> out;
  constexpr int density = 8;
  for (Index h = 0; h < mesh.half_edge_count(); ++h)
    for (int i = 0; mesh.twin(h) == no_index && i <= density; ++i)
      out.push_back(
          surface.patches()
              .evaluate(h, side_parameter(surface.domain(), 1, grid_fraction(i, density)), Order::first)
              .position +
          surface.origin());
  return out;
}

TEST(OutlineSurface, FlatRimsStayFlat) {
  // A rounded triangle in a plane that is not that of two axes; normals lean outward by angles that vary
  // along it.
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Vector3(1, 2, 0.5).normalized()));
  OutlineLoop loop;
  for (int i = 0; i < 36; ++i) {
    const double t = 2 * pi * i / 36, r = 1 + 0.05 * std::cos(3 * t), dr = -0.15 * std::sin(3 * t);
    const Vector3 along = Vector3(dr * std::cos(t) - r * std::sin(t), dr * std::sin(t) + r * std::cos(t), 0);
    const Vector3 outward = along.cross(Vector3::UnitZ()).normalized();
    const double lean = 0.9 + 0.1 * std::sin(t);
    loop.points.push_back(turn * Vector3(r * std::cos(t), r * std::sin(t), 0));
    loop.normals.push_back(turn * (std::sin(lean) * outward + std::cos(lean) * Vector3::UnitZ()));
  }
  GaussOptions options = in_mode(GaussMode::umbilic);
  const auto points = must(control_points({{loop}}, options));
  const auto polyhedron = must(outline_polyhedron(*points));
  for (const auto& [mode, allowed] : {std::pair{Mode::fair, 1e-13}, {Mode::g2, 1e-4}}) {
    double highest = 0;
    for (const Vector3& point :
         border_points(surface_of(*polyhedron, mode).surface, polyhedron->polyhedron.topology()))
      highest = std::max(highest, std::abs(point.dot(turn * Vector3::UnitZ())));
    if (std::getenv("HARIKO_SHOW_NUMBERS")) std::cout << "flat rim | height " << highest << std::endl;
    EXPECT_LE(highest, allowed);
  }
}

TEST(OutlineSurface, EvenSitesTakeTheRipplesAway) {
  for (const GroundTruth& truth :
       {sphere_cap(24), three_holes(Vector3::Ones(), 14, "three holes"), ellipsoid_cap(32)}) {
    SCOPED_TRACE(truth.name);
    const auto angles = [&](int rounds) {
      GaussOptions options;
      options.relaxation = rounds;
      ControlPoints points = *control_points(truth.outline, options);
      // On the true surface, so that what is left is between the points.
      for (std::size_t i = points.boundary_count; i < points.points.size(); ++i)
        points.points[i] = truth.truth.point_of_normal(points.normals[i]);
      const OutlinePolyhedron polyhedron = *outline_polyhedron(points);
      return surface_errors(surface_of(polyhedron, Mode::fair).surface, polyhedron, truth);
    };
    const SurfaceErrors before = angles(0), after = angles(GaussOptions().relaxation);
    if (std::getenv("HARIKO_SHOW_NUMBERS"))
      std::cout << std::setprecision(3) << "ripples | " << truth.name << " | " << before.median_angle << " "
                << before.usual_angle << " " << before.largest_angle << " -> " << after.median_angle << " "
                << after.usual_angle << " " << after.largest_angle << std::endl;
    EXPECT_LE(after.median_angle, 0.65 * before.median_angle);
    EXPECT_LE(after.usual_angle, 0.8 * before.usual_angle);
  }
}

}  // namespace
}  // namespace hariko::test
