#pragma once

// Reading what a designer opens: a document, or a file of another program as a document with its objects.

#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/document.hpp"
#include "core/exchange/clean_part.hpp"
#include "core/polyhedron/repair.hpp"

namespace hariko {

struct OpenedFile {
  std::optional<Document> document;  ///< nothing when an error is among the messages
  std::vector<Message> messages;     ///< of reading and, for a mesh that makes no polyhedron, of validation
  /// The first mesh that was read but makes no polyhedron, for reports and repairs.
  std::optional<PolygonMesh> broken_mesh;
  /// What the file becomes where such meshes are changed by `make_manifold`, and as reference facets; nothing
  /// where it cannot be that.
  std::optional<Document> repaired, reference;
  RepairReport repair;  ///< how `repaired` was made
  CleanReport cleaned;  ///< what was done to the meshes at once; the messages tell of it
  std::string name;     ///< of the object that a mesh file makes: as the file says, else after the file
  bool meshes = false;  ///< a mesh file, whose polyhedra were not made here
  std::size_t dense_faces = 0;  ///< of the densest mesh, where it is to be asked what it becomes; else 0
  bool native = false;          ///< a *.hariko document, so that saving may go back to the same file
  /// The file says the unit of its lengths: the documents have it, or millimetres.
  bool says_unit = false;

  /// The first error among the messages; null when there is a document.
  const Message* error() const;
};

/// The ending of the name decides: .obj .off .ply .stl .glb .gltf .3mf are meshes, .step .stp .iges .igs
/// parts of a CAD program, .bpt Bezier patches, .json what its content says, all else a document. Bezier
/// patches become one object a name; a single one that `is_editable` can be edited at once. Messages are
/// those of the readers, of `validate` and of making sources, E_FORMAT_UNKNOWN for kinds of JSON that are not
/// opened; E_CANCELLED alone where it was cancelled. Meshes are cleaned (`clean`), their corners joined as
/// `join` says.
OpenedFile open_file(const std::filesystem::path& file, const CancelToken& cancel = {},
                     const Progress& progress = {}, const JoinChoice& join = {});

}  // namespace hariko
