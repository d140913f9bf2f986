#include "core/base/solvers/banded_cholesky.hpp"

#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

TEST(BandedCholesky, SolvesWhatItWasGiven) {
  for_random(4400, 40, [](std::mt19937_64& rng) {
    const auto size = std::size_t(uniform_int(rng, 1, 30)), band = std::size_t(uniform_int(rng, 0, 9));
    BandedCholesky matrix(size, band);
    std::vector<std::vector<double>> dense(size, std::vector<double>(size, 0));
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = i > band ? i - band : 0; k <= i; ++k)
        matrix.entry(i, k) = dense[i][k] = dense[k][i] = i == k ? 20 : uniform(rng, -1, 1);
    std::vector<double> wanted, right(size, 0);
    for (std::size_t i = 0; i < size; ++i) wanted.push_back(uniform(rng, -1, 1));
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k) right[i] += dense[i][k] * wanted[k];
    ASSERT_TRUE(matrix.factor());
    matrix.solve(right);
    for (std::size_t i = 0; i < size; ++i) EXPECT_NEAR(right[i], wanted[i], 1e-12);
  });
}

TEST(BandedCholesky, RefusesWhatIsNotDefinite) {
  BandedCholesky matrix(2, 1);
  matrix.entry(0, 0) = matrix.entry(1, 0) = matrix.entry(1, 1) = 1;
  EXPECT_FALSE(matrix.factor());
}

}  // namespace
}  // namespace hariko::test
