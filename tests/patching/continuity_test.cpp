// Tangent continuity on the evaluated surface: samples of the reference models and random polyhedra with
// random shaping.

#include "core/analysis/continuity.hpp"

#include <Eigen/Geometry>

#include "core/network/network_system.hpp"
#include "core/patching/quartic/patch_constants.hpp"
#include "core/patching/quartic/quartic_patch.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/random_shaping.hpp"

namespace hariko::test {
namespace {

TEST(Continuity, ReferenceModelsAreG1WithoutFolds) {
  for (const char* name :
       {"cube", "octahedron", "torus", "grid3", "fig2", "fig2_open", "genus3", "car", "prism6"})
    for (const Mode mode : quartic_modes) {
      SCOPED_TRACE(name);
      const auto input = golden_input(std::string(name) + ".obj", mode);
      PolyhedronSurfacer surfacer;
      const auto result = must(surfacer.rebuild(input));
      EXPECT_TRUE(result->report.fair_converged);
      const ContinuityReport report = continuity(result->surface);
      EXPECT_LE(*report.largest_normal_jump, 1e-10);
      EXPECT_LE(report.largest_gap, 1e-13 * size_of(input.polyhedron));
      EXPECT_EQ(report.degenerate_samples, 0U);
      EXPECT_EQ(report.folded_samples, 0U);
      for (const Message& warning : result->warnings)
        EXPECT_FALSE(warning.code == w_fold) << to_string(warning);
    }
}

TEST(Continuity, ConcaveFacesFoldAndAreNamed) {
  for (const Mode mode : quartic_modes) {
    PolyhedronSurfacer surfacer;
    const auto result = must(surfacer.rebuild(golden_input("concave.obj", mode)));
    std::vector<std::uint64_t> folded;
    for (const Message& warning : result->warnings)
      if (warning.code == w_fold) folded.push_back(warning.element.id);
    EXPECT_EQ(folded, (std::vector<std::uint64_t>{0, 1})) << "the two octagons";
  }
}

TEST(Continuity, RandomPolyhedraWithRandomTensions) {
  for_random(11, 60, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_polyhedron(rng)).value();
    const Shaping shaping = random_shaping(polyhedron, rng, 1000, 0.001, 1000);
    for (const Mode mode : quartic_modes) {
      PolyhedronSurfacer surfacer;
      const auto result = must(surfacer.rebuild({polyhedron, shaping, mode, Vector3::Zero()}));
      EXPECT_TRUE(result->report.fair_converged) << result->report.fair_iterations;
      const ContinuityReport report = continuity(result->surface);
      EXPECT_LE(report.largest_normal_jump.value_or(0), 1e-10) << "mode " << int(mode);
      EXPECT_LE(report.largest_gap, 1e-13 * size_of(polyhedron));
    }
  });
}

TEST(Continuity, FacesWithManySidesWorkUpToTheLimit) {
  for (const int sides : {64, 128, 129}) {
    const Polyhedron polyhedron = Polyhedron::build(prism(sides)).value();
    for (const Mode mode : quartic_modes) {
      PolyhedronSurfacer surfacer;
      const auto result = surfacer.rebuild({polyhedron, {}, mode, Vector3::Zero()});
      if (mode == Mode::fair && sides > 128) {
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.error().code.name, e_too_many_sides.name);
        continue;
      }
      ASSERT_TRUE(result.ok());
      EXPECT_LE(*continuity(result->surface).largest_normal_jump, 1e-10) << sides << " mode " << int(mode);
    }
  }
}

TEST(Continuity, SidesAgreeBitForBit) {
  for_random(12, 20, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_polyhedron(rng)).value();
    for (const Mode mode : quartic_modes) {
      PolyhedronSurfacer surfacer;
      const auto result = must(surfacer.rebuild({polyhedron, {}, mode, Vector3::Zero()}));
      const Surface& surface = result->surface;
      for (const Seam& seam : surface.seams())
        for (const double x : {0.0, 0.125, 0.5, 0.75, 1.0}) {
          const Vector3 a = surface.patches()
                                .evaluate(seam.first.patch,
                                          side_parameter(Domain::triangle, seam.first.side, x), Order::first)
                                .position;
          const Vector3 b =
              surface.patches()
                  .evaluate(seam.second.patch, side_parameter(Domain::triangle, seam.second.side, 1 - x),
                            Order::first)
                  .position;
          ASSERT_EQ(a, b);
        }
    }
  });
}

TEST(Continuity, TwoSidedDerivativeIdentityHoldsOnEveryEdge) {
  // dQ(dA) = dQbar(dB) with the constants of the conditions: the first-order half of J(t).
  for_random(13, 10, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_polyhedron(rng)).value();
    const Shaping shaping = random_shaping(polyhedron, rng, 10, 0.1, 10);
    const auto network = must(NetworkSystem::assemble(polyhedron, shaping));
    const HalfEdgeMesh& mesh = polyhedron.topology();
    const PatchConstants constants = patch_constants(mesh, network->frames());
    for (const Mode mode : quartic_modes) {
      PolyhedronSurfacer surfacer;
      const auto result = must(surfacer.rebuild({polyhedron, shaping, mode, Vector3::Zero()}));
      const auto& set = dynamic_cast<const QuarticPatchSet&>(result->surface.patches());
      const auto derivative = [&](Index patch, const Vector3& point, const Vector3& direction) {
        const QuarticBasis basis = quartic_basis(point[0], point[1], point[2]);
        Vector3 sum = Vector3::Zero();
        for (std::size_t k = 0; k < quartic_control_count; ++k)
          sum += basis.gradient.row(Eigen::Index(k)).dot(direction.transpose()) * set.patch(patch).control[k];
        return sum;
      };
      for (Index e = 0; e < mesh.edge_count(); ++e) {
        const Index h = mesh.half_edge_of_edge(e), twin = mesh.twin(h);
        if (!constants.smooth[h]) continue;
        for (const double t : {0.1, 0.4, 0.9}) {
          const double p = (1 - t) * (1 - constants.c_origin[h]) + t * constants.c_target[h];
          const double ms = 4 * p / 3 - (1 - t) / 3, me = 4 * (1 - p) / 3 - t / 3;
          const Vector3 left = derivative(h, {0, 1 - t, t}, constants.own[h] * Vector3(1, -ms, -me));
          const Vector3 right = derivative(twin, {0, t, 1 - t}, -constants.own[twin] * Vector3(1, -me, -ms));
          ASSERT_LT((left - right).norm(), 1e-12 * (1 + left.norm()));
        }
      }
    }
  });
}

