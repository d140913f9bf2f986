#pragma once

// OutlineSettings: what a designer chooses beside the outline itself.

#include <optional>

#include "core/gaussmap/outline_check.hpp"

namespace hariko {

struct GaussOptions;

/// How the surface inside of an outline is found; the meaning of each is that of `GaussOptions`.
struct OutlineSettings {
  GaussMode mode = GaussMode::umbilic;
  CurvatureSign sign = CurvatureSign::positive;
  double radius = 0.6;                ///< median steps of the normals along the outline; > 0
  Index most_points = 20000;          ///< inserted ones
  std::optional<double> gap;          ///< length > 0; empty: only `radius` decides
  bool curvature_continuous = false;  ///< patches of mode G2 instead of FAIR

  static constexpr double smallest_radius = 0.01, largest_radius = 100;
  static constexpr Index point_limit = 20000;
  friend bool operator==(const OutlineSettings&, const OutlineSettings&) = default;
};

GaussOptions gauss_options(const OutlineSettings& settings);

/// Mode curvature where all of the curvature is given and positive, else umbilic with the curvature's sign.
OutlineSettings usual_settings(const Outline& outline);

}  // namespace hariko
