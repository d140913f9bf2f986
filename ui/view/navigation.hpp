#pragma once

// Navigation: which presses and turns of the wheel move the view, by the presets of the settings. Pure.

#include <optional>

#include "ui/base/settings.hpp"
#include "ui/editor/editor.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

enum class NavigationAction { orbit, pan, zoom };

/// Effect of a press that drags on a view in perspective or in parallel projection; nothing when it belongs
/// to other tools.
std::optional<NavigationAction> navigation_action(NavigationPreset preset, const PointerEvent& press,
                                                  bool parallel = false);
/// The same by the settings, in the active view.
std::optional<NavigationAction> navigation_of(const Editor& editor, const PointerEvent& press);

/// Action of the wheel. On the trackpad preset two fingers orbit, with Shift they pan and with Ctrl they
/// zoom.
NavigationAction wheel_action(NavigationPreset preset, bool shift, bool control);

/// Hint of drags, for the status line: "Middle drag orbits   Shift pans   Ctrl or wheel zooms".
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

/// Deflection of the cap for some time. Components are in the camera's axes (x right, y up, z towards the
/// viewer), 1 at full deflection.
struct CapMotion {
  Vector3 push = Vector3::Zero();
  Vector3 turn = Vector3::Zero();  ///< about these axes, right-handed
  double seconds = 0;              ///< 0 or more
};

/// Effect of the cap on a view.
struct CapEffect {
  double turn_speed = 1, push_speed = 1;  ///< factors of the usual speeds
  bool rolls = false;                     ///< turns freely; else the horizon stays level
  bool turns = true;                      ///< the view may turn at all
};

/// Radians a second, heights of the view a second, and natural logarithm of the distance's factor a second,
/// all at full deflection.
inline constexpr double cap_turn = 2, cap_pan = 1, cap_zoom = 1.5;
/// Turns smaller than this share of the full deflection are a hand that pushes.
inline constexpr double least_cap_turn = 0.02;
/// Longest time that one motion counts for, in seconds: the first one comes after a rest.
inline constexpr double longest_cap_motion = 0.05;

/// Camera after a motion. Pushes move the model along the picture and nearer by or farther away; turns go
/// about the target. What is not finite counts as no motion. Pure.
Camera moved_by_cap(const Camera& camera, const CapMotion& motion, const CapEffect& effect);

/// Motions in a row, which are one step to go back from.
class CapGesture {
 public:
  /// Moves the active view as the settings say.
  void move(Editor& editor, const CapMotion& motion);

 private:
  double last_ = -1;
  static constexpr double rest_seconds = 0.5;
};

}  // namespace hariko
