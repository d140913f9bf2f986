#include "render/scene.hpp"

#include "core/base/assert.hpp"

namespace hariko {

namespace {

void extend(Box3& box, const Box3& part, const Vector3& origin, const Matrix4& transform) {
  if (part.isEmpty()) return;
  for (int i = 0; i < 8; ++i) {
    const Vector3 corner = origin + part.corner(static_cast<Box3::CornerType>(i));
    box.extend(Vector3(transform.topLeftCorner<3, 3>() * corner + transform.topRightCorner<3, 1>()));
  }
}

}  // namespace

Matrix4 matrix_of(const Similarity& transform) {
  Matrix4 m = Matrix4::Identity();
  m.topLeftCorner<3, 3>() = transform.scale * transform.rotation.toRotationMatrix();
  m.topRightCorner<3, 1>() = transform.translation;
  return m;
}

Box3 SceneObject::world_box() const {
  Box3 box;
  if (mesh && show_surface) extend(box, mesh->box(), mesh->origin(), transform);
  if (polyhedron && (show_polyhedron || box.isEmpty()))
    extend(box, polyhedron->box, polyhedron->origin, transform);
  return box;
}

void SceneObject::add_outline(std::vector<Vector3>& points, std::size_t limit) const {
  const auto add = [&](const Vector3& local) {
    points.push_back(transform.topLeftCorner<3, 3>() * local + transform.topRightCorner<3, 1>());
  };
  if (mesh && show_surface) {
    const std::size_t stride = mesh->vertex_count() / limit + 1;
    for (std::size_t i = 0; i < mesh->vertex_count(); i += stride) {
      const auto& p = mesh->vertex(i).position;
      add(mesh->origin() + Vector3(double(p[0]), double(p[1]), double(p[2])));
    }
  }
  if (polyhedron && (show_polyhedron || !mesh || !show_surface))
    for (std::size_t v = 0; v < polyhedron->positions.size(); v += polyhedron->positions.size() / limit + 1)
      add(polyhedron->origin + polyhedron->position(static_cast<Index>(v)));
}

Camera framed(const Camera& camera, const Scene& scene, PixelSize size, int left) {
  HARIKO_ASSERT(left >= 0 && left < size.width, "a margin leaves some width");
  std::vector<Vector3> points;
  for (const SceneObject& object : scene.objects) object.add_outline(points);
  return camera.frame(points, {size.width - left, size.height}).pan(0.5 * left, 0, size);
}

Box3 Scene::world_box() const {
  Box3 box;
  for (const SceneObject& object : objects) box.extend(object.world_box());
  return box;
}

}  // namespace hariko
