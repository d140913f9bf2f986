#pragma once

// View: one look at the model: a camera with its flights, and the way back to where it was. A value.

#include <optional>
#include <vector>

#include "render/camera.hpp"

namespace hariko {

/// Times are seconds of any steady clock.
class View {
 public:
  View() : View(StandardView::iso, false, true) {}
  View(StandardView from, bool orthographic, bool can_turn);

  /// Plans (top, front, right) do not turn: what would orbit them pans.
  bool turns = true;
  /// Everything is framed as soon as the size of the view's picture is known.
  bool wants_framing = true;

  /// Eased while a change is under way; a change of the projection comes at its orthographic end.
  Camera camera(double now) const;
  /// Camera as it is, or where it flies to.
  const Camera& goal() const { return to_; }
  /// At once; ends a flight.
  void set(const Camera& camera);
  /// In `flight_seconds`, and remembered as a step to go back from.
  void fly_to(const Camera& camera, double now);
  /// The same to a camera whose projection is to stay when the view is turned.
  void go_to(const Camera& camera, double now);
  bool flying(double now) const { return now < flight_start_ + flight_seconds; }
  static constexpr double flight_seconds = 0.18;

  /// Looks along an axis, or from three quarters. A view along an axis becomes orthographic; where it was in
  /// perspective it is so again when it is turned.
  void look_from(StandardView side, double now);
  /// Call before the camera is turned by hand.
  void begin_turning(double now);
  /// Ends a flight, and leaves the parallel projection of a side that was looked at from perspective:
  /// `begin_turning` without `remember`.
  void leave_side(double now);
  /// Between perspective and parallel projection, as the user asks for it.
  void toggle_orthographic();
  /// Between perspective with three and with two vanishing points; from parallel projection to the latter.
  void toggle_two_point();

  /// Notes where the camera is, before a change by hand: something to go back to.
  void remember();
  bool can_go_back() const { return !past_.empty(); }
  bool can_go_forward() const { return !future_.empty(); }
  void go_back(double now);
  void go_forward(double now);

 private:
  void fly(const Camera& camera, double now);
  void step(std::vector<Camera>& from, std::vector<Camera>& to, double now);

  Camera from_, to_;
  double flight_start_ = -1;
  bool returns_to_perspective_ = false;
  std::vector<Camera> past_, future_;
};

/// The side that a camera looks from, if it is one of the six along axes with a level horizon.
std::optional<StandardView> side_of(const Camera& camera);

}  // namespace hariko
