#pragma once

// Navigation: which presses and turns of the wheel move the view, by the presets of the settings. Pure.

#include <optional>

#include "ui/base/settings.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

enum class NavigationAction { orbit, pan, zoom };

/// Effect of a press that drags on a view in perspective or in parallel projection; nothing when it belongs
/// to other tools.
std::optional<NavigationAction> navigation_action(NavigationPreset preset, const PointerEvent& press,
                                                  bool parallel = false);
/// The same by the settings, in the active view.
std::optional<NavigationAction> navigation_of(const Editor& editor, const PointerEvent& press);

/// What the wheel does. On the trackpad preset two fingers orbit, with Shift they pan and with Ctrl they
/// zoom.
NavigationAction wheel_action(NavigationPreset preset, bool shift, bool control);

/// Which drags do what, for the status line: "Middle drag orbits   Shift pans   Ctrl or wheel zooms".
const char* navigation_hint(NavigationPreset preset, bool parallel = false);

/// The tool that carries it out.
std::unique_ptr<Tool> make_navigation_tool(NavigationAction action);

/// Turns of the wheel, positive away from the user; x for wheels that tilt and for trackpads.
struct WheelEvent {
  Vector2 steps = Vector2::Zero();
  Vector2 pixel = Vector2::Zero();
  bool shift = false, control = false;
};
/// Moves the active view as the settings say. Turns that follow each other are one step to go back from.
void turn_wheel(ToolContext& context, const WheelEvent& wheel, bool new_step);

/// The camera `factor` as far away (< 1 comes closer), with the point that shows under the pixel staying
/// there: the point of the surface, else of the target's plane; the middle of the view unless
/// `zoom_to_cursor`.
Camera zoomed(const ToolContext& context, double factor, const Vector2& pixel);

}  // namespace hariko
