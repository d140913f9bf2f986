#pragma once

// Preferences: what is chosen once for the program. A window beside the work: every change applies at once.

#include <optional>
#include <string>

#include "ui/widgets/panels.hpp"

namespace hariko {

/// The list of commands with their keys, which are recorded by pressing them.
class KeyPage {
 public:
  void draw(PanelContext& context);
  /// While a key is being recorded it comes here. True when it was taken.
  bool key(Editor& editor, const CommandTable& commands, const KeyChord& chord);
  void stop() { recording_.clear(); }

 private:
  void draw_row(PanelContext& context, const Command& command);
  void draw_conflict(PanelContext& context);
  /// Puts `wanted_` into the settings.
  void assign(Editor& editor, const CommandTable& commands);
  void record(const Command& command, std::size_t slot);

  std::string search_;
  std::string recording_;           ///< id of the command that waits for a key; empty for none
  std::size_t slot_ = 0;            ///< number of the key that is replaced; one past the last adds one
  std::optional<KeyChord> wanted_;  ///< pressed, but another command has it
};

class Preferences {
 public:
  enum class Page { interface, navigation, units, files, colours, keys };

  void open() { open_ = focus_ = true; }
  void open(Page page) {
    page_ = page;
    open();
  }
  bool is_open() const { return open_; }
  void close();
  bool key(Editor& editor, const CommandTable& commands, const KeyChord& chord) {
    return open_ && page_ == Page::keys && keys_.key(editor, commands, chord);
  }
  void draw(PanelContext& context, float top);

 private:
  void draw_pages(PanelContext& context);
  void draw_page(PanelContext& context);

  bool open_ = false, focus_ = false;
  Page page_ = Page::interface;
  KeyPage keys_;
};

}  // namespace hariko
