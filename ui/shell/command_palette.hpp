#pragma once

// The command palette: everything the program can do, found by typing a few letters of it.

#include <string>
#include <vector>

#include "ui/widgets/panels.hpp"

namespace hariko {

class CommandPalette {
 public:
  void open();
  bool is_open() const { return open_; }
  void close() { open_ = false; }
  /// Up, Down, page keys and Enter; everything else goes into the text.
  void key(const KeyChord& chord);
  /// Draws it below the menu bar, and runs what was chosen.
  void draw(PanelContext& context, float top);

 private:
  /// A command, an object to go to, or a saved view.
  struct Row {
    const Command* command = nullptr;
    ObjectId object{};
    std::string view = {};  ///< name of a saved view
    std::string label, path, detail, keys;
    bool refused = false;  ///< `detail` is the reason
  };
  std::vector<Row> rows(const PanelContext& context) const;
  void draw_rows(PanelContext& context, const std::vector<Row>& rows);
  /// True when the row was clicked.
  bool draw_row(PanelContext& context, const Row& row, bool selected) const;
  void choose(PanelContext& context, const Row& row);

  bool open_ = false, focus_ = false, accept_ = false, scroll_ = false;
  std::string text_, pending_;  ///< the command to run when the palette is gone
  int selected_ = 0, step_ = 0;
  int row_count_ = 0;                ///< rows of the last frame, for the height of the window
  std::vector<std::string> recent_;  ///< ids of commands, latest first
};

}  // namespace hariko
