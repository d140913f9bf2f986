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
  /// `mode` stands in for the mode minkowski, which a file or command line asked for; not saved.
  bool mode_replaced = false;

  static constexpr double smallest_radius = 0.01, largest_radius = 100;
  static constexpr Index point_limit = 20000;
  /// Compares all but `mode_replaced`, so that a saved document equals the one that is read back.
  friend bool operator==(const OutlineSettings& a, const OutlineSettings& b) {
    return a.mode == b.mode && a.sign == b.sign && a.radius == b.radius && a.most_points == b.most_points &&
           a.gap == b.gap && a.curvature_continuous == b.curvature_continuous && a.frames == b.frames;
  }
};

/// Options of `control_points` for these settings.
GaussOptions gauss_options(const OutlineSettings& settings);

/// Settings of new outlines: frames by measure, otherwise the defaults.
OutlineSettings new_outline_settings();

/// Default settings for a new outline: mode curvature where all of the curvature is given and positive, else
/// umbilic with the curvature's sign; frames by measure.
OutlineSettings usual_settings(const Outline& outline);

}  // namespace hariko
