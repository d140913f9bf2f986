#include "app/application.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/assets_folder.hpp"
#include "app/crash_offers.hpp"
#include "app/crash_report.hpp"
#include "app/document_session.hpp"
#include "app/engines/gauss_engine.hpp"
#include "app/engines/mesh_previewer.hpp"
#include "app/engines/paper_engine.hpp"
#include "app/engines/rebuild_engine.hpp"
#include "app/engines/reference_loader.hpp"
#include "app/engines/surface_builder.hpp"
#include "app/input/frame_meter.hpp"
#include "app/input/replay.hpp"
#include "app/input/test_log.hpp"
#include "app/jobs/background_work.hpp"
#include "app/jobs/conversion_jobs.hpp"
#include "app/jobs/exchange_jobs.hpp"
#include "app/jobs/reference_jobs.hpp"
#include "app/jobs/skin_jobs.hpp"
#include "app/persistence/settings_file.hpp"
#include "app/pictures/pictures.hpp"
#include "app/pictures/sample_pictures.hpp"
#include "app/pictures/samples.hpp"
#include "app/scratch_folder.hpp"
#include "app/window/display_loss.hpp"
#include "app/window/failure_dialog.hpp"
#include "app/window/gl_window.hpp"
#include "app/window/interface_text.hpp"
#include "app/window/signal_watch.hpp"
#include "app/window/window_icons.hpp"
#include "core/document/format/format.hpp"
#include "ui/base/fonts.hpp"
#include "ui/base/system_information.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

namespace {

constexpr const char* no_assets = translatable(
    "Samples and languages were not found beside the program. Install Hariko again, or name their folder in "
    "the "
    "variable HARIKO_ASSETS.");

bool software_renderer() {
  return describe_gl().find("llvmpipe") != std::string::npos;
}

class Application final : private ApplicationServices {
 public:
  Application(GlWindow& window, Renderer renderer, const WindowOptions& options, std::optional<Replay> replay,
              SignalWatch& signals, const RunLog& run_log)
      : window_(window),
        signals_(signals),
        run_log_(run_log),
        renderer_(std::move(renderer)),
        log_(options.test_log),
        engine_([] { return std::make_unique<SurfaceBuilder>(); }, &GlWindow::wake,
                [this](ObjectId id, const SurfaceView& view) { log_.rebuilt(id, view); }),
        long_(editor_, &GlWindow::wake),
        edits_(editor_, &GlWindow::wake),
        meshes_(editor_, &GlWindow::wake, [this] { log_.file("meshed", {}); }),
        paper_(editor_, long_, &GlWindow::wake),
        skins_(editor_, long_, edits_, [this](const char* what, const auto& path) { happened(what, path); }),
        conversions_(editor_, long_, [this](const char* what, const auto& path) { happened(what, path); }),
        pictures_in_(editor_, long_, [this](const char* what, const auto& path) { happened(what, path); }),
        references_(editor_, &GlWindow::wake),
        workbench_(editor_, renderer_, software_renderer() ? 1 : 4, window.metrics(), *this),
        exchange_(editor_, workbench_, long_,
                  [this](const char* what, const auto& path) { happened(what, path); }),
        gauss_(editor_, editor_.gauss, &GlWindow::wake),
        session_(editor_, workbench_, folders_, assets_folder() / "samples",
                 {&GlWindow::wake, [this] { engine_.reset(); },
                  [this](const char* what, const auto& path) { happened(what, path); }}),
        crashes_(editor_, workbench_, folders_.state, run_log_),
        pictures_(renderer_, long_, folders_.cache / "thumbnails"),
        sample_pictures_(sample_pictures_folder(assets_folder()), workbench_.samples(), pictures_) {
    editor_.views = &engine_.views();
    editor_.on_notice = [this](Notice::Kind kind, const std::string& text) {
      if (kind != Notice::Kind::info) run_log_.line(kind == Notice::Kind::error ? "error" : "warning", text);
    };
    if (std::error_code unknown; !std::filesystem::is_directory(assets_folder(), unknown))
      editor_.notify(Notice::Kind::warning, editor_.language(no_assets));
    workbench_.samples() = find_samples(assets_folder());
    if (const char* missing = missing_fonts())
      editor_.notify(Notice::Kind::warning, editor_.language(missing));
    begin_replay(options, std::move(replay));
    // A replay must not depend on this user's settings and recovery files.
    if (!player_) load_settings();
    if (player_) settings_of_replay();
    const auto& files = player_ ? player_->replay().start.files : options.files;
    for (const auto& file : files) file == files.front() ? session_.open(file) : exchange_.import_file(file);
    if (!player_) {
      crashes_.find();
      session_.find_offers(pictures_);
    }
    watch_for_the_end();
  }
  ~Application() override {
    // Signals and a lost display must not reach a session that is being destroyed.
    signals_.set_action({});
    on_display_loss({});
  }
  Application(const Application&) = delete;
  Application& operator=(const Application&) = delete;

