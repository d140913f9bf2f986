#pragma once

// Lists, menus and dialogs that open over a window, and their rows. Texts are in the language of the
// interface already; a mark is also the name of its item for ImGui.

#include <string>

#include "ui/base/marks.hpp"

namespace hariko {

/// Scope of what has opened: its rows are drawn in it, and it ends with it.
class OpenScope {
 public:
  OpenScope(bool open, void (*end)()) : open_(open), end_(end) {}
  ~OpenScope() {
    if (open_) end_();
  }
  OpenScope(const OpenScope&) = delete;
  OpenScope& operator=(const OpenScope&) = delete;
  explicit operator bool() const { return open_; }

 private:
  bool open_;
  void (*end_)();
};

/// A field that shows the present choice and opens a list of all. `width`: pixels; -1 for the rest of the
/// row.
[[nodiscard]] OpenScope list_scope(Marks& marks, const std::string& mark, const std::string& now, float width,
                                   ImGuiComboFlags flags = 0);
/// A menu of the bar, or one of another menu.
[[nodiscard]] OpenScope menu_scope(Marks& marks, const std::string& mark, const std::string& label);
/// A menu that ImGui::OpenPopup opens.
[[nodiscard]] OpenScope popup_scope(const std::string& id, ImGuiWindowFlags flags = 0);
/// The menu of the last item, which the right button opens.
[[nodiscard]] OpenScope item_menu_scope(const char* id = "menu");
/// A dialog in the middle of the window, which ImGui::OpenPopup opens.
[[nodiscard]] OpenScope dialog_scope(const std::string& title, ImGuiWindowFlags flags);
/// A table without lines whose columns share the width.
[[nodiscard]] OpenScope table_scope(const char* id, int columns);
/// Goes to the next cell of a table, from the last column to the next row.
void next_cell();

/// A row of a list. True when it was chosen. `size`: pixels; 0 for the rest of the row and for one line.
bool selectable_row(Marks& marks, const std::string& mark, const std::string& text, bool chosen,
                    ImVec2 size = {0, 0}, ImGuiSelectableFlags flags = 0);
/// A row of a menu. True when it was chosen.
bool menu_row(Marks& marks, const std::string& mark, const std::string& text, bool checked = false,
              bool enabled = true);

}  // namespace hariko
