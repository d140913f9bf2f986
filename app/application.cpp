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
#include "app/crash_report.hpp"
#include "app/document_session.hpp"
#include "app/engines/environment_loader.hpp"
#include "app/engines/gauss_engine.hpp"
#include "app/engines/mesh_previewer.hpp"
#include "app/engines/paper_engine.hpp"
#include "app/engines/rebuild_engine.hpp"
#include "app/engines/reference_loader.hpp"
#include "app/engines/section_engine.hpp"
#include "app/engines/surface_builder.hpp"
#include "app/input/frame_meter.hpp"
#include "app/input/replay_session.hpp"
#include "app/input/space_mouse.hpp"
#include "app/input/test_log.hpp"
#include "app/jobs/background_work.hpp"
#include "app/jobs/conversion_jobs.hpp"
#include "app/jobs/edit_jobs.hpp"
#include "app/jobs/exchange_jobs.hpp"
#include "app/jobs/reference_jobs.hpp"
#include "app/jobs/skin_jobs.hpp"
#include "app/offers.hpp"
#include "app/persistence/settings_file.hpp"
#include "app/pictures/pictures.hpp"
#include "app/pictures/sample_pictures.hpp"
#include "app/pictures/samples.hpp"
#include "app/scripts/script_recorder.hpp"
#include "app/window/display_loss.hpp"
#include "app/window/failure_dialog.hpp"
#include "app/window/gl_window.hpp"
#include "app/window/interface_text.hpp"
#include "app/window/signal_watch.hpp"
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

/// Worker beside the event loop.
struct Publisher {
  std::function<std::size_t()> publish;  ///< applies finished results and returns their number
  std::function<bool()> idle;            ///< whether nothing waits, runs or is unpublished
};

