#pragma once

// DisplaySettings: what of an object is shown, and how. Authored, hence part of the document.

#include <cstdint>

namespace hariko {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;  ///< sRGB
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// What colours the surface.
enum class SurfaceMap : std::uint8_t {
  shaded,
  patches,        ///< one colour a patch
  zebra,          ///< reflection lines
  gaussian,       ///< Gaussian curvature
  mean,           ///< mean curvature
  principal_max,  ///< larger principal curvature
  principal_min,  ///< smaller principal curvature
  continuity,     ///< relative jump of curvature across edges
};

struct DisplaySettings {
  bool surface = true;
  bool polyhedron = true;
  bool network = true;
  SurfaceMap map = SurfaceMap::shaded;
  /// Least intervals a patch side when drawn, min_density .. max_density; small models are drawn finer.
  int density = 8;
  Colour colour{0xb9, 0xb4, 0xac};

  static constexpr int min_density = 1, max_density = 64;
  friend bool operator==(const DisplaySettings&, const DisplaySettings&) = default;
};

}  // namespace hariko
