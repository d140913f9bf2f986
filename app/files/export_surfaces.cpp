#include "app/files/export_surfaces.hpp"

#include <string>

#include "core/exchange/mesh_file.hpp"
#include "core/modeling/attached.hpp"

namespace hariko {

namespace {

constexpr std::size_t max_triangles = 20'000'000;

/// From object space to the document's.
void place(TriangleMesh& mesh, const Similarity& transform) {
  if (transform == Similarity{}) return;
  mesh.origin = transform.apply(mesh.origin);
  for (Vector3& position : mesh.positions) position = transform.apply_to_vector(position);
  for (Vector3& normal : mesh.normals) normal = transform.rotation * normal;
}

}  // namespace

WriteOptions write_options(const Document& document, const FileChoices& choices, const CancelToken& cancel) {
  const auto metres = [](Unit unit) { return millimetres_per(unit) / 1000; };
  WriteOptions out{cancel, metres(document.unit)};
  if (choices.unit) out.metres_per_file_unit = metres(*choices.unit);
  out.factor = choices.scale;
  out.up = choices.y_up ? UpAxis::y : UpAxis::z;
  out.encoding = choices.ascii ? MeshEncoding::ascii : MeshEncoding::binary;
  return out;
}

MeshColour colour_of(const Object& object) {
  const Colour& colour = object.display.colour;
  return {colour.red, colour.green, colour.blue};
}

Result<std::vector<NamedMesh>> density_meshes(const Document& document, int density,
                                              const CancelToken& cancel, const Progress& progress) {
  std::vector<NamedMesh> meshes;
  std::size_t triangles = 0;
  const auto count = static_cast<double>(document.objects.size());
  const auto cancelled = [] { return make_error(e_cancelled, "The export was cancelled."); };
  double number = 0;
  for (const auto& object : document.objects) {
    const Progress part = progress.part(number / count, (number + 1) / count);
    ++number;
    part.report(0);
    if (!object->visible || !object->has_surface()) continue;
    const auto named_error = [&](Message error) {
      error.text = object->name + ": " + error.text;
      return error;
    };
    const auto built = object_surface(document, *object, cancel);
    if (cancel.cancelled()) return cancelled();
    if (!built.ok()) return named_error(built.error());
    part.report(0.6);
    const auto n = static_cast<std::size_t>(density);
    triangles += built->surface.patch_count() * n * n;
    if (triangles > max_triangles)
      return make_error(e_too_many_triangles,
                        "The export would have more than " + std::to_string(max_triangles) + " triangles.",
                        "Choose a smaller density.");
    meshes.push_back({object->name, tessellate(built->surface, density, cancel), colour_of(*object)});
    place(meshes.back().mesh, object->transform);
  }
  if (cancel.cancelled()) return cancelled();
  if (meshes.empty())
    return make_error(e_no_surface, "There is no visible surface to export.",
                      "Show an object or import one.");
  return meshes;
}

Result<Done> export_surfaces(const Document& document, const std::filesystem::path& path, int density,
                             const FileChoices& choices, const CancelToken& cancel,
                             const Progress& progress) {
  // Writing takes about a fourth of the time, solving more than cutting into triangles.
  constexpr double writing = 0.75;
  const auto meshes = density_meshes(document, density, cancel, progress.part(0, writing));
  if (!meshes.ok()) return meshes.error();
  std::vector<NamedTriangles> named;
  for (const NamedMesh& mesh : *meshes) named.push_back({mesh.name, &mesh.mesh, mesh.colour});
  progress.report(writing);
  return write_mesh_file(path, named, write_options(document, choices, cancel));
}

}  // namespace hariko
