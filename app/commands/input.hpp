#pragma once

// Reading what a subcommand works on: a document, or a mesh file as a document with one polyhedron.

#include <filesystem>
#include <optional>
#include <vector>

#include "core/document/document.hpp"

namespace hariko {

struct Input {
  std::optional<Document> document;  ///< nothing when an error is among the messages
  std::vector<Message> messages;     ///< of reading and, for a mesh that makes no polyhedron, of validation
  /// A mesh that was read but makes no polyhedron: its name and size, for reports.
  std::optional<PolygonMesh> broken_mesh;
  std::string name;
  double milliseconds = 0;
};

/// The ending of the name decides: .obj .off .ply .stl are meshes, all else is a document. A mesh is named as
/// its file says, else after the file.
Input read_input(const std::filesystem::path& file);

/// As above; reports all messages and gives nothing on an error.
std::optional<Document> read_document_or_report(const std::filesystem::path& file);

}  // namespace hariko