  /// Runs the event loop; returns the exit code.
  int run() {
    while (!quit_ && signal_ == 0) {
      begin_session();
      play();
      const bool opening = workbench_.field_opening();
      if (opening) frames_ = std::max(frames_, 1);
      if (window_.wait(wait_seconds(), opening)) {
        frames_ = frames_after_input;
        idle_ = false;
      }
      editor_.now = window_.now();
      follow_recording();
      if (recorder_) recorder_->batch(window_.input_time(), window_.input());
      log_.input(window_.input());
      if (engine_.publish() + paper_.publish() + long_.publish() + edits_.publish() + session_.publish() +
              meshes_.publish() + gauss_.publish() + references_.publish() >
          0) {
        frames_ = std::max(frames_, 2);
        idle_ = false;
      }
      take_input();
      session_.update();
      save_settings();
      const bool blinking = ImGui::GetIO().WantTextInput;
      // Cancelled work ends without a frame of its own; the log and replays wait for the idle state instead.
      const bool comes_to_rest = !idle_ && rests();
      if (frames_ <= 0 && !due() && !blinking && !comes_to_rest) continue;
      --frames_;
      frame();
    }
    if (recorder_) recorder_->finish(editor_.now, editor_.history.current(), editor_.history.position());
    if (recorder_ && !recorder_->ok())
      std::cerr << editor_.language("The replay is not whole: its file could not be written to the end.")
                << "\n";
    session_.update();
    signal_ == 0 ? session_.end() : session_.write_autosave();
    save_settings();
    if (signal_ != 0) return 128 + signal_;
    return player_ ? judge_replay() : 0;
  }

 private:
  /// Frames drawn after input: ImGui settles hovering and sizes over a few frames.
  static constexpr int frames_after_input = 3;

  /// Writes an event to both logs; events without a file are for tests only.
  void happened(const char* what, const std::filesystem::path& path) {
    log_.file(what, path);
    if (!path.empty()) run_log_.line(what, path.filename().string());
  }

  // Requests of the interface.
  void open(const std::filesystem::path& path) override { session_.open(path); }
  void import_file(const std::filesystem::path& path) override { exchange_.import_file(path); }
  void save(const std::filesystem::path& path, std::function<void()> then) override {
    session_.save(path, std::move(then));
  }
  void save_copy(const std::filesystem::path& path) override { session_.save_copy(path); }
  void revert() override { session_.revert(); }
  void recover(const std::string& id) override { session_.recover(id); }
  void discard_recovery(const std::string& id) override { session_.discard_recovery(id); }
  void dismiss_crash() override { crashes_.dismiss(); }
  void show_log_folder() override { crashes_.show_folder(); }
  void export_file(const std::filesystem::path& path, const ExportSettings& settings) override {
    exchange_.export_file(path, settings);
  }
  void count_export(const std::filesystem::path& path, const ExportSettings& settings) override {
    exchange_.count_export(path, settings);
  }
  void export_cad(const std::filesystem::path& path, const CadSettings& settings) override {
    exchange_.export_cad(path, settings);
  }
  void count_cad(const CadSettings& settings) override { exchange_.count_cad(settings); }
  void cancel_count() override { exchange_.cancel_count(); }
  void export_pictures(PictureOrder order) override { exchange_.export_pictures(std::move(order)); }
  void export_drawing(DrawingOrder order) override { exchange_.export_drawing(std::move(order)); }
  void export_control(const std::filesystem::path& path) override { skins_.export_control(path); }
  void export_pages(const std::filesystem::path& path) override { exchange_.export_pages(path); }
  void add_pictures(const std::vector<std::filesystem::path>& files) override { pictures_in_.add(files); }
  void pack_pictures(const std::vector<ObjectId>& pictures) override { pictures_in_.pack(pictures); }
  void unpack_picture(ObjectId picture, const std::filesystem::path& file) override {
    pictures_in_.unpack(picture, file);
  }
  void replace_picture(ObjectId picture, const std::filesystem::path& file) override {
    pictures_in_.replace(picture, file);
  }
  void find_pictures(const std::filesystem::path& file) override { pictures_in_.find(file); }
  void convert(ObjectId object) override { conversions_.convert(object); }
  void add_section(ObjectId skin, double place) override { skins_.add_section(skin, place); }
  void record(const std::filesystem::path& path) override { record_to_ = path; }
  void stop_recording() override { recording_ends_ = true; }
  void give_picture(Sample& sample) override { sample_pictures_.give(sample, editor_.settings.theme); }
  void quit() override { quit_ = true; }

