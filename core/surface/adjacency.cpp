#include "core/surface/adjacency.hpp"

#include <cmath>

#include "core/base/assert.hpp"

namespace hariko {

bool is_full(const Seam& seam) {
  return seam.first_begin == 0 && seam.first_end == 1 && seam.second_begin == 1 && seam.second_end == 0;
}

Adjacency::Adjacency(const Surface& surface) : corners_(3) {
  if (surface.patch_count() == 0) {
    offsets_.assign(1, 0);
    return;
  }
  corners_ = static_cast<std::size_t>(corner_count(surface.domain()));
  const std::size_t slots = std::size_t{surface.patch_count()} * corners_;
  const std::vector<Seam>& list = surface.seams();

  offsets_.assign(slots + 1, 0);
  full_.assign(slots, no_index);
  std::vector<double> covered(slots, 0.0);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::size_t a = slot(list[i].first), b = slot(list[i].second);
    ++offsets_[a + 1];
    ++offsets_[b + 1];
    covered[a] += std::abs(list[i].first_end - list[i].first_begin);
    covered[b] += std::abs(list[i].second_end - list[i].second_begin);
    if (is_full(list[i])) full_[a] = full_[b] = static_cast<Index>(i);
  }
  for (std::size_t k = 0; k < slots; ++k) offsets_[k + 1] += offsets_[k];
  seams_.resize(2 * list.size());
  std::vector<Index> next(offsets_.begin(), offsets_.end() - 1);
  for (std::size_t i = 0; i < list.size(); ++i) {
    seams_[next[slot(list[i].first)]++] = static_cast<Index>(i);
    seams_[next[slot(list[i].second)]++] = static_cast<Index>(i);
  }
  for (std::size_t k = 0; k < slots; ++k)
    if (covered[k] < 1 - 1e-9)
      boundary_.push_back({static_cast<Index>(k / corners_), static_cast<std::uint8_t>(k % corners_)});
}

std::span<const Index> Adjacency::seams(PatchSide side) const {
  const std::size_t k = slot(side);
  HARIKO_ASSERT(k + 1 < offsets_.size(), "no such side");
  return {seams_.data() + offsets_[k], seams_.data() + offsets_[k + 1]};
}

Index Adjacency::full_seam(PatchSide side) const {
  HARIKO_ASSERT(slot(side) < full_.size(), "no such side");
  return full_[slot(side)];
}

}  // namespace hariko
