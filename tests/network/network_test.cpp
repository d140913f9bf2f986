// The network solver against a dense solution assembled here from the definition of the energy.

#include "core/network/network_system.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/random_shaping.hpp"

namespace hariko::test {
namespace {

struct DenseSystem {
  Eigen::MatrixXd matrix;
  Eigen::MatrixXd right;  ///< three columns
};

/// Gradient of sum beta/3 (A.A + A.B + B.B) + alpha |T|^2 with A = D + Tb - 2 Ta, B = -D + Ta - 2 Tb, per
/// coordinate.
DenseSystem dense(const Polyhedron& polyhedron, const NetworkSystem& system) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const auto& frames = system.frames();
  const auto n = static_cast<Eigen::Index>(frames.basis_count());
  DenseSystem out{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, 3)};
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e), a = mesh.origin(h), b = mesh.target(h);
    Eigen::VectorXd ta = Eigen::VectorXd::Zero(n), tb = Eigen::VectorXd::Zero(n);
    for (int i = 0; i < 2; ++i) {
      if (frames.ends[2 * h].basis[i] != no_index) ta[frames.ends[2 * h].basis[i]] += frames.ends[2 * h].c[i];
      if (frames.ends[2 * h + 1].basis[i] != no_index)
        tb[frames.ends[2 * h + 1].basis[i]] += frames.ends[2 * h + 1].c[i];
    }
    const Eigen::VectorXd ra = tb - 2 * ta, rb = ta - 2 * tb;
    const double beta = system.beta()[e];
    out.matrix +=
        beta / 3 *
        (2 * ra * ra.transpose() + ra * rb.transpose() + rb * ra.transpose() + 2 * rb * rb.transpose());
    out.matrix += 2 * system.alpha()[a] * ta * ta.transpose() + 2 * system.alpha()[b] * tb * tb.transpose();
    const Eigen::RowVector3d d = (polyhedron.position(b) - polyhedron.position(a)).transpose();
    // d/dX of beta/3 (2 A.D-part ...): A = D + ra X, B = -D + rb X.
    out.right -= beta / 3 * ((2 * ra + rb) * d - (ra + 2 * rb) * d);
  }
  return out;
}

TEST(Network, SolvesTheMinimumOfTheEnergy) {
  for_random(1, 30, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_polyhedron(rng)).value();
    const auto system =
        must(NetworkSystem::assemble(polyhedron, random_shaping(polyhedron, rng, 1000, 0.001, 1000)));
    const auto positions = polyhedron.positions();
    const auto solution = system->solve(positions, {});
    const DenseSystem reference = dense(polyhedron, *system);
    const Eigen::MatrixXd x = reference.matrix.ldlt().solve(reference.right);
    const double size = x.lpNorm<Eigen::Infinity>();
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      ASSERT_LT((solution.basis[std::size_t(i)].transpose() - x.row(i)).norm(), 1e-11 * size)
          << "basis " << i;
    EXPECT_LE(solution.iterations, 30);
  });
}

TEST(Network, SpectrumLiesBetweenOneHalfAndThreeHalves) {
  for_random(2, 20, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_polyhedron(rng)).value();
    if (polyhedron.vertex_count() > 150) return;
    const auto system =
        must(NetworkSystem::assemble(polyhedron, random_shaping(polyhedron, rng, 1000, 0.001, 1000)));
    const Eigen::MatrixXd matrix = dense(polyhedron, *system).matrix;
    Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(matrix.rows(), matrix.cols());
    const auto& begin = system->frames().basis_begin;
    for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
      const auto at = Eigen::Index(begin[v]), count = Eigen::Index(begin[v + 1] - begin[v]);
      blocks.block(at, at, count, count) = matrix.block(at, at, count, count);
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix, blocks,
                                                                          Eigen::EigenvaluesOnly);
    EXPECT_GE(eigen.eigenvalues().minCoeff(), 0.5 - 1e-10);
    EXPECT_LE(eigen.eigenvalues().maxCoeff(), 1.5 + 1e-10);
  });
}

