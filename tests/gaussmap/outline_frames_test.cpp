// Surfaces over outlines with frames by measure, beside those with equal frames.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <vector>

#include "core/analysis/measures.hpp"
#include "core/gaussmap/outline_polyhedron.hpp"
#include "core/geometry/angles.hpp"
#include "core/patching/fair/boundary_curvature_load.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

using namespace test;

/// A polyhedron for these frames, and its surface.
struct Framed {
  OutlinePolyhedron polyhedron;
  PolyhedronSurface made;
};
Framed framed_surface(const ControlPoints& points, Mode mode, Frames frames) {
  auto polyhedron = outline_polyhedron(points, frames);
  EXPECT_TRUE(polyhedron.ok());
  PolyhedronSurfaceInput input{polyhedron->polyhedron, polyhedron->shaping, mode, polyhedron->origin};
  input.frames = frames;
  auto made = PolyhedronSurfacer().rebuild(input);
  EXPECT_TRUE(made.ok());
  return {std::move(polyhedron).value(), std::move(made).value()};
}

/// Largest angle between the surface's own normals at the points of the outline and the given ones, radians.
double off_at_outline(const Framed& of, const ControlPoints& points) {
  const Surface& surface = of.made.surface;
  const HalfEdgeMesh& mesh = of.polyhedron.polyhedron.topology();
  double out = 0;
  for (Index h = 0; h < mesh.half_edge_count(); ++h)
    for (const int corner : {1, 2}) {
      const Index v = corner == 1 ? mesh.origin(h) : mesh.target(h);
      if (v >= points.boundary_count) continue;
      const PatchPoint at =
          surface.patches().evaluate(h, corner_parameter(surface.domain(), corner), Order::first);
      out = std::max(out, angle_between(at.ds.cross(at.dt), points.normals[v]));
      EXPECT_LE((at.position + surface.origin() - points.points[v]).norm(), 1e-12);
    }
  return out;
}

/// One to three loops on an ellipsoid, most of them with uneven steps.
Outline uneven_outline(std::mt19937_64& rng) {
  const Truth truth = ellipsoid({uniform(rng, 0.5, 2), uniform(rng, 0.5, 2), uniform(rng, 0.5, 2)});
  Outline out;
  const std::size_t count = 1 + rng() % 3;
  const double missing = chance(rng, 0.5) ? 0.2 : 0;
  for (std::size_t l = 0; l < count; ++l) {
    const double angle = count == 1 ? uniform(rng, 0.4, 1.4) : uniform(rng, 0.2, 0.6);
    const OutlineLoop whole = circle_of_normals(truth, random_vector(rng), angle, 14 + rng() % 14, count > 1);
    OutlineLoop& loop = out.loops.emplace_back();
    for (std::size_t i = 0; i < whole.points.size(); ++i) {
      if (chance(rng, missing)) continue;
      loop.points.push_back(whole.points[i]);
      loop.normals.push_back(whole.normals[i]);
      loop.curvature.push_back(whole.curvature[i]);
    }
  }
  return out;
}

bool folds(const PolyhedronSurface& made) {
  return std::any_of(made.warnings.begin(), made.warnings.end(),
                     [](const Message& warning) { return warning.code == w_fold; });
}

/// Outlines whose surface folds with equal frames, and by measure.
struct Folded {
  int equal = 0, metric = 0;
};

/// Bending by measure relative to that with equal frames; nothing where the outline cannot be filled or has
/// warnings about its points, or where a surface folds, which is counted: its bending is arbitrary then.
std::optional<double> relative_bending(const Outline& outline, Mode mode, Folded& folded) {
  GaussOptions options;
  options.mode = GaussMode::umbilic;
  options.most_points = 400;  // far fewer leave faces that turn so far that neither surface is a good one
  const auto points = control_points(outline, options);
  if (!points) return {};
  for (const Message& message : points->messages)
    if (message.code != w_too_many_points) {
      if (std::getenv("HARIKO_SHOW_NUMBERS")) std::cout << "left out | " << to_string(message) << std::endl;
      return {};
    }
  const Framed equal = framed_surface(*points, mode, Frames::equal),
               metric = framed_surface(*points, mode, Frames::metric);
  const bool equal_folds = folds(equal.made), metric_folds = folds(metric.made);
  folded.equal += equal_folds ? 1 : 0;
  folded.metric += metric_folds ? 1 : 0;
  if (equal_folds || metric_folds) return {};
  const double before = measure(equal.made.surface).bending, after = measure(metric.made.surface).bending;
  if (std::getenv("HARIKO_SHOW_NUMBERS")) {
    std::ostringstream line;
    line << "frames | " << (mode == Mode::g2 ? "g2" : "fair") << " | " << outline.loops.size() << " loops, "
         << points->points.size() << " points | bending " << std::setprecision(6) << before << " " << after;
    std::cout << line.str() << std::endl;
  }
  EXPECT_LE(off_at_outline(equal, *points), 1e-9);
  EXPECT_LE(off_at_outline(metric, *points), 1e-9);
  return after / before;
}

