#pragma once

// OutlineSettings: the designer's choices for the surface inside an outline.

#include <optional>

#include "core/gaussmap/outlines/outline_check.hpp"
#include "core/network/shaping.hpp"

namespace hariko {

struct GaussOptions;

/// Settings of the surface inside an outline; their meaning is that of `GaussOptions`.
struct OutlineSettings {
  GaussMode mode = GaussMode::umbilic;
  CurvatureSign sign = CurvatureSign::positive;
  double radius = 0.6;                ///< median steps of the normals along the outline; > 0
  Index most_points = 20000;          ///< largest number of inserted points
  std::optional<double> gap;          ///< length > 0; empty: only `radius` decides
  bool curvature_continuous = false;  ///< patches of mode G2 instead of FAIR
  Frames frames = Frames::equal;      ///< layout of the control points' polyhedron in the plane

  static constexpr double smallest_radius = 0.01, largest_radius = 100;
  static constexpr Index point_limit = 20000;
  friend bool operator==(const OutlineSettings&, const OutlineSettings&) = default;
};

/// Options of `control_points` for these settings.
GaussOptions gauss_options(const OutlineSettings& settings);

/// Settings of new outlines: frames by measure, otherwise the defaults.
OutlineSettings new_outline_settings();

/// Default settings for a new outline: mode curvature where all of the curvature is given and positive, else
/// umbilic with the curvature's sign; frames by measure.
OutlineSettings usual_settings(const Outline& outline);

}  // namespace hariko
