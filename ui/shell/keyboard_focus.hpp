#pragma once

// KeyboardFocus: whether keys go from item to item of a menu, a dialog or a panel, or are commands of the
// views.

#include <string>

#include "ui/base/key_chord.hpp"

namespace hariko {

class KeyboardFocus {
 public:
  /// At the beginning and at the end of a frame of ImGui. `preferences`: whether that window is open, which
  /// is no popup.
  void begin_frame(bool preferences);
  void end_frame(bool preferences);

  /// Whether the keyboard goes from item to item: in menus, lists and dialogs, and in the panel that was
  /// chosen.
  bool navigates(bool preferences) const;
  /// A panel has the keyboard.
  bool in_panel() const { return !panel_.empty(); }
  /// Gives the keyboard to the next panel from above (`back`: the one before), or back to the views.
  void next_panel(bool back);
  void leave_panel();
  /// Takes the keys that go from item to item, while they do.
  bool item_key(const KeyChord& chord);

 private:
  bool activates_ = false;   ///< Enter was pressed on the item that the keyboard is on
  bool item_drawn_ = false;  ///< the item that the keyboard is on was there in the last frame
  std::string panel_;        ///< name of the window that has the keyboard; empty for the views
};

/// A field takes text, after the last frame. (io.WantTextInput is as old as the frame before that: a key that
/// follows a click at once would miss the field.)
bool text_field_active();

/// Closes every menu and list; Dear ImGui asserts that there is one to close.
void close_popups(bool restore_focus);

}  // namespace hariko