  double wait_seconds() const {
    if (frames_ > 0) return 0;
    double seconds = player_ ? 0.005 : 1;
    const double next = workbench_.viewport().next_frame_in();
    if (next >= 0) seconds = std::min(seconds, next);
    if (ImGui::GetIO().WantTextInput) seconds = std::min(seconds, 0.25);
    if (editor_.notices_expire() || engine_.any_pending() || !editor_.jobs.empty() || editor_.meshing.job)
      seconds = std::min(seconds, 0.1);
    if (editor_.history.in_gesture()) seconds = std::min(seconds, RebuildEngine::rest_seconds / 2);
    if (const double autosave = session_.due_in(); autosave >= 0) seconds = std::min(seconds, autosave);
    return seconds;
  }

  /// Writes unsaved work when the program is ended from outside.
  void watch_for_the_end() {
    signals_.set_action([this](int signal) {
      session_.write_autosave();  // immediately: the main thread may be stuck
      signal_ = signal;
      GlWindow::wake();
    });
    on_display_loss([this] {
      session_.write_autosave();
      std::cerr << editor_.language(
                       "The display was lost. Unsaved work is kept: start Hariko again to recover it.")
                << "\n";
    });
  }

  void load_settings() {
    const auto loaded = settings_file_.load();
    editor_.settings = saved_settings_ = loaded.settings;
    workbench_.files().remember(loaded.exports);
    saved_exports_ = workbench_.files().remembered();
    for (const Message& problem : loaded.problems) editor_.notify(problem);
  }

  void save_settings() {
    // Not while a slider moves: every value would be written.
    if (player_ || ImGui::IsAnyMouseDown()) return;
    ExportMemory exports = workbench_.files().remembered();
    if (editor_.settings == saved_settings_ && exports == saved_exports_) return;
    saved_settings_ = editor_.settings;
    saved_exports_ = std::move(exports);
    if (auto saved = settings_file_.save(saved_settings_, saved_exports_); !saved)
      editor_.notify(saved.error());
  }

  /// Whether something changes with time alone.
  bool due() const {
    const double next = workbench_.viewport().next_frame_in();
    return next == 0 || editor_.notices_expire() || engine_.any_pending() || editor_.history.in_gesture() ||
           !editor_.jobs.empty() || editor_.meshing.job;
  }

  /// Whether nothing is left to do until input arrives.
  bool rests() const {
    return frames_ <= 0 && !due() && long_.idle() && edits_.idle() && paper_.idle() && session_.idle() &&
           meshes_.idle() && gauss_.idle() && references_.idle() &&
           workbench_.viewport().next_frame_in() < 0 && !session_waits_;
  }

  void take_input() {
    for (const KeyPress& press : window_.take_keys()) workbench_.key(press);
    std::vector<std::filesystem::path> pictures;
    for (const auto& path : window_.take_drops()) {
      if (is_reference_file(path))
        pictures.push_back(path);
      else if (path.extension() == ".hariko" || !editor_.has_document)
        workbench_.open_guarded(path);
      else
        exchange_.import_file(path);
    }
    pictures_in_.add(pictures);
    if (window_.take_close()) workbench_.quit();
  }

