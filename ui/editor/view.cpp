#include "ui/editor/view.hpp"

#include <algorithm>
#include <array>

namespace hariko {

View::View(StandardView from, bool orthographic, bool can_turn) : turns(can_turn) {
  to_ = Camera::standard(from);
  to_.orthographic = orthographic;
}

Camera View::camera(double now) const {
  if (!flying(now)) return to_;
  const double x = std::clamp((now - flight_start_) / flight_seconds, 0.0, 1.0);
  Camera between = Camera::mix(from_, to_, 1 - (1 - x) * (1 - x) * (1 - x));
  between.orthographic = from_.orthographic && to_.orthographic;
  return between;
}

void View::set(const Camera& camera) {
  to_ = camera;
  flight_start_ = -1;
}

void View::fly(const Camera& camera, double now) {
  from_ = this->camera(now);
  to_ = camera;
  flight_start_ = now;
}

void View::fly_to(const Camera& camera, double now) {
  remember();
  fly(camera, now);
}

void View::go_to(const Camera& camera, double now) {
  fly_to(camera, now);
  returns_to_perspective_ = false;
}

void View::look_from(StandardView side, double now) {
  Camera camera = to_;
  camera.orientation = Camera::standard(side).orientation;
  if (side == StandardView::iso) {
    if (returns_to_perspective_) camera.orthographic = false;
    returns_to_perspective_ = false;
  } else if (!camera.orthographic) {
    camera.orthographic = true;
    returns_to_perspective_ = true;
  }
  fly_to(camera, now);
}

void View::begin_turning(double now) {
  remember();
  leave_side(now);
}

void View::leave_side(double now) {
  Camera camera = this->camera(now);
  if (returns_to_perspective_) camera.orthographic = false;
  returns_to_perspective_ = false;
  set(camera);
}

void View::toggle_orthographic() {
  remember();
  to_.orthographic = !to_.orthographic;
  returns_to_perspective_ = false;
}

void View::toggle_two_point() {
  remember();
  to_.two_point = to_.orthographic || !to_.two_point;
  to_.orthographic = false;
  returns_to_perspective_ = false;
}

void View::remember() {
  constexpr std::size_t most = 100;
  if (!past_.empty() && past_.back() == to_) return;
  past_.push_back(to_);
  if (past_.size() > most) past_.erase(past_.begin());
  future_.clear();
}

void View::step(std::vector<Camera>& from, std::vector<Camera>& to, double now) {
  while (!from.empty() && from.back() == to_) from.pop_back();
  if (from.empty()) return;
  to.push_back(to_);
  const Camera camera = from.back();
  from.pop_back();
  returns_to_perspective_ = false;
  fly(camera, now);
}

void View::go_back(double now) {
  step(past_, future_, now);
}

void View::go_forward(double now) {
  step(future_, past_, now);
}

std::optional<StandardView> side_of(const Camera& camera) {
  constexpr double tolerance = 1e-5;  // radians
  constexpr std::array sides{StandardView::front, StandardView::back, StandardView::left,
                             StandardView::right, StandardView::top,  StandardView::bottom};
  for (const StandardView side : sides)
    if (camera.orientation.angularDistance(Camera::standard(side).orientation) < tolerance) return side;
  return std::nullopt;
}

}  // namespace hariko
