// Surfaces over outlines go on bending at their rims as the true surfaces do (kuriyama.md section 6).

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "core/analysis/curvature.hpp"
#include "core/gaussmap/outline_polyhedron.hpp"
#include "core/patching/fair/boundary_curvature_load.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// The curvature tensor of the true surface at a foot, from the turn of its normal; as in `Curvature`.
Matrix3 true_tensor(const Truth& truth, const Truth::Foot& foot, double step) {
  const Vector3 x = foot.normal.unitOrthogonal(), y = foot.normal.cross(x);
  const auto turn = [&](const Vector3& along) -> Vector3 {
    return (truth.foot(foot.point + step * along).normal - truth.foot(foot.point - step * along).normal) /
           (2 * step);
  };
  const Vector3 dx = turn(x), dy = turn(y);
  const double twist = (dx.dot(y) + dy.dot(x)) / 2;
  return dx.dot(x) * x * x.transpose() + dy.dot(y) * y * y.transpose() +
         twist * (x * y.transpose() + y * x.transpose());
}

PolyhedronSurfaceInput input_of(const OutlinePolyhedron& polyhedron, Mode mode = Mode::fair) {
  return {polyhedron.polyhedron, polyhedron.shaping, mode, polyhedron.origin};
}

/// The same polyhedron, but with rims that are smooth of themselves.
OutlinePolyhedron without_tags(OutlinePolyhedron polyhedron) {
  const HalfEdgeMesh& mesh = polyhedron.polyhedron.topology();
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.valence(v) > 2) polyhedron.shaping.tag.erase(VertexId{v});
  return polyhedron;
}

/// Points inside on the true surface, so that what is left is between them.
OutlinePolyhedron over_true_points(const GroundTruth& truth, GaussMode mode) {
  GaussOptions options = in_mode(mode);
  ControlPoints points = *control_points(truth.outline, options);
  for (std::size_t i = points.boundary_count; i < points.points.size(); ++i) {
    const Truth::Foot foot = truth.truth.foot(points.points[i]);
    points.points[i] = foot.point;
    points.normals[i] = foot.normal;
  }
  return *outline_polyhedron(points);
}

/// Error of curvature against the true one, relative, root of the mean square.
struct Error {
  double rim = 0;     ///< on the rim
  double beside = 0;  ///< in the patches along it
  double inside = 0;  ///< in faces that do not touch it
  /// On the rim, across it: what is too much (where the true one is positive), mean and least.
  double across = 0, least = 0;
};

Error curvature_error(const OutlinePolyhedron& polyhedron, const GroundTruth& of) {
  const auto made = must(PolyhedronSurfacer().rebuild(input_of(polyhedron)));
  const Surface& surface = made->surface;
  const HalfEdgeMesh& mesh = polyhedron.polyhedron.topology();
  Error out;
  std::size_t rims = 0, besides = 0, insides = 0;
  const auto measure = [&](Index h, const Vector2& at, double& sum, std::size_t& count, bool on_rim) {
    const PatchPoint point = surface.patches().evaluate(h, at, Order::second);
    const auto found = curvature(point);
    if (!found) return;
    const Truth::Foot foot = of.truth.foot(point.position + surface.origin());
    const double side = found->normal.dot(foot.normal) < 0 ? -1 : 1;
    const Matrix3 is = true_tensor(of.truth, foot, 1e-4 * of.outline.size()), off = side * found->tensor - is;
    sum += off.squaredNorm() / is.squaredNorm();
    ++count;
    if (!on_rim) return;
    const Vector3 across = found->normal.cross(point.dt - point.ds).normalized();
    const double more = across.dot(off * across) / (is.norm() / std::sqrt(2.0));
    out.across += more;
    out.least = std::min(out.least, more);
  };
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const bool rim = mesh.twin(h) == no_index;
    bool touches = rim;
    for (const Index v : {mesh.origin(h), mesh.target(h), mesh.target(mesh.next(h))})
      touches = touches || mesh.is_border_vertex(v);
    if (rim)
      for (const double x : {0.1, 0.3, 0.5, 0.7, 0.9})
        measure(h, side_parameter(surface.domain(), 1, x), out.rim, rims, true);
    if (touches && !rim) continue;
    for (const Vector2& at : {Vector2(0.4, 0.4), Vector2(0.15, 0.15)})
      measure(h, at, rim ? out.beside : out.inside, rim ? besides : insides, false);
  }
  out.across /= double(rims);
  out.rim = std::sqrt(out.rim / double(rims));
  out.beside = std::sqrt(out.beside / double(besides));
  out.inside = std::sqrt(out.inside / double(insides));
  return out;
}

