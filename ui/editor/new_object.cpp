#include "ui/editor/new_object.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/envelope/solid.hpp"
#include "ui/editor/object_size.hpp"

namespace hariko {

namespace {

/// 1, 2 or 5 times a power of ten.
double nice_length(double length) {
  const double power = std::pow(10, std::floor(std::log10(length)));
  const double lead = length / power;
  return (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * power;
}

}  // namespace

void begin_document(Editor& editor) {
  if (editor.has_document) return;
  Document document;
  document.unit = editor.settings.unit;
  editor.open(std::move(document), std::nullopt);
}

double new_object_radius(const Editor& editor) {
  const Box3 box = box_of_visible(editor.document());
  const double extent = box.isEmpty() ? 0 : box.sizes().maxCoeff();
  if (extent > 0 && std::isfinite(extent)) return nice_length(std::clamp(extent / 4, 1e-6, 1e6));
  return first_object_radius(editor.document().unit);
}

void bring_into_sight(Editor& editor, ObjectId object) {
  bring_into_sight(editor, std::span(&object, 1));
}

void bring_into_sight(Editor& editor, std::span<const ObjectId> objects) {
  const Projector projector(editor.camera(), editor.viewport);
  const auto inside = [&](const Vector3& corner) {
    const auto at = projector.project(corner);
    return at && at->x() >= 0 && at->y() >= 0 && at->x() <= editor.viewport.width &&
           at->y() <= editor.viewport.height;
  };
  for (const ObjectId object : objects) {
    const Object* found = editor.document().find(object);
    const Box3 box = found ? world_box(*found) : Box3();
    for (int i = 0; i < 8 && !box.isEmpty(); ++i)
      if (!inside(box.corner(static_cast<Box3::CornerType>(i)))) return editor.frame_all();
  }
}

double first_object_radius(Unit unit) {
  constexpr double radius = 50;  // mm
  return nice_length(radius / millimetres_per(unit));
}

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
