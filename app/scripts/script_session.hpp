#pragma once

// ScriptSession: the editor with its whole command table, without a window. Work that the window does beside
// its event loop is waited for.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/engines/paper_engine.hpp"
#include "app/engines/rebuild_engine.hpp"
#include "app/files/open_file.hpp"
#include "app/jobs/background_work.hpp"
#include "app/jobs/conversion_jobs.hpp"
#include "app/jobs/exchange_jobs.hpp"
#include "app/jobs/reference_jobs.hpp"
#include "app/jobs/skin_jobs.hpp"
#include "app/scripts/circumstances.hpp"
#include "render/renderer.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

inline constexpr Code e_script_step{"E_SCRIPT_STEP"};
inline constexpr Code w_script_unsaved{"W_SCRIPT_UNSAVED"};

/// Notice of a command.
struct ScriptNote {
  Notice::Kind kind = Notice::Kind::info;
  std::string text;  ///< English, of messages with their code
};

/// Begins without a document, in object mode: without names commands act on whole objects.
class ScriptSession final : private ApplicationServices {
 public:
  using OpenFile = std::function<OpenedFile(const std::filesystem::path&)>;
  /// `open_file`: reads documents and meshes.
  explicit ScriptSession(OpenFile open_file);
  ~ScriptSession() override = default;
  ScriptSession(const ScriptSession&) = delete;
  ScriptSession& operator=(const ScriptSession&) = delete;

  const CommandTable& commands() const { return workbench_.commands(); }
  Editor& editor() { return editor_; }
  const Editor& editor() const { return editor_; }

  /// Opens a file in the place of the document. Errors: E_SCRIPT_STEP with what the reading says.
  Result<Done> open_document(const std::filesystem::path& path);
  /// Runs a command, which may be refused whatever its arguments are, and waits for what it began. Errors:
  /// E_SCRIPT_STEP (what `why_not` or an error notice says, or the window is needed).
  Result<Done> run(const Command& command, const Arguments& arguments);
  /// Saves the document. Errors: E_SCRIPT_STEP where there is none, those of `save_document`.
  Result<Done> save_document_to(const std::filesystem::path& path);

  /// Notices since the last call, without errors.
  std::vector<ScriptNote> take_notes();
  /// Files that were written so far.
  const std::vector<std::filesystem::path>& written() const { return written_; }
  /// True where the document has changes that are in no file.
  bool unsaved() const { return editor_.has_document && editor_.history.dirty(); }

 private:
  // Requests of commands to the application.
  void open(const std::filesystem::path& path) override;
  void import_file(const std::filesystem::path& path) override;
  void save(const std::filesystem::path& path, std::function<void()> then) override;
  void save_copy(const std::filesystem::path& path) override;
  void revert() override;
  void export_file(const std::filesystem::path& path, const ExportSettings& settings) override;
  void export_cad(const std::filesystem::path& path, const CadSettings& settings) override;
  void export_control(const std::filesystem::path& path) override;
  void export_pages(const std::filesystem::path& path) override;
  void export_sections(SectionOrder order) override;
  void add_pictures(const std::vector<std::filesystem::path>& files) override;
  void pack_pictures(const std::vector<ObjectId>& pictures) override;
  void unpack_picture(ObjectId picture, const std::filesystem::path& file) override;
  void replace_picture(ObjectId picture, const std::filesystem::path& file) override;
  void convert(ObjectId object) override;
  void add_section(ObjectId skin, double place) override;
  // Requests of dialogs, panels and commands that need the window: asserted against.
  void drop_files(const std::vector<std::filesystem::path>& files) override;
  void recover(const std::string& id) override;
  void discard_recovery(const std::string& id) override;
  void dismiss_crash() override;
  void show_log_folder() override;
  void count_export(const std::filesystem::path& path, const ExportSettings& settings) override;
  void count_cad(const CadSettings& settings) override;
  void cancel_count() override;
  void export_pictures(PictureOrder order) override;
  void export_drawing(DrawingOrder order) override;
  void find_pictures(const std::filesystem::path& file) override;
  void record(const std::filesystem::path& path) override;
  void stop_recording() override;
  void record_script(const std::filesystem::path& path) override;
  void stop_script() override;
  void give_picture(Sample& sample) override;
  void quit() override;

  std::optional<OpenedFile> opened(const std::filesystem::path& path);
  void settle();
  void make_surfaces();
  void note(const char* what, const std::filesystem::path& path);
  std::optional<std::string> waits_for_hands() const;
  Result<Done> judge(std::size_t first) const;

  OpenFile open_file_;
  std::vector<ScriptNote> notes_;
  std::vector<std::filesystem::path> written_;
  Editor editor_;
  Renderer renderer_ = Renderer::undrawn();
  Metrics metrics_;
  std::unique_ptr<RebuildEngine> engine_;  ///< null before a command looks at surfaces
  std::uint64_t surfaced_ = 0;             ///< number of the document that the engine knows
  BackgroundWork files_, edits_;
  PaperEngine paper_;
  SkinJobs skins_;
  ConversionJobs conversions_;
  ReferenceJobs pictures_;
  Workbench workbench_;
  ExchangeJobs exchange_;
};

/// Document in which a script stands, with its circumstances.
struct ScriptState {
  std::optional<Document> document;  ///< nothing before the first one was opened
  Circumstances circumstances;
};

/// Runs steps as `hariko run` does, in a session of its own. For the main thread.
class ScriptTrial {
 public:
  explicit ScriptTrial(ScriptSession::OpenFile open_file) : open_file_(std::move(open_file)) {}

  /// State in which a script begins.
  ScriptState start();
  /// State after the steps; nothing where one of them is refused. Takes as long as they take.
  std::optional<ScriptState> run(const ScriptState& from, std::span<const WrittenCommand> steps);
  const CommandTable& commands() { return session().commands(); }

 private:
  ScriptSession& session();
  bool run_step(const WrittenCommand& step);

  ScriptSession::OpenFile open_file_;
  std::unique_ptr<ScriptSession> session_;
};

}  // namespace hariko