template <class Worker>
Publisher publisher(Worker& worker) {
  return {[&worker] { return worker.publish(); }, [&worker] { return worker.idle(); }};
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
        skins_(editor_, edits_, [this](const char* what, const auto& path) { happened(what, path); }),
        conversions_(editor_, long_, [this](const char* what, const auto& path) { happened(what, path); }),
        pictures_in_(editor_, long_, [this](const char* what, const auto& path) { happened(what, path); }),
        references_(editor_, &GlWindow::wake),
        environments_(editor_, &GlWindow::wake),
        workbench_(editor_, renderer_, software_renderer() ? 1 : 4, window.metrics(), *this),
        exchange_(editor_, workbench_, long_,
                  [this](const char* what, const auto& path) { happened(what, path); }),
        gauss_(editor_, editor_.gauss, &GlWindow::wake),
        sections_(editor_, editor_.sections, &GlWindow::wake),
        session_(editor_, workbench_, folders_, assets_folder() / "samples",
                 {&GlWindow::wake, [this] { engine_.reset(); },
                  [this](const char* what, const auto& path) { happened(what, path); }}),
        crashes_(editor_, workbench_, folders_.state, run_log_),
        pictures_(renderer_, long_, folders_.cache / "thumbnails"),
        sample_pictures_(sample_pictures_folder(assets_folder()), workbench_.samples(), pictures_) {
    editor_.views = &engine_.views();
    editor_.on_long_edit = [this](const LongEdit& edit) { long_edits_.make(edit); };
    editor_.on_notice = [this](Notice::Kind kind, const std::string& text) {
      if (kind != Notice::Kind::info) run_log_.line(kind == Notice::Kind::error ? "error" : "warning", text);
    };
    if (std::error_code unknown; !std::filesystem::is_directory(assets_folder(), unknown))
      editor_.warn(no_assets);
    workbench_.samples() = find_samples(assets_folder());
    if (const char* missing = missing_fonts()) editor_.warn(missing);
    replay_.begin(options, std::move(replay));
    const Replay* played = replay_.replay();
    // A replay must not depend on this user's settings and recovery files.
    if (!played) load_settings();
    const auto& files = played ? played->start.files : options.files;
    for (const auto& file : files) file == files.front() ? session_.open(file) : import_file(file);
    if (!played) {
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
      if (replay_.open_document(frames_ <= 0)) frames_ = frames_after_input;
      if (replay_.play(idle_)) quit_ = true;
      window_.queue(space_mouse_.take());
      const bool opening = workbench_.field_opening();
      if (opening) frames_ = std::max(frames_, 1);
      if (window_.wait(wait_seconds(), opening)) {
        frames_ = frames_after_input;
        idle_ = false;
      }
      editor_.now = window_.now();
      if (replay_.follow_requests()) {
        frames_ = frames_after_input;
        idle_ = false;
      }
      replay_.record_input();
      log_.input(window_.input());
      std::size_t published = 0;
      for (const Publisher& one : publishers_) published += one.publish();
      if (published > 0) {
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
    replay_.end();
    scripts_.finish();
    session_.update();
    signal_ == 0 ? session_.end() : session_.write_autosave();
    save_settings();
    if (signal_ != 0) return 128 + signal_;
    return replay_.judge();
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
  void import_file(const std::filesystem::path& path) override {
    session_.when_opened([this, path] { exchange_.import_file(path); });
  }
  void drop_files(const std::vector<std::filesystem::path>& files) override { window_.drop(files); }
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
  void export_sections(SectionOrder order) override { exchange_.export_sections(std::move(order)); }
  void export_control(const std::filesystem::path& path) override { exchange_.export_control(path); }
  void export_pages(const std::filesystem::path& path) override { exchange_.export_pages(path); }
  void add_pictures(const std::vector<std::filesystem::path>& files) override {
    session_.when_opened([this, files] { pictures_in_.add(files); });
  }
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
  void record(const std::filesystem::path& path) override { replay_.record(path); }
  void stop_recording() override { replay_.stop(); }
  void record_script(const std::filesystem::path& path) override { scripts_.begin(path); }
  void stop_script() override { scripts_.finish(); }
  void give_picture(Sample& sample) override { sample_pictures_.give(sample, editor_.settings.theme); }
  void quit() override { quit_ = true; }

  double wait_seconds() const {
    if (frames_ > 0) return 0;
    double seconds = replay_.replay() ? 0.005 : 1;
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
    if (replay_.replay() || ImGui::IsAnyMouseDown()) return;
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
    return frames_ <= 0 && !due() &&
           std::ranges::all_of(publishers_, [](const Publisher& one) { return one.idle(); }) &&
           workbench_.viewport().next_frame_in() < 0 && !replay_.document_waits();
  }

  void take_input() {
    for (const KeyPress& press : window_.take_keys()) workbench_.key(press);
    for (const InputEvent& event : window_.take_caps()) {
      const auto& c = event.cap;
      if (event.kind == InputEvent::Kind::cap)
        workbench_.cap({{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, event.seconds});
      else if (event.down)
        workbench_.cap_button(event.code);
    }
    workbench_.take_files(window_.take_drops());
    if (window_.take_close()) workbench_.quit();
  }

  void frame() {
    editor_.now = window_.now();
    editor_.stale_since.clear();
    for (const auto& [id, view] : engine_.views())
      if (engine_.pending(id)) editor_.stale_since[id] = engine_.pending_since(id);
    skins_.follow(engine_);
    if (!ImGui::IsAnyMouseDown()) {
      skins_.settle();
      long_edits_.settle();
    }
    const Settings& settings = editor_.settings;
    if (window_.set_appearance(settings.theme, settings.interface_scale))
      frames_ = frames_after_input;  // sizes settle again
    if (std::exchange(pictured_theme_, settings.theme) != settings.theme) sample_pictures_.forget();
    text_.update(editor_, workbench_.offers(), window_);
    const auto start = std::chrono::steady_clock::now();
    const bool measured = editor_.frame_times.visible;
    window_.begin_frame();
    workbench_.frame();
    // Edits of this frame go to the worker before its picture goes to the screen, which may take until the
    // next refresh: the next frame can then show their surface.
    Recompute& recompute = editor_.recompute;
    if (std::exchange(recompute.wants_cancel, false)) engine_.cancel_all();
    if (std::exchange(recompute.wants_now, false)) engine_.recompute_outdated();
    engine_.sync(editor_.document(), editor_.history.in_gesture(), editor_.now, recompute.policy,
                 editor_.view.map);
    const GlWindow::FrameEnd end = window_.end_frame(measured);
    meshes_.sync();
    gauss_.sync();
    sections_.sync();
    references_.sync();
    environments_.sync();
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
    if (idle_) replay_.record_idle();
    log_.frame(editor_, workbench_, idle_);
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
  Editor editor_;
  InterfaceText text_{assets_folder() / "languages", editor_};
  RebuildEngine engine_;
  BackgroundWork long_;
  BackgroundWork edits_;  ///< edits made by a worker do not wait for files
  EditJobs long_edits_{editor_, edits_};
  MeshPreviewer meshes_;
  PaperEngine paper_;
  SkinJobs skins_;
  ConversionJobs conversions_;
  ReferenceJobs pictures_in_;
  ReferenceLoader references_;
  EnvironmentLoader environments_;
  Workbench workbench_;
  ExchangeJobs exchange_;
  GaussEngine gauss_;
  SectionEngine sections_;
  DocumentSession session_;
  CrashOffers crashes_;
  Pictures pictures_;
  SamplePictures sample_pictures_;
  /// In the order in which their results are applied.
  const std::vector<Publisher> publishers_{
      publisher(engine_),   publisher(paper_),       publisher(long_),  publisher(edits_),
      publisher(session_),  publisher(meshes_),      publisher(gauss_), publisher(references_),
      publisher(sections_), publisher(environments_)};
  int frames_ = frames_after_input;
  bool quit_ = false, idle_ = false;
  bool first_ = true;                       ///< no frame has been drawn yet
  ThemeId pictured_theme_ = ThemeId::dark;  ///< theme of the samples' pictures
  std::atomic<int> signal_ = 0;             ///< signal that asked to end
  FrameMeter meter_;
  ReplaySession replay_{editor_, workbench_, window_, engine_, log_};
  SpaceMouse space_mouse_{&GlWindow::wake};
  ScriptRecorder scripts_{editor_, workbench_,
                          [](const std::filesystem::path& path) { return open_file(path); }};
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
