#include "app/document_files.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/printable.hpp"
#include "core/document/file.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko {

namespace {

Result<OpenedFile> open_mesh(const std::filesystem::path& path) {
  auto imported = read_mesh_file(path);
  if (!imported.ok()) return imported.error();
  std::string name =
      printable(imported->name.empty() ? path.stem().string() : imported->name, Object::max_name_length);
  if (!check_name(name).ok()) name = "mesh";
  std::vector<Message> warnings = imported->warnings;
  auto document = document_from_mesh(std::move(imported).value().mesh, std::move(name));
  if (!document.ok()) {
    Message error = document.error();
    error.text = path.filename().string() + ": " + error.text;
    return error;
  }
  OpenedFile opened;
  opened.document = std::move(document).value();
  opened.warnings = std::move(warnings);
  return opened;
}

/// From object space to the document's.
void place(TriangleMesh& mesh, const Similarity& transform) {
  if (transform == Similarity{}) return;
  mesh.origin = transform.apply(mesh.origin);
  for (Vector3& position : mesh.positions) position = transform.apply_to_vector(position);
  for (Vector3& normal : mesh.normals) normal = transform.rotation * normal;
}

}  // namespace

Result<OpenedFile> open_file(const std::filesystem::path& path) {
  if (format_of_extension(path)) return open_mesh(path);
  auto document = load_document(path);
  if (!document.ok()) return document.error();
  OpenedFile opened;
  opened.document = std::move(document).value();
  opened.native = true;
  return opened;
}

Result<Done> export_surfaces(const Document& document, const std::filesystem::path& path, int density,
                             const CancelToken& cancel) {
  std::vector<std::pair<std::string, TriangleMesh>> meshes;
  for (const auto& object : document.objects) {
    if (!object->visible || !object->polyhedron()) continue;
    auto made = PolyhedronSurfacer().rebuild(object->polyhedron()->surface_input(), Quality::final, cancel);
    if (!made.ok()) {
      Message error = made.error();
      error.text = object->name + ": " + error.text;
      return error;
    }
    meshes.emplace_back(object->name, tessellate(made->surface, density, cancel));
    place(meshes.back().second, object->transform);
  }
  if (meshes.empty())
    return make_error(e_no_surface, "There is no visible surface to export.",
                      "Show an object or import one.");
  if (cancel.cancelled()) return make_error(e_cancelled, "The export was cancelled.");
  std::vector<NamedTriangles> named;
  for (const auto& [name, mesh] : meshes) named.push_back({name, &mesh});
  return write_mesh_file(path, named);
}

}  // namespace hariko