TEST(Network, PinnedTangentsStayAndTheRestIsOptimal) {
  for_random(3, 20, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_closed_polyhedron(rng)).value();
    const auto free_system = must(NetworkSystem::assemble(polyhedron, {}));
    const auto& begin = free_system->frames().basis_begin;
    Shaping shaping;
    std::vector<bool> pinned(free_system->frames().basis_count(), false);
    Eigen::MatrixXd fixed = Eigen::MatrixXd::Zero(Eigen::Index(pinned.size()), 3);
    for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
      if (!chance(rng, 0.2)) continue;
      Pin pin{Pin::Kind::tangents, {}};
      for (Index b = begin[v]; b < begin[v + 1]; ++b) {
        pin.vectors.push_back(random_vector(rng));
        pinned[b] = true;
        fixed.row(Eigen::Index(b)) = pin.vectors.back().transpose();
      }
      shaping.pin.set(polyhedron.vertex_id(v), pin);
    }
    const auto system = must(NetworkSystem::assemble(polyhedron, shaping));
    EXPECT_FALSE(system->couples_coordinates());
    const auto solution = system->solve(polyhedron.positions(), {});
    DenseSystem reference = dense(polyhedron, *system);
    reference.right -= reference.matrix * fixed;
    for (std::size_t b = 0; b < pinned.size(); ++b) {
      if (!pinned[b]) continue;
      const auto i = Eigen::Index(b);
      reference.matrix.row(i).setZero();
      reference.matrix.col(i).setZero();
      reference.matrix(i, i) = 1;
      reference.right.row(i) = fixed.row(i);
    }
    const Eigen::MatrixXd x = reference.matrix.ldlt().solve(reference.right);
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      ASSERT_LT((solution.basis[std::size_t(i)].transpose() - x.row(i)).norm(), 1e-11) << "basis " << i;
  });
}

TEST(Network, PinnedNormalsHoldAndTheGradientIsAlongThem) {
  for_random(4, 20, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_polyhedron(rng)).value();
    Shaping shaping = random_shaping(polyhedron, rng, 10, 0.1, 10);
    const auto plain = must(NetworkSystem::assemble(polyhedron, shaping));
    std::vector<Vector3> normal(polyhedron.vertex_count(), Vector3::Zero());
    for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
      if (!chance(rng, 0.3) || plain->frames().kind[v] == FrameKind::isolated) continue;
      normal[v] = (random_vector(rng) + Vector3(0, 0, 2)).normalized();
      shaping.pin.set(polyhedron.vertex_id(v), {Pin::Kind::normal, {3.0 * normal[v]}});
    }
    const auto system = must(NetworkSystem::assemble(polyhedron, shaping));
    const auto solution = system->solve(polyhedron.positions(), {});
    const DenseSystem reference = dense(polyhedron, *system);
    Eigen::MatrixXd x(reference.right.rows(), 3);
    for (Eigen::Index i = 0; i < x.rows(); ++i) x.row(i) = solution.basis[std::size_t(i)].transpose();
    const Eigen::MatrixXd gradient = reference.matrix * x - reference.right;
    const double scale = reference.right.lpNorm<Eigen::Infinity>();
    const auto& begin = system->frames().basis_begin;
    for (Index v = 0; v < polyhedron.vertex_count(); ++v)
      for (Index b = begin[v]; b < begin[v + 1]; ++b) {
        const Vector3 g = gradient.row(Eigen::Index(b)).transpose();
        if (normal[v].isZero()) {
          ASSERT_LT(g.norm(), 1e-11 * scale);
        } else {
          ASSERT_LT(std::abs(solution.basis[b].dot(normal[v])), 1e-14 * (1 + solution.basis[b].norm()));
          ASSERT_LT((g - normal[v] * normal[v].dot(g)).norm(), 1e-11 * scale);
        }
      }
  });
}