  void frame() {
    editor_.now = window_.now();
    editor_.stale_since.clear();
    for (const auto& [id, view] : engine_.views())
      if (engine_.pending(id)) editor_.stale_since[id] = engine_.pending_since(id);
    skins_.follow(engine_);
    if (!ImGui::IsAnyMouseDown()) skins_.settle();
    const Settings& settings = editor_.settings;
    if (window_.set_appearance(settings.theme, settings.interface_scale))
      frames_ = frames_after_input;  // sizes settle again
    if (std::exchange(pictured_theme_, settings.theme) != settings.theme) sample_pictures_.forget();
    text_.update(editor_, workbench_.offers(), window_);
    const auto start = std::chrono::steady_clock::now();
    const bool measured = editor_.frame_times.visible;
    window_.begin_frame();
    workbench_.frame();
    const GlWindow::FrameEnd end = window_.end_frame(measured);
    // Edits of this frame go to the worker immediately, so that the next frame may show their surface.
    Recompute& recompute = editor_.recompute;
    if (std::exchange(recompute.wants_cancel, false)) engine_.cancel_all();
    if (std::exchange(recompute.wants_now, false)) engine_.recompute_outdated();
    engine_.sync(editor_.document(), editor_.history.in_gesture(), editor_.now, recompute.policy,
                 editor_.view.map);
    meshes_.sync();
    gauss_.sync();
    references_.sync();
    const auto layout_before = editor_.paper.layout;
    paper_.sync();
    if (editor_.paper.layout != layout_before) frames_ = std::max(frames_, 2);
    if (auto outdated = engine_.outdated(); outdated != recompute.outdated) {
      recompute.outdated = std::move(outdated);
      frames_ = std::max(frames_, 1);
    }
    if (measured)
      meter_.measure(editor_, {start, end, workbench_.viewport().picture_milliseconds()}, window_.input(),
                     window_.now());
    const std::string title =
        editor_.has_document ? editor_.title() + " \u2014 Hariko" : std::string("Hariko");
    window_.set_title(title);
    if (std::exchange(first_, false)) log_.first_frame(workbench_);
    idle_ = rests();
    if (recorder_ && idle_) recorder_->idle(editor_.now);
    log_.frame(editor_, workbench_, idle_);
  }

  void begin_replay(const WindowOptions& options, std::optional<Replay> replay) {
    if (replay) player_.emplace(*std::move(replay), options.skip_pauses);
    editor_.recording = player_.has_value();
    if (!options.record.empty())
      record(options.record, {window_.width(), window_.height(), window_.monitor_scale(), options.files});
  }

  void record(const std::filesystem::path& path, const ReplayStart& start) {
    recorder_.emplace(path, start, window_.now());
    editor_.recording = recorder_->ok();
    if (recorder_->ok()) return;
    recorder_.reset();
    editor_.notify(Notice::Kind::error,
                   fill(editor_.language("{0} cannot be written: nothing is recorded."), {path.string()}));
  }

  /// Starts a requested recording before the next event, and ends a recording that has all events so far.
  void follow_recording() {
    if (const auto path = std::exchange(record_to_, std::nullopt); path && !recorder_) record_session(*path);
    if (!std::exchange(recording_ends_, false)) return;
    if (recorder_) {
      recorder_->finish(editor_.now, editor_.history.current(), editor_.history.position());
      const bool whole = recorder_->ok();
      recorder_.reset();
      log_.file("recorded", {});
      if (whole)
        editor_.notify(Notice::Kind::info, editor_.language("The replay is written."));
      else
        editor_.notify(
            Notice::Kind::error,
            editor_.language("The replay is not whole: its file could not be written to the end."));
    }
    editor_.end_recording();
  }

  /// Starts recording; the replay will begin with the document as it is now.
  void record_session(const std::filesystem::path& path) {
    const History& history = editor_.history;
    ReplayStart start{window_.width(), window_.height(), window_.monitor_scale(), {}};
    start.session = {write_document(history.current()),
                     editor_.path ? editor_.path->filename().string() : std::string(), history.dirty(),
                     settings_text(editor_.settings)};
    record(path, start);
    if (!recorder_) return;
    editor_.begin_recording();
    workbench_.forget_interface();
    engine_.reset();
    frames_ = frames_after_input;
    idle_ = false;
    // The replay waits until everything that it opened is shown.
    recorder_->idle(editor_.now);
    // Position of the pointer, for keys that come before it moves.
    InputEvent pointer;
    pointer.x = double(ImGui::GetIO().MousePos.x);
    pointer.y = double(ImGui::GetIO().MousePos.y);
    if (ImGui::IsMousePosValid()) recorder_->batch(editor_.now, {pointer});
    log_.file("recording", path);
  }

  void settings_of_replay() {
    const auto& session = player_->replay().start.session;
    if (!session) return;
    editor_.settings = saved_settings_ = settings_of(session->settings);
    session_waits_ = true;
  }

  /// Opens the initial document of a recorded session once the window has its sizes, so that views are framed
  /// as in the recording. The document's file is a scratch file of the replay.
  void begin_session() {
    if (!session_waits_ || frames_ > 0) return;
    session_waits_ = false;
    frames_ = frames_after_input;
    const ReplayStart::Session& session = *player_->replay().start.session;
    auto document = read_document(session.document);
    if (!document) return editor_.notify(document.error());
    std::optional<std::filesystem::path> file;
    if (!session.name.empty()) {
      scratch_.emplace();
      file = scratch_->path() / std::filesystem::path(session.name).filename();
    }
    editor_.open(std::move(document).value(), file);
    if (session.dirty) editor_.history.mark_unsaved();
  }

