#include "core/skinning/sections/section_frame.hpp"

#include <Eigen/Geometry>

namespace hariko {

Matrix3 upright_axes(const Vector3& direction) {
  constexpr double least_up = 0.1;
  const Vector3 back = -direction;
  const auto across = [&](const Vector3& axis) { return Vector3(axis - axis.dot(back) * back); };
  Vector3 up = across(Vector3::UnitZ());
  // In views from above, y is up.
  if (up.norm() < least_up) up = across(Vector3::UnitY());
  up.normalize();
  Matrix3 axes;
  axes << up.cross(back), up, back;
  return axes;
}

Matrix3 carried_axes(const Matrix3& axes, const Vector3& direction) {
  const Vector3 back = -direction;
  return Eigen::Quaterniond::FromTwoVectors(Vector3(axes.col(2)), back).toRotationMatrix() * axes;
}

Vector3 section_normal(const SkinSection& section) {
  Vector3 centre = Vector3::Zero(), best = Vector3::Zero();
  for (const SectionPoint& p : section.points) centre += p.position / double(section.size());
  double square = 0;
  for (const SectionPoint& p : section.points) square += (p.position - centre).squaredNorm();
  for (int i = 0; i < section.size(); ++i)
    for (int j = 0; j < i; ++j) {
      const Vector3 n = (section.points[std::size_t(i)].position - centre)
                            .cross(section.points[std::size_t(j)].position - centre);
      if (n.squaredNorm() > best.squaredNorm()) best = n;
    }
  return best.norm() > 1e-6 * square ? Vector3(best.normalized()) : Vector3(Vector3::Zero());
}

Vector3 section_direction_of_view(const Skin& skin, const SkinSection& section) {
  const Vector3 along = evaluate(skin.path, section.v).first;
  const Vector3 path = along.norm() > 0 ? Vector3(along.normalized()) : Vector3(Vector3::UnitX());
  Vector3 normal = section_normal(section);
  if (normal.isZero(0)) {
    // A line has a whole plane of normals: takes the one nearest to the path's direction.
    const Vector3 line = section.points.back().position - section.points.front().position;
    if (line.norm() > 0) normal = path - path.dot(line) / line.squaredNorm() * line;
    return normal.norm() > 1e-6 ? Vector3(normal.normalized()) : path;
  }
  return normal.dot(path) < 0 ? Vector3(-normal) : normal;
}

}  // namespace hariko
