#include <deque>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/input.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko {

namespace {

constexpr Code e_no_surface{"E_NO_SURFACE"};
constexpr Code e_too_many_triangles{"E_TOO_MANY_TRIANGLES"};
constexpr std::size_t max_triangles = 20'000'000;  // about 2 GB of memory

/// From object space to the document's.
void transform(const Similarity& by, TriangleMesh& mesh) {
  mesh.origin = by.apply(mesh.origin);
  for (Vector3& position : mesh.positions) position = by.apply_to_vector(position);
  for (Vector3& normal : mesh.normals) normal = by.rotation * normal;
}

Result<Done> export_objects(const Document& document, const ExportArguments& arguments) {
  std::deque<TriangleMesh> meshes;
  std::vector<NamedTriangles> named;
  std::size_t triangles = 0;
  for (const auto& object : document.objects) {
    const PolyhedronSource* source = object->polyhedron();
    if (!object->visible || !source) continue;
    const auto built = PolyhedronSurfacer().rebuild(source->surface_input());
    if (!built.ok()) return built.error();
    const auto density = static_cast<std::size_t>(arguments.density);
    triangles += built->surface.patch_count() * density * density;
    if (triangles > max_triangles)
      return make_error(e_too_many_triangles,
                        "The export would have more than " + std::to_string(max_triangles) + " triangles.",
                        "Choose a smaller density.");
    meshes.push_back(tessellate(built->surface, arguments.density));
    if (!(object->transform == Similarity{})) transform(object->transform, meshes.back());
    named.push_back({object->name, &meshes.back()});
  }
  if (named.empty())
    return make_error(e_no_surface, "No visible object of the file has a surface.",
                      "Make an object visible, or add one.");
  return write_mesh_file(arguments.out, named);
}

}  // namespace

int run_export(const ExportArguments& arguments) {
  const auto document = read_document_or_report(arguments.file);
  if (!document) return exit_failed;
  const auto done = export_objects(*document, arguments);
  if (done.ok()) return exit_fine;
  report(arguments.file.string(), done.error());
  return exit_failed;
}

}  // namespace hariko
