#pragma once

// Recovery copies: a folder with the latest unsaved state of one document, so that a crash loses little work.
//
// The folder contains copies "copy-<n>.hariko" with growing n, and the note "recovery.json" with data that
// are not part of the document. A new copy is complete on the disk before older ones are removed: at any
// moment the folder contains a whole copy. The copy to use is chosen by what can be read, never by file
// times.

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/base/files/file_io.hpp"
#include "core/base/files/file_stamp.hpp"
#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_no_recovery{"E_NO_RECOVERY"};            ///< the folder contains no copy
inline constexpr Code e_recovery_damaged{"E_RECOVERY_DAMAGED"};  ///< it contains copies, but none can be read

struct RecoveryNote {
  std::filesystem::path original;             ///< absolute; empty when the document was never saved
  std::optional<FileStamp> original_stamp{};  ///< state of the original when it was last read or written
  std::int64_t written_at = 0;                ///< seconds since 1970, UTC, by the caller's clock

  friend bool operator==(const RecoveryNote&, const RecoveryNote&) = default;
};

/// Recovered document with its note and file.
struct RecoveryCopy {
  Document document;
  RecoveryNote note;           ///< empty where it could not be read
  std::filesystem::path file;  ///< the copy it was read from
};

/// Replaces the contents of the (existing) folder by a copy of this document. On an error (E_FILE_WRITE) the
/// last copy is still there. Linked pictures whose paths no file can hold have paths from the original's
/// folder in it.
Result<Done> write_recovery(const std::filesystem::path& folder, const Document& document,
                            const RecoveryNote& note, FileLayer& layer);

/// Reads the latest whole copy. Errors: E_NO_RECOVERY, E_RECOVERY_DAMAGED.
Result<RecoveryCopy> read_recovery(const std::filesystem::path& folder);

/// Whether the folder contains any copy, whole or not. Reads none.
bool has_recovery(const std::filesystem::path& folder);

/// Reads the note alone, without the copies; nothing when it is missing or damaged.
std::optional<RecoveryNote> read_recovery_note(const std::filesystem::path& folder);

/// Removes all copies and the note; other files stay. A folder without them is no error.
Result<Done> remove_recovery(const std::filesystem::path& folder, FileLayer& layer);

}  // namespace hariko
