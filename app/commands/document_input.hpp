#pragma once

// Reading of a command's input file, with the choices of its options.

#include <filesystem>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/files/open_file.hpp"

namespace hariko {

/// Opens a file, with a progress line. A mesh that makes no polyhedron is repaired or kept as facets where
/// `reading` says so, and a warning about that replaces the errors; otherwise a warning tells that it is
/// possible.
OpenedFile open_as_asked(const std::filesystem::path& file, const Reading& reading);

/// Opens a command's file; reports all messages on the error stream and returns nothing on an error.
std::optional<Document> read_document_or_report(const std::filesystem::path& file,
                                                const Construction& construction = {});

/// Document with the construction applied to every polyhedron, outline and set of solids, also to locked
/// ones, as nothing is saved.
Document with_construction(Document document, const Construction& construction);

/// Document in which exactly the objects of these names are visible, also hidden ones; unchanged where `only`
/// is empty. Errors: E_NO_SUCH_OBJECT.
Result<Document> with_only(const Document& document, const std::vector<std::string>& only);

}  // namespace hariko