/// Nearly all bend less, and fewer fold. About one in thirty bends more, some of them much: stretched
/// ellipsoids where faces at the rim have corners near a half turn. By chance a few seeds have three among
/// fewer than forty, so the limit is two and a tenth of all.
TEST(OutlineFrames, ByMeasureFairSurfacesBendLessAndKeepTheNormals) {
  std::vector<double> found;
  Folded folded;
  for_random(9640, 40, [&](std::mt19937_64& rng) {
    const auto ratio = relative_bending(uneven_outline(rng), Mode::fair, folded);
    if (ratio) found.push_back(*ratio);
  });
  ASSERT_GT(found.size(), 4U);
  EXPECT_LE(folded.metric, folded.equal + 1);
  if (std::getenv("HARIKO_SHOW_NUMBERS"))
    std::cout << "folded " << folded.equal << " " << folded.metric << " of " << found.size() << std::endl;
  const auto worse = std::count_if(found.begin(), found.end(), [](double ratio) { return ratio > 1.02; });
  EXPECT_LE(worse, 2 + std::ptrdiff_t(found.size() / 10));
  std::nth_element(found.begin(), found.begin() + std::ptrdiff_t(found.size() / 2), found.end());
  EXPECT_LT(found[found.size() / 2], 1);
}

TEST(OutlineFrames, ByMeasureSurfacesG2OfEvenOutlinesBendLessAndKeepTheNormals) {
  for (const GroundTruth& truth : {sphere_cap(24), ellipsoid_cap(28), paraboloid_cap(28)}) {
    SCOPED_TRACE(truth.name);
    Folded folded;
    const auto ratio = relative_bending(truth.outline, Mode::g2, folded);
    ASSERT_TRUE(ratio.has_value());
    EXPECT_LT(*ratio, 1);
  }
}

TEST(OutlineFrames, ByMeasureTheSurfaceIsNearerToTheTrueOne) {
  for (const GroundTruth& truth :
       {sphere_cap(28), three_holes(Vector3::Ones(), 14, "three holes"), sphere_band(20)}) {
    SCOPED_TRACE(truth.name);
    const ControlPoints points = *control_points(truth.outline, {});
    const auto largest_angle = [&](Frames frames) {
      const Framed made = framed_surface(points, Mode::fair, frames);
      const Surface& surface = made.made.surface;
      double out = 0;
      for (Index patch = 0; patch < surface.patch_count(); ++patch)
        for (const Vector2& at : {Vector2(0.2, 0.2), Vector2(0.45, 0.45), Vector2(0.1, 0.8)}) {
          const PatchPoint point = surface.patches().evaluate(patch, at, Order::first);
          out = std::max(out, angle_between(point.ds.cross(point.dt),
                                            truth.truth.foot(point.position + surface.origin()).normal));
        }
      return out;
    };
    EXPECT_LE(largest_angle(Frames::metric), 0.7 * largest_angle(Frames::equal));
  }
}

TEST(OutlineFrames, FormsAndNormalsTogetherClampRims) {
  const ControlPoints points = *control_points(sphere_cap(16).outline, {});
  const OutlinePolyhedron made = *outline_polyhedron(points, Frames::metric);
  EXPECT_EQ(made.shaping.form.size(), 16U);
  EXPECT_EQ(clamped_boundary_edges(made.polyhedron, made.shaping).size(), 16U);
  Shaping no_forms = made.shaping, no_pins = made.shaping, no_tags = made.shaping;
  no_forms.form = {};
  no_pins.pin = {};
  no_tags.tag = {};
  for (const Shaping& shaping : {no_forms, no_pins, no_tags})
    EXPECT_TRUE(clamped_boundary_edges(made.polyhedron, shaping).empty());
}

TEST(OutlineFrames, ByMeasureFlatRimsStayFlat) {
  // Normals lean outward by an angle that varies along a rounded triangle.
  OutlineLoop loop;
  for (int i = 0; i < 36; ++i) {
    const double t = 2 * pi * i / 36, r = 1 + 0.05 * std::cos(3 * t), dr = -0.15 * std::sin(3 * t);
    const Vector3 along(dr * std::cos(t) - r * std::sin(t), dr * std::sin(t) + r * std::cos(t), 0);
    const double lean = 0.9 + 0.1 * std::sin(t);
    loop.points.emplace_back(r * std::cos(t), r * std::sin(t), 0);
    loop.normals.push_back(std::sin(lean) * along.cross(Vector3::UnitZ()).normalized() +
                           std::cos(lean) * Vector3::UnitZ());
  }
  GaussOptions options;
  options.mode = GaussMode::umbilic;
  const ControlPoints points = *control_points({{loop}}, options);
  for (const auto& [mode, allowed] : {std::pair{Mode::fair, 1e-12}, {Mode::g2, 1e-4}}) {
    const Framed made = framed_surface(points, mode, Frames::metric);
    const HalfEdgeMesh& mesh = made.polyhedron.polyhedron.topology();
    double highest = 0;
    for (Index h = 0; h < mesh.half_edge_count(); ++h)
      for (int i = 0; mesh.twin(h) == no_index && i <= 8; ++i) {
        const Vector2 at = side_parameter(made.made.surface.domain(), 1, grid_fraction(i, 8));
        const Vector3 point = made.made.surface.patches().evaluate(h, at, Order::first).position;
        highest = std::max(highest, std::abs((point + made.made.surface.origin()).z()));
      }
    EXPECT_LE(highest, allowed);
  }
}

}  // namespace
}  // namespace hariko
