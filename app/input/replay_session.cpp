#include "app/input/replay_session.hpp"

#include <iostream>
#include <string>
#include <utility>

#include "app/persistence/settings_file.hpp"
#include "core/document/format/format.hpp"

namespace hariko {

ReplaySession::ReplaySession(Editor& editor, Workbench& workbench, GlWindow& window, RebuildEngine& engine,
                             TestLog& log)
    : editor_(editor), workbench_(workbench), window_(window), engine_(engine), log_(log) {}

void ReplaySession::begin(const WindowOptions& options, std::optional<Replay> replay) {
  if (replay) player_.emplace(*std::move(replay), options.skip_pauses);
  editor_.recording = player_.has_value();
  if (!options.record.empty())
    start(options.record, {window_.width(), window_.height(), window_.monitor_scale(), options.files});
  if (!player_ || !player_->replay().start.session) return;
  editor_.settings = settings_of(player_->replay().start.session->settings);
  document_waits_ = true;
}

void ReplaySession::start(const std::filesystem::path& path, const ReplayStart& beginning) {
  recorder_.emplace(path, beginning, window_.now());
  editor_.recording = recorder_->ok();
  if (recorder_->ok()) return;
  recorder_.reset();
  editor_.notify(Notice::Kind::error,
                 fill(editor_.language("{0} cannot be written: nothing is recorded."), {path.string()}));
}

/// Starts recording; the replay will begin with the document as it is now.
void ReplaySession::start_session(const std::filesystem::path& path) {
  const History& history = editor_.history;
  ReplayStart beginning{window_.width(), window_.height(), window_.monitor_scale(), {}};
  beginning.session = {write_document(history.current()),
                       editor_.path ? editor_.path->filename().string() : std::string(), history.dirty(),
                       settings_text(editor_.settings)};
  start(path, beginning);
  if (!recorder_) return;
  editor_.begin_recording();
  workbench_.forget_interface();
  engine_.reset();
  // The replay waits until everything that it opened is shown.
  recorder_->idle(editor_.now);
  // Position of the pointer, for keys that come before it moves.
  InputEvent pointer;
  pointer.x = double(ImGui::GetIO().MousePos.x);
  pointer.y = double(ImGui::GetIO().MousePos.y);
  if (ImGui::IsMousePosValid()) recorder_->batch(editor_.now, {pointer});
  log_.file("recording", path);
}

bool ReplaySession::follow_requests() {
  bool started = false;
  if (const auto path = std::exchange(record_to_, std::nullopt); path && !recorder_) {
    start_session(*path);
    started = recorder_.has_value();
  }
  if (!std::exchange(recording_ends_, false)) return started;
  if (recorder_) {
    finish();
    const bool whole = recorder_->ok();
    recorder_.reset();
    log_.file("recorded", {});
    if (whole)
      editor_.inform("The replay is written.");
    else
      editor_.notify(Notice::Kind::error,
                     editor_.language("The replay is not whole: its file could not be written to the end."));
  }
  editor_.end_recording();
  return started;
}

void ReplaySession::finish() {
  recorder_->finish(editor_.now, editor_.history.current(), editor_.history.position());
}

void ReplaySession::record_input() {
  if (recorder_) recorder_->batch(window_.input_time(), window_.input());
}

void ReplaySession::record_idle() {
  if (recorder_) recorder_->idle(editor_.now);
}

void ReplaySession::end() {
  if (!recorder_) return;
  finish();
  if (!recorder_->ok())
    std::cerr << editor_.language("The replay is not whole: its file could not be written to the end.")
              << "\n";
}

bool ReplaySession::open_document(bool has_sizes) {
  if (!document_waits_ || !has_sizes) return false;
  document_waits_ = false;
  const ReplayStart::Session& session = *player_->replay().start.session;
  auto document = read_document(session.document);
  if (!document) return editor_.notify(document.error()), true;
  std::optional<std::filesystem::path> file;
  if (!session.name.empty()) {
    scratch_.emplace();
    file = scratch_->path() / std::filesystem::path(session.name).filename();
  }
  editor_.open(std::move(document).value(), file);
  if (session.dirty) editor_.history.mark_unsaved();
  return true;
}

bool ReplaySession::play(bool idle) {
  if (!player_) return false;
  const auto now = std::chrono::steady_clock::now();
  const double seconds = std::chrono::duration<double>(now - played_at_).count();
  played_at_ = now;
  const auto batch = player_->advance(seconds, idle);
  window_.replay(player_->now(), batch);
  return player_->finished() || player_->stuck();
}

int ReplaySession::judge() const {
  if (!player_) return 0;
  const auto wrong = [](const std::string& what) {
    std::cerr << "The replay ended otherwise than it was recorded: " << what << "\n";
    return 1;
  };
  if (player_->stuck()) return wrong("the program did not come to rest.");
  if (!player_->all_played()) return wrong("the program was left before the end.");
  if (const auto difference = other_document(player_->replay(), editor_.history.current()))
    return wrong(*difference);
  if (editor_.history.position() != player_->replay().undo_steps)
    return wrong("there are " + std::to_string(editor_.history.position()) + " steps to undo instead of " +
                 std::to_string(player_->replay().undo_steps) + ".");
  return 0;
}

}  // namespace hariko
