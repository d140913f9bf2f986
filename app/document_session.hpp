#pragma once

// DocumentSession: the open document and its file: opening, saving, the lock, changes by other programs,
// autosave and recovery.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/files/open_file.hpp"
#include "app/jobs/background_work.hpp"
#include "app/persistence/autosaver.hpp"
#include "app/persistence/recent_files.hpp"
#include "app/persistence/xdg_folders.hpp"
#include "app/pictures/pictures.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

inline constexpr Code e_document_locked{"E_DOCUMENT_LOCKED"};  ///< another window has the file open

/// For the main thread, but for `write_autosave`.
class DocumentSession {
 public:
  struct Hooks {
    std::function<void()> wake;
    std::function<void()> replaced;  ///< another document: what was computed for the last one is void
    /// What happened, for the test log: "opened", "saved", "copied", "reverted", "recovered", "autosaved",
    /// "offers".
    std::function<void(const char* what, const std::filesystem::path&)> log;
  };
  /// Files in the folder `samples` came with the program: they open as copies without a file.
  DocumentSession(Editor& editor, Workbench& workbench, const XdgFolders& folders,
                  std::filesystem::path samples, Hooks hooks);

  /// Looks for what earlier sessions left, and for recent files; the workbench's offers follow.
  void find_offers(Pictures& pictures);

  /// Asks first where a mesh is broken, or has corners nearly at the same place, unless `join` says what
  /// becomes of these.
  void open(const std::filesystem::path& path, const JoinChoice& join = {});
  void save(const std::filesystem::path& path, std::function<void()> then);
  void save_copy(const std::filesystem::path& path);
  /// Brings the file's content back as a step that can be undone.
  void revert();
  void recover(const std::string& id);
  void discard_recovery(const std::string& id);

  /// Once a turn of the loop: sees what changed and autosaves when it is time.
  void update();
  /// Seconds until `update` has something to do; negative when it does not.
  double due_in() const;
  std::size_t publish() { return background_.publish(); }
  bool idle() const { return background_.idle(); }

  /// From any thread: brings the recovery copy up to date with the last `update` before it returns.
  void write_autosave();
  /// The user leaves: what is not saved by now was discarded.
  void end();

 private:
  /// `copy`: without a file, as if it were new.
  enum class Mode { normal, read_only, copy };
  struct Opened;
  struct Recovered;
  struct Saved;
  /// What the document's file held when this session read or wrote it.
  struct Disk {
    std::optional<FileStamp> stamp;
    std::optional<Document> content;
  };

  void install(const std::shared_ptr<Opened>& opened, Mode mode);
  void ask_about_lock(const std::shared_ptr<Opened>& opened);
  void warn_about_lock(const std::filesystem::path& path, const FileLock::Attempt& attempt);
  void ask_about_mesh(const std::shared_ptr<Opened>& opened);
  void ask_about_density(const std::shared_ptr<Opened>& opened);
  void ask_about_corners(const std::shared_ptr<Opened>& opened);
  void start_save(const std::filesystem::path& path, std::function<void()> then, bool overwrite);
  void finish_save(Saved& saved, const std::function<void()>& then);
  void ask_about_change(const std::filesystem::path& path, std::function<void()> then);
  void finish_recovery(const std::string& id, Recovered& recovered);
  void autosave();
  void used(const std::filesystem::path& path);
  void show_recent(const std::vector<RecentEntry>& entries);
  void show_leftovers(const std::vector<Leftover>& leftovers);
  bool is_own_file(const std::filesystem::path& path) const;
  double interval() const;

  Editor& editor_;
  Workbench& workbench_;
  Hooks hooks_;
  std::filesystem::path samples_;
  RecoveryStore recovery_;
  RecentFiles recent_;
  Autosaver autosaver_;
  Pictures* pictures_ = nullptr;
  std::uint64_t document_ = 0;  ///< Editor::documents when this session set or saw the document
  Disk disk_;
  FileLock lock_;
  bool autosaving_ = false, autosave_failed_ = false;
  BackgroundWork background_;  ///< last: its thread stops before the rest goes
};

}  // namespace hariko
