#include "app/files/prepare_meshes.hpp"

#include <algorithm>

#include "core/document/edits/edits.hpp"
#include "core/modeling/operations/sharp_edges.hpp"

namespace hariko {

namespace {

std::size_t faces_of(const Object& object) {
  if (const PolyhedronSource* source = object.polyhedron()) return source->polyhedron.face_count();
  return object.mesh() ? object.mesh()->mesh->face_count() : 0;
}

std::size_t most_faces(const Document& document) {
  std::size_t most = 0;
  for (const auto& object : document.objects) most = std::max(most, faces_of(*object));
  return most;
}

/// Hides points and edges, so that the surface or facets are visible instead of a cloud of dots.
void show_plainly(std::optional<Document>& document) {
  if (!document) return;
  for (const auto& object : Document(*document).objects) {
    if (faces_of(*object) <= MeshImport::dense_faces) continue;
    DisplaySettings display = object->display;
    display.points = display.polyhedron = display.network = false;
    if (auto shown = set_display(*document, object->id, display)) document = std::move(shown).value();
  }
}

void crease(std::optional<Document>& document, double degrees) {
  if (!document) return;
  if (auto creased = with_creases(*document, degrees)) document = std::move(creased).value();
}

}  // namespace

void prepare_meshes(OpenedFile& opened, const MeshImport& choice) {
  if (!opened.meshes) return;
  if (choice.creases)
    for (auto* document : {&opened.document, &opened.repaired}) crease(*document, choice.crease_degrees);
  if (opened.document) {
    const std::size_t faces = most_faces(*opened.document);
    const bool asks = choice.use == MeshUse::ask && faces > MeshImport::dense_faces;
    if (asks || choice.use == MeshUse::reference)
      if (auto facets = as_reference(*opened.document)) opened.reference = std::move(facets).value();
    if (asks && opened.reference) opened.dense_faces = faces;
    if (choice.use == MeshUse::reference && opened.reference) opened.document = opened.reference;
  }
  for (auto* document : {&opened.document, &opened.repaired, &opened.reference}) show_plainly(*document);
}

}  // namespace hariko
