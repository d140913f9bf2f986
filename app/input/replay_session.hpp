#pragma once

// ReplaySession: recording of what the user does in the window, and playing of a recording in his place.

#include <chrono>
#include <filesystem>
#include <optional>

#include "app/engines/rebuild_engine.hpp"
#include "app/input/replay.hpp"
#include "app/input/test_log.hpp"
#include "app/scratch_folder.hpp"
#include "app/window/gl_window.hpp"
#include "app/window/window_options.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

/// Recorder and player of one window, for its event loop. For the main thread.
class ReplaySession {
 public:
  /// Borrows everything. `log`: receives "recording" and "recorded".
  ReplaySession(Editor& editor, Workbench& workbench, GlWindow& window, RebuildEngine& engine, TestLog& log);

  /// Begins to play `replay`, with its settings, and to record where the options say so.
  void begin(const WindowOptions& options, std::optional<Replay> replay);
  /// Replay that is played; null for none.
  const Replay* replay() const { return player_ ? &player_->replay() : nullptr; }
  /// Whether the replay's initial document is not opened yet.
  bool document_waits() const { return document_waits_; }

  /// Opens the initial document of a recorded session once the window `has_sizes`, so that views are framed
  /// as in the recording. Its file is a scratch file of the replay. True where it was time to open it.
  bool open_document(bool has_sizes);
  /// Feeds the window with the replay's events that are due. `idle`: whether the program has nothing left to
  /// do. True when the replay is at its end.
  bool play(bool idle);

  /// Requests a recording, which starts before the next event.
  void record(const std::filesystem::path& path) { record_to_ = path; }
  /// Requests the end of the recording, which will have all events so far.
  void stop() { recording_ends_ = true; }
  /// Follows these requests. True where a recording started: the interface begins anew.
  bool follow_requests();
  /// Records the present batch of input.
  void record_input();
  /// Records that the program is idle.
  void record_idle();
  /// Ends a recording together with the program.
  void end();

  /// Exit code: 1 for a replay that ended in another state than its recording, and says why; else 0.
  int judge() const;

 private:
  void start(const std::filesystem::path& path, const ReplayStart& beginning);
  void start_session(const std::filesystem::path& path);
  void finish();

  Editor& editor_;
  Workbench& workbench_;
  GlWindow& window_;
  RebuildEngine& engine_;
  TestLog& log_;
  std::optional<ReplayRecorder> recorder_;
  std::optional<std::filesystem::path> record_to_;  ///< file of a requested recording
  bool recording_ends_ = false;
  bool document_waits_ = false;
  std::optional<ScratchFolder> scratch_;  ///< for a replay that saves files
  std::optional<ReplayPlayer> player_;
  std::chrono::steady_clock::time_point played_at_ = std::chrono::steady_clock::now();
};

}  // namespace hariko
