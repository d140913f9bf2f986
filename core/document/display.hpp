#pragma once

// DisplaySettings: the visible parts of an object and their look. Set by the designer, hence part of the
// document.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace hariko {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;  ///< sRGB
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// Colouring of the surface.
enum class SurfaceMap : std::uint8_t {
  shaded,
  patches,        ///< one colour per patch
  zebra,          ///< reflection lines
  gaussian,       ///< Gaussian curvature
  mean,           ///< mean curvature
  principal_max,  ///< larger principal curvature
  principal_min,  ///< smaller principal curvature
  continuity,     ///< relative jump of curvature across edges
  isophotes,      ///< lines of equal angle to a direction
  draft,          ///< angle to the direction in which a mould opens
  radius,         ///< smallest radius of curvature
  thickness,      ///< thickness of the walls of closed surfaces
  deviation,      ///< signed distance from a reference
};
inline constexpr int surface_map_count = 13;

/// Light reflection of the surface in the map `shaded`.
enum class Material : std::uint8_t { clay, porcelain, metal, wax, rubber, plastic };
inline constexpr int material_count = 6;
/// Default colour of a material, used until the designer chooses another one.
Colour natural_colour(Material material);

/// Range of values that a map's colours cover.
enum class RangeMode : std::uint8_t {
  /// Same distance on both sides of zero (from zero, where no value is negative), without the outermost 2%.
  symmetric,
  percentile,  ///< from the 2 % to the 98 % quantile
  full,        ///< from the smallest to the largest value
  manual       ///< from `low` to `high`
};

struct MapRange {
  RangeMode mode = RangeMode::symmetric;
  /// Limits in the map's own unit; kept while another mode is active. Finite, low < high.
  double low = -1, high = 1;
  friend bool operator==(const MapRange&, const MapRange&) = default;
};

/// Ranges of the maps with values, see `range_slot`.
using MapRanges = std::array<MapRange, 9>;

/// Patch lines drawn on the surface.
enum class PatchWire : std::uint8_t { none, borders, mesh };

/// Curvature combs on the curves over the polyhedron's edges.
struct CombSettings {
  bool shown = false;
  int density = 24;  ///< intervals per curve, min_density .. max_density
  double scale = 1;  ///< factor of the automatic length, min_scale .. max_scale
  static constexpr int min_density = 4, max_density = 128;
  static constexpr double min_scale = 1.0 / 64, max_scale = 64;
  friend bool operator==(const CombSettings&, const CombSettings&) = default;
};

struct DisplaySettings {
  bool surface = true;
  bool polyhedron = true;
  bool network = true;
  SurfaceMap map = SurfaceMap::shaded;
  /// Least number of intervals per patch side when drawn, min_density .. max_density; small models are drawn
  /// finer.
  int density = 8;
  Colour colour{0xb9, 0xb4, 0xac};
  Material material = Material::clay;
  bool points = true;  ///< vertices, shown with the polyhedron
  PatchWire wire = PatchWire::none;
  bool tensions = false;  ///< tensions as colours and numbers on the polyhedron
  bool marks = false;     ///< continuity of the edges: G0, G1, G2
  CombSettings combs{};
  MapRanges ranges{};

  static constexpr int min_density = 1, max_density = 64;
  friend bool operator==(const DisplaySettings&, const DisplaySettings&) = default;
};

/// Returns the settings with another material; the colour changes with it unless the designer chose one.
DisplaySettings with_material(DisplaySettings display, Material material);

/// Index of a map's range in `DisplaySettings::ranges`; nothing for maps without values.
std::optional<std::size_t> range_slot(SurfaceMap map);
/// Range of a map with values (asserted).
const MapRange& range_of(const DisplaySettings& display, SurfaceMap map);
MapRange& range_of(DisplaySettings& display, SurfaceMap map);

}  // namespace hariko
