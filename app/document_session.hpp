#pragma once

// DocumentSession: the open document and its file: opening, saving, locking, changes by other programs,
// autosave and recovery.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/files/open_file.hpp"
#include "app/jobs/background_work.hpp"
#include "app/jobs/mesh_questions.hpp"
#include "app/offers.hpp"
#include "app/persistence/autosaver.hpp"
#include "app/persistence/xdg_folders.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

inline constexpr Code e_document_locked{"E_DOCUMENT_LOCKED"};  ///< another window has the file open

/// Session of one document at a time. For the main thread, except `write_autosave`.
class DocumentSession {
 public:
  struct Hooks {
    std::function<void()> wake;
    std::function<void()> replaced;  ///< another document was opened: results for the last one are void
    /// Event of the session, for the test log: "opened", "saved", "copied", "reverted", "recovered",
    /// "autosaved", "offers".
    std::function<void(const char* what, const std::filesystem::path&)> log;
  };
  /// `samples`: folder of the program's samples, which open as copies without a file.
  DocumentSession(Editor& editor, Workbench& workbench, const XdgFolders& folders,
                  std::filesystem::path samples, Hooks hooks);

  /// Looks for recovery copies of earlier sessions and for recent files, and updates the workbench's offers.
  void find_offers(Pictures& pictures);

  /// Opens a file. Asks first where a mesh is broken or has faults, unless `answers` decides about these.
  /// Work that was done while the file was read is asked about before another document takes its place.
  void open(const std::filesystem::path& path, const MeshAnswers& answers = {});
  /// Calls `then` when there is a document, or none is to come: at once, unless a file is being opened or
  /// asked about for the start page.
  void when_opened(std::function<void()> then);
  /// Saves the document; `then` is called after success.
  void save(const std::filesystem::path& path, std::function<void()> then);
  /// Saves a copy; the document keeps its file.
  void save_copy(const std::filesystem::path& path);
  /// Restores the file's content as an undoable step.
  void revert();
  /// Opens a recovery copy of an earlier session.
  void recover(const std::string& id);
  /// Removes a recovery copy of an earlier session.
  void discard_recovery(const std::string& id) { recoveries_.discard(id); }

  /// Notices changes and autosaves when it is time. To be called once in every turn of the event loop.
  void update();
  /// Seconds until `update` has something to do; negative where it has nothing.
  double due_in() const;
  /// Applies finished work; returns the number of jobs.
  std::size_t publish() { return background_.publish(); }
  bool idle() const { return background_.idle(); }

  /// Writes the recovery copy as of the last `update` before it returns. From any thread.
  void write_autosave();
  /// Ends the session: the user leaves, and work that is not saved was discarded. Files that were asked for
  /// are written first.
  void end();

 private:
  /// Modes of opening. `copy`: without a file, as if new.
  enum class Mode { normal, read_only, copy };
  struct Opened;
  struct Recovered;
  /// State of the work that another document would replace.
  struct Work {
    std::uint64_t document = 0, serial = 0;
    friend bool operator==(const Work&, const Work&) = default;
  };
  struct Saved;
  /// File that this session wrote last, by its lock.
  struct OwnWrite {
    std::filesystem::path lock;
    std::optional<FileStamp> stamp;
  };
  /// File that a document is being saved to for the first time.
  struct NextFile {
    std::uint64_t document = 0;
    std::filesystem::path path;
  };
  /// Content of the document's file when this session last read or wrote it.
  struct Disk {
    std::optional<FileStamp> stamp;
    std::optional<Document> content;
  };

  Work present_work() const { return {editor_.documents, editor_.history.serial()}; }
  /// `replaces`: work that the user knows to be replaced.
  void start_open(const std::filesystem::path& path, const MeshAnswers& answers, const Work& replaces);
  bool opening() const;
  void install(const std::shared_ptr<Opened>& opened, Mode mode);
  void ask_about_lock(const std::shared_ptr<Opened>& opened);
  void warn_about_lock(const std::filesystem::path& path, const FileLock::Attempt& attempt);
  void ask_about_mesh(const std::shared_ptr<Opened>& opened, const MeshAnswers& answers);
  void ask_about_density(const std::shared_ptr<Opened>& opened);
  void ask_about_faults_of(const std::shared_ptr<Opened>& opened, const MeshAnswers& answers);
  void start_save(const std::filesystem::path& path, std::function<void()> then, bool overwrite);
  void finish_save(Saved& saved, const std::function<void()>& then);
  void ask_about_change(const std::filesystem::path& path, std::function<void()> then);
  void finish_recovery(const std::string& id, const std::shared_ptr<Recovered>& found);
  void autosave();
  bool is_own_file(const std::filesystem::path& path) const;
  double interval() const;

  Editor& editor_;
  Workbench& workbench_;
  Hooks hooks_;
  std::filesystem::path samples_;
  RecoveryStore recovery_;
  RecentOffers recent_;
  RecoveryOffers recoveries_;
  Autosaver autosaver_;
  std::uint64_t document_ = 0;  ///< Editor::documents when this session last set or saw the document
  std::uint64_t saves_ = 0;     ///< number of times that the document's file was written
  Disk disk_;
  std::optional<NextFile> next_file_;
  std::shared_ptr<OwnWrite> own_write_ = std::make_shared<OwnWrite>();  ///< for the jobs that save alone
  FileLock lock_;
  int unwritten_ = 0;  ///< files that were asked for and are not written yet
  bool autosaving_ = false, autosave_failed_ = false;
  std::vector<std::function<void()>> after_opening_;  ///< work that waits for a document
  BackgroundWork background_;  ///< last: its thread stops before the other members are destroyed
};

}  // namespace hariko
