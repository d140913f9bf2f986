#include "core/document/file.hpp"

#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/edits/edit_pictures.hpp"
#include "core/document/format/format.hpp"

namespace hariko {
namespace {

/// Number of values that the mesh of an object takes in a file: rows, their numbers and ids.
std::size_t values_of_mesh(const Object& object) {
  if (const MeshSource* source = object.mesh()) {
    const PolygonMesh& mesh = *source->mesh;
    return 4 * mesh.positions.size() + mesh.face_count() + mesh.face_vertices.size();
  }
  if (const PolyhedronSource* source = object.polyhedron()) {
    const HalfEdgeMesh& mesh = source->polyhedron.topology();
    return 5 * std::size_t(mesh.vertex_count()) + 2 * std::size_t(mesh.face_count()) +
           std::size_t(mesh.half_edge_count());
  }
  return 0;
}

/// Returns the text of the document after it has been read back and found equal.
Result<std::string> verified_text(const Document& document) {
  std::string text = write_document(document);
  const Result<Document> again = read_document(text);
  const auto differs = [](const std::string& why) {
    return make_error(e_save_verify, "The document was not saved, as its file would not open again: " + why,
                      "Save under another name, and report this as a defect of the program.");
  };
  if (!again && again.error().code == e_limit)
    return make_error(e_document_size, "The document was not saved: it is larger than a file may be.",
                      "Delete or reduce its largest meshes, or unpack its pictures.");
  if (!again) return differs(to_string(again.error()));
  if (!(*again == document)) return differs("it would hold something else.");
  return text;
}

/// Absolute folder of a file; empty where it cannot be determined.
std::filesystem::path folder_of(const std::filesystem::path& file) {
  std::error_code unknown;
  const std::filesystem::path absolute = std::filesystem::absolute(file, unknown);
  return unknown ? std::filesystem::path() : absolute.lexically_normal().parent_path();
}

}  // namespace

bool has_too_large_meshes(const Document& document) {
  std::size_t values = 0;
  for (const auto& object : document.objects) values += values_of_mesh(*object);
  return values > max_document_values;
}

Result<Document> load_document(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, max_document_bytes);
  if (!text) return text.error();
  Result<Document> document = read_document(*text);
  if (document) return with_absolute_pictures(*document, folder_of(path));
  Message message = document.error();
  message.text = shortened(path.filename().string(), 200) + ": " + message.text;
  return message;
}

Result<Done> save_document(const Document& document, const std::filesystem::path& path) {
  SystemFileLayer layer;
  return save_document(document, path, layer);
}

Result<Done> save_document(const Document& document, const std::filesystem::path& path, FileLayer& layer) {
  const Result<std::string> text = verified_text(with_relative_pictures(document, folder_of(path)));
  if (!text) return text.error();
  return write_file_atomic(path, *text, layer);
}

}  // namespace hariko
