#pragma once

// FileDialog: an own browser on std::filesystem, the same on every desktop and testable by keys alone.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/base/folder_list.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

class FileDialog {
 public:
  struct Request {
    std::string title;    ///< "Open"
    std::string action;   ///< text of the button: "Open"
    bool saving = false;  ///< a new name is fine, an existing file is asked about
    std::vector<std::string>
        extensions;                  ///< ".hariko", ...; the first is added to names without one when saving
    std::filesystem::path proposal;  ///< file or folder to begin with
    std::function<void(const std::filesystem::path&)> accept;
    /// Draws further settings above the buttons, for a file of the name typed so far.
    std::function<void(PanelContext&, const std::filesystem::path&)> options = {};
    /// File that accepting this name would replace when saving; without it the file of that name itself.
    std::function<std::optional<std::filesystem::path>(const std::filesystem::path&)> replaces = {};
  };

  void open(Request request);
  bool is_open() const { return open_; }
  void close() { open_ = false; }
  void draw(PanelContext& context);

 private:
  void go_to(const std::filesystem::path& folder);
  void draw_places(PanelContext& context, float width, float height);
  void draw_path(PanelContext& context);
  /// Heights that the list and the settings have below the path.
  struct Fit {
    bool folded = false;  ///< the settings stand in place of the list when they are asked for
    float height = 0;     ///< height of the list, or of what stands in its place
    bool header = true;   ///< the list has names of columns
  };
  Fit fit() const;
  bool has_settings() const;
  struct Columns {
    float name_end = 0, size_at = 0, date_at = 0;  ///< 0 where there is no room for it
  };
  static Columns columns(const Metrics& metrics, float width);
  void draw_header(PanelContext& context, const Columns& places);
  void draw_list(PanelContext& context, const Fit& room);
  void draw_entry(PanelContext& context, std::size_t number, const Columns& places);
  void draw_format(PanelContext& context);
  void draw_settings(PanelContext& context);
  void draw_name(PanelContext& context);
  void draw_footer(PanelContext& context, bool folded);
  void choose_format(std::size_t number);
  void make_folder(PanelContext& context);
  /// Goes in the list to what begins with the name as far as it is typed.
  void follow_typing();
  /// The entry that many rows further down becomes the name.
  void step(int by);
  void submit(bool overwrite);
  bool matches(const std::filesystem::path& file) const;
  bool replaces_something(const std::filesystem::path& path);

  Request request_;
  bool open_ = false, appearing_ = false, ask_overwrite_ = false;
  bool focus_name_ = false;          ///< the name gets the keyboard back
  std::optional<std::size_t> only_;  ///< the one extension whose files are shown when opening
  FolderOrder order_ = FolderOrder::name;
  bool descending_ = false, hidden_ = false;
  std::optional<std::string> new_folder_;         ///< its name while it is typed
  std::filesystem::path folder_, chosen_folder_;  ///< shown, and of the file that was accepted last
  std::vector<FolderEntry> entries_;
  std::optional<std::size_t> at_;  ///< the entry that the arrow keys are at
  bool scroll_ = false;
  std::vector<Place> places_;
  std::string name_;
  Phrase error_;  ///< reason why what is named cannot be opened or written; empty while nothing is wrong
  float footer_height_ = 0, settings_height_ = 0;  ///< heights when they were drawn last; 0 before
  bool settings_shown_ = false;                    ///< the designer opened the settings where they are folded
  std::string replaced_;                           ///< file that the question about replacing names
};

}  // namespace hariko
