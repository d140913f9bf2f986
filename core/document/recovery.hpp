#pragma once

// Recovery copies: a folder that holds the latest unsaved state of one document, so that a crash costs
// little.
//
// The folder has copies "copy-<n>.hariko", of which n grows, and the note "recovery.json" with what a
// document does not say of itself. A new copy is complete on the disk before older ones go: at any moment the
// folder holds a whole copy. Which one counts is decided by what can be read, never by times of files.

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/base/file_io.hpp"
#include "core/base/file_stamp.hpp"
#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_no_recovery{"E_NO_RECOVERY"};  ///< the folder holds no copy
inline constexpr Code e_recovery_damaged{
    "E_RECOVERY_DAMAGED"};  ///< it holds copies, of which none can be read

struct RecoveryNote {
  std::filesystem::path original;             ///< absolute; empty when the document was never saved
  std::optional<FileStamp> original_stamp{};  ///< of the original when it was last read or written
  std::int64_t written_at = 0;                ///< seconds since 1970, UTC; by the caller's clock

  friend bool operator==(const RecoveryNote&, const RecoveryNote&) = default;
};

struct RecoveryCopy {
  Document document;
  RecoveryNote note;           ///< empty where it could not be read
  std::filesystem::path file;  ///< the copy it was read from
};

/// Replaces what the folder (which exists) holds by a copy of this document. On an error (E_FILE_WRITE) the
/// last copy is still there.
Result<Done> write_recovery(const std::filesystem::path& folder, const Document& document,
                            const RecoveryNote& note, FileLayer& layer);

/// The latest whole copy. Errors: E_NO_RECOVERY, E_RECOVERY_DAMAGED.
Result<RecoveryCopy> read_recovery(const std::filesystem::path& folder);

/// Whether the folder holds any copy, whole or not. Reads none.
bool has_recovery(const std::filesystem::path& folder);

/// The note alone, without looking at the copies; nothing when it is missing or broken.
std::optional<RecoveryNote> read_recovery_note(const std::filesystem::path& folder);

/// Removes all copies and the note; other files stay. A folder without them is fine.
Result<Done> remove_recovery(const std::filesystem::path& folder, FileLayer& layer);

}  // namespace hariko
