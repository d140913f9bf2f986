// Mode G2 against the reference numbers of its prototype.

#include <Eigen/Geometry>
#include <cmath>

#include "core/analysis/curvature.hpp"
#include "core/analysis/measures.hpp"
#include "core/analysis/quadrature.hpp"
#include "core/g2/g2_patch_set.hpp"
#include "tests/patching/g2_support.hpp"
#include "tests/patching/highlight_lines.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {
namespace {

PolyhedronSurface built(const PolyhedronSurfaceInput& input) {
  auto result = must(PolyhedronSurfacer().rebuild(input));
  return std::move(result).value();
}

/// The reference measured with 12 x 12 points a patch, so that is compared.
Measures measured_alike(const Surface& surface) {
  const DomainRule rule = gauss_rule(Domain::triangle, 12);
  Measures out;
  for (Index patch = 0; patch < surface.patch_count(); ++patch)
    for (std::size_t k = 0; k < rule.points.size(); ++k) {
      const PatchPoint point = surface.patches().evaluate(patch, rule.points[k], Order::second);
      const double area = rule.weights[k] * point.ds.cross(point.dt).norm();
      out.area += area;
      if (const auto at = curvature(point)) out.bending += area * (at->k1 * at->k1 + at->k2 * at->k2);
    }
  return out;
}

/// 1 x 1 x 10, one face high in `parts` parts.
PolygonMesh long_box(int parts) {
  PolygonMesh mesh;
  for (int k = 0; k <= parts; ++k)
    for (int i = 0; i < 4; ++i)
      mesh.positions.emplace_back(i == 1 || i == 2 ? 0.5 : -0.5, i >= 2 ? 0.5 : -0.5, 10.0 * k / parts - 5);
  const auto at = [](int k, int i) { return static_cast<Index>(4 * k + i % 4); };
  mesh.add_face({at(0, 3), at(0, 2), at(0, 1), at(0, 0)});
  for (int k = 0; k < parts; ++k)
    for (int i = 0; i < 4; ++i) mesh.add_face({at(k, i), at(k, i + 1), at(k + 1, i + 1), at(k + 1, i)});
  mesh.add_face({at(parts, 0), at(parts, 1), at(parts, 2), at(parts, 3)});
  return mesh;
}

PolygonMesh model(const std::string& name) {
  if (name.starts_with("box")) return long_box(std::stoi(name.substr(3)));
  if (name == "prism12") return prism(12);
  return golden_obj(name + ".obj");
}

/// A reference implementation's bending in mode FAIR and in this mode with equal frames, and its beads: how
/// many extrema a line, and how much variation.
struct Row {
  const char* name;
  double fair, bending, extrema, excess;
};
const Row rows[] = {{"cube", 27.06, 25.23, 0.60, 0.060},      {"octahedron", 25.91, 25.29, 0.60, 0.085},
                    {"fig2", 34.11, 30.97, 0.57, 0.077},      {"fig2_open", 30.15, 28.47, 0.16, 0.036},
                    {"torus", 93.94, 91.51, 0.00, 0.011},     {"genus3", 226.03, 209.07, 0.55, 0.105},
                    {"car", 317.05, 209.92, 0.63, 0.339},     {"concave_split", 90.97, 86.11, 0.67, 0.108},
                    {"g2_convex", 46.29, 36.50, 0.56, 0.083}, {"box1", 190.05, 174.90, 0.87, 0.487},
                    {"box2", 124.26, 117.41, 0.52, 0.122},    {"box5", 110.83, 106.16, 0.31, 0.044},
                    {"prism12", 81.71, 80.72, 1.15, 0.147}};

TEST(G2Acceptance, EqualFramesAreThoseOfTheReference) {
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    PolyhedronSurfaceInput input{Polyhedron::build(model(row.name)).value(), {}, Mode::g2, Vector3::Zero()};
    const PolyhedronSurface made = built(input);
    const Measures measures = measured_alike(made.surface);
    EXPECT_NEAR(measures.bending, row.bending, 0.02 * row.bending);
    const Jumps jumps = jumps_of(made.surface);
    EXPECT_EQ(jumps.gap, 0);
    EXPECT_LE(jumps.normal, 1e-11);
    EXPECT_LE(jumps.relative(), 1e-8);
    // A line has few extrema: the count has a step where one is as high as the limit.
    const double unit = std::sqrt(row.fair / measures.area);
    const Beads beads = beads_of(made.surface, input.polyhedron.topology(), unit);
    // Lines of other faces than quads begin elsewhere than the reference's.
    const bool quads = input.polyhedron.topology().half_edge_count() == 4 * input.polyhedron.face_count();
    EXPECT_LE(beads.extrema, row.extrema + (quads ? 0.2 : 1.3));
    EXPECT_LE(beads.excess, (quads ? 1.2 : 1.8) * row.excess + 0.005);
    for (const Message& warning : made.warnings) EXPECT_NE(warning.code.name, w_fold.name);
  }
}

