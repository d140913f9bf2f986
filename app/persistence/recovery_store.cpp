#include "app/persistence/recovery_store.hpp"

#include <algorithm>
#include <random>
#include <system_error>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/edits/edit_pictures.hpp"
#include "core/document/file.hpp"

namespace hariko {

namespace fs = std::filesystem;
using Outcome = FileLock::Attempt::Outcome;

namespace {

constexpr std::string_view lock_end = ".lock";

Message folder_error(const fs::path& folder, const std::string& reason) {
  return make_error(
      e_recovery_folder,
      "Unsaved work cannot be kept for recovery in " + sanitized_utf8(folder.string()) + ": " + reason + ".",
      "Save often, and free space or repair the permissions of this folder.");
}

/// Path of a folder's lock. It is beside the folder, which must never exist without its lock.
fs::path lock_path(fs::path folder) {
  return folder += lock_end;
}

Result<Done> make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return folder_error(folder, error.message());
  fs::permissions(folder, fs::perms::owner_all, error);  // documents are private to their user
  return Done{};
}

/// Whether the original file has the copy's document, so that nothing is lost without the copy.
bool original_holds(const RecoveryCopy& copy) {
  if (copy.note.original.empty()) return false;
  const auto original = load_document(copy.note.original);
  if (!original.ok()) return false;
  return *original == with_absolute_pictures(copy.document, copy.note.original.parent_path());
}

std::optional<Leftover> describe(const RecoverySlot& slot) {
  Leftover leftover;
  leftover.id = slot.folder().filename().string();
  const auto copy = read_recovery(slot.folder());
  if (!copy.ok() && copy.error().code == e_no_recovery) return {};
  if (copy.ok()) {
    if (original_holds(*copy)) return {};
    leftover.note = copy->note;
    leftover.copy = copy->file;
    leftover.objects = copy->document.objects.size();
  } else {
    leftover.note = read_recovery_note(slot.folder()).value_or(RecoveryNote{});
    leftover.damaged = true;
  }
  const RecoveryNote& note = leftover.note;
  leftover.file_changed =
      !note.original.empty() && note.original_stamp && stamp_of(note.original) != note.original_stamp;
  return leftover;
}

}  // namespace

RecoverySlot& RecoverySlot::operator=(RecoverySlot&& other) noexcept {
  if (this == &other) return *this;
  leave();
  folder_ = std::move(other.folder_);
  lock_ = std::move(other.lock_);
  return *this;
}

RecoverySlot::~RecoverySlot() {
  leave();
}

void RecoverySlot::leave() {
  if (!lock_.held()) return;
  std::error_code ignored;
  if (!has_recovery(folder_)) fs::remove_all(folder_, ignored);
}

Result<Done> RecoverySlot::write(const Document& document, const RecoveryNote& note, FileLayer& layer) {
  return write_recovery(folder_, document, note, layer);
}

Result<Done> RecoverySlot::clear(FileLayer& layer) {
  return remove_recovery(folder_, layer);
}

Result<RecoverySlot> RecoveryStore::create(std::int64_t now) const {
  if (auto made = make_folder(folder_); !made) return made.error();
  const LockOwner self = this_process();
  std::random_device random;
  const std::string name = std::to_string(self.process) + "-" + std::to_string(self.process_start) + "-" +
                           std::to_string(random());
  const fs::path folder = folder_ / name;
  auto attempt = FileLock::try_lock(lock_path(folder), now);
  if (attempt.outcome != Outcome::acquired)
    return folder_error(folder_, attempt.reason.empty() ? "it is in use" : attempt.reason);
  if (auto made = make_folder(folder); !made) return made.error();
  return RecoverySlot(folder, std::move(attempt.lock));
}

Result<RecoverySlot> RecoveryStore::adopt(const std::string& id, std::int64_t now) const {
  const auto gone = [] {
    return make_error(e_no_recovery,
                      "This work is no longer there: another window recovered or discarded it.");
  };
  const fs::path folder = folder_ / id;
  std::error_code error;
  if (id.empty() || fs::path(id).filename() != id || !fs::is_directory(folder, error)) return gone();
  auto attempt = FileLock::try_lock(lock_path(folder), now);
  if (attempt.outcome == Outcome::taken)
    return make_error(e_recovery_taken, "Another window is using this work.", "Close that window first.");
  if (attempt.outcome == Outcome::unavailable) return folder_error(folder_, attempt.reason);
  if (!fs::is_directory(folder, error)) return gone();
  return RecoverySlot(folder, std::move(attempt.lock));
}

std::size_t RecoveryStore::candidates(std::int64_t now) const {
  std::size_t count = 0;
  std::error_code error;
  for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error))
    if (std::error_code unknown; it->is_directory(unknown) && adopt(it->path().filename().string(), now).ok())
      ++count;
  return count;
}

std::vector<Leftover> RecoveryStore::leftovers(std::int64_t now) const {
  std::vector<Leftover> found;
  std::vector<fs::path> folders;
  std::error_code error;
  for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error))
    if (std::error_code unknown; it->is_directory(unknown)) folders.push_back(it->path());
  for (const fs::path& folder : folders) {
    const auto slot = adopt(folder.filename().string(), now);
    if (!slot.ok()) continue;  // its session is running
    if (auto leftover = describe(*slot)) {
      found.push_back(std::move(*leftover));
      continue;
    }
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  std::sort(found.begin(), found.end(),
            [](const Leftover& a, const Leftover& b) { return a.note.written_at > b.note.written_at; });
  return found;
}

}  // namespace hariko
