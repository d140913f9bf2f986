#include "app/scripts/script_session.hpp"

#include <string_view>
#include <system_error>
#include <utility>

#include "app/engines/surface_builder.hpp"
#include "app/files/left_out.hpp"
#include "app/files/sheet_file.hpp"
#include "core/document/convert_unit.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/document/file.hpp"
#include "core/polyhedron/message_summary.hpp"
#include "ui/files/picture_order.hpp"

namespace hariko {

namespace {

namespace fs = std::filesystem;

/// Size of the views, which some commands look at.
constexpr PixelSize view_size{1280, 960};

Message failed_step(std::string text) {
  return make_error(e_script_step, std::move(text));
}

fs::path absolute_path(const fs::path& path) {
  std::error_code unknown;
  const fs::path absolute = fs::absolute(path, unknown);
  return (unknown ? path : absolute).lexically_normal();
}

void asked_without_window() {
  HARIKO_ASSERT(false, "a script cannot ask for this");
}

}  // namespace

ScriptSession::ScriptSession(OpenFile open_file)
    : open_file_(std::move(open_file)),
      files_(editor_, {}),
      edits_(editor_, {}),
      paper_(editor_, files_, {}),
      skins_(editor_, edits_, [this](const char* what, const fs::path& path) { note(what, path); }),
      conversions_(editor_, files_, [](const char*, const fs::path&) {}),
      pictures_(editor_, files_, [this](const char* what, const fs::path& path) { note(what, path); }),
      workbench_(editor_, renderer_, 1, metrics_, *this),
      exchange_(editor_, workbench_, files_,
                [this](const char* what, const fs::path& path) { note(what, path); }) {
  editor_.mode = ElementMode::object;
  editor_.viewport = view_size;
  editor_.on_notice = [this](Notice::Kind kind, const std::string& text) { notes_.push_back({kind, text}); };
}

// Running.

/// Waits until nothing that was begun is left.
void ScriptSession::settle() {
  std::size_t published = 0;
  do {
    paper_.sync();
    files_.wait();
    edits_.wait();
    paper_.wait();
    published = files_.publish() + edits_.publish() + paper_.publish();
    skins_.settle();
  } while (published > 0 || !files_.idle() || !edits_.idle() || !paper_.idle());
}

void ScriptSession::make_surfaces() {
  if (!engine_)
    engine_ = std::make_unique<RebuildEngine>([] { return std::make_unique<SurfaceBuilder>(); }, [] {});
  if (std::exchange(surfaced_, editor_.documents) != editor_.documents) engine_->reset();
  // Surfaces that follow others come after them.
  do {
    engine_->sync(editor_.document(), false, editor_.now);
    engine_->wait();
    engine_->publish();
  } while (engine_->any_pending());
  editor_.views = &engine_->views();
}

/// Sentence about a tool, dialog or question that a command left; nothing where it left none.
std::optional<std::string> ScriptSession::waits_for_hands() const {
  if (const Prompt::Request* question = workbench_.question())
    return "It asks something that only the window can answer: " + question->text;
  if (workbench_.viewport().tool_active() || workbench_.files().is_open())
    return std::string(needs_the_window);
  return {};
}

/// Fails with the errors among the notices from this one on.
Result<Done> ScriptSession::judge(std::size_t first) const {
  std::string errors;
  for (std::size_t i = first; i < notes_.size(); ++i)
    if (notes_[i].kind == Notice::Kind::error) errors += (errors.empty() ? "" : " ") + notes_[i].text;
  if (!errors.empty()) return failed_step(std::move(errors));
  return Done{};
}

Result<Done> ScriptSession::run(const Command& command, const Arguments& arguments) {
  const std::size_t said = notes_.size();
  if (command.script.looks_at_surfaces) make_surfaces();
  const CommandTable::Outcome outcome = commands().run_in_script(command, arguments);
  settle();
  editor_.views = nullptr;  // they are those of an earlier state from here on
  if (!outcome.ran) return failed_step(outcome.reason);
  if (const auto waits = waits_for_hands()) return failed_step(*waits);
  return judge(said);
}

Result<Done> ScriptSession::open_document(const fs::path& path) {
  const std::size_t said = notes_.size();
  open(path);
  return judge(said);
}

Result<Done> ScriptSession::save_document_to(const fs::path& path) {
  if (!editor_.has_document) return failed_step("There is no document to be saved.");
  const auto saved = save_document(editor_.history.current(), absolute_path(path));
  if (!saved) return saved.error();
  editor_.history.mark_saved();
  written_.push_back(path);
  return Done{};
}

std::vector<ScriptNote> ScriptSession::take_notes() {
  std::vector<ScriptNote> out = std::exchange(notes_, {});
  std::erase_if(out, [](const ScriptNote& note) { return note.kind == Notice::Kind::error; });
  return out;
}

/// Keeps the names of files that jobs wrote.
void ScriptSession::note(const char* what, const fs::path& path) {
  const std::string_view event = what;
  if (event.ends_with("exported") || event == "picture_unpacked") written_.push_back(path);
}

// Files.

/// The file, after its warnings were told; nothing, after its error.
std::optional<OpenedFile> ScriptSession::opened(const fs::path& path) {
  OpenedFile file = open_file_(absolute_path(path));
  for (const MessageSummary& summary : summarised(file.messages)) editor_.notify(one_message(summary));
  if (!file.document) return {};
  return file;
}

void ScriptSession::open(const fs::path& path) {
  if (unsaved())
    editor_.notify(make_warning(w_script_unsaved, "The document before had changes that no step saved.",
                                "Save it by file.save first."));
  auto file = opened(path);
  if (!file) return;
  editor_.open(*std::move(file->document), file->native ? std::optional(absolute_path(path)) : std::nullopt);
}

void ScriptSession::import_file(const fs::path& path) {
  const auto file = opened(path);
  if (!file) return;
  if (!editor_.has_document) editor_.open({}, {});
  const Document& before = editor_.history.current();
  // Sizes stay where the file says its unit, else numbers.
  const auto fitting =
      file->says_unit ? convert_unit(*file->document, before.unit) : Result<Document>(*file->document);
  if (!fitting) return editor_.notify(fitting.error());
  if (!editor_.commit(append_document(before, *fitting), "Import")) return;
  if (const auto left = left_out_of_import(*file->document)) editor_.notify(*left);
  editor_.selection.clear_elements();
  editor_.selection.clear_objects();
  // A document may bring saved views alone.
  if (!fitting->objects.empty()) editor_.selection.active = editor_.document().objects.back()->id;
}

void ScriptSession::save(const fs::path& path, std::function<void()> then) {
  if (const auto saved = save_document_to(path); !saved) return editor_.notify(saved.error());
  editor_.path = absolute_path(path);
  if (then) then();
}

void ScriptSession::save_copy(const fs::path& path) {
  const auto saved = save_document(editor_.history.current(), absolute_path(path));
  if (!saved) return editor_.notify(saved.error());
  written_.push_back(path);
}

void ScriptSession::revert() {
  if (editor_.commit(load_document(*editor_.path), translatable("Revert to the file")))
    editor_.history.mark_saved();
}

void ScriptSession::export_file(const fs::path& path, const ExportSettings& settings) {
  exchange_.export_file(path, settings);
}
void ScriptSession::export_cad(const fs::path& path, const CadSettings& settings) {
  exchange_.export_cad(path, settings);
}
void ScriptSession::export_control(const fs::path& path) {
  exchange_.export_control(path);
}
void ScriptSession::export_pages(const fs::path& path) {
  if (!sheet_format_of(path))
    return editor_.notify(make_error(e_argument,
                                     "The name of the pages must end in .pdf, .svg, .dxf, .png or .json.",
                                     "`hariko run --list` says what each command takes."));
  exchange_.export_pages(path);
}

void ScriptSession::export_sections(SectionOrder order) {
  exchange_.export_sections(std::move(order));
}

void ScriptSession::add_pictures(const std::vector<fs::path>& files) {
  pictures_.add(files);
}
void ScriptSession::pack_pictures(const std::vector<ObjectId>& pictures) {
  pictures_.pack(pictures);
}
void ScriptSession::unpack_picture(ObjectId picture, const fs::path& file) {
  pictures_.unpack(picture, file);
}
void ScriptSession::replace_picture(ObjectId picture, const fs::path& file) {
  pictures_.replace(picture, file);
}

void ScriptSession::convert(ObjectId object) {
  conversions_.convert(object);
}
void ScriptSession::add_section(ObjectId skin, double place) {
  skins_.add_section(skin, place);
}

// Requests that need a window.

void ScriptSession::drop_files(const std::vector<fs::path>&) {
  asked_without_window();
}
void ScriptSession::recover(const std::string&) {
  asked_without_window();
}
void ScriptSession::discard_recovery(const std::string&) {
  asked_without_window();
}
void ScriptSession::dismiss_crash() {
  asked_without_window();
}
void ScriptSession::show_log_folder() {
  asked_without_window();
}
void ScriptSession::count_export(const fs::path&, const ExportSettings&) {
  asked_without_window();
}
void ScriptSession::count_cad(const CadSettings&) {
  asked_without_window();
}
void ScriptSession::cancel_count() {
  asked_without_window();
}
void ScriptSession::export_pictures(PictureOrder) {
  asked_without_window();
}
void ScriptSession::export_drawing(DrawingOrder) {
  asked_without_window();
}
void ScriptSession::find_pictures(const fs::path&) {
  asked_without_window();
}
void ScriptSession::record(const fs::path&) {
  asked_without_window();
}
void ScriptSession::stop_recording() {
  asked_without_window();
}
void ScriptSession::record_script(const fs::path&) {
  asked_without_window();
}
void ScriptSession::stop_script() {
  asked_without_window();
}
void ScriptSession::give_picture(Sample&) {
  asked_without_window();
}
void ScriptSession::quit() {
  asked_without_window();
}

ScriptSession& ScriptTrial::session() {
  if (!session_) session_ = std::make_unique<ScriptSession>(open_file_);
  return *session_;
}

ScriptState ScriptTrial::start() {
  session_.reset();
  return {std::nullopt, circumstances_of(session().editor())};
}

std::optional<ScriptState> ScriptTrial::run(const ScriptState& from, std::span<const WrittenCommand> steps) {
  if (!from.document) session_.reset();  // a session cannot go back to before its first document
  Editor& editor = session().editor();
  if (from.document) editor.open(*from.document, std::nullopt);
  set_circumstances(editor, from.circumstances);
  for (const WrittenCommand& step : steps)
    if (!run_step(step)) {
      session_.reset();  // a tool or a question may be left of what failed
      return {};
    }
  session().take_notes();
  ScriptState out{std::nullopt, circumstances_of(editor)};
  if (editor.has_document) out.document = editor.history.current();
  return out;
}

bool ScriptTrial::run_step(const WrittenCommand& step) {
  const Command* command = session().commands().find(step.command);
  if (!command || !command->scriptable()) return false;
  const Editor& editor = session().editor();
  const Unit unit = editor.has_document ? editor.document().unit : editor.settings.unit;
  const auto arguments = read_arguments(command->script.arguments, step.arguments, unit);
  return arguments.ok() && session().run(*command, *arguments).ok();
}

}  // namespace hariko