/// Bending in frames by measure. Without a target for third derivatives the 1 x 1 x 10 box, whose long faces
/// have distorted charts, bends 286. With regular charts the prism bends 29.0, and the car 110.
TEST(G2Acceptance, FramesByMeasureBendLittle) {
  const std::pair<const char*, double> most[] = {
      {"cube", 25.18},    {"octahedron", 25.24}, {"fig2", 29.45}, {"fig2_open", 28.35},
      {"torus", 91.45},   {"genus3", 208.5},     {"car", 105.5},  {"concave_split", 84.3},
      {"box1", 104.0},    {"box2", 103.5},       {"box5", 103.7}, {"prism12", 26.6},
      {"g2_convex", 36.1}};
  for (const auto& [name, bending] : most) {
    PolyhedronSurfaceInput input{Polyhedron::build(model(name)).value(), {}, Mode::g2, Vector3::Zero()};
    input.frames = Frames::metric;
    const PolyhedronSurface made = built(input);
    EXPECT_LT(measured_alike(made.surface).bending, bending) << name;
    EXPECT_LE(jumps_of(made.surface).relative(), 1e-8) << name;
    for (const Message& warning : made.warnings) EXPECT_NE(warning.code.name, w_fold.name) << name;
  }
}

/// Cages whose caps have many sides: corners that are nearly straight in their vertices and turn in the caps.
/// With linear maps of corners and weights by absolute distances, prisms of 18 sides and more bent by up to a
/// third more than in mode FAIR, in narrow bands along their rims.
TEST(G2Acceptance, CapsOfManySidesBendLessThanInModeFair) {
  const auto bend = [](const PolygonMesh& mesh, Mode mode) {
    PolyhedronSurfaceInput input{Polyhedron::build(mesh).value(), {}, mode, Vector3::Zero()};
    input.frames = Frames::metric;
    const PolyhedronSurface made = built(input);
    for (const Message& warning : made.warnings) EXPECT_NE(warning.code.name, w_fold.name);
    return measured_alike(made.surface);
  };
  // Faces of tall prisms of up to eight sides are slender, and bend more than in mode FAIR (g2.md section 9).
  for (const auto& [sides, height] : {std::pair{5, 2.0},
                                      {8, 0.2},
                                      {8, 2.0},
                                      {12, 0.2},
                                      {12, 10.0},
                                      {18, 2.0},
                                      {24, 10.0},
                                      {48, 2.0},
                                      {96, 2.0}}) {
    SCOPED_TRACE("prism of " + std::to_string(sides) + " sides, height " + std::to_string(height));
    PolygonMesh mesh = prism(sides);
    const double scale = height / (mesh.positions.back().z() - mesh.positions.front().z());
    for (Vector3& p : mesh.positions) p.z() *= scale;
    EXPECT_LE(bend(mesh, Mode::g2).bending, bend(mesh, Mode::fair).bending);
  }
}

TEST(G2Acceptance, TensionsWithEqualFramesAreThoseOfTheReference) {
  const auto bend = [](const char* name, double alpha, double beta, const char* tension = "") {
    auto input = golden_input(std::string(name) + ".obj", Mode::g2, tension);
    for (Index v = 0; alpha > 0 && v < input.polyhedron.vertex_count(); ++v)
      input.shaping.alpha.set(input.polyhedron.vertex_id(v), alpha);
    for (Index e = 0; beta != 1 && e < input.polyhedron.edge_count(); ++e)
      input.shaping.beta.set(input.polyhedron.edge_id(e), beta);
    return measured_alike(built(input).surface).bending;
  };
  // 78 in the reference, whose smoothing of forms depends on the corner that a face's chart begins with.
  EXPECT_NEAR(bend("cube", 10, 1), 74.7, 0.02 * 74.7);
  EXPECT_NEAR(bend("fig2", 1, 1), 35.1, 0.02 * 35.1);
  EXPECT_NEAR(bend("cube", 0, 10), 31.9, 0.02 * 31.9);
  EXPECT_NEAR(bend("car", 0, 10), 292, 0.02 * 292);
  EXPECT_NEAR(bend("cube", 0, 1, "cube_crease.tension.json"), 18.9, 0.02 * 18.9);
}

}  // namespace
}  // namespace hariko::test
