#pragma once

// Members of the settings with their names and ranges: described once, for the file that keeps them and for
// the preferences that show them.

#include "ui/base/settings.hpp"

namespace hariko {

/// Visits the members of one settings, or of several side by side: `choice(name, values...)` of enumerations
/// with words, `flag(name, values...)`, `number(name, least, most, values...)`, `text(name, values...)` and
/// `texts(name, values...)`.
template <class Visitor, class... AnySettings>
void visit_settings(Visitor& visitor, AnySettings&... s) {
  visitor.choice("theme", s.theme...);
  visitor.number("interface_scale", 0.5, 3, s.interface_scale...);
  visitor.text("language", s.language...);
  visitor.flag("colour_blind_maps", s.colour_blind_maps...);
  visitor.choice("unit", s.unit...);
  visitor.choice("navigation", s.navigation...);
  visitor.flag("trackball", s.trackball...);
  visitor.flag("zoom_to_cursor", s.zoom_to_cursor...);
  visitor.flag("invert_wheel", s.invert_wheel...);
  visitor.flag("orbit_selection", s.orbit_selection...);
  visitor.flag("refine_on_surface", s.refine_on_surface...);
  visitor.flag("snap_vertices", s.snaps.vertices...);
  visitor.flag("snap_midpoints", s.snaps.midpoints...);
  visitor.flag("snap_centres", s.snaps.centres...);
  visitor.flag("snap_intersections", s.snaps.crossings...);
  visitor.flag("snap_perpendicular", s.snaps.perpendicular...);
  visitor.flag("snap_tangent", s.snaps.tangent...);
  visitor.flag("snap_curves", s.snaps.curves...);
  visitor.flag("snap_surfaces", s.snaps.surfaces...);
  visitor.flag("snap_grid", s.snaps.grid...);
  visitor.flag("snap_always", s.snaps.always...);
  visitor.choice("environment", s.environment.kind...);
  visitor.text("environment_file", s.environment.file...);
  visitor.number("environment_turn", 0, 360, s.environment.turn...);
  visitor.number("environment_exposure", -Environment::most_exposure, Environment::most_exposure,
                 s.environment.exposure...);
  visitor.number("orbit_speed", 0.05, 20, s.orbit_speed...);
  visitor.number("zoom_speed", 0.05, 20, s.zoom_speed...);
  visitor.number("autosave_seconds", 1, Settings::most_autosave_seconds, s.autosave_seconds...);
  visitor.texts("keys", s.keys...);
  visitor.number("side_width", 100, 2000, s.side_width...);
  visitor.number("objects_height", 0, 4000, s.objects_height...);
}

}  // namespace hariko