TEST(BoundaryCurvatureLoad, SurfacesGoOnBendingAtTheirRims) {
  for (const auto& [truth, mode] : {std::pair{sphere_cap(24), GaussMode::curvature},
                                    {ellipsoid_cap(32), GaussMode::curvature},
                                    {paraboloid_cap(32), GaussMode::curvature},
                                    {sphere_band(16), GaussMode::curvature},
                                    {three_holes(Vector3::Ones(), 14, "three holes"), GaussMode::curvature},
                                    {catenoid_strip(13, 15), GaussMode::umbilic},
                                    {saddle_disc(32), GaussMode::umbilic}}) {
    SCOPED_TRACE(truth.name);
    const OutlinePolyhedron polyhedron = over_true_points(truth, mode);
    const Error before = curvature_error(without_tags(polyhedron), truth),
                after = curvature_error(polyhedron, truth);
    if (std::getenv("HARIKO_SHOW_NUMBERS")) {
      std::ostringstream line;
      line << std::fixed << std::setprecision(3) << "rim | " << truth.name << " | on it " << before.rim
           << " -> " << after.rim << " | beside " << before.beside << " -> " << after.beside << " | inside "
           << before.inside << " -> " << after.inside << " | across too much by " << before.across << " -> "
           << after.across << ", least " << before.least << " -> " << after.least;
      std::cout << line.str() << std::endl;
    }
    EXPECT_LE(after.rim, 0.4 * before.rim);
    EXPECT_LE(after.beside, 0.8 * before.beside);
    EXPECT_LE(after.inside, 1.01 * before.inside);
    EXPECT_LE(std::abs(after.across), 0.3);
  }
}

TEST(BoundaryCurvatureLoad, TheSphereCapIsOneToItsRim) {
  const GroundTruth truth = sphere_cap(32);
  const OutlinePolyhedron polyhedron = over_true_points(truth, GaussMode::curvature);
  // Radius 2: without bending across the rim the curvature is off by more than all of it.
  EXPECT_LT(curvature_error(without_tags(polyhedron), truth).least, -1);
  const Error error = curvature_error(polyhedron, truth);
  EXPECT_LT(error.rim, 0.15);
  EXPECT_LT(std::abs(error.across), 0.08);
  EXPECT_GT(error.least, -0.5);
}

const QuarticPatchArray& patches_of(const PolyhedronSurface& surface) {
  return dynamic_cast<const QuarticPatchSet&>(surface.surface.patches()).array();
}
double largest_difference(const PolyhedronSurface& a, const PolyhedronSurface& b) {
  double out = 0;
  for (std::size_t h = 0; h < patches_of(a).size(); ++h)
    for (std::size_t i = 0; i < quartic_control_count; ++i)
      out = std::max(out, (patches_of(a)[h].control[i] - patches_of(b)[h].control[i]).norm());
  return out;
}

TEST(BoundaryCurvatureLoad, DragsAreWhatAFullSolveGives) {
  for_random(9611, 2, [](std::mt19937_64& rng) {
    const GroundTruth truth = sphere_cap(16);
    const OutlinePolyhedron outline = *outline_polyhedron(*control_points(truth.outline, {}));
    const HalfEdgeMesh& mesh = outline.polyhedron.topology();
    PolyhedronSurfaceInput input = input_of(outline);
    std::vector<bool> at_rim(mesh.vertex_count(), false);
    for (const Index h : clamped_boundary_edges(input.polyhedron, input.shaping))
      for (const Index v : {mesh.origin(h), mesh.target(h), mesh.target(mesh.next(h))}) at_rim[v] = true;
    for (const bool rim : {false, true}) {
      Index v = 0;
      while (at_rim[v] != rim) v = Index(rng() % mesh.vertex_count());
      input.polyhedron = outline.polyhedron;
      PolyhedronSurfacer surfacer;
      ASSERT_TRUE(surfacer.rebuild(input).ok());
      PolyhedronSurface dragged;
      for (int frame = 0; frame < 3 || !dragged.settled; ++frame) {
        ASSERT_LT(frame, 40);
        const Vector3 moved = outline.polyhedron.position(v) + random_vector(rng, 0.1);
        input.polyhedron = outline.polyhedron.with_positions(std::span(&v, 1), std::span(&moved, 1)).value();
        dragged = surfacer.rebuild(input, Quality::drag).value();
        // Fast where rims do not feel it.
        EXPECT_EQ(bool(dragged.changed), !rim);
      }
      EXPECT_LT(largest_difference(dragged, *PolyhedronSurfacer().rebuild(input)),
                (rim ? 1e-4 : 1e-9) * truth.outline.size());
      EXPECT_EQ(largest_difference(*surfacer.rebuild(input), *PolyhedronSurfacer().rebuild(input)), 0);
    }
  });
}

