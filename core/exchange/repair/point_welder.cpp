#include "core/exchange/repair/point_welder.hpp"

#include <bit>
#include <cstdint>

namespace hariko {
namespace {

std::uint64_t mix(std::uint64_t x) {  // finaliser of splitmix64 (Steele, Lea, Flood 2014)
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// Coordinates that were floats have 29 zero low bits, and so have their products with integers: rotation
/// keeps these of different axes apart.
std::size_t hash_of(const Vector3& p) {
  const auto bits = [&](int axis) { return std::bit_cast<std::uint64_t>(p[axis]); };
  return mix(bits(0) * 0x9e3779b97f4a7c15U + std::rotl(bits(1) * 0xc2b2ae3d27d4eb4fU, 21) +
             std::rotl(bits(2) * 0xd6e8feb86659fd93U, 42));
}

}  // namespace

PointWelder::PointWelder(std::size_t expected_points) {
  positions_.reserve(expected_points);
  slots_.assign(std::bit_ceil(2 * expected_points + 16), no_index);
}

Index PointWelder::add(Vector3 position) {
  position += Vector3::Zero();  // -0 becomes 0
  if (2 * (positions_.size() + 1) > slots_.size()) grow();
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t slot = hash_of(position) & mask;; slot = (slot + 1) & mask) {
    const Index found = slots_[slot];
    if (found == no_index) {
      slots_[slot] = static_cast<Index>(positions_.size());
      positions_.push_back(position);
      return slots_[slot];
    }
    if (positions_[found] == position) return found;
  }
}

void PointWelder::expect(Vector3 position) const {
  position += Vector3::Zero();
  __builtin_prefetch(&slots_[hash_of(position) & (slots_.size() - 1)]);
}

void PointWelder::grow() {
  slots_.assign(2 * slots_.size(), no_index);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    std::size_t slot = hash_of(positions_[i]) & mask;
    while (slots_[slot] != no_index) slot = (slot + 1) & mask;
    slots_[slot] = static_cast<Index>(i);
  }
}

}  // namespace hariko
