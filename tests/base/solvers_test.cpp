#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "core/base/solvers/dense_solver.hpp"
#include "core/base/solvers/least_squares.hpp"
#include "core/base/solvers/small_solver.hpp"
#include "core/base/solvers/sparse_solver.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

namespace {

Eigen::MatrixXd random_matrix(std::mt19937_64& rng, Eigen::Index rows, Eigen::Index columns) {
  Eigen::MatrixXd out(rows, columns);
  for (Eigen::Index k = 0; k < columns; ++k)
    for (Eigen::Index i = 0; i < rows; ++i) out(i, k) = uniform(rng, -1, 1);
  return out;
}

/// Positive definite.
Eigen::MatrixXd random_definite(std::mt19937_64& rng, Eigen::Index size) {
  const Eigen::MatrixXd a = random_matrix(rng, size + 2, size);
  return transposed_product(a, a) + 0.1 * Eigen::MatrixXd::Identity(size, size);
}

template <int n>
void expect_small_system_solved(std::mt19937_64& rng) {
  using Matrix = Eigen::Matrix<double, n, n>;
  using Vector = Eigen::Matrix<double, n, 1>;
  const Matrix matrix = random_definite(rng, n);
  const Vector right = random_matrix(rng, n, 1), x = solve_symmetric(matrix, right);
  EXPECT_LE((matrix * x - right).norm(), 1e-12);
}

}  // namespace

TEST(SmallSolver, SolvesSymmetricSystems) {
  for_random(41, 300, [&](std::mt19937_64& rng) {
    expect_small_system_solved<2>(rng);
    expect_small_system_solved<3>(rng);
    expect_small_system_solved<4>(rng);
  });
}

TEST(SmallSolver, LeavesOutWhatASemidefiniteSystemDoesNotDetermine) {
  const Vector3 n(1, 2, 3);
  const Matrix3 matrix = n * n.transpose();
  const Vector3 x = solve_symmetric(matrix, Vector3(4 * n));
  EXPECT_TRUE(x.allFinite());
  EXPECT_NEAR(n.dot(x), 4, 1e-12);
  EXPECT_EQ(solve_symmetric(Matrix3(Matrix3::Zero()), n), Vector3::Zero());
}

TEST(SmallSolver, SolvesTwoConditionsAndTakesOneOfManySolutions) {
  for_random(42, 300, [&](std::mt19937_64& rng) {
    const Eigen::Matrix2d matrix = random_matrix(rng, 2, 2);
    const Vector2 x(uniform(rng, -1, 1), uniform(rng, -1, 1));
    const Vector2 found = solve_general(matrix, Vector2(matrix * x));
    EXPECT_LE((found - x).norm(), 1e-13 / std::abs(matrix.determinant()));
  });
  Eigen::Matrix2d one_row;
  one_row << 0, 0, 1, 2;
  EXPECT_LE((one_row * solve_general(one_row, Vector2(0, 3)) - Vector2(0, 3)).norm(), 1e-14);
  EXPECT_EQ(solve_general(Eigen::Matrix2d(Eigen::Matrix2d::Zero()), Vector2(1, 1)), Vector2::Zero());
}

TEST(SmallSolver, AxesOfMatricesPutThemTogetherAgain) {
  for_random(43, 100, [&](std::mt19937_64& rng) {
    const Matrix3 matrix = random_matrix(rng, 3, 3), symmetric = matrix + matrix.transpose();
    const SymmetricAxes axes = symmetric_axes(symmetric);
    EXPECT_TRUE(axes.values[0] <= axes.values[1] && axes.values[1] <= axes.values[2]);
    EXPECT_LE((axes.vectors * axes.values.asDiagonal() * axes.vectors.transpose() - symmetric).norm(), 1e-13);
    const SingularAxes parts = singular_axes(matrix);
    EXPECT_TRUE(parts.values[0] >= parts.values[1] && parts.values[1] >= parts.values[2]);
    EXPECT_LE((parts.u * parts.values.asDiagonal() * parts.v.transpose() - matrix).norm(), 1e-13);
  });
  const SingularAxes none = singular_axes(Matrix3::Constant(NAN));
  EXPECT_EQ(none.values, Vector3::Zero());
}