TEST(Continuity, DerivativesMatchCentralDifferences) {
  for_random(14, 20, [](std::mt19937_64& rng) {
    QuarticPatch patch;
    for (Vector3& control : patch.control) control = random_vector(rng);
    for (int i = 0; i < 10; ++i) {
      const double a = uniform(rng, 0.1, 0.8), b = uniform(rng, 0.1, 0.9 - a);
      const Vector2 at(a, b);
      const double step = 1e-4;
      const auto p = [&](double ds, double dt) {
        return evaluate_patch(patch, at + Vector2(ds, dt), Order::second);
      };
      const PatchPoint point = p(0, 0);
      EXPECT_LT((point.ds - (p(step, 0).position - p(-step, 0).position) / (2 * step)).norm(), 1e-5);
      EXPECT_LT((point.dt - (p(0, step).position - p(0, -step).position) / (2 * step)).norm(), 1e-5);
      EXPECT_LT((point.dss - (p(step, 0).ds - p(-step, 0).ds) / (2 * step)).norm(), 1e-4);
      EXPECT_LT((point.dst - (p(0, step).ds - p(0, -step).ds) / (2 * step)).norm(), 1e-4);
      EXPECT_LT((point.dtt - (p(0, step).dt - p(0, -step).dt) / (2 * step)).norm(), 1e-4);
    }
  });
}

TEST(Continuity, GridEvaluationEqualsTheScalarForm) {
  std::mt19937_64 rng(15);
  std::vector<QuarticPatch> patches(5);
  for (QuarticPatch& patch : patches)
    for (Vector3& control : patch.control) control = random_vector(rng);
  const QuarticPatchSet set(QuarticPatchArray(patches), std::make_shared<QuarticTables>());
  const std::vector<Index> wanted{3, 0, 4};
  for (const int density : {1, 2, 5, 8}) {
    const GridPattern pattern{Domain::triangle, density};
    const auto n = static_cast<std::size_t>(pattern.point_count());
    std::vector<Vector3> positions(3 * n), normals(3 * n);
    std::vector<PatchPoint> points(3 * n);
    set.evaluate_grid(wanted, pattern, positions, normals);
    set.evaluate_grid(wanted, pattern, points);
    const auto parameters = pattern.parameters();
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < n; ++i) {
        const PatchPoint point = set.evaluate(wanted[k], parameters[i], Order::second);
        EXPECT_LT((positions[k * n + i] - point.position).norm(), 1e-14);
        EXPECT_LT((points[k * n + i].position - point.position).norm(), 1e-14);
        EXPECT_LT((normals[k * n + i] - unit_normal(point)).norm(), 1e-10);
        EXPECT_LT((points[k * n + i].dst - point.dst).norm(), 1e-12);
        EXPECT_LT((points[k * n + i].dss - point.dss).norm(), 1e-12);
        EXPECT_LT((points[k * n + i].dtt - point.dtt).norm(), 1e-12);
      }
  }
}

TEST(Continuity, BatchesEqualSinglePoints) {
  std::mt19937_64 rng(16);
  std::vector<QuarticPatch> patches(5);
  for (QuarticPatch& patch : patches)
    for (Vector3& control : patch.control) control = random_vector(rng);
  const QuarticPatchSet set(QuarticPatchArray(patches), std::make_shared<QuarticTables>());
  std::vector<Vector2> parameters{{0, 0}, {1, 0}, {0, 1}, {0.2, 0.3}, {1e-9, 1e-9}};
  for (int side = 0; side < 3; ++side)
    for (const double x : {0.0, 0.125, 0.3, 1.0})
      parameters.push_back(side_parameter(Domain::triangle, side, x));
  const std::size_t n = parameters.size();
  const auto batch = set.batch(parameters);
  const std::vector<Index> wanted{3, 0, 4};
  std::vector<PatchPoint> points(wanted.size() * n);
  for (const Order order : {Order::first, Order::second}) {
    batch->evaluate(wanted, order, points);
    for (std::size_t k = 0; k < wanted.size(); ++k)
      for (std::size_t i = 0; i < n; ++i) {
        const PatchPoint one = set.evaluate(wanted[k], parameters[i], order), &many = points[k * n + i];
        const bool on_side = i < 3 || i >= 5;
        EXPECT_LE((many.position - one.position).norm(), on_side ? 0 : 1e-14) << i;
        EXPECT_LT((many.ds - one.ds).norm() + (many.dt - one.dt).norm(), 1e-13) << i;
        EXPECT_LT((many.dss - one.dss).norm() + (many.dst - one.dst).norm() + (many.dtt - one.dtt).norm(),
                  1e-12)
            << i;
      }
  }
}

}  // namespace
}  // namespace hariko::test
