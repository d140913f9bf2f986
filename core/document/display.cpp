#include "core/document/display.hpp"

#include "core/base/assert.hpp"

namespace hariko {

Colour natural_colour(Material material) {
  switch (material) {
    case Material::clay:
      break;
    case Material::porcelain:
      return {0xee, 0xed, 0xe8};
    case Material::metal:
      return {0xb9, 0xbd, 0xc4};
    case Material::wax:
      return {0xd9, 0xa9, 0x8c};
    case Material::rubber:
      return {0x3a, 0x3c, 0x40};
    case Material::plastic:
      return {0xc4, 0x2b, 0x25};
  }
  return {0xb9, 0xb4, 0xac};
}

DisplaySettings with_material(DisplaySettings display, Material material) {
  if (display.colour == natural_colour(display.material)) display.colour = natural_colour(material);
  display.material = material;
  return display;
}

std::optional<std::size_t> range_slot(SurfaceMap map) {
  switch (map) {
    case SurfaceMap::gaussian:
      return 0;
    case SurfaceMap::mean:
      return 1;
    case SurfaceMap::principal_max:
      return 2;
    case SurfaceMap::principal_min:
      return 3;
    case SurfaceMap::continuity:
      return 4;
    case SurfaceMap::draft:
      return 5;
    case SurfaceMap::radius:
      return 6;
    case SurfaceMap::thickness:
      return 7;
    case SurfaceMap::deviation:
      return 8;
    case SurfaceMap::shaded:
    case SurfaceMap::patches:
    case SurfaceMap::zebra:
    case SurfaceMap::isophotes:
      break;
  }
  return std::nullopt;
}

const MapRange& range_of(const DisplaySettings& display, SurfaceMap map) {
  const auto slot = range_slot(map);
  HARIKO_ASSERT(slot.has_value(), "only maps with values have a range");
  return display.ranges[slot.value_or(0)];
}

MapRange& range_of(DisplaySettings& display, SurfaceMap map) {
  const auto slot = range_slot(map);
  HARIKO_ASSERT(slot.has_value(), "only maps with values have a range");
  return display.ranges[slot.value_or(0)];
}

}  // namespace hariko
