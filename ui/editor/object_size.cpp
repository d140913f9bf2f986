#include "ui/editor/object_size.hpp"

#include <cmath>

#include "core/document/object_box.hpp"
#include "core/modeling/objects/transformation.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "ui/editor/object_kind.hpp"

namespace hariko {

namespace {

constexpr int most_rounds = 8;
constexpr double good_enough = 1e-6;

Box3 box_of(const DisplayMesh& mesh) {
  Box3 box = mesh.box();
  if (!box.isEmpty()) box.translate(mesh.origin());
  return box;
}

Result<Document> stretched(const Document& document, const Object& object, const Vector3& centre,
                           const Vector3& factors) {
  Transformation stretch;
  stretch.frame = object.transform.rotation.toRotationMatrix();
  stretch.factors = factors;
  return transform_object(document, object.id, stretch, object.transform.apply(centre));
}

/// Length of the surface along an axis.
Result<double> length_along(const Document& document, ObjectId id, int axis, int density) {
  const Object& object = *document.find(id);
  const auto made = object_surface(document, object);
  if (!made) return made.error();
  DisplayOptions options;
  options.density = density;
  const auto mesh = DisplayMesh::build(made->surface, options);
  return mesh->box().sizes()[axis] * object.transform.scale;
}

}  // namespace

Box3 own_box(const Editor& editor, const Object& object) {
  const SurfaceView* view = editor.view_of(object.id);
  if (view && view->mesh && !view->mesh->box().isEmpty()) return box_of(*view->mesh);
  Object placed_nowhere = object;
  placed_nowhere.transform = {};
  return box_at_own_place(placed_nowhere);
}

Box3 shown_box(const Editor& editor, const Object& object) {
  const SurfaceView* view = editor.view_of(object.id);
  if (!view || !view->mesh || view->mesh->box().isEmpty()) return world_box(object);
  const DisplayMesh& mesh = *view->mesh;
  return box_of_places(object, [&](const Similarity& place) {
    Box3 box;
    for (const auto& chunk : mesh.chunks())
      for (const DisplayVertex& vertex : chunk->vertices) {
        const Vector3 local(double(vertex.position[0]), double(vertex.position[1]),
                            double(vertex.position[2]));
        box.extend(place.apply(mesh.origin() + local));
      }
    return box;
  });
}

Box3 box_of_visible(const Document& document) {
  Box3 box;
  for (const auto& object : document.objects)
    if (object->visible) box.extend(world_box(*object));
  return box;
}

bool stretches(const Object& object) {
  return object_kind(object).stretching() != Stretching::none;
}

int shown_density(const Editor& editor, const Object& object) {
  const SurfaceView* view = editor.view_of(object.id);
  return view && view->mesh ? view->mesh->options().density : object.display.density;
}

Result<Document> with_size(const Document& document, ObjectId id, const Box3& box, int density, int axis,
                           double size, bool proportional) {
  const Object* object = document.find(id);
  const double now = object && !box.isEmpty() ? box.sizes()[axis] * object->transform.scale : 0;
  if (!(size > 0) || !std::isfinite(size) || !(now > 0))
    return make_error(e_size, "The object cannot have this size.",
                      "Type a size above zero, along an axis in which the object is not flat.");
  double factor = size / now;
  if (proportional || !stretches(*object))
    return stretched(document, *object, box.center(), Vector3::Constant(factor));
  Result<Document> result = document;
  // Secants of the logarithms: a surface grows by a power of the factor that its polyhedron alone decides.
  double power = 1, last_factor = 1, last_length = now;
  for (int round = 0; round < most_rounds; ++round) {
    Vector3 factors = Vector3::Ones();
    factors[axis] = factor;
    result = stretched(document, *object, box.center(), factors);
    if (!result || object_kind(*object).stretching() == Stretching::affine) return result;
    const auto length = length_along(*result, id, axis, density);
    if (!length) return length.error();
    if (std::abs(*length - size) <= good_enough * size) break;
    const double step = std::log(factor / last_factor), answer = std::log(*length / last_length);
    if (std::abs(step) > 1e-9 && answer / step > 0.1) power = answer / step;
    last_factor = factor;
    last_length = *length;
    factor *= std::pow(size / *length, 1 / power);
  }
  return result;
}

}  // namespace hariko
