#pragma once

// Documents on disk.

#include <filesystem>

#include "core/base/file_io.hpp"
#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_save_verify{"E_SAVE_VERIFY"};

/// Errors: those of `read_file` and of `read_document`; the text names the file.
Result<Document> load_document(const std::filesystem::path& path);

/// Writes the text, reads it back and compares (E_SAVE_VERIFY when they differ, nothing is written then), and
/// replaces the file in one step: on any error the old file is as it was (`write_file_atomic`, whose errors
/// come back).
Result<Done> save_document(const Document& document, const std::filesystem::path& path);
/// The same through other system calls, for tests.
Result<Done> save_document(const Document& document, const std::filesystem::path& path, FileLayer& layer);

}  // namespace hariko
