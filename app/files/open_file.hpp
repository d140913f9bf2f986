#pragma once

// Opening of documents, and of files of other programs as documents.

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/document.hpp"
#include "core/exchange/repair/clean_part.hpp"
#include "core/polyhedron/repair.hpp"

namespace hariko {

/// Result of opening a file.
struct OpenedFile {
  std::optional<Document> document;  ///< nothing where there is an error among the messages
  std::vector<Message> messages;  ///< from reading and, for a mesh that makes no polyhedron, from validation
  /// First mesh that was read but makes no polyhedron, for reports and repairs.
  std::optional<PolygonMesh> broken_mesh;
  /// Document with broken meshes changed by `make_manifold`, and with reference facets instead; nothing where
  /// that is impossible.
  std::optional<Document> repaired, reference;
  RepairReport repair;          ///< changes made for `repaired`
  CleanReport cleaned;          ///< changes already made to all meshes; the messages report them
  std::string name;             ///< name of a mesh file's object: the file's own, else the file name
  bool meshes = false;          ///< a mesh file whose polyhedra were not made by this program
  std::size_t dense_faces = 0;  ///< number of faces of the densest mesh where the user is to be asked; else 0
  /// Number of closed parts of polyhedra that are inside out, where `prepare_meshes` counted them.
  std::size_t inside_out = 0;
  bool native = false;  ///< a *.hariko document, so that saving may go to the same file
  /// Whether the file gives the unit of its lengths; the documents have it, or millimetres.
  bool says_unit = false;

  /// First error among the messages; null where there is a document.
  const Message* error() const;
};

/// Opens a file by the ending of its name: .obj .off .ply .stl .glb .gltf .3mf are meshes, .step .stp .iges
/// .igs CAD models, .bpt Bezier patches, .json depends on its content, all else is a document. Bezier patches
/// become one object for each name; a single patch that `is_editable` becomes editable. Meshes are cleaned
/// (`clean`), with corners joined according to `join`. Messages: those of the readers, of `validate` and of
/// making sources; E_FORMAT_UNKNOWN for kinds of JSON that are not opened; only E_CANCELLED where it was
/// cancelled.
OpenedFile open_file(const std::filesystem::path& file, const CancelToken& cancel = {},
                     const Progress& progress = {}, const JoinChoice& join = {});

}  // namespace hariko
