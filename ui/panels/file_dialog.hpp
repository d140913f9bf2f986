#pragma once

// FileDialog: an own browser on std::filesystem, the same on every desktop and testable by keys alone.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/panels/panels.hpp"

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
    std::function<void(const std::filesystem::path&)> options = {};
    std::function<int()> option_rows = [] { return 1; };  ///< how many rows these take
    /// When saving, a file that accepting this name would replace; without it the file of that name itself.
    std::function<std::optional<std::filesystem::path>(const std::filesystem::path&)> replaces = {};
    /// What the extensions mean, one each, to be chosen from a list: "PNG picture", ...; empty for no list.
    std::vector<std::string> formats = {};
  };

  void open(Request request);
  bool is_open() const { return open_; }
  void close() { open_ = false; }
  void draw(PanelContext& context);

 private:
  struct Entry {
    std::string name;
    bool folder = false;
    std::uintmax_t size = 0;
  };
  void go_to(const std::filesystem::path& folder);
  void list(PanelContext& context);
  void format_row(PanelContext& context);
  void footer(PanelContext& context);
  void submit(bool overwrite);
  bool matches(const std::filesystem::path& file) const;
  bool replaces_something(const std::filesystem::path& path);

  Request request_;
  bool open_ = false, appearing_ = false, ask_overwrite_ = false;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::string name_, error_;
  std::string replaced_;  ///< what the question about replacing names
};

}  // namespace hariko
