#include "app/files/export_surfaces.hpp"

#include <deque>
#include <string>

#include "core/exchange/mesh_file.hpp"
#include "core/modeling/mirrored.hpp"

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

Result<Done> export_surfaces(const Document& document, const std::filesystem::path& path, int density,
                             const CancelToken& cancel) {
  std::deque<TriangleMesh> meshes;
  std::vector<NamedTriangles> named;
  std::size_t triangles = 0;
  for (const auto& object : document.objects) {
    const PolyhedronSource* source = object->polyhedron();
    if (!object->visible || !source) continue;
    const auto named_error = [&](Message error) {
      error.text = object->name + ": " + error.text;
      return error;
    };
    const auto input = surface_input(*source);
    if (!input) return named_error(input.error());
    const auto built = PolyhedronSurfacer().rebuild(*input, Quality::final, cancel);
    if (!built.ok()) return named_error(built.error());
    const auto n = static_cast<std::size_t>(density);
    triangles += built->surface.patch_count() * n * n;
    if (triangles > max_triangles)
      return make_error(e_too_many_triangles,
                        "The export would have more than " + std::to_string(max_triangles) + " triangles.",
                        "Choose a smaller density.");
    meshes.push_back(tessellate(built->surface, density, cancel));
    place(meshes.back(), object->transform);
    named.push_back({object->name, &meshes.back()});
  }
  if (cancel.cancelled()) return make_error(e_cancelled, "The export was cancelled.");
  if (named.empty())
    return make_error(e_no_surface, "There is no visible surface to export.",
                      "Show an object or import one.");
  return write_mesh_file(path, named);
}

}  // namespace hariko
