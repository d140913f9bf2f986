#include "core/g2/faces/face_region.hpp"

#include <cmath>
#include <cstdint>
#include <numeric>

#include "core/base/index_list.hpp"

namespace hariko {

FaceRegion face_region(const G2Layout& layout, const std::vector<bool>& given, std::vector<Index> faces) {
  FaceRegion region;
  region.faces = std::move(faces);
  const Index count = layout.unknowns().count;
  const std::vector<std::uint32_t>& incidence = layout.incidence();
  std::vector<std::uint32_t> met(count, 0);
  for (const Index f : region.faces) {
    region.first_slot.push_back(region.slot.size());
    for (int i = 0; i < layout.slot_count(f); ++i) {
      region.slot.push_back(layout.slot_unknown(f, i));
      ++met[region.slot.back()];
    }
  }
  region.first_slot.push_back(region.slot.size());
  std::vector<Index> own(count, no_index);
  for (Index i = 0; i < count; ++i) {
    // Not in this region, or shared with a face outside, or given.
    if (met[i] == 0 || met[i] != incidence[i] || given[i]) continue;
    own[i] = static_cast<Index>(region.global.size());
    region.global.push_back(i);
    region.share.push_back(1 / std::sqrt(double(incidence[i])));
  }
  region.begin.assign(region.global.size() + 1, 0);
  for (Index& slot : region.slot) {
    slot = own[slot];
    if (slot != no_index) ++region.begin[slot + 1];
  }
  std::partial_sum(region.begin.begin(), region.begin.end(), region.begin.begin());
  region.slots.resize(region.begin.back());
  std::vector<std::size_t> cursor(region.begin.begin(), region.begin.end() - 1);
  for (std::size_t k = 0; k < region.slot.size(); ++k)
    if (region.slot[k] != no_index) region.slots[cursor[region.slot[k]]++] = k;
  return region;
}

FaceRegion region_of_all(const G2Layout& layout, const std::vector<bool>& given) {
  return face_region(layout, given, ascending_indices(layout.mesh().face_count()));
}

}  // namespace hariko
