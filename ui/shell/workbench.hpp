#pragma once

// Workbench: the whole interface of one window. Owns the panels' state, the commands and the dialogs.

#include <cstdint>
#include <functional>

#include "ui/editor/command_host.hpp"
#include "ui/files/file_dialogs.hpp"
#include "ui/outline/gauss_panel.hpp"
#include "ui/paper/paper_panel.hpp"
#include "ui/shell/cheat_sheet.hpp"
#include "ui/shell/command_palette.hpp"
#include "ui/shell/context_menu.hpp"
#include "ui/shell/keyboard_focus.hpp"
#include "ui/shell/offers_panel.hpp"
#include "ui/shell/preferences.hpp"
#include "ui/shell/start_page.hpp"
#include "ui/view/navigation.hpp"
#include "ui/view/viewport.hpp"
#include "ui/widgets/application_services.hpp"
#include "ui/widgets/command_services.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/widgets/prompt.hpp"

namespace hariko {

/// The command that was run or refused last, and how many there were.
struct CommandLog {
  std::uint64_t number = 0;
  std::pair<std::string, CommandTable::Outcome> last;
};

/// Is told what happens in a window, for recording. Each may be empty.
struct WorkWatch {
  std::function<void()> before_command;
  std::function<void(const Command&, const CommandTable::Outcome&)> after_command;
  std::function<void()> after_frame;
};

class Workbench final : public CommandServices {
 public:
  Workbench(Editor& editor, Renderer& renderer, int quick_samples, const Metrics& metrics,
            ApplicationServices& application);
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

  /// Draws everything, within an ImGui frame.
  void frame();
  /// A key that was pressed. Fields that take text keep theirs.
  void key(const KeyPress& press);
  /// The cap of a 3D mouse moves the active view; not while a question, a dialog or the palette is open.
  void cap(const CapMotion& motion);
  /// A button of a 3D mouse was pressed: 0 opens the palette, 1 frames everything. Others do nothing.
  void cap_button(int number);
  /// A field was asked for and gets the keyboard in a frame or two: keys are to wait for it.
  bool field_opening() const { return panel_state_.field_opening || editor_.rename_wanted; }

  const CommandTable& commands() const { return commands_; }
  const CommandLog& command_log() const { return command_log_; }
  /// From now on, in the place of whom was told before; not from within one of these functions.
  void watch(WorkWatch watch) { watch_ = std::move(watch); }
  const Viewport& viewport() const { return viewport_; }
  /// Text of the status line about the tool, the selection and the view.
  const std::string& status() const { return status_; }
  const Marks& marks() const { return marks_; }
  std::vector<Sample>& samples() { return samples_; }
  const std::vector<Sample>& samples() const { return samples_; }
  Offers& offers() { return offers_; }

  void ask(Prompt::Request request) override {
    editor_.show_text(request.title);
    editor_.show_text(request.text);
    prompt_.ask(std::move(request));
  }
  /// Question that is being asked; null when there is none.
  const Prompt::Request* question() const { return prompt_.question(); }
  /// Does something that replaces the document or ends the program, after asking about unsaved work.
  void guarded(std::function<void()> action);
  void open_guarded(const std::filesystem::path& path) override;
  /// Files that were dropped on the window: pictures are added, documents opened, and so is the first file on
  /// the start page; any other is imported.
  void take_files(const std::vector<std::filesystem::path>& files);
  void save(std::function<void()> then);
  void new_document();
  /// Shows what a session left that crashed, where the start page does not.
  void offer_recovery();
  void show_recent() { offers_dialog_.open(OffersDialog::Kind::recent); }
  void show_samples();
  void show_recoveries() { offers_dialog_.open(OffersDialog::Kind::recovery); }
  void show_palette() { palette_.open(); }
  void show_cheat_sheet() { cheat_sheet_.open(); }
  void show_context_menu() { context_menu_.open(editor_); }
  void show_preferences() { preferences_.open(); }
  void show_preferences(Preferences::Page page) { preferences_.open(page); }
  /// Brings a row of the properties into sight, and the keyboard to its field.
  void show_property(std::string id) {
    constexpr double patience = 1;  // seconds
    panel_state_.wanted_row = std::move(id);
    panel_state_.wanted_until = editor_.now + patience;
  }
  FileDialogs& files() { return files_; }
  const FileDialogs& files() const { return files_; }
  void export_pages() override { files_.export_pages(); }
  void export_sections() override { files_.export_sections(); }
  void add_picture() override { files_.add_picture(); }
  void replace_picture(ObjectId picture) override { files_.replace_picture(picture); }
  void unpack_picture(ObjectId picture) override { files_.unpack_picture(picture); }
  void find_pictures(const std::string& missing) override { files_.find_pictures(missing); }
  void choose_environment() override { files_.choose_environment(); }
  /// Panels as after the start of the program: closed or open by default, scrolled to their beginnings.
  void forget_interface();
  void close_document();
  /// Asks about unsaved work and about work on files that would be lost.
  void quit();

 private:
  /// State of the editor: its document, that of the history, and the number of operations made.
  struct State {
    std::uint64_t document = 0, serial = 0, operations = 0;
  };
  State state() const;
  bool made_a_step(const Command& command) const;
  void add_commands();
  void escape();
  /// F6, F10, letters of menus, and keys that go from item to item. True when the key is taken.
  bool navigation_key(const KeyChord& chord);
  /// A command chosen by its key: what it refuses is explained where the pointer is.
  void run_from_key(const Command& command);
  void explain_at_pointer(const std::string& text);
  /// Takes up the keys of the settings.
  void apply_keys();
  void layout(PanelContext& context, float menu);
  std::string status_note() const;
  void drag_border(const PanelRect& border);
  /// Between the list of objects, which begins at `top`, and the properties.
  void drag_list_end(const PanelRect& border, float top);

  Editor& editor_;
  Viewport viewport_;
  CapGesture cap_;
  const Metrics& metrics_;
  ApplicationServices& application_;
  CommandTable commands_;
  CommandHost host_;
  Marks marks_;
  PanelState panel_state_;
  std::vector<Sample> samples_;
  Offers offers_;
  StartPage start_page_;
  CommandPalette palette_;
  CheatSheet cheat_sheet_;
  ContextMenu context_menu_;
  Preferences preferences_;
  PaperPanel paper_panel_;
  GaussPanel gauss_panel_;
  float paper_split_ = 0.5F, gauss_split_ = 0.55F;  ///< beginnings of these, as a share of the views' width
  std::map<std::string, std::string> keys_in_use_;  ///< keys of the settings
  CommandLog command_log_;
  WorkWatch watch_;
  State found_;  ///< state when the last command began
  KeyboardFocus keyboard_;
  FileDialogs files_;
  OffersDialog offers_dialog_;
  Prompt prompt_;
  std::string status_;
};

}  // namespace hariko