TEST(DenseSolver, SolvesSystems) {
  for_random(44, 50, [&](std::mt19937_64& rng) {
    const Eigen::Index size = uniform_int(rng, 1, 30);
    const Eigen::MatrixXd definite = random_definite(rng, size), right = random_matrix(rng, size, 3);
    const auto found = solve_definite(definite, right);
    ASSERT_TRUE(found);
    EXPECT_LE((definite * *found - right).norm(), 1e-10);
    EXPECT_FALSE(solve_definite(-definite, right));
    const Eigen::VectorXd column = right.col(0);
    EXPECT_LE((definite * solve_symmetric(definite, column) - column).norm(), 1e-10);
    const Eigen::MatrixXd general =
        random_matrix(rng, size, size) + 3 * Eigen::MatrixXd::Identity(size, size);
    const Eigen::VectorXd x = solve_general(general, column);
    const double large = std::max(1.0, x.norm());
    EXPECT_LE((general * x - column).norm(), 1e-10 * large);
    EXPECT_LE((inverse_matrix(general) * column - x).norm(), 1e-9 * large * large);
  });
}

TEST(DenseSolver, EigenvaluesAscendAndAreThoseOfTheMatrix) {
  for_random(45, 30, [&](std::mt19937_64& rng) {
    const Eigen::Index size = uniform_int(rng, 1, 12);
    const Eigen::MatrixXd a = random_matrix(rng, size, size), matrix = a + a.transpose();
    const Eigen::VectorXd values = symmetric_eigenvalues(matrix);
    ASSERT_EQ(values.size(), size);
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    EXPECT_NEAR(values.sum(), matrix.trace(), 1e-12);
    EXPECT_NEAR(values.squaredNorm(), matrix.squaredNorm(), 1e-11);
    Eigen::MatrixXd lower = matrix;
    lower.triangularView<Eigen::StrictlyUpper>().setConstant(1e9);
    EXPECT_EQ(symmetric_eigenvalues(lower), values) << "only the lower triangle is read";
  });
  EXPECT_EQ(symmetric_eigenvalues(Eigen::MatrixXd::Zero(3, 3)), Eigen::VectorXd::Zero(3));
}

TEST(LeastSquaresTest, FindsTheShortestSolutionAndAllOthers) {
  for_random(46, 50, [&](std::mt19937_64& rng) {
    // Five conditions of rank two on four unknowns.
    const Eigen::MatrixXd matrix = random_matrix(rng, 5, 2) * random_matrix(rng, 2, 4);
    const Eigen::VectorXd right = random_matrix(rng, 5, 1);
    const LeastSquares all = all_least_squares(matrix, right, 1e-9);
    ASSERT_EQ(all.free.cols(), 2);
    EXPECT_LE((matrix * all.free).norm(), 1e-13);
    EXPECT_LE((all.free.transpose() * all.free - Eigen::MatrixXd::Identity(2, 2)).norm(), 1e-13);
    EXPECT_LE((all.free.transpose() * all.shortest).norm(), 1e-10 * (1 + all.shortest.norm()));
    const Eigen::VectorXd slope = matrix.transpose() * (matrix * all.shortest - right);
    EXPECT_LE(slope.norm(), 1e-10 * (1 + all.shortest.norm()));
    const Eigen::VectorXd other = solve_least_squares(matrix, right);
    EXPECT_LE((other - all.shortest).norm(), 1e-8 * (1 + all.shortest.norm()));
    const Eigen::VectorXd any = solve_overdetermined(matrix, right);
    EXPECT_LE((matrix.transpose() * (matrix * any - right)).norm(), 1e-9 * (1 + any.norm()));
  });
}

