#pragma once

// Offers: what the start page proposes from earlier sessions: work to recover, and files to open again.
// Values that the application fills.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hariko {

/// Work that a session left behind when it ended without saving.
struct RecoveryOffer {
  std::string id;               ///< for ApplicationServices::recover and discard_recovery
  std::filesystem::path path;   ///< the file it was opened from; empty when it was never saved
  std::int64_t written_at = 0;  ///< seconds since 1970, UTC
  std::size_t objects = 0;
  bool file_changed = false;  ///< the file was saved or changed after the copy was made
  bool damaged = false;       ///< nothing of it can be read: it can only be discarded
  unsigned picture = 0;       ///< name of a texture; 0 when there is none (yet)
  float aspect = 4.0F / 3;    ///< width by height of the picture
};

/// A session that ended by a mistake of the program.
struct CrashOffer {
  std::int64_t at = 0;  ///< seconds since 1970, UTC
  std::string report;   ///< text that a report about the mistake needs, for the clipboard
};

struct RecentFile {
  std::filesystem::path path;
  std::int64_t used_at = 0;  ///< seconds since 1970, UTC; opened or saved
  unsigned picture = 0;      ///< name of a texture; 0 when there is none (yet)
  float aspect = 4.0F / 3;
};

struct Offers {
  std::optional<CrashOffer> crash;        ///< until it is dismissed
  std::vector<RecoveryOffer> recoveries;  ///< latest first
  /// Cards that have their place from the first frame on, before it is known what they offer.
  std::size_t recovery_places = 0;
  bool recoveries_known = false;
  std::vector<RecentFile> recent;  ///< latest first; files that are gone are left out
};

}  // namespace hariko
