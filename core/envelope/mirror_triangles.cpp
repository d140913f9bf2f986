#include "core/envelope/mirror_triangles.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "core/base/disjoint_sets.hpp"

namespace hariko {

namespace {

using Triangle = std::array<Index, 3>;

/// The same triangle, its lowest corner first.
Triangle ordered(const Triangle& t) {
  const auto lowest = std::size_t(std::min_element(t.begin(), t.end()) - t.begin());
  return {t[lowest], t[(lowest + 1) % 3], t[(lowest + 2) % 3]};
}

Triangle image_of(const Triangle& t, std::span<const Index> image) {
  return ordered({image[t[0]], image[t[2]], image[t[1]]});
}

}  // namespace

void mirror_triangles(std::vector<Triangle>& triangles, std::span<const Index> image) {
  std::set<Triangle> known;
  std::map<std::pair<Index, Index>, Index> sides;  // and their triangles
  for (Index t = 0; t < triangles.size(); ++t) {
    known.insert(ordered(triangles[t]));
    for (std::size_t i = 0; i < 3; ++i) sides[{triangles[t][i], triangles[t][(i + 1) % 3]}] = t;
  }
  std::vector<Index> alone;
  for (Index t = 0; t < triangles.size(); ++t)
    if (!known.contains(image_of(triangles[t], image))) alone.push_back(t);
  if (alone.empty()) return;
  // Sides without an image are cuts through faces.
  DisjointSets faces(triangles.size());
  for (const auto& [side, one] : sides)
    if (const auto other = sides.find({side.second, side.first});
        other != sides.end() && !sides.contains({image[side.first], image[side.second]}))
      faces.join(one, other->second);
  std::map<Index, std::vector<Index>> face;  // triangles, by the first of them
  for (const Index t : alone) face[faces.find(t)].push_back(t);
  std::map<std::set<Index>, const std::vector<Index>*> by_corners;
  const auto corners_of = [&](const std::vector<Index>& members) {
    std::set<Index> out;
    for (const Index t : members) out.insert(triangles[t].begin(), triangles[t].end());
    return out;
  };
  for (const auto& [first, members] : face) by_corners[corners_of(members)] = &members;
  for (const auto& [corners, members] : by_corners) {
    std::set<Index> images;
    for (const Index v : corners) images.insert(image[v]);
    const auto other = by_corners.find(images);
    if (!(corners < images) || other == by_corners.end() || other->second->size() != members->size())
      continue;
    for (std::size_t k = 0; k < members->size(); ++k)
      triangles[(*other->second)[k]] = image_of(triangles[(*members)[k]], image);
  }
}

}  // namespace hariko