TEST(Network, StartsWarm) {
  std::mt19937_64 rng(5);
  const Polyhedron polyhedron = Polyhedron::build(torus(20, 12)).value();
  const auto system = NetworkSystem::assemble(polyhedron, {}).value();
  auto positions = polyhedron.positions();
  const auto cold = system.solve(positions, {});
  NetworkSystem::SolveOptions warm;
  warm.start = &cold.basis;
  EXPECT_EQ(system.solve(positions, warm).iterations, 0);
  EXPECT_LE(cold.iterations, 20);
}

// --- errors ------------------------------------------------------------------------------------------------

Polyhedron cube_polyhedron() {
  return Polyhedron::build(cube()).value();
}

void expect_error(const Shaping& shaping, Code code, Element element) {
  const auto system = NetworkSystem::assemble(cube_polyhedron(), shaping);
  ASSERT_FALSE(system.ok());
  EXPECT_EQ(system.error().code.name, code.name);
  EXPECT_EQ(system.error().element, element);
  EXPECT_FALSE(system.error().text.empty());
  EXPECT_FALSE(system.error().remedy.empty());
}

TEST(NetworkErrors, TensionsMustBeFiniteAndNotNegative) {
  Shaping shaping;
  shaping.alpha.set({3}, -1.0);
  expect_error(shaping, e_tension_negative, element_of(VertexId{3}));
  shaping = {};
  shaping.alpha.set({2}, std::nan(""));
  expect_error(shaping, e_tension_nonfinite, element_of(VertexId{2}));
  const EdgeId edge = EdgeId::of({1}, {0});
  shaping = {};
  shaping.beta.set(edge, -0.5);
  expect_error(shaping, e_tension_negative, element_of(edge));
  shaping = {};
  shaping.beta.set(edge, std::numeric_limits<double>::infinity());
  expect_error(shaping, e_tension_nonfinite, element_of(edge));
}

TEST(NetworkErrors, VertexWithoutTensionIsSingular) {
  Shaping shaping;
  const Polyhedron polyhedron = cube_polyhedron();
  for (Index e = 0; e < polyhedron.edge_count(); ++e)
    if (const EdgeId id = polyhedron.edge_id(e); id.low.value == 0) shaping.beta.set(id, 0.0);
  expect_error(shaping, e_singular_vertex, element_of(VertexId{0}));
  shaping.alpha.set({0}, 0.5);  // tension at the vertex itself is enough
  EXPECT_TRUE(NetworkSystem::assemble(polyhedron, shaping).ok());
}

TEST(NetworkErrors, CornerNeedsCreases) {
  Shaping shaping;
  shaping.tag.set({6}, VertexTag::corner);
  expect_error(shaping, e_corner_needs_crease, element_of(VertexId{6}));
  shaping.crease.set(EdgeId::of({6}, {5}), true);
  expect_error(shaping, e_corner_needs_crease, element_of(VertexId{6}));
  shaping.crease.set(EdgeId::of({6}, {7}), true);
  EXPECT_TRUE(NetworkSystem::assemble(cube_polyhedron(), shaping).ok());
}

TEST(NetworkErrors, PinsMustFitTheVertex) {
  Shaping shaping;
  shaping.pin.set({1}, {Pin::Kind::tangents, {Vector3::UnitX()}});
  expect_error(shaping, e_pin_mismatch, element_of(VertexId{1}));
  shaping.pin.set({1}, {Pin::Kind::normal, {Vector3::Zero()}});
  expect_error(shaping, e_pin_mismatch, element_of(VertexId{1}));
  shaping.pin.set({1}, {Pin::Kind::normal, {Vector3(std::nan(""), 0, 1)}});
  expect_error(shaping, e_pin_mismatch, element_of(VertexId{1}));
}

}  // namespace
}  // namespace hariko::test
