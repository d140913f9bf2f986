#include "app/files/model_facets.hpp"

#include "app/files/export_surfaces.hpp"
#include "app/files/open_file.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/modeling/attached.hpp"
#include "core/unfolding/facet_graph.hpp"

namespace hariko {

namespace {

constexpr std::size_t max_facets = 1'000'000;

/// Adds polygons, moved into the document's space, as further components.
void append(PolygonMesh& out, const PolygonMesh& mesh, const Vector3& origin, const Similarity& transform) {
  const auto first = static_cast<Index>(out.positions.size());
  for (const Vector3& position : mesh.positions) out.positions.push_back(transform.apply(origin + position));
  std::vector<Index> face;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    face.assign(mesh.face(f).begin(), mesh.face(f).end());
    for (Index& vertex : face) vertex += first;
    out.add_face(face);
  }
}

}  // namespace

Result<ModelFacets> document_facets(const Document& document, int density, const CancelToken& cancel) {
  ModelFacets out;
  out.millimetres_per_unit = millimetres_per(document.unit);
  for (const auto& object : document.objects) {
    if (!object->visible) continue;
    if (const MeshSource* mesh = object->mesh()) {
      append(out.mesh, *mesh->mesh, mesh->origin, object->transform);
    } else if (object->cage()) {
      const auto built = object_surface(document, *object, cancel);
      if (!built.ok()) {
        Message error = built.error();
        error.text = object->name + ": " + error.text;
        return error;
      }
      const auto n = static_cast<std::size_t>(density);
      if (out.mesh.face_count() + 2 * built->surface.patch_count() * n * n > max_facets)
        return make_error(e_too_many_triangles,
                          "The paper model would have more than " + std::to_string(max_facets) + " facets.",
                          "Choose a smaller density.");
      append(out.mesh, polygons_of(tessellate(built->surface, density, cancel)), Vector3::Zero(),
             object->transform);
    }
    if (cancel.cancelled()) return make_error(e_cancelled, "Meshing was cancelled.");
  }
  if (out.mesh.face_count() == 0)
    return make_error(e_no_surface, "There is no visible surface to unfold.",
                      "Show an object or import one.");
  return out;
}

Result<ModelFacets> model_facets(const std::filesystem::path& file, int density, const CancelToken& cancel) {
  if (format_of_extension(file)) {
    auto mesh = read_mesh_file(file, {.cancel = cancel, .progress = {}});
    if (!mesh.ok()) return mesh.error();
    return ModelFacets{std::move(mesh->mesh), 1, mesh->warnings};
  }
  OpenedFile opened = open_file(file, cancel);
  if (!opened.document) {
    const Message* error = opened.error();
    return error ? *error : make_error(e_no_surface, "The file holds no document.");
  }
  auto facets = document_facets(*opened.document, density, cancel);
  if (facets.ok()) facets.value().warnings = std::move(opened.messages);
  return facets;
}

}  // namespace hariko