TEST(SparseSolver, SolvesSystemsAndTellsSingularOnes) {
  for_random(47, 20, [&](std::mt19937_64& rng) {
    const int size = uniform_int(rng, 1, 40);
    SparseEntries entries;
    for (int i = 0; i < size; ++i) {
      entries.emplace_back(i, i, 4.0);
      entries.emplace_back(i, i, 1.0);
      const int other = uniform_int(rng, 0, size - 1);
      entries.emplace_back(i, other, uniform(rng, -1, 1));
    }
    const SparseMatrix general = sparse_matrix(size, size, entries);
    const Eigen::VectorXd right = random_matrix(rng, size, 1);
    const SparseLu lu(general);
    ASSERT_TRUE(lu.succeeded());
    EXPECT_LE((general * lu.solve(right) - right).norm(), 1e-12);
    const SparseMatrix definite = transposed_product(general, general);
    EXPECT_LE(
        (Eigen::MatrixXd(sparse_product(general.transpose(), general)) - Eigen::MatrixXd(definite)).norm(),
        1e-12);
    const SparseCholesky cholesky(definite);
    ASSERT_TRUE(cholesky.succeeded());
    const Eigen::MatrixXd columns = random_matrix(rng, size, 3);
    EXPECT_LE((definite * cholesky.solve(columns) - columns).norm(), 1e-11);
    EXPECT_LE((definite * cholesky.solve(right) - right).norm(), 1e-11);
    const Eigen::MatrixXd scaled = scaled_rows(right, general);
    EXPECT_LE((scaled - Eigen::MatrixXd(right.asDiagonal() * Eigen::MatrixXd(general))).norm(), 1e-14);
  });
  EXPECT_FALSE(SparseLu(sparse_matrix(2, 2, {{0, 0, 1.0}, {1, 0, 1.0}})).succeeded());
}

TEST(DenseSolver, WhatIsDefiniteButForRoundingCanBeSolved) {
  for_random(77, 50, [](std::mt19937_64& rng) {
    const Eigen::Index n = uniform_int(rng, 2, 12);
    // Columns that depend on each other to the last digits, in very different units.
    Eigen::MatrixXd half(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index k = 0; k < n; ++k) half(i, k) = uniform(rng, -1, 1);
    half.col(0) = half.col(n - 1);
    Eigen::VectorXd unit(n);
    for (Eigen::Index k = 0; k < n; ++k) unit[k] = log_uniform(rng, 1e-6, 1e6);
    Eigen::MatrixXd matrix = scaled_both_sides(unit, transposed_product(half, half));
    matrix(0, 0) *= 1 - 1e-15;
    const Eigen::MatrixXd inverse = solve_nearly_definite(matrix, Eigen::MatrixXd::Identity(n, n));
    EXPECT_TRUE(inverse.allFinite());
    const Eigen::VectorXd values =
        symmetric_eigenvalues(scaled_both_sides(unit, (inverse + inverse.transpose()) / 2));
    EXPECT_GT(values.minCoeff(), -1e-6 * values.maxCoeff());
    // A right-hand side that the matrix can make comes back.
    const Eigen::MatrixXd right = matrix * unit.cwiseInverse();
    const Eigen::MatrixXd back = matrix_product(matrix, solve_nearly_definite(matrix, right));
    EXPECT_LT((back - right).col(0).cwiseQuotient(unit).norm(),
              1e-6 * right.col(0).cwiseQuotient(unit).norm());
  });
  // As the ordinary solver where there is nothing to be raised.
  const Eigen::MatrixXd plain = Eigen::Vector2d(4, 9).asDiagonal();
  EXPECT_EQ(solve_nearly_definite(plain, Eigen::MatrixXd::Identity(2, 2)),
            *solve_definite(plain, Eigen::MatrixXd::Identity(2, 2)));
}

}  // namespace hariko::test
