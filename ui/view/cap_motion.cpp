#include "ui/view/cap_motion.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

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
