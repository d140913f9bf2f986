#include "ui/editor/placement.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/envelope/solid.hpp"

namespace hariko {

namespace {

/// Angles of a rotation Rz Ry Rx, in degrees: the inverse of `solid_rotation`.
Vector3 turns_of(const Matrix3& rotation) {
  constexpr double degrees = 180 / std::numbers::pi;
  const double across = std::hypot(rotation(0, 0), rotation(1, 0));
  const double about_y = std::atan2(-rotation(2, 0), across);
  // Looking straight up or down x alone turns.
  constexpr double least_across = 1e-9;
  if (!(across > least_across))
    return degrees * Vector3(std::atan2(-rotation(1, 2), rotation(1, 1)), about_y, 0);
  return degrees * Vector3(std::atan2(rotation(2, 1), rotation(2, 2)), about_y,
                           std::atan2(rotation(1, 0), rotation(0, 0)));
}

}  // namespace

Similarity place_for_new(const Editor& editor) {
  Similarity place;
  const bool first = editor.document().objects.empty();
  const WorkingPlane& plane = editor.working_plane;
  if (plane.is_ground()) {
    if (!first) place.translation = editor.camera().target;
    return place;
  }
  place.rotation = Eigen::Quaterniond(plane.frame.axes).normalized();
  place.translation = first ? plane.frame.point : plane.frame.foot(editor.camera().target);
  return place;
}

void add_place_arguments(std::vector<ArgumentSpec>& arguments) {
  arguments.push_back(point_argument("at", translatable("Location"), ArgumentUnit::length, Vector3(0, 0, 0)));
  arguments.push_back(point_argument("turned", translatable("Degrees about X, Y and Z, one after the other"),
                                     ArgumentUnit::degrees, Vector3(0, 0, 0)));
}

Similarity given_place(const Arguments& arguments) {
  Similarity place;
  place.translation = arguments.point("at");
  const Vector3 turned = arguments.point("turned");
  if (turned != Vector3(Vector3::Zero()))
    place.rotation = Eigen::Quaterniond(solid_rotation(turned)).normalized();
  return place;
}

std::vector<WrittenArgument> written_place(const Similarity& place) {
  std::vector<WrittenArgument> out{written("at", place.translation)};
  const Vector3 turned = turns_of(place.rotation.toRotationMatrix());
  if (turned != Vector3(Vector3::Zero())) out.push_back(written("turned", turned));
  return out;
}

}  // namespace hariko
