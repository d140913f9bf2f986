#include "ui/view/navigation.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

constexpr double wheel_step = 0.85;   ///< factor of the distance for one step
constexpr double wheel_orbit = 0.06;  ///< radians a step
constexpr double wheel_pan = 24;      ///< design pixels a step
using Action = std::optional<NavigationAction>;

/// The modifiers that most presets share: none orbits, Shift pans, Control zooms.
Action by_modifiers(const PointerEvent& press) {
  if (press.shift && press.control) return {};
  if (press.shift) return NavigationAction::pan;
  if (press.control) return NavigationAction::zoom;
  return NavigationAction::orbit;
}

}  // namespace

std::optional<NavigationAction> navigation_action(NavigationPreset preset, const PointerEvent& press,
                                                  bool parallel) {
  const bool left = press.button == PointerButton::left, middle = press.button == PointerButton::middle;
  const bool right = press.button == PointerButton::right;
  switch (preset) {
    case NavigationPreset::hariko:
      // Alt with the left button is for machines without a middle one.
      if (left && !press.alt) return {};
      return by_modifiers(press);
    case NavigationPreset::blender:
      return middle && !press.alt ? by_modifiers(press) : Action();
    case NavigationPreset::maya:
      if (!press.alt || press.control || press.shift) return {};
      // Orthographic cameras are locked against tumbling there.
      if (left && parallel) return NavigationAction::pan;
      return left ? NavigationAction::orbit : middle ? NavigationAction::pan : NavigationAction::zoom;
    case NavigationPreset::rhino:
      if (!right || press.alt) return {};
      if (!parallel) return by_modifiers(press);
      if (press.shift && press.control) return NavigationAction::orbit;
      return press.control ? NavigationAction::zoom : NavigationAction::pan;
    case NavigationPreset::trackpad:
      if (left) return press.alt ? by_modifiers(press) : Action();
      return middle ? by_modifiers(press) : Action();
  }
  return {};
}

NavigationAction wheel_action(NavigationPreset preset, bool shift, bool control) {
  if (preset == NavigationPreset::trackpad)
    return control ? NavigationAction::zoom : shift ? NavigationAction::pan : NavigationAction::orbit;
  return shift ? NavigationAction::pan : NavigationAction::zoom;
}

std::optional<NavigationAction> navigation_of(const Editor& editor, const PointerEvent& press) {
  return navigation_action(editor.settings.navigation, press, editor.camera().orthographic);
}

const char* navigation_hint(NavigationPreset preset, bool parallel) {
  switch (preset) {
    case NavigationPreset::hariko:
      return translatable("Middle or right drag orbits   Shift pans   wheel zooms");
    case NavigationPreset::blender:
      return translatable("Middle drag orbits   Shift pans   wheel zooms");
    case NavigationPreset::maya:
      if (parallel) return translatable("Alt+left or Alt+middle drag pans   wheel zooms");
      return translatable("Alt+left drag orbits   Alt+middle pans   wheel zooms");
    case NavigationPreset::rhino:
      if (parallel) return translatable("Right drag pans   Ctrl+Shift orbits   wheel zooms");
      return translatable("Right drag orbits   Shift pans   wheel zooms");
    case NavigationPreset::trackpad:
      return translatable("Two fingers or Alt+drag orbit   Shift pans   Ctrl zooms");
  }
  return "";
}

std::unique_ptr<Tool> tool_for(const Editor& editor, const PointerEvent& press) {
  if (auto action = navigation_of(editor, press)) {
    // Plans keep their direction.
    if (*action == NavigationAction::orbit && !editor.layout.active_view().turns)
      action = NavigationAction::pan;
    return make_navigation_tool(*action);
  }
  return press.button == PointerButton::left ? make_select_tool() : nullptr;
}

Camera zoomed(const ToolContext& context, double factor, const Vector2& pixel) {
  const Camera camera = context.editor.camera();
  Camera out = camera;
  out.distance = camera.zoom(factor, pixel, context.editor.viewport).distance;  // within its limits
  if (!context.editor.settings.zoom_to_cursor) return out;
  const Projector projector = context.projector();
  const auto hit = pick_surface(context.scene.scene(), projector.ray(pixel));
  const Vector3 pivot = hit ? hit->point : projector.on_facing_plane(pixel, camera.target);
  out.target = pivot + out.distance / camera.distance * (camera.target - pivot);
  return out;
}

