#pragma once

// Replays: recorded user input that can be played again. docs/replays.md describes the file format.

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "app/input/input_queue.hpp"
#include "core/base/result.hpp"
#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_replay_read{"E_REPLAY_READ"};

/// Initial state of a recording.
struct ReplayStart {
  int width = 1280, height = 800;            ///< size of the window
  double scale = 1;                          ///< scale of the interface, the monitor's included
  std::vector<std::filesystem::path> files;  ///< opened files, relative to the replay file

  /// Initial state of a recording that starts in the middle of a session, instead of files.
  struct Session {
    std::string document;  ///< text of the saved document
    std::string name;      ///< name of its file, without a folder; empty where it was never saved
    bool dirty = false;    ///< the document differed from its file
    std::string settings;  ///< `settings_text`
  };
  std::optional<Session> session = {};
};

/// Step of a replay: a batch of input, or a mark.
struct ReplayStep {
  double time = 0;                ///< seconds since the start, ascending
  std::vector<InputEvent> batch;  ///< input of one frame; empty for marks
  bool waits_for_idle = false;    ///< the program was idle at this moment
};

/// Recorded session.
struct Replay {
  ReplayStart start;
  std::vector<ReplayStep> steps;
  std::string document;        ///< text of the final document, `write_document`; before that was kept, a hash
  std::size_t undo_steps = 0;  ///< number of undo steps at the end

  /// Reads a replay file. Errors: those of read_file, E_REPLAY_READ with the line.
  static Result<Replay> read(const std::filesystem::path& path);
};

/// Compares the document at the end of a replay with the one that was recorded, both as the present format
/// writes them: a recording outlives changes of the format. Nothing where they are equal, else a sentence
/// with the first line that differs. A recording that kept a hash of the text, which a new format changes,
/// compares nothing.
std::optional<std::string> other_document(const Replay& replay, const Document& document);

/// Writes a replay during a session. Every line reaches the disk immediately, so that a crash leaves the
/// input that led to it.
class ReplayRecorder {
 public:
  /// Opens the file; `ok()` is false where it cannot be written.
  ReplayRecorder(const std::filesystem::path& path, const ReplayStart& start, double now);
  bool ok() const { return out_.good(); }
  /// Records the input of a frame.
  void batch(double now, const std::vector<InputEvent>& events);
  /// Records that the program is idle: a replay waits for the same state.
  void idle(double now);
  /// Records the final state and ends the replay.
  void finish(double now, const Document& document, std::size_t undo_steps);

 private:
  double since_start(double now) const;

  std::ofstream out_;
  double start_ = 0;
  bool marked_idle_ = false;
};

/// Determines when recorded input is played. Its clock stops where the program is slower than the recording
/// was, so that double clicks stay double clicks.
class ReplayPlayer {
 public:
  /// `skip_pauses`: advances the clock to the next event whenever the program is idle.
  explicit ReplayPlayer(Replay replay, bool skip_pauses = false)
      : replay_(std::move(replay)), skip_pauses_(skip_pauses) {}

  /// Advances by `seconds` of real time and returns the batch that is due now, at most one per call. `idle`:
  /// whether the program has nothing left to do.
  std::vector<InputEvent> advance(double seconds, bool idle);
  /// Time that the program should use.
  double now() const { return now_; }
  /// Whether everything was played and the program is idle again.
  bool finished() const { return finished_; }
  /// Whether the program has not become idle for `longest_wait`.
  bool stuck() const { return waited_ > longest_wait; }
  /// Seconds. Programs with sanitizers, several on one processor, need more than a minute.
  static constexpr double longest_wait = 240;

  /// Whether only marks are left.
  bool all_played() const;

  const Replay& replay() const { return replay_; }

 private:
  Replay replay_;
  bool skip_pauses_;
  std::size_t next_ = 0;
  double now_ = 0, delay_ = 0, waited_ = 0;
  bool finished_ = false;
};

}  // namespace hariko
