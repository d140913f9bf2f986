#include "app/files/export_surfaces.hpp"

#include <array>
#include <deque>
#include <string>
#include <utility>

#include "app/files/left_out.hpp"
#include "app/files/walled_surface.hpp"
#include "core/base/files/file_io.hpp"
#include "core/document/object_shape.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/exchange/obj/write_control_mesh.hpp"
#include "core/skinning/evaluate_skin.hpp"
#include "core/skinning/local_skin.hpp"

namespace hariko {

namespace {

constexpr std::size_t max_triangles = 20'000'000;

Message beyond_limit() {
  return make_error(e_too_many_triangles,
                    "The export would have more than " + std::to_string(max_triangles) + " triangles.",
                    "Choose a smaller density, or export fewer objects.");
}

/// Triangles of an object that has a surface.
Result<NamedMesh> tessellated(const Document& document, const Object& object, int density, const Wall& wall,
                              std::size_t& triangles, const CancelToken& cancel, const Progress& progress) {
  const auto built = walled_surface(document, object, wall, FoldedWalls::tell, cancel);
  if (!built.ok()) return built.error();
  progress.report(0.6);
  const auto n = static_cast<std::size_t>(density);
  const std::size_t of_patch = n * n * (built->surface.domain() == Domain::triangle ? 1 : 2);
  triangles += built->surface.patch_count() * of_patch * place_count(object);
  if (triangles > max_triangles) return beyond_limit();
  return NamedMesh{object.name, tessellate(built->surface, density, cancel), colour_of(object),
                   built->warnings};
}

/// Appends the mesh of an object once for each of its places.
void append_at_places(std::vector<NamedMesh>& meshes, const Object& object, const NamedMesh& made) {
  const std::vector<Similarity> places = places_of(object);
  for (std::size_t k = 0; k < places.size(); ++k) {
    meshes.push_back(made);
    meshes.back().name = name_of_place(object, k);
    if (k > 0) meshes.back().warnings.clear();
    place(meshes.back().mesh, places[k]);
  }
}

}  // namespace

void place(TriangleMesh& mesh, const Similarity& transform) {
  if (transform == Similarity{}) return;
  mesh.origin = transform.apply(mesh.origin);
  for (Vector3& position : mesh.positions) position = transform.apply_to_vector(position);
  for (Vector3& normal : mesh.normals) normal = transform.apply_to_normal(normal);
  if (!transform.mirrors()) return;
  for (auto* triangles : {&mesh.triangles, &mesh.normal_triangles})
    for (std::array<Index, 3>& triangle : *triangles) std::swap(triangle[1], triangle[2]);
}

WriteOptions write_options(const Document& document, const FileChoices& choices, const CancelToken& cancel) {
  const auto metres = [](Unit unit) { return millimetres_per(unit) / 1000; };
  WriteOptions out{cancel, metres(document.unit)};
  if (choices.unit) out.metres_per_file_unit = metres(*choices.unit);
  out.factor = choices.scale;
  out.up = choices.y_up ? UpAxis::y : UpAxis::z;
  out.encoding = choices.ascii ? MeshEncoding::ascii : MeshEncoding::binary;
  out.to_zero = choices.to_zero;
  return out;
}

MeshColour colour_of(const Object& object) {
  const Colour& colour = object.display.colour;
  return {colour.red, colour.green, colour.blue};
}

Result<std::vector<NamedMesh>> density_meshes(const Document& document, int density,
                                              const CancelToken& cancel, const Progress& progress,
                                              const Wall& wall) {
  if (auto wrong = why_no_wall(document, wall)) return *wrong;
  std::vector<NamedMesh> meshes;
  std::size_t triangles = 0;
  const auto count = static_cast<double>(document.objects.size());
  double number = 0;
  for (const auto& object : document.objects) {
    const Progress part = progress.part(number / count, (number + 1) / count);
    ++number;
    part.report(0);
    if (!object->visible || !has_shape(*object)) continue;
    if (is_faceted(*object)) {
      const NamedMesh made{object->name, triangles_of(*object->mesh()), colour_of(*object)};
      triangles += made.mesh.triangles.size() * place_count(*object);
      if (triangles > max_triangles) return beyond_limit();
      append_at_places(meshes, *object, made);
    } else {
      const auto made = tessellated(document, *object, density, wall, triangles, cancel, part);
      if (!made.ok()) return made.error();
      append_at_places(meshes, *object, *made);
    }
  }
  if (cancel.cancelled()) return make_error(e_cancelled, "The export was cancelled.");
  if (meshes.empty())
    return make_error(e_no_surface, "There is nothing visible to export.", "Show an object or import one.");
  return meshes;
}

Result<WrittenMeshes> export_surfaces(const Document& document, const std::filesystem::path& path,
                                      int density, const FileChoices& choices, const CancelToken& cancel,
                                      const Progress& progress, const Wall& wall) {
  // Writing takes about a fourth of the time; of the rest solving takes more than tessellation.
  constexpr double writing = 0.75;
  const auto meshes = density_meshes(document, density, cancel, progress.part(0, writing), wall);
  if (!meshes.ok()) return meshes.error();
  std::vector<NamedTriangles> named;
  for (const NamedMesh& mesh : *meshes) named.push_back({mesh.name, &mesh.mesh, mesh.colour});
  progress.report(writing);
  auto written = write_mesh_file(path, named, write_options(document, choices, cancel));
  if (!written.ok()) return written;
  auto shapeless = left_out_of_triangles(document);
  for (const NamedMesh& mesh : *meshes)
    shapeless.insert(shapeless.end(), mesh.warnings.begin(), mesh.warnings.end());
  std::vector<Message>& warnings = written.value().warnings;
  warnings.insert(warnings.begin(), shapeless.begin(), shapeless.end());
  return written;
}

Result<Done> export_control_meshes(const Document& document, const std::filesystem::path& path) {
  std::deque<ControlMesh> meshes;
  std::vector<NamedControlMesh> named;
  for (const auto& object : document.objects) {
    if (!object->visible || !has_control_mesh(*object)) continue;
    const LocalSkin local = local_skin(*object->skin()->skin);
    auto made = evaluate_skin(local.skin);
    if (!made) {
      Message error = made.error();
      error.text = object->name + ": " + error.text;
      return error;
    }
    const std::vector<Similarity> places = places_of(*object);
    for (std::size_t k = 0; k < places.size(); ++k) {
      meshes.push_back(made->mesh.control);
      PolygonMesh& mesh = meshes.back().mesh;
      for (Vector3& p : mesh.positions) p = places[k].apply(local.origin + p);
      if (places[k].mirrors()) reverse_faces(mesh);
      named.push_back({name_of_place(*object, k), &meshes.back()});
    }
  }
  if (named.empty())
    return make_error(e_no_skin, "There is no visible skin whose control mesh could be written.",
                      "Show a skin, or draw one.");
  return write_file_atomic(path, write_control_obj(named));
}

}  // namespace hariko
