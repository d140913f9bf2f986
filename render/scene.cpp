#include "render/scene.hpp"

#include <algorithm>
#include <cmath>

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

namespace {

Vector3 vertex_place(const SceneObject& object, Index vertex) {
  return object.to_world(object.polyhedron->origin, object.polyhedron->positions[vertex]);
}

}  // namespace

std::optional<bool> runs_forward(const SceneObject& object, Index edge, const EdgeCurves::Run& run) {
  const auto segments = object.edge_curves->segments(run);
  const Vector3 begin = object.mesh_vertex(segments.front().vertices[1]);
  const Vector3 end = object.mesh_vertex(segments.back().vertices[2]);
  const Vector3 first = vertex_place(object, object.polyhedron->edges[edge][0]);
  const Vector3 last = vertex_place(object, object.polyhedron->edges[edge][1]);
  const double close = 1e-3 * ((last - first).norm() + (end - begin).norm());
  if ((begin - first).norm() <= close && (end - last).norm() <= close) return true;
  if ((begin - last).norm() <= close && (end - first).norm() <= close) return false;
  return std::nullopt;
}

std::vector<Vector3> shown_curve(const SceneObject& object, Index edge) {
  std::vector<Vector3> out;
  if (!object.curves_pickable()) return out;
  for (const EdgeCurves::Run& run : object.edge_curves->of(edge)) {
    const auto forward = runs_forward(object, edge, run);
    if (!forward) continue;
    const auto segments = object.edge_curves->segments(run);
    out.push_back(object.mesh_vertex(segments.front().vertices[1]));
    for (const CurveSegment& segment : segments) out.push_back(object.mesh_vertex(segment.vertices[2]));
    if (!*forward) std::reverse(out.begin(), out.end());
    break;
  }
  return out;
}

}  // namespace hariko
