#include "core/document/dimension.hpp"

#include <algorithm>
#include <type_traits>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

bool is_sound_anchor(const Anchor& anchor) {
  return std::visit(
      [](const auto& held) {
        using T = std::decay_t<decltype(held)>;
        if constexpr (std::is_same_v<T, VertexAnchor>)
          return true;
        else if constexpr (std::is_same_v<T, EdgeAnchor>)
          return held.edge.low < held.edge.high && held.share >= 0 && held.share <= 1;
        else if constexpr (std::is_same_v<T, PatchAnchor>)
          // A little outside of the domain, as rounding leaves it, does no harm.
          return held.parameter.minCoeff() >= -1e-6 && held.parameter.maxCoeff() <= 1 + 1e-6;
        else
          return held.point.allFinite();
      },
      anchor);
}

/// Whether the surface has a curvature there that does not depend on the side one comes from.
bool lies_on_a_surface(const Anchor& anchor) {
  return std::holds_alternative<PatchAnchor>(anchor) || std::holds_alternative<NearestAnchor>(anchor);
}

}  // namespace

ObjectId* object_of(Anchor& anchor) {
  return std::visit(
      [](auto& held) -> ObjectId* {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, SpaceAnchor>)
          return nullptr;
        else
          return &held.object;
      },
      anchor);
}

const ObjectId* object_of(const Anchor& anchor) {
  return std::visit(
      [](const auto& held) -> const ObjectId* {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, SpaceAnchor>)
          return nullptr;
        else
          return &held.object;
      },
      anchor);
}

std::size_t anchor_count(DimensionKind kind) {
  switch (kind) {
    case DimensionKind::distance:
      return 2;
    case DimensionKind::angle:
      return 3;
    case DimensionKind::radius:
      return 1;
  }
  HARIKO_ASSERT(false, "kind of dimension out of range");
  return 0;
}

DimensionId next_dimension_id(const Dimensions& dimensions) {
  std::vector<std::uint32_t> ids;
  for (const Dimension& dimension : dimensions) ids.push_back(dimension.id.value);
  std::sort(ids.begin(), ids.end());
  if (ids.empty()) return {1};
  if (ids.back() < max_dimension_id) return {ids.back() + 1};
  std::uint32_t free = 1;
  for (const std::uint32_t id : ids)
    if (id == free) ++free;
  return {free};
}

bool is_sound(const Dimension& dimension) {
  return dimension.anchors.size() == anchor_count(dimension.kind) && dimension.label.allFinite() &&
         std::all_of(dimension.anchors.begin(), dimension.anchors.end(), is_sound_anchor) &&
         (dimension.kind != DimensionKind::radius || lies_on_a_surface(dimension.anchors.front()));
}

}  // namespace hariko
