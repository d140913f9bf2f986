#pragma once

#include <filesystem>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/files/open_file.hpp"

namespace hariko {

/// Opens a file; a mesh that makes no polyhedron is repaired or kept as facets where that is asked for, which
/// a warning then tells in the place of the errors; else a warning tells that it can be.
OpenedFile open_as_asked(const std::filesystem::path& file, const Reading& reading,
                         const Progress& progress = {});

/// Opens the file of a subcommand; reports all messages on the error stream and gives nothing on an error.
std::optional<Document> read_document_or_report(const std::filesystem::path& file,
                                                const Construction& construction = {});

/// Every polyhedron and outline gets the construction, locked ones too: nothing is saved.
Document with_construction(Document document, const Construction& construction);

/// The objects of these names, hidden ones included, and no others visible; all as they are when `only` is
/// empty. Error: E_NO_SUCH_OBJECT.
Result<Document> with_only(const Document& document, const std::vector<std::string>& only);

}  // namespace hariko
