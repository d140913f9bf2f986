#include "render/scene_picture.hpp"

#include <cmath>

namespace hariko {

bool ScenePicture::seen_by(const Camera& camera) const {
  constexpr double tolerance = 1e-5;  // radians
  return !look.only_from || camera.orientation.angularDistance(facing(*look.only_from)) < tolerance;
}

std::array<Vector3, 4> ScenePicture::corners() const {
  const auto corner = [&](double x, double y) -> Vector3 {
    return transform.topLeftCorner<3, 3>() * Vector3(x * half.x(), y * half.y(), 0) + middle();
  };
  return {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
}

std::optional<double> ScenePicture::hit(const Ray& ray) const {
  const Vector3 right = transform.col(0).head<3>(), up = transform.col(1).head<3>();
  const Vector3 normal = right.cross(up);
  const double towards = normal.dot(ray.direction);
  if (std::abs(towards) < 1e-9 * normal.norm()) return std::nullopt;  // seen edge-on
  const double t = normal.dot(middle() - ray.origin) / towards;
  const Vector3 from_middle = ray.at(t) - middle();
  const double x = from_middle.dot(right) / right.squaredNorm(), y = from_middle.dot(up) / up.squaredNorm();
  if (!(t > 0) || std::abs(x) > half.x() || std::abs(y) > half.y()) return std::nullopt;
  return t;
}

}  // namespace hariko
