#pragma once

// Settings: what a user chooses once for the program, not for a document. A value; app/ keeps it in a file.

#include <map>
#include <string>

#include "core/base/text/enum_words.hpp"
#include "core/document/document.hpp"
#include "render/environment.hpp"
#include "ui/base/language_files.hpp"

namespace hariko {

enum class ThemeId { dark, light };
template <>
inline constexpr auto enum_words<ThemeId> = all_words<ThemeId>({{ThemeId::dark, "dark"},
                                                                {ThemeId::light, "light"}});
/// Presets of buttons and modifiers that move the view, by the products whose users know them.
enum class NavigationPreset { hariko, blender, maya, rhino, trackpad };
template <>
inline constexpr auto enum_words<NavigationPreset> =
    all_words<NavigationPreset>({{NavigationPreset::hariko, "hariko"},
                                 {NavigationPreset::blender, "blender"},
                                 {NavigationPreset::maya, "maya"},
                                 {NavigationPreset::rhino, "rhino"},
                                 {NavigationPreset::trackpad, "trackpad"}});

/// Kinds of targets that drawings and drags jump to while they snap.
struct SnapSettings {
  bool vertices = true, midpoints = true, centres = false, crossings = false;
  bool perpendicular = false, tangent = false;  ///< from where the gesture began
  bool curves = false, surfaces = false, grid = true;
  bool always = false;  ///< without Ctrl, which then lets go
  friend bool operator==(const SnapSettings&, const SnapSettings&) = default;
};

/// Environment that surfaces reflect in views that show one.
struct EnvironmentSettings {
  EnvironmentKind kind = EnvironmentKind::studio;
  std::string file;     ///< path of the user's own picture; kept while another kind is chosen
  double turn = 0;      ///< degrees about z, anticlockwise from above: 0 .. 360
  double exposure = 0;  ///< stops, up to Environment::most_exposure either way
  friend bool operator==(const EnvironmentSettings&, const EnvironmentSettings&) = default;
};

struct Settings {
  ThemeId theme = ThemeId::dark;
  std::string language = english_id;  ///< id of its catalogue, or `english_id`
  float interface_scale = 1;          ///< on top of the monitor's own, 0.5 .. 3
  bool colour_blind_maps = false;
  Unit unit = Unit::millimetre;  ///< unit of new documents

  NavigationPreset navigation = NavigationPreset::hariko;
  bool trackball = false;  ///< else turntable
  bool zoom_to_cursor = true;
  bool invert_wheel = false;
  bool orbit_selection = false;  ///< about the selection instead of the view's target
  double orbit_speed = 1, zoom_speed = 1;

  /// New vertices of cuts and subdivisions lie on the surface, which keeps its form; else on straight edges.
  bool refine_on_surface = true;
  SnapSettings snaps;
  EnvironmentSettings environment;

  /// Writing takes time too, and no more than 30 seconds of work are ever lost.
  static constexpr double most_autosave_seconds = 25;
  double autosave_seconds = 20;             ///< 1 .. most_autosave_seconds
  std::map<std::string, std::string> keys;  ///< command id to keys that replace the default; "" for none
  float side_width = 312;                   ///< width of the right panel, design pixels
  float objects_height = 0;                 ///< height of the list of objects, design pixels; 0: as rows need

  friend bool operator==(const Settings&, const Settings&) = default;
};

}  // namespace hariko