TEST(BoundaryCurvatureLoad, OnlyWhereTagsAndPinsSayItAndAsLongAsTheyDo) {
  const OutlinePolyhedron outline = *outline_polyhedron(*control_points(sphere_cap(16).outline, {}));
  const Polyhedron& polyhedron = outline.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const std::vector<Index> rims = clamped_boundary_edges(polyhedron, outline.shaping);
  EXPECT_EQ(rims.size(), 16u);
  Shaping tags_only = outline.shaping, pins_only = outline.shaping;
  tags_only.pin = {};
  pins_only.tag = {};
  EXPECT_TRUE(clamped_boundary_edges(polyhedron, tags_only).empty());
  EXPECT_TRUE(clamped_boundary_edges(polyhedron, pins_only).empty());
  EXPECT_TRUE(clamped_boundary_edges(polyhedron, {}).empty());

  // A surfacer that has seen the pins go and come gives what a new one does.
  PolyhedronSurfacer surfacer;
  PolyhedronSurfaceInput input = input_of(outline);
  ASSERT_TRUE(surfacer.rebuild(input).ok());
  const VertexId third = polyhedron.vertex_id(mesh.target(mesh.next(rims[0])));
  for (const bool pinned : {false, true}) {
    if (!pinned) input.shaping.pin.erase(third);
    if (pinned) input.shaping = outline.shaping;
    EXPECT_EQ(clamped_boundary_edges(polyhedron, input.shaping).size() < 16, !pinned);
    const auto dragged = must(surfacer.rebuild(input, Quality::drag));
    EXPECT_LT(largest_difference(*dragged, *PolyhedronSurfacer().rebuild(input)), 1e-4);
    EXPECT_EQ(largest_difference(*surfacer.rebuild(input), *PolyhedronSurfacer().rebuild(input)), 0);
  }
}

TEST(BoundaryCurvatureLoad, SizeDoesNotMatterAndFoldedRimsStayFinite) {
  for_random(9612, 4, [](std::mt19937_64& rng) {
    const OutlinePolyhedron outline = *outline_polyhedron(*control_points(sphere_cap(16).outline, {}));
    const Polyhedron& polyhedron = outline.polyhedron;
    const HalfEdgeMesh& mesh = polyhedron.topology();
    PolyhedronSurfaceInput input = input_of(outline);
    const PolyhedronSurface made = *PolyhedronSurfacer().rebuild(input);
    const double scale = std::pow(10.0, uniform(rng, -6, 6));
    std::vector<Index> all;
    std::vector<Vector3> positions;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      all.push_back(v);
      positions.push_back(scale * polyhedron.position(v));
      Pin pin = *outline.shaping.pin.find(VertexId{v});
      for (Vector3& tangent : pin.vectors) tangent *= scale;
      input.shaping.pin.set(VertexId{v}, pin);
    }
    input.polyhedron = polyhedron.with_positions(all, positions).value();
    const PolyhedronSurface scaled = *PolyhedronSurfacer().rebuild(input);
    for (std::size_t h = 0; h < patches_of(made).size(); ++h)
      for (std::size_t i = 0; i < quartic_control_count; ++i)
        ASSERT_LE((patches_of(scaled)[h].control[i] / scale - patches_of(made)[h].control[i]).norm(), 1e-9);

    // The third corner of a rim's triangle on the rim, and all of the triangle in one point.
    input = input_of(outline);
    const std::vector<Index> rims = clamped_boundary_edges(polyhedron, outline.shaping);
    const Index h = rims[rng() % rims.size()], c = mesh.target(mesh.next(h));
    const Vector3 a = polyhedron.position(mesh.origin(h)), b = polyhedron.position(mesh.target(h));
    for (const bool point : {false, true}) {
      const std::array<Index, 2> moved{mesh.target(h), c};
      const std::array<Vector3, 2> to{point ? a : b, point ? a : Vector3((a + b) / 2)};
      input.polyhedron = polyhedron.with_positions(moved, to).value();
      const auto folded = must(PolyhedronSurfacer().rebuild(input));
      double largest = 0;
      for (std::size_t k = 0; k < patches_of(*folded).size(); ++k)
        for (const Vector3& control : patches_of(*folded)[k].control) {
          ASSERT_TRUE(control.allFinite());
          largest = std::max(largest, control.norm());
        }
      EXPECT_LE(largest, 10);  // the cap is about 4 wide
    }
  });
}

}  // namespace
}  // namespace hariko::test
