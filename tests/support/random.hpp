#pragma once

// Repeatable random tests: seeds are printed on failure, and the environment variables HARIKO_SEED and
// HARIKO_REPEAT_SCALE (a factor on the number of repetitions, 1 by default) override seed and length.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

#include "core/base/vector.hpp"
#include "tests/support/must.hpp"

namespace hariko::test {

/// Seed from HARIKO_SEED, or `fallback`.
inline std::uint64_t random_seed(std::uint64_t fallback) {
  const char* text = std::getenv("HARIKO_SEED");
  return text && *text ? std::strtoull(text, nullptr, 10) : fallback;
}

/// Number of repetitions: `count` times HARIKO_REPEAT_SCALE, at least 1.
inline int repetitions(int count) {
  const char* text = std::getenv("HARIKO_REPEAT_SCALE");
  const double scale = text && *text ? std::strtod(text, nullptr) : 1.0;
  return std::max(1, static_cast<int>(std::lround(count * scale)));
}

/// Runs test(rng) `count` (scaled) times, each with a generator of its own seed: seed, seed + 1, ... Stops at
/// the first fatal failure. To repeat a failing run alone, set HARIKO_SEED to the seed it printed; it then
/// runs first.
template <class Test>
void for_random(std::uint64_t seed, int count, Test&& test) {
  const std::uint64_t first = random_seed(seed);
  const int total = repetitions(count);
  for (int i = 0; i < total && !::testing::Test::HasFatalFailure(); ++i) {
    const std::uint64_t own = first + static_cast<std::uint64_t>(i);
    SCOPED_TRACE("HARIKO_SEED=" + std::to_string(own));
    std::mt19937_64 rng(own);
    test(rng);
  }
}

// Written out because the distributions of the standard library differ between implementations.

/// Uniform number in [low, high).
inline double uniform(std::mt19937_64& rng, double low = 0, double high = 1) {
  return low + (high - low) * (static_cast<double>(rng() >> 11) * 0x1p-53);
}

/// Uniform integer in low .. high, both included.
inline int uniform_int(std::mt19937_64& rng, int low, int high) {
  return low + static_cast<int>(rng() % static_cast<std::uint64_t>(high - low + 1));
}

/// True with the given probability.
inline bool chance(std::mt19937_64& rng, double probability) {
  return uniform(rng) < probability;
}

/// Uniform vector in the cube [-radius, radius]^3.
inline Vector3 random_vector(std::mt19937_64& rng, double radius = 1) {
  const double x = uniform(rng, -radius, radius), y = uniform(rng, -radius, radius);
  return {x, y, uniform(rng, -radius, radius)};
}

/// Logarithmically uniform number in [low, high), both positive, for tensions.
inline double log_uniform(std::mt19937_64& rng, double low, double high) {
  return std::exp(uniform(rng, std::log(low), std::log(high)));
}

}  // namespace hariko::test
