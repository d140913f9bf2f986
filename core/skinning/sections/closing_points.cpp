#include "core/skinning/sections/closing_points.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <vector>

namespace hariko {

namespace {

constexpr double same_closing_place = 1e-9;  ///< relative to the size of a section

bool repeats_first_point(const SkinSection& section) {
  if (!section.closed || section.points.size() <= 3) return false;
  Eigen::AlignedBox3d box;
  for (const SectionPoint& point : section.points) box.extend(point.position);
  const double distance = (section.points.back().position - section.points.front().position).norm();
  return distance <= same_closing_place * box.diagonal().norm();
}

/// Puts `now` in the place of a point; removes the point where `now` is there already.
void replace_point(std::vector<std::uint32_t>& ids, std::uint32_t old, std::uint32_t now) {
  const auto at = std::find(ids.begin(), ids.end(), old);
  if (at == ids.end()) return;
  if (std::find(ids.begin(), ids.end(), now) == ids.end())
    *at = now;
  else
    ids.erase(at);
}

}  // namespace

std::size_t drop_closing_points(Skin& skin) {
  std::size_t out = 0;
  for (SkinSection& section : skin.sections) {
    if (!repeats_first_point(section)) continue;
    SectionPoint& first = section.points.front();
    const SectionPoint last = section.points.back();
    first.sharp = first.sharp || last.sharp;
    for (SkinLink& link : skin.links) {
      replace_point(link.a, last.id, first.id);
      replace_point(link.b, last.id, first.id);
    }
    for (SkinMerge& merge : skin.merges) {
      replace_point(merge.members, last.id, first.id);
      if (merge.target == last.id) merge.target = first.id;
    }
    // A merge of both points at the same place is none.
    std::erase_if(skin.merges, [](const SkinMerge& merge) { return merge.members.size() < 2; });
    section.points.pop_back();
    ++out;
  }
  return out;
}

}  // namespace hariko
