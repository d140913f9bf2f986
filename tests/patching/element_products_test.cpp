#include "core/patching/fair/element_products.hpp"

#include "tests/support/random.hpp"

namespace hariko::test {

namespace {

std::vector<double> random_entries(std::mt19937_64& rng, std::size_t count) {
  std::vector<double> out(count);
  for (double& value : out) value = uniform(rng, -1, 1);
  return out;
}

}  // namespace

TEST(ElementProducts, AddMatrixTimesThreeColumns) {
  for_random(51, 200, [&](std::mt19937_64& rng) {
    const auto rows = std::size_t(uniform_int(rng, 1, 31)), inner = std::size_t(uniform_int(rng, 1, 31));
    const auto a = random_entries(rng, rows * inner), b = random_entries(rng, 3 * inner);
    const auto before = random_entries(rng, 3 * rows);
    auto out = before;
    add_product(rows, inner, a.data(), b.data(), out.data());
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < rows; ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < inner; ++k) sum += a[k * rows + i] * b[c * inner + k];
        EXPECT_EQ(out[c * rows + i], before[c * rows + i] + sum);
      }
  });
}

TEST(ElementProducts, AddTransposedMatrixTimesThreeColumns) {
  for_random(52, 200, [&](std::mt19937_64& rng) {
    const auto rows = std::size_t(uniform_int(rng, 1, 20));
    const std::size_t inner = uniform_int(rng, 0, 1) == 0 ? 6 : 18;
    const auto a = random_entries(rng, rows * inner), b = random_entries(rng, 3 * inner);
    const auto before = random_entries(rng, 3 * rows);
    auto out = before;
    add_transposed_product(rows, inner, a.data(), b.data(), out.data());
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < rows; ++i) {
        double sum = before[c * rows + i];
        for (std::size_t k = 0; k < inner; ++k) sum += a[i * inner + k] * b[c * inner + k];
        EXPECT_NEAR(out[c * rows + i], sum, 1e-14);
      }
  });
}

}  // namespace hariko::test
