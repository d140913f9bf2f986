// Conjugate gradients against sparse factorisation of the same systems. Factor and back-substitution (three
// right-hand sides) are timed apart, since a factor may be kept while connectivity and tensions stand.

#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>
#include <memory>

#include "bench/models.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/fair/fair_system.hpp"

namespace hariko {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Solver = Eigen::SimplicialLDLT<Matrix>;

Matrix network_matrix(const Polyhedron& polyhedron, const NetworkSystem& system) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const VertexFrames& frames = system.frames();
  std::vector<Eigen::Triplet<double>> entries;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    const Index ends[2] = {2 * h, 2 * h + 1};
    const double beta = system.beta()[e];
    const double alpha[2] = {system.alpha()[mesh.origin(h)], system.alpha()[mesh.target(h)]};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2; ++b) {
            const Index row = frames.ends[ends[i]].basis[a], column = frames.ends[ends[j]].basis[b];
            if (row == no_index || column == no_index) continue;
            const double weight = i == j ? 2 * (beta + alpha[i]) : -beta;
            entries.emplace_back(int(row), int(column),
                                 weight * frames.ends[ends[i]].c[a] * frames.ends[ends[j]].c[b]);
          }
  }
  Matrix matrix(Eigen::Index(frames.basis_count()), Eigen::Index(frames.basis_count()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Columns by multiplication with unit vectors, three at a time.
Matrix fair_matrix(const FairSystem& system) {
  const std::size_t n = system.unknown_count();
  std::vector<Eigen::Triplet<double>> entries;
  FairSystem::Field x(n);
  for (std::size_t first = 0; first < n; first += 3) {
    for (std::size_t c = 0; c < 3 && first + c < n; ++c) x[first + c][Eigen::Index(c)] = 1;
    const FairSystem::Field y = system.multiply(x);
    for (std::size_t c = 0; c < 3 && first + c < n; ++c) {
      for (std::size_t i = 0; i < n; ++i)
        if (const double value = y[i][Eigen::Index(c)]; value != 0)
          entries.emplace_back(int(i), int(first + c), value);
      x[first + c].setZero();
    }
  }
  const auto size = static_cast<Eigen::Index>(n);
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

void factor(benchmark::State& state, const Matrix& matrix) {
  Solver solver;
  for (auto _ : state) solver.compute(matrix);
  state.counters["unknowns"] = double(matrix.rows());
}

void solve(benchmark::State& state, const Matrix& matrix) {
  const Solver solver(matrix);
  const Eigen::MatrixXd right = Eigen::MatrixXd::Random(matrix.rows(), 3);
  Eigen::MatrixXd x;
  for (auto _ : state) x = solver.solve(right);
  state.counters["unknowns"] = double(matrix.rows());
}

void network_direct(benchmark::State& state, void (*step)(benchmark::State&, const Matrix&)) {
  const Polyhedron polyhedron = bench_torus(state.range(0));
  step(state, network_matrix(polyhedron, NetworkSystem::assemble(polyhedron, {}).value()));
}
BENCHMARK_CAPTURE(network_direct, factor, factor)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(20000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(network_direct, solve, solve)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(20000)
    ->Unit(benchmark::kMillisecond);

void fair_direct(benchmark::State& state, void (*step)(benchmark::State&, const Matrix&)) {
  const Polyhedron polyhedron = bench_torus(state.range(0));
  const NetworkSystem network = NetworkSystem::assemble(polyhedron, {}).value();
  const FairSystem fair(polyhedron.shared_topology(), network,
                        patch_constants(polyhedron.topology(), network.frames()));
  step(state, fair_matrix(fair));
}
BENCHMARK_CAPTURE(fair_direct, factor, factor)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fair_direct, solve, solve)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hariko
