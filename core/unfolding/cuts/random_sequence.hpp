#pragma once

// RandomSequence: pseudo-random numbers that are the same on every platform (splitmix64). Internal to
// core/unfolding.

#include <cstdint>

namespace hariko {

/// Generator splitmix64 (Steele, Lea, Flood 2014).
class RandomSequence {
 public:
  explicit RandomSequence(std::uint64_t seed) : state_(seed) {}
  /// Next number, uniform over all 64 bits.
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  /// Uniform integer in 0 .. count - 1, except for a bias of count / 2^64.
  std::uint64_t below(std::uint64_t count) { return next() % count; }
  /// Uniform number in [0, 1).
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

}  // namespace hariko
