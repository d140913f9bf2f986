#pragma once

// Workbench: the whole interface of one window. Owns the panels' state, the commands and the dialogs.

#include <functional>
#include <memory>

#include "ui/commands/command_host.hpp"
#include "ui/panels/cad_options.hpp"
#include "ui/panels/cheat_sheet.hpp"
#include "ui/panels/command_palette.hpp"
#include "ui/panels/context_menu.hpp"
#include "ui/panels/export_options.hpp"
#include "ui/panels/file_dialog.hpp"
#include "ui/panels/gauss_panel.hpp"
#include "ui/panels/offers_panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/paper_panel.hpp"
#include "ui/panels/picture_options.hpp"
#include "ui/panels/preferences.hpp"
#include "ui/panels/prompt.hpp"
#include "ui/picture_order.hpp"
#include "ui/viewport.hpp"

namespace hariko {

/// Work on files and other work that takes long, done by the application. None of these blocks.
struct FileActions {
  std::function<void(const std::filesystem::path&)> open;         ///< replaces the document
  std::function<void(const std::filesystem::path&)> import_file;  ///< adds to the document
  /// Saves the committed document; `then` runs after success.
  std::function<void(const std::filesystem::path&, std::function<void()> then)> save;
  std::function<void(const std::filesystem::path&)> save_copy;
  std::function<void()> revert;  ///< to what the file holds
  std::function<void(const std::filesystem::path&, const ExportSettings&)> export_file;
  /// Finds out what the triangles would be like; ends in `Workbench::take_export_count`. Only the last one
  /// asked for counts.
  std::function<void(const ExportSettings&)> count_export;
  /// The same of faces, and `Workbench::take_cad_count`.
  std::function<void(const CadSettings&)> count_cad;
  std::function<void()> cancel_count;  ///< of either
  std::function<void(const std::filesystem::path&, const CadSettings&)> export_cad;
  std::function<void(PictureOrder)> export_pictures;
  std::function<void(DrawingOrder)> export_drawing;
  /// Writes the control meshes of the visible skins.
  std::function<void(const std::filesystem::path&)> export_control;
  /// Makes a polyhedron of a skin, which is hidden then. Only the last one asked for counts.
  std::function<void(ObjectId)> convert_skin;
  /// Adds a section to a skin, at a place of its path: a step when it is there.
  std::function<void(ObjectId, double place)> add_section;
  /// Writes the pages of the paper model that is shown.
  std::function<void(const std::filesystem::path&)> export_pages;
  /// Opens work that an earlier session left behind, or throws it away.
  std::function<void(const std::string&id)> recover, discard_recovery;
  /// Records what the user does from now on as a replay, until it is told to stop.
  std::function<void(const std::filesystem::path&)> record;
  std::function<void()> stop_recording;
  std::function<void()> picture_samples;  ///< gives the samples their pictures where they have none
  std::function<void()> quit;             ///< at once
};

/// The command that was run or refused last, and how many there were.
struct CommandLog {
  std::uint64_t number = 0;
  std::pair<std::string, CommandTable::Outcome> last;
};

class Workbench {
 public:
  Workbench(Editor& editor, Renderer& renderer, int quick_samples, const Metrics& metrics,
            FileActions actions);
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

  /// Draws everything, within an ImGui frame.
  void frame();
  /// A key that was pressed. Fields that take text keep theirs.
  void key(const KeyPress& press);
  /// A field was asked for and gets the keyboard in a frame or two: keys are to wait for it.
  bool field_opening() const { return panel_state_.field_opening || editor_.rename_wanted; }

  const CommandTable& commands() const { return commands_; }
  const CommandLog& command_log() const { return command_log_; }
  const Viewport& viewport() const { return viewport_; }
  const Marks& marks() const { return marks_; }
  /// The Gauss sphere: the application fills it while it is shown.
  GaussView& gauss() { return gauss_; }
  std::vector<Sample>& samples() { return samples_; }
  Offers& offers() { return offers_; }

