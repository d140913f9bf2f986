#include "app/files/mesh_surfaces.hpp"

#include "app/files/export_surfaces.hpp"
#include "core/approximation/decimate.hpp"
#include "core/exchange/triangulate.hpp"
#include "core/modeling/attached.hpp"
#include "core/surface/facets.hpp"

namespace hariko {

namespace {

/// Lengths from the document's space to the object's.
MeshOptions in_object_space(MeshOptions options, double scale) {
  for (std::optional<double>* length : {&options.criteria.distance, &options.criteria.max_edge})
    if (*length) **length /= scale;
  return options;
}

void scale(ErrorField& field, double factor) {
  for (std::vector<float>* values : {&field.points, &field.facets})
    for (float& value : *values) value *= static_cast<float>(factor);
  field.largest *= factor;
  field.mean *= factor;
}

void place(MeshErrorMap& map, const Similarity& transform) {
  for (SurfaceSample& sample : map.samples) sample.position = transform.apply_to_vector(sample.position);
  for (ErrorField* field : {&map.distance, &map.normal_angle, &map.mesh_distance, &map.fold_angle})
    field->place = transform.apply_to_vector(field->place);
  scale(map.distance, transform.scale);
  scale(map.mesh_distance, transform.scale);
}

/// From object space to the document's.
void place(MeshedObject& object, const Similarity& transform) {
  if (transform == Similarity{}) return;
  object.surface_origin = transform.apply(object.surface_origin);
  if (object.errors) place(*object.errors, transform);
  MeshApproximation& result = object.result;
  TriangleMesh& mesh = result.mesh;
  mesh.origin = transform.apply(mesh.origin);
  for (Vector3& position : mesh.positions) position = transform.apply_to_vector(position);
  for (Vector3& normal : mesh.normals) normal = transform.rotation * normal;
  result.distance.largest *= transform.scale;
  result.distance.mean *= transform.scale;
  result.distance.bound *= transform.scale;
  for (float& error : result.distance.facets) error *= static_cast<float>(transform.scale);
  result.longest_edge *= transform.scale;
}

Message named(Message error, const std::string& name) {
  if (!name.empty()) error.text = name + ": " + error.text;
  return error;
}

/// The mesh of one surface, in its own space.
Result<MeshedObject> mesh_of(const Surface& surface, const std::string& name, const MeshRequest& request,
                             const CancelToken& cancel, const Progress& progress) {
  const double meshing = request.errors ? 0.7 : 1;
  auto made = approximate(surface, request.options, cancel, progress.part(0, meshing));
  if (!made.ok()) return named(made.error(), name);
  MeshedObject out{name, std::move(made).value(), {}, surface.origin()};
  if (!request.errors) return out;
  auto map =
      mesh_error_map(surface, out.result.mesh, out.result.parts, {}, cancel, progress.part(meshing, 1));
  if (!map.ok()) return named(map.error(), name);
  out.errors = std::move(map).value();
  return out;
}

/// A reference mesh with fewer facets, in its own space; its facets are the surface.
Result<MeshedObject> decimated(const MeshSource& source, const std::string& name, const MeshRequest& request,
                               const CancelToken& cancel, const Progress& progress) {
  FaceTriangles cut = triangulate(*source.mesh);
  TriangleMesh dense{source.origin, source.mesh->positions, std::move(cut.triangles), {}, {}};
  auto made = decimate(dense, request.options, cancel, progress.part(0, request.errors ? 0.7 : 1));
  if (!made.ok()) return named(made.error(), name);
  MeshedObject out{name, std::move(made).value(), {}, source.origin};
  if (!request.errors) return out;
  std::vector<Element> sources;
  for (const Index face : cut.faces) sources.push_back({Element::Kind::face, face});
  const Surface facets = facet_surface(source.origin, dense.positions, std::move(dense.triangles), sources);
  auto map = mesh_error_map(facets, out.result.mesh, {}, {}, cancel, progress.part(0.7, 1));
  if (!map.ok()) return named(map.error(), name);
  out.errors = std::move(map).value();
  return out;
}

}  // namespace

Result<std::vector<MeshedObject>> mesh_surfaces(const Document& document, const MeshRequest& request,
                                                const CancelToken& cancel, const Progress& progress) {
  std::vector<MeshedObject> out;
  const auto count = static_cast<double>(document.objects.size());
  double number = 0;
  for (const auto& object : document.objects) {
    const Progress part = progress.part(number / count, (number + 1) / count);
    ++number;
    const MeshSource* reference = request.meshes ? object->mesh() : nullptr;
    if (!object->visible || !(object->has_surface() || reference)) continue;
    const MeshRequest own{in_object_space(request.options, object->transform.scale), request.errors};
    if (reference) {
      auto made = decimated(*reference, object->name, own, cancel, part);
      if (!made.ok()) return made.error();
      place(made.value(), object->transform);
      out.push_back(std::move(made).value());
      out.back().colour = colour_of(*object);
      continue;
    }
    const auto built = object_surface(document, *object, cancel);
    if (cancel.cancelled()) return make_error(e_cancelled, "The meshing was cancelled.");
    if (!built.ok()) return named(built.error(), object->name);
    auto made = mesh_of(built->surface, object->name, own, cancel, part);
    if (!made.ok()) return made.error();
    place(made.value(), object->transform);
    out.push_back(std::move(made).value());
    out.back().colour = colour_of(*object);
  }
  if (out.empty())
    return make_error(e_no_surface, "There is nothing to approximate.", "Show an object or import one.");
  return out;
}

}  // namespace hariko