void turn_wheel(ToolContext& context, const WheelEvent& wheel, bool new_step) {
  Editor& editor = context.editor;
  const Settings& settings = editor.settings;
  View& view = editor.layout.active_view();
  NavigationAction action = wheel_action(settings.navigation, wheel.shift, wheel.control);
  if (action == NavigationAction::orbit && !view.turns) action = NavigationAction::pan;
  const Vector2 steps = settings.invert_wheel ? Vector2(-wheel.steps) : wheel.steps;
  if (action == NavigationAction::orbit)
    view.begin_turning(editor.now);
  else if (new_step)
    view.remember();
  const Camera camera = editor.camera();
  switch (action) {
    case NavigationAction::zoom:
      return view.set(zoomed(context, std::pow(wheel_step, steps.y() * settings.zoom_speed), wheel.pixel));
    case NavigationAction::pan: {
      // A wheel that cannot tilt pans upwards and downwards.
      const Vector2 by = wheel_pan * editor.pixel_scale * steps;
      return view.set(camera.pan(by.x(), by.y(), editor.viewport));
    }
    case NavigationAction::orbit: {
      const Vector2 by = wheel_orbit * settings.orbit_speed * steps;
      return view.set(settings.trackball ? camera.trackball(by.x(), by.y(), camera.target)
                                         : camera.orbit(by.x(), by.y()));
    }
  }
}

namespace {

constexpr double least_cap_distance = 1e-9, greatest_cap_distance = 1e12;

Vector3 cap_part(const Vector3& deflection) {
  return deflection.allFinite() ? Vector3(deflection.cwiseMax(-1.0).cwiseMin(1.0)) : Vector3(Vector3::Zero());
}

bool cap_turns(const CapMotion& motion) {
  return cap_part(motion.turn).cwiseAbs().maxCoeff() >= least_cap_turn;
}

Camera turned_by_cap(const Camera& camera, const Vector3& angles, bool rolls) {
  if (!rolls) return camera.orbit(angles.y(), angles.x());
  const double angle = angles.norm();
  if (!(angle > 0)) return camera;
  Camera out = camera;
  const Vector3 axis = angles / angle;
  out.orientation = (camera.orientation * Eigen::Quaterniond(Eigen::AngleAxisd(-angle, axis))).normalized();
  return out;
}

}  // namespace

Camera moved_by_cap(const Camera& camera, const CapMotion& motion, const CapEffect& effect) {
  const double seconds =
      std::isfinite(motion.seconds) ? std::clamp(motion.seconds, 0.0, longest_cap_motion) : 0;
  if (seconds == 0) return camera;
  Camera out = camera;
  if (effect.turns && cap_turns(motion))
    out = turned_by_cap(out, cap_turn * effect.turn_speed * seconds * cap_part(motion.turn), effect.rolls);
  const Vector3 push = effect.push_speed * seconds * cap_part(motion.push);
  out.target -= cap_pan * out.view_height() * (push.x() * out.right() + push.y() * out.picture_up());
  out.distance =
      std::clamp(out.distance * std::exp(-cap_zoom * push.z()), least_cap_distance, greatest_cap_distance);
  return out;
}

void CapGesture::move(Editor& editor, const CapMotion& motion) {
  if (!editor.has_document) return;
  View& view = editor.layout.active_view();
  if (last_ < 0 || editor.now > last_ + rest_seconds || editor.now < last_) view.remember();
  last_ = editor.now;
  if (view.turns && cap_turns(motion))
    view.leave_side(editor.now);
  else
    view.set(view.camera(editor.now));  // ends a flight where it is
  const Settings& settings = editor.settings;
  view.set(moved_by_cap(view.goal(), motion,
                        {settings.orbit_speed, settings.zoom_speed, settings.trackball, view.turns}));
}

}  // namespace hariko
