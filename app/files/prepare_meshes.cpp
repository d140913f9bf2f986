#include "app/files/prepare_meshes.hpp"

#include <algorithm>

#include "app/files/reading.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/file.hpp"
#include "core/modeling/operations/sharp_edges.hpp"

namespace hariko {

namespace {

constexpr Code w_not_savable{"W_NOT_SAVABLE"};

/// Faces of a source's own: facets, or those of a polyhedron.
struct OwnFaces {
  std::size_t operator()(const PolyhedronSource& source) const { return source.polyhedron.face_count(); }
  std::size_t operator()(const MeshSource& source) const { return source.mesh->face_count(); }
  std::size_t operator()(const PatchSource&) const { return 0; }
  std::size_t operator()(const BezierSource&) const { return 0; }
  std::size_t operator()(const SolidsSource&) const { return 0; }
  std::size_t operator()(const SkinSource&) const { return 0; }
  std::size_t operator()(const OutlineSource&) const { return 0; }
  std::size_t operator()(const PictureSource&) const { return 0; }
  std::size_t operator()(const UnknownSource&) const { return 0; }
};

std::size_t faces_of(const Object& object) {
  return std::visit(OwnFaces(), object.source);
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
  if (opened.document) opened.inside_out = parts_inside_out(*opened.document);
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
  // Before work is done on what no file can hold.
  const std::optional<Document>& least = opened.reference ? opened.reference : opened.document;
  if (least && has_too_large_meshes(*least))
    opened.messages.push_back(
        make_warning(w_not_savable, "The mesh has so many faces that the document cannot be saved.",
                     "Make it coarser first, by hariko mesh or in the program that it comes from."));
}

}  // namespace hariko
