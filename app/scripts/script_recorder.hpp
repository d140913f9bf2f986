#pragma once

// ScriptRecorder: what is done in a window, as the steps of a script that does the same without it.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/scripts/script_file.hpp"
#include "app/scripts/script_session.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

/// Every edit is looked at when it is done. Steps that may express it (the command that was used, what a tool
/// says of itself, and what the difference of the documents suggests) run in a trial beside the window, from
/// the document before the edit; those that give the document after it, to the last bit, are taken. Other
/// edits are left out, counted and named. Undo takes steps back, redo brings them again.
///
/// For the main thread, which a step keeps as long again as its command took.
class ScriptRecorder {
 public:
  /// Borrows the window's editor and workbench.
  ScriptRecorder(Editor& editor, Workbench& workbench, ScriptSession::OpenFile open_file);
  ~ScriptRecorder();
  ScriptRecorder(const ScriptRecorder&) = delete;
  ScriptRecorder& operator=(const ScriptRecorder&) = delete;

  /// Begins with the document as it is. An empty one is made by the script itself; others are to be opened by
  /// `hariko run --in`. Nothing where a script is recorded already.
  void begin(const std::filesystem::path& path);
  /// Writes the file, and tells what is in it. Nothing where no script is recorded.
  void finish();

  /// The script so far; empty where none is recorded.
  Script script() const;

 private:
  /// Names a state of the window's history.
  struct Place {
    std::uint64_t documents = 0, serial = 0;
    friend bool operator==(const Place&, const Place&) = default;
  };
  /// An edit.
  struct Entry {
    Place place;                        ///< the place it led to
    Document document;                  ///< at that place
    Circumstances before;               ///< state of the window when it was made
    std::vector<WrittenCommand> steps;  ///< empty: it was left out
    std::string left_out;               ///< label of the step that was
    Circumstances script;               ///< in which the script is afterwards
  };
  using Steps = std::vector<WrittenCommand>;

  Place here() const;
  void before_command() { look(nullptr); }
  void after_command(const Command& command, bool ran);
  void look(const Command* command);
  void go_back_to_parent();
  void take(const Command* command);
  std::vector<Steps> candidates(const Command* command) const;
  std::vector<Steps> opening_candidates() const;
  bool first_that_does(const std::vector<Steps>& candidates, Entry& entry);
  bool tried(const Steps& steps, Entry& entry);
  void leave_out(Entry& entry, const Command* command);
  void show_progress();

  Editor& editor_;
  Workbench& workbench_;
  ScriptTrial trial_;
  std::optional<std::filesystem::path> path_;  ///< while a script is recorded
  std::string beginning_;           ///< name of the document that it began with; empty: it makes it
  std::vector<Entry> entries_;      ///< the first is the beginning
  std::size_t position_ = 0;        ///< entry at which the window is; later ones were undone
  Circumstances window_;            ///< state of the window before what is done next
  std::string begun_;               ///< command that was run last, whose work may end later
  std::vector<std::string> files_;  ///< labels of commands that wrote files, with their places
};

}  // namespace hariko
