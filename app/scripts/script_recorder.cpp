#include "app/scripts/script_recorder.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "app/scripts/edit_guesses.hpp"
#include "core/base/files/file_io.hpp"
#include "core/document/words.hpp"

namespace hariko {

namespace {

/// Commands that write files by way of dialogs: they change no document, so a script goes without them.
constexpr std::array file_writers{"file.export",         "file.export_cad",       "file.export_control",
                                  "file.export_picture", "file.export_turntable", "paper.export",
                                  "picture.unpack"};

bool chooses(const WrittenCommand& step) {
  return step.command.starts_with("select.");
}

/// Whether a document takes the place of the one before.
bool opens(const WrittenCommand& step) {
  return step.command == "file.new" || step.command == "file.open" || step.command == "file.new_from_box";
}

}  // namespace

ScriptRecorder::ScriptRecorder(Editor& editor, Workbench& workbench, ScriptSession::OpenFile open_file)
    : editor_(editor), workbench_(workbench), trial_(std::move(open_file)) {}

ScriptRecorder::~ScriptRecorder() {
  if (path_) workbench_.watch({});
}

ScriptRecorder::Place ScriptRecorder::here() const {
  return {editor_.documents, editor_.history.serial()};
}

void ScriptRecorder::begin(const std::filesystem::path& path) {
  if (path_) return;
  path_ = path;
  beginning_.clear();
  files_.clear();
  begun_.clear();
  position_ = 0;
  window_ = circumstances_of(editor_);
  const ScriptState start = trial_.start();
  Entry entry{here(), editor_.history.current(), window_, {}, {}, start.circumstances};
  if (!entry.document.objects.empty() || !first_that_does(opening_candidates(), entry)) {
    beginning_ = editor_.title();
    // As after the opening of that document.
    entry.script.selection = {};
    entry.script.selection.prune(entry.document);
  }
  entries_ = {std::move(entry)};
  // The place of the file is tried at once, as it is easy to choose another one now.
  if (const auto done = write_file_atomic(path, write_script(script())); !done) {
    path_.reset();
    return editor_.notify(done.error());
  }
  workbench_.watch({[this] { before_command(); },
                    [this](const Command& command, const CommandTable::Outcome& outcome) {
                      after_command(command, outcome.ran);
                    },
                    [this] { look(nullptr); }});
  show_progress();
}

void ScriptRecorder::finish() {
  if (!path_) return;
  look(nullptr);
  workbench_.watch({});
  const Script made = script();
  const auto path = *std::exchange(path_, std::nullopt);
  editor_.script_recording.reset();
  if (const auto done = write_file_atomic(path, write_script(made)); !done)
    return editor_.notify(done.error());
  const std::string count = std::to_string(made.steps.size()), missing = std::to_string(made.left_out);
  if (made.left_out == 0) return editor_.inform({"The script is written. Its steps: {0}.", {count}});
  editor_.warn({"The script is written. Its steps: {0}; edits without a command, which it leaves out: {1}.",
                {count, missing}},
               "Its member \u201cnotes\u201d names them.");
}

Script ScriptRecorder::script() const {
  Script out;
  if (entries_.empty()) return out;
  if (!beginning_.empty()) out.notes.push_back(note_of_beginning(beginning_));
  for (std::size_t i = 0; i <= position_; ++i) {
    const Entry& entry = entries_[i];
    out.steps.insert(out.steps.end(), entry.steps.begin(), entry.steps.end());
    if (entry.left_out.empty()) continue;
    ++out.left_out;
    out.notes.push_back(note_of_missing(out.steps.size(), entry.left_out));
  }
  for (const std::string& file : files_) out.notes.push_back(file);
  return out;
}

void ScriptRecorder::after_command(const Command& command, bool ran) {
  if (!path_) return;
  const Place before = entries_[position_].place;
  look(&command);
  if (!ran) return;
  if (here() == before && (command.changes_document || command.needs_window)) begun_ = command.id;
  if (std::find(file_writers.begin(), file_writers.end(), command.id) == file_writers.end()) return;
  files_.push_back(note_of_file(script().steps.size(), command.label));
}

/// Takes up what has changed since the last look: by the command, or by fields, tools and work beside the
/// event loop.
void ScriptRecorder::look(const Command* command) {
  if (!path_) return;
  if (editor_.has_document && !(entries_[position_].place == here())) {
    const auto known =
        std::ranges::find_if(entries_, [&](const Entry& entry) { return entry.place == here(); });
    if (known != entries_.end())
      position_ = static_cast<std::size_t>(known - entries_.begin());  // undone or redone
    else
      take(command);
    show_progress();
  }
  window_ = circumstances_of(editor_);
}

/// Goes to the entry from which the last step was made: of numbers that were adjusted the one before these.
void ScriptRecorder::go_back_to_parent() {
  const History& history = editor_.history;
  if (history.position() == 0) return;
  const Place parent{editor_.documents, history.serial_at(history.position() - 1)};
  for (std::size_t i = 0; i < position_; ++i) {
    if (!(entries_[i].place == parent)) continue;
    window_ = entries_[i + 1].before;  // as for what it replaces
    position_ = i;
    return;
  }
}

void ScriptRecorder::take(const Command* command) {
  const bool opened = entries_[position_].place.documents != editor_.documents;
  if (!opened) go_back_to_parent();
  entries_.resize(position_ + 1);
  Entry entry{here(), editor_.history.current(), window_, {}, {}, entries_[position_].script};
  if (!first_that_does(opened ? opening_candidates() : candidates(command), entry)) leave_out(entry, command);
  entries_.push_back(std::move(entry));
  ++position_;
  begun_.clear();
}

void ScriptRecorder::leave_out(Entry& entry, const Command* command) {
  const std::string& label = editor_.history.undo_label();
  const bool back = command && command->id == "edit.undo";  // to before the beginning
  entry.left_out = back            ? command->label
                   : label.empty() ? fill(translatable("Open {0}"), {editor_.title()})
                                   : label;
  entry.script.selection.prune(entry.document);
  editor_.warn({"\u201c{0}\u201d has no command: the script leaves it out.",
                {editor_.language.phrase(entry.left_out)}});
}

/// Steps that may be the last edit, the likeliest first.
std::vector<ScriptRecorder::Steps> ScriptRecorder::candidates(const Command* command) const {
  std::vector<Steps> out;
  if (const auto told = editor_.told_script(); !told.empty()) out.emplace_back(told.begin(), told.end());
  const Command* used = command ? command : workbench_.commands().find(begun_);
  if (used && used->scriptable() && used->id != "edit.undo" && used->id != "edit.redo") {
    out.push_back({WrittenCommand{used->id}});
    // In the window a switch turns round what is.
    if (std::ranges::any_of(used->script.arguments,
                            [](const ArgumentSpec& spec) { return spec.name == "on"; }))
      for (const bool on : {true, false})
        out.push_back({WrittenCommand{used->id, {written_switch("on", on)}}});
  }
  for (Steps& steps :
       edit_guesses(entries_[position_].document, editor_.history.current(), workbench_.commands()))
    out.push_back(std::move(steps));
  return out;
}

/// Steps that may have opened the present document.
std::vector<ScriptRecorder::Steps> ScriptRecorder::opening_candidates() const {
  const Document& document = editor_.history.current();
  const std::string unit(enum_word(document.unit));
  std::vector<Steps> out;
  if (document.objects.empty()) out.push_back({WrittenCommand{"file.new", {written("unit", unit)}}});
  if (editor_.path)
    out.push_back({WrittenCommand{"file.open", {written("path", editor_.path->string())}}});
  else if (!document.objects.empty())
    out.push_back({WrittenCommand{"file.new_from_box"}});
  return out;
}

/// Takes the first of the candidates that does the edit; false where none does.
bool ScriptRecorder::first_that_does(const std::vector<Steps>& candidates, Entry& entry) {
  return std::ranges::any_of(candidates, [&](const Steps& steps) { return tried(steps, entry); });
}

/// Takes the steps for the entry where they make its document of the one before.
bool ScriptRecorder::tried(const Steps& steps, Entry& entry) {
  ScriptState from{std::nullopt, entry.script};
  Steps all;
  if (!opens(steps.front())) {
    from.document = entries_[position_].document;
    all = steps_to_set(entry.script, entry.before);
    if (!chooses(steps.front()))
      for (auto& step : steps_to_select(*from.document, entry.script, entry.before))
        all.push_back(std::move(step));
  }
  all.insert(all.end(), steps.begin(), steps.end());
  const auto reached = trial_.run(from, all);
  if (!reached || !reached->document || !(*reached->document == entry.document)) return false;
  entry.steps = std::move(all);
  entry.script = reached->circumstances;
  return true;
}

void ScriptRecorder::show_progress() {
  const Script now = script();
  editor_.script_recording = ScriptProgress{now.steps.size(), now.left_out};
}

}  // namespace hariko