  /// Feeds the window with the replay's events that are due.
  void play() {
    if (!player_) return;
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - played_at_).count();
    played_at_ = now;
    const auto batch = player_->advance(seconds, idle_);
    window_.replay(player_->now(), batch);
    if (player_->finished() || player_->stuck()) quit_ = true;
  }

  int judge_replay() const {
    const auto wrong = [](const std::string& what) {
      std::cerr << "The replay ended otherwise than it was recorded: " << what << "\n";
      return 1;
    };
    if (player_->stuck()) return wrong("the program did not come to rest.");
    if (!player_->all_played()) return wrong("the program was left before the end.");
    const std::string hash = document_hash(editor_.history.current());
    if (hash != player_->replay().document_hash)
      return wrong("the document is another one (" + hash + " instead of " + player_->replay().document_hash +
                   ").");
    if (editor_.history.position() != player_->replay().undo_steps)
      return wrong("there are " + std::to_string(editor_.history.position()) + " steps to undo instead of " +
                   std::to_string(player_->replay().undo_steps) + ".");
    return 0;
  }

  GlWindow& window_;
  SignalWatch& signals_;
  const RunLog& run_log_;
  const XdgFolders folders_ = xdg_folders();
  SettingsFile settings_file_{folders_.config / "settings.json"};
  Settings saved_settings_;
  ExportMemory saved_exports_;
  Renderer renderer_;
  TestLog log_;
  InterfaceText text_{assets_folder() / "languages"};
  Editor editor_;
  RebuildEngine engine_;
  BackgroundWork long_;
  BackgroundWork edits_;  ///< edits made by a worker do not wait for files
  MeshPreviewer meshes_;
  PaperEngine paper_;
  SkinJobs skins_;
  ConversionJobs conversions_;
  ReferenceJobs pictures_in_;
  ReferenceLoader references_;
  Workbench workbench_;
  ExchangeJobs exchange_;
  GaussEngine gauss_;
  DocumentSession session_;
  CrashOffers crashes_;
  Pictures pictures_;
  SamplePictures sample_pictures_;
  int frames_ = frames_after_input;
  bool quit_ = false, idle_ = false;
  bool first_ = true;                       ///< no frame has been drawn yet
  ThemeId pictured_theme_ = ThemeId::dark;  ///< theme of the samples' pictures
  std::atomic<int> signal_ = 0;             ///< signal that asked to end
  FrameMeter meter_;
  std::optional<ReplayRecorder> recorder_;
  std::optional<std::filesystem::path> record_to_;  ///< file of a requested recording
  bool recording_ends_ = false;
  bool session_waits_ = false;            ///< the replay's initial document is not opened yet
  std::optional<ScratchFolder> scratch_;  ///< for a replay that saves files
  std::optional<ReplayPlayer> player_;
  std::chrono::steady_clock::time_point played_at_ = std::chrono::steady_clock::now();
};

int fail(const Message& error, const RunLog& run_log) {
  run_log.line("error", to_string(error));
  report_failure(error);
  return 1;
}

}  // namespace

int run_window(const WindowOptions& options) {
  SignalWatch signals;  // before the driver and the workers start their threads
  // A replay is not this user's work and leaves nothing behind.
  const bool user = options.replay.empty();
  const std::filesystem::path state = user ? xdg_folders().state : std::filesystem::path();
  const std::filesystem::path crash_file = CrashReports(state).own_file();
  const RunLog run_log(state);
  run_log.line("start", program_version() + ", " + to_string(options));
  if (user) keep_crash_reports(crash_file, program_version());
  std::optional<Replay> replay;
  GlWindow::Options size{"Hariko", options.width, options.height, options.scale};
  if (!user) {
    auto read = Replay::read(options.replay);
    if (!read.ok()) return fail(read.error(), run_log);
    replay = std::move(read).value();
    size = {"Hariko", replay->start.width, replay->start.height, replay->start.scale};
  }
  size.icons = window_icons(icons_folder(assets_folder()));
  auto window = GlWindow::open(size);
  if (!window.ok()) return fail(window.error(), run_log);
  auto renderer = Renderer::create();
  if (!renderer.ok()) return fail(renderer.error(), run_log);
  run_log.line("opengl", describe_gl());
  if (user) keep_crash_reports(crash_file, system_information());
  Application application(**window, std::move(renderer).value(), options, std::move(replay), signals,
                          run_log);
  const int exit_code = application.run();
  run_log.line("end", std::to_string(exit_code));
  return exit_code;
}

}  // namespace hariko
