#pragma once

// Replays: what a user did in the window, in a file that plays it again. The format is in docs/replays.md.

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

/// With what the recording began.
struct ReplayStart {
  int width = 1280, height = 800;            ///< of the window
  double scale = 1;                          ///< of the interface, the monitor's included
  std::vector<std::filesystem::path> files;  ///< opened; relative to the replay file

  /// With what a recording in the middle of a session began, instead of files.
  struct Session {
    std::string document;  ///< the text that it is saved as
    std::string name;      ///< of its file, without a folder; empty when it was never saved
    bool dirty = false;    ///< it differed from its file
    std::string settings;  ///< `settings_text`
  };
  std::optional<Session> session = {};
};

struct ReplayStep {
  double time = 0;                ///< seconds since the start, not descending
  std::vector<InputEvent> batch;  ///< what one frame sees; empty for marks
  bool waits_for_idle = false;    ///< nothing was left to do at this moment
};

struct Replay {
  ReplayStart start;
  std::vector<ReplayStep> steps;
  std::string document_hash;   ///< of the text that the document is saved as, at the end
  std::size_t undo_steps = 0;  ///< in the history at the end

  /// Errors: those of read_file, E_REPLAY_READ with the line.
  static Result<Replay> read(const std::filesystem::path& path);
};

/// FNV-1a, 64 bits, of the text that the document is saved as; 16 hexadecimal digits.
std::string document_hash(const Document& document);

/// Writes a replay while it happens. Every line is on the disk at once, so that a crash leaves what led to
/// it.
class ReplayRecorder {
 public:
  /// False in `ok()` when the file cannot be written.
  ReplayRecorder(const std::filesystem::path& path, const ReplayStart& start, double now);
  bool ok() const { return out_.good(); }
  void batch(double now, const std::vector<InputEvent>& events);
  /// Nothing is left to do: a replay waits until that is so again.
  void idle(double now);
  void finish(double now, const Document& document, std::size_t undo_steps);

 private:
  double since_start(double now) const;

  std::ofstream out_;
  double start_ = 0;
  bool marked_idle_ = false;
};

/// Says when what is to be played. Time stands still where the program is slower than the recording was, so
/// that double clicks stay double clicks.
class ReplayPlayer {
 public:
  /// `skip_pauses`: the clock leaps to the next event whenever the program has nothing left to do.
  explicit ReplayPlayer(Replay replay, bool skip_pauses = false)
      : replay_(std::move(replay)), skip_pauses_(skip_pauses) {}

  /// Advances by `seconds` of real time and gives the batch that is due now; `idle`: the program has nothing
  /// left to do. At most one batch a call.
  std::vector<InputEvent> advance(double seconds, bool idle);
  /// The time that the program is to see.
  double now() const { return now_; }
  /// All was played and the program is idle again.
  bool finished() const { return finished_; }
  /// Why waiting is in vain: the program has not become idle for this long.
  bool stuck() const { return waited_ > longest_wait; }
  /// Seconds. Programs with sanitizers of which several share a processor need more than a minute.
  static constexpr double longest_wait = 240;

  /// Nothing but marks is left.
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
