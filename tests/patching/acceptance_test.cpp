// Reference numbers beyond the golden files: element matrices, defects of even rings, sums of energy, further
// models.

#include <Eigen/Geometry>
#include <cmath>

#include "core/analysis/continuity.hpp"
#include "core/analysis/measures.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/fair/fair_elements.hpp"
#include "core/patching/patch_network.hpp"
#include "core/patching/quartic/quartic_patch.hpp"
#include "tests/support/golden.hpp"

namespace hariko::test {
namespace {

using namespace quartic;

TEST(Acceptance, EnergyMatricesOfRegularPolygons) {
  const PatchEnergy square = patch_energy(4), triangle = patch_energy(3);
  EXPECT_NEAR(square.plate.trace(), 793.3804957062, 1e-9);
  EXPECT_NEAR(square.plate(d400, d400), 38.4, 1e-10);
  EXPECT_NEAR(square.plate(d211w, d211w), 34.7428571429, 1e-9);
  EXPECT_NEAR(square.plate(d211w, d211v), -9.1428571429, 1e-9);
  EXPECT_NEAR(triangle.plate.trace(), 3238.2359122353, 1e-9);
  EXPECT_NEAR(square.membrane.trace(), 5.1085319535, 1e-9);
}

TEST(Acceptance, SumsOfThePlateEnergy) {
  for (const GoldenCase& c : golden_cases()) {
    SCOPED_TRACE(c.stem);
    const nlohmann::json json = golden_json(c.stem + ".json");
    const auto input = golden_input(c.obj, golden_mode(json["mode"]), c.tension);
    PolyhedronSurfacer surfacer;
    const auto result = surfacer.rebuild(input);
    const auto& set = dynamic_cast<const QuarticPatchSet&>(result->surface.patches());
    double sum = 0;
    for (Index h = 0; h < set.patch_count(); ++h) {
      using Controls = Eigen::Matrix<double, quartic_control_count, 3, Eigen::RowMajor>;
      const Eigen::Map<const Controls> d(set.patch(h).control[0].data());
      const Index sides = input.polyhedron.topology().side_count(input.polyhedron.topology().face(h));
      sum += (d.transpose() * patch_energy(sides).plate * d).trace();
    }
    EXPECT_NEAR(sum, json["metrics"]["tp"].get<double>(), 1e-8 * sum);
  }
}

/// Largest |y . R| / |y| over the rings round closed, smooth vertices: how far even rings are from being
/// solvable.
double largest_defect(const PolyhedronSurfaceInput& input) {
  const HalfEdgeMesh& mesh = input.polyhedron.topology();
  const auto system = NetworkSystem::assemble(input.polyhedron, input.shaping).value();
  const auto positions = input.polyhedron.positions();
  const Network network = system.network(system.solve(positions, {}), positions);
  const PatchConstants constants = patch_constants(mesh, system.frames());
  PatchNetwork split;
  split.split_tangent.resize(mesh.half_edge_count());
  split.centre.resize(mesh.face_count());
  split.centre_tangent.resize(mesh.half_edge_count());
  std::vector<Index> faces(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) faces[f] = f;
  fill_split_tangents(mesh, system.frames(), constants, positions, network, faces, split);
  fill_split_points(mesh, system.frames().charts, positions, faces, split);
  const PatchBuilder builder(mesh, constants, positions, network, split);
  double largest = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (system.frames().kind[v] != FrameKind::smooth) continue;
    Vector3 sum = Vector3::Zero();
    double square = 0;
    Index h = mesh.outgoing(v);
    do {
      const Index right = mesh.twin(h);
      const double x = constants.x[h], before = constants.x[right];
      const double edge = 1 / before + 1 / x, inner = -2 / x;
      sum += edge * (builder.right_side_at_origin(h) - positions[v]) +
             inner * (builder.right_side_at_vertex(h) - positions[v]);
      square += edge * edge + inner * inner;
      h = mesh.rotate(h);
    } while (h != mesh.outgoing(v));
    largest = std::max(largest, sum.norm() / std::sqrt(square));
  }
  return largest;
}

TEST(Acceptance, DefectsOfEvenRings) {
  EXPECT_NEAR(largest_defect(golden_input("cube.obj", Mode::paper)), 0.176776695297, 1e-11);
  EXPECT_NEAR(largest_defect(golden_input("octahedron.obj", Mode::paper)), 0.117851130198, 1e-11);
}

TEST(Acceptance, NetworkEnergies) {
  const std::pair<const char*, double> expected[] = {
      {"cube.obj", 16.0 / 7},        {"octahedron.obj", 2},      {"grid3.obj", 0},
      {"torus.obj", 6.854421838},    {"prism6.obj", 39.0 / 28},  {"fig2.obj", 1.262851305},
      {"fig2_open.obj", 1.28068399}, {"genus3.obj", 6.506486198}};
  for (const auto& [name, energy] : expected) {
    PolyhedronSurfacer surfacer;
    EXPECT_NEAR(surfacer.rebuild(golden_input(name, Mode::paper))->network->energy, energy,
                1e-9 * (1 + energy))
        << name;
  }
  PolyhedronSurfacer surfacer;
  EXPECT_LT(std::abs(surfacer.rebuild(golden_input("grid3.obj", Mode::paper))->network->energy), 1e-30);
}

TEST(Acceptance, Torus) {
  const auto expect = [](const Vector3& value, double x, double y, double z) {
    EXPECT_LT((value - Vector3(x, y, z)).norm(), 2e-11);
  };
  const auto run = [](Mode mode) {
    PolyhedronSurfacer surfacer;
    return surfacer.rebuild(golden_input("torus.obj", mode)).value();
  };
  const auto input = golden_input("torus.obj", Mode::paper);
  const HalfEdgeMesh& mesh = input.polyhedron.topology();
  // The first face is (0, 4, 5, 1), so patch 0 has corners O, vertex 0, vertex 4.
  ASSERT_EQ(mesh.origin(0), 0U);
  ASSERT_EQ(mesh.target(0), 4U);
  const auto paper = run(Mode::paper), target = run(Mode::target), fair = run(Mode::fair);
  const auto patch = [](const PolyhedronSurface& s) {
    return dynamic_cast<const QuarticPatchSet&>(s.surface.patches()).patch(0).control;
  };
  const auto at_centre = [](const PolyhedronSurface& s) {
    return s.surface.patches().evaluate(0, {1.0 / 3, 1.0 / 3}, Order::first);
  };
  expect(paper.network->start[0], 0, 0.783611624891, 0);
  expect(paper.network->start[mesh.find_half_edge(0, 1) == no_index ? 0 : mesh.find_half_edge(0, 1)], 0, 0,
         0.5);
  const auto p = patch(paper);
  expect(p[d400], 2.46708007902, 1.02189802819, 0.6875);
  expect(4 * (p[d310] - p[d400]) / 3, 0.306077677768, -0.253621353491, -0.1875);
  expect(4 * (p[d130] - p[d040]) / 3, 0, 0.391805812446, 0.25);
  expect(p[d211w], 2.72445750431, 1.12850724839, 0.40625);
  expect(patch(target)[d211w], 2.72664318449, 1.12941258677, 0.375);
  expect(p[d121w], 2.90850605806, 0.881563078003, 0.1875);
  expect(p[d121u], 2.91885435933, 0.881563078003, 0.1875);
  expect(at_centre(paper).position, 2.72510196682, 1.12877419351, 0.252314814815);
  expect(unit_normal(at_centre(paper)), 0.873175911751, 0.361681304985, 0.326726890173);
  expect(at_centre(target).position, 2.72542577129, 1.12890831771, 0.247685185185);
  expect(unit_normal(at_centre(target)), 0.871782283522, 0.361104045271, 0.331058180122);
  expect(patch(fair)[d400], 2.48076446301, 1.02756628563, 0.68749397971);
  expect(at_centre(fair).position, 2.73159821659, 1.13146502827, 0.247684305433);
  expect(unit_normal(at_centre(fair)), 0.881506166386, 0.365131809432, 0.299375417101);
  EXPECT_NEAR(measure(paper.surface).bending, 106.6846048997, 1e-4);
  EXPECT_NEAR(measure(target.surface).bending, 96.6880004545, 1e-4);
  EXPECT_NEAR(measure(fair.surface).bending, 93.943246573, 1e-4);
}

TEST(Acceptance, FairAgainstPaper) {
  struct Row {
    const char* obj;
    double paper_bend, paper_jump, target_bend, target_jump, fair_bend, fair_jump;
  };
  // Jumps of symmetric models are zero up to rounding. The table prints three or four digits; 2 % is asked
  // for.
  const Row rows[] = {{"cube.obj", 75.27, 0, 75.27, 0, 27.06, 0},
                      {"octahedron.obj", 78.53, 0, 78.53, 0, 25.91, 0},
                      {"prism6.obj", 59.62, 0.478, 50.14, 0.555, 36.98, 0.031},
                      {"fig2.obj", 43.14, 0.455, 42.08, 0.411, 34.11, 0.018},
                      {"fig2_open.obj", 39.21, 0.517, 38.08, 0.469, 30.15, 0.022},
                      {"torus.obj", 106.7, 0.614, 96.69, 0.008, 93.94, 0.002},
                      {"genus3.obj", 281.6, 0.505, 270.2, 0.361, 226.0, 0.051}};
  for (const Row& row : rows) {
    const auto check = [&](Mode mode, double bend, double jump) {
      SCOPED_TRACE(std::string(row.obj) + " mode " + std::to_string(int(mode)));
      PolyhedronSurfacer surfacer;
      const auto result = surfacer.rebuild(golden_input(row.obj, mode));
      EXPECT_NEAR(measure(result->surface).bending, bend, 0.02 * bend);
      // Half a unit of the last printed digit beside the 2 %.
      EXPECT_NEAR(*continuity(result->surface).rms_curvature_jump, jump, 0.02 * jump + 0.0005);
    };
    check(Mode::paper, row.paper_bend, row.paper_jump);
    check(Mode::target, row.target_bend, row.target_jump);
    check(Mode::fair, row.fair_bend, row.fair_jump);
  }
}

TEST(Acceptance, SplittingConcaveFacesHalvesTheBending) {
  PolygonMesh split = golden_obj("concave.obj");
  PolygonMesh parts;
  parts.positions = split.positions;
  for (std::size_t f = 2; f < split.face_count(); ++f) parts.add_face(split.face(f));
  for (const std::size_t octagon : {0, 1}) {
    // Bottom faces of the octagon's vertex numbering, turned the way the octagon is.
    const auto old = split.face(octagon);
    const Index base = *std::min_element(old.begin(), old.end());
    const bool up = (old[0] + 1 == old[1]);
    for (std::vector<Index> part : {std::vector<Index>{0, 5, 6, 7}, {0, 1, 4, 5}, {1, 2, 3, 4}}) {
      for (Index& v : part) v += base;
      if (!up) std::reverse(part.begin(), part.end());
      parts.add_face(part);
    }
  }
  const Polyhedron whole = Polyhedron::build(split).value(), convex = Polyhedron::build(parts).value();
  const auto bend = [](const Polyhedron& polyhedron, Mode mode) {
    PolyhedronSurfacer surfacer;
    return measure(surfacer.rebuild({polyhedron, {}, mode, Vector3::Zero()})->surface).bending;
  };
  EXPECT_NEAR(bend(whole, Mode::paper), 394, 0.05 * 394);
  EXPECT_NEAR(bend(whole, Mode::fair), 249, 0.05 * 249);
  EXPECT_NEAR(bend(convex, Mode::paper), 140, 0.02 * 140);
  EXPECT_NEAR(bend(convex, Mode::fair), 91, 0.02 * 91);
}

}  // namespace
}  // namespace hariko::test
