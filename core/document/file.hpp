#pragma once

// Loading and saving of documents.

#include <filesystem>

#include "core/base/files/file_io.hpp"
#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_save_verify{"E_SAVE_VERIFY"};
inline constexpr Code e_document_size{"E_DOCUMENT_SIZE"};

/// Loads a document. Errors: those of `read_file` and of `read_document`; the text names the file.
Result<Document> load_document(const std::filesystem::path& path);

/// Saves a document: writes the text, reads it back, compares (E_SAVE_VERIFY when they differ,
/// E_DOCUMENT_SIZE when it is beyond the limits of files; nothing is written then), and replaces the file in
/// one step. On any error the old file stays unchanged. Errors also of `write_file_atomic`.
Result<Done> save_document(const Document& document, const std::filesystem::path& path);
/// Saves through other system calls, for tests.
Result<Done> save_document(const Document& document, const std::filesystem::path& path, FileLayer& layer);

/// Whether meshes and polyhedra alone have more values than a file may hold, so that the document cannot be
/// saved. O(objects).
bool has_too_large_meshes(const Document& document);

}  // namespace hariko
