#pragma once

// CapMotion: the push and turn of a 3D mouse's cap, and what becomes of the camera. The model follows the
// hand, as if the cap held it (object mode).

#include "ui/editor/editor.hpp"

namespace hariko {

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