  /// Asks something that cannot be undone.
  void ask(Prompt::Request request) { prompt_.ask(std::move(request)); }
  /// What is being asked; null when nothing is.
  const Prompt::Request* question() const { return prompt_.question(); }
  /// Does something that replaces the document or ends the program, after asking about unsaved work.
  void guarded(std::function<void()> action);
  /// Opens a file, whatever kind it is, after asking about unsaved work.
  void open_guarded(const std::filesystem::path& path);
  void save(std::function<void()> then);
  void save_as(std::function<void()> then);
  void save_copy();
  void new_document();
  void revert() { actions_.revert(); }
  /// Shows what can be recovered, where the start page does not.
  void offer_recovery();
  void show_recent() { offers_dialog_.open(OffersDialog::Kind::recent); }
  void show_samples();
  void show_recoveries() { offers_dialog_.open(OffersDialog::Kind::recovery); }
  void show_palette() { palette_.open(); }
  void show_cheat_sheet() { cheat_sheet_.open(); }
  void show_context_menu() { context_menu_.open(editor_); }
  void show_preferences() { preferences_.open(); }
  void show_open_dialog();
  void show_import_dialog();
  void show_export_dialog();
  void show_cad_dialog();
  void take_export_count(const ExportSettings& settings, const Result<ExportCount>& count) {
    export_options_.take(settings, count);
  }
  void take_cad_count(const CadSettings& settings, const Result<CadTotals>& count) {
    cad_options_.take(settings, count);
  }
  /// What was chosen in the dialogs that export, and what they begin with.
  ExportMemory exports() const { return {export_options_.remembered(), cad_options_.settings().choices}; }
  void remember(ExportMemory exports) {
    export_options_.remember(std::move(exports.formats));
    cad_options_.remember(exports.cad);
  }
  /// For the control meshes of skins.
  void show_control_export();
  void convert_skin(ObjectId object) { actions_.convert_skin(object); }
  void add_section(ObjectId object, double place) { actions_.add_section(object, place); }
  void show_key_export();
  void show_key_import();
  /// Of the active view: one picture or line drawing, or a series that turns round the model.
  void show_picture_dialog(bool turntable);
  void show_record_dialog();
  /// For the pages of the paper model.
  void show_sheet_dialog();
  void stop_recording() { actions_.stop_recording(); }
  /// Panels as after the start of the program: closed or open by default, scrolled to their beginnings.
  void forget_interface();
  void close_document();
  /// Asks about unsaved work and about work on files that would be lost.
  void quit();

 private:
  void add_commands();
  void escape();
  /// A command chosen by its key: what it refuses is explained where the pointer is.
  void run_from_key(const Command& command);
  void explain_at_pointer(const std::string& text);
  /// Takes up the keys of the settings.
  void apply_keys();
  void layout(PanelContext& context, float menu);
  void drag_border(const PanelRect& border);
  void export_picture(const std::filesystem::path& path, bool turntable);
  std::filesystem::path folder_proposal() const;
  std::filesystem::path name_proposal() const;

  Editor& editor_;
  Viewport viewport_;
  const Metrics& metrics_;
  FileActions actions_;
  CommandTable commands_;
  CommandHost host_;
  Marks marks_;
  PanelState panel_state_;
  std::vector<Sample> samples_;
  Offers offers_;
  CommandPalette palette_;
  CheatSheet cheat_sheet_;
  ContextMenu context_menu_;
  Preferences preferences_;
  PaperPanel paper_panel_;
  GaussPanel gauss_panel_;
  GaussView gauss_;
  float paper_split_ = 0.5F, gauss_split_ = 0.55F;  ///< where these begin, of the width of the views
  std::map<std::string, std::string> keys_in_use_;  ///< of the settings
  CommandLog command_log_;
  FileDialog dialog_;
  bool counting_ = false;  ///< something may be counted for the dialog
  OffersDialog offers_dialog_;
  Prompt prompt_;
  ExportOptions export_options_;
  CadOptions cad_options_;
  PictureSettings picture_settings_;
  DrawingOptions drawing_options_;
  std::string picture_ending_ = ".png";  ///< of the last picture
};

}  // namespace hariko
