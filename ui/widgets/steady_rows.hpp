#pragma once

// SteadyRows: keeps the row under the hand where it is while rows above it come and go.

#include <string>

#include "ui/base/marks.hpp"

namespace hariko {

/// The scrolling of a panel that is worked in. The row that is typed into, or else the one under the pointer,
/// stays at its place on the screen: the panel scrolls, or gets empty space at an end, by as much as the rows
/// before it grew or shrank. As soon as the pointer has left and nothing is typed all is as usual.
class SteadyRows {
 public:
  /// Between ImGui::Begin of the panel and its first row.
  void begin();
  /// After its last row. `marks` of this frame say where rows are; `typed` is that of the field that has the
  /// keyboard, empty for none.
  void end(const Marks& marks, const std::string& typed);

 private:
  std::string row_;              ///< mark of the row that stays; empty for none
  float place_ = 0;              ///< place of the row, from the beginning of the panel's contents
  float above_ = 0, below_ = 0;  ///< empty space
  float scroll_ = 0;             ///< place that the panel is to scroll to
  int waits_ = 0;                ///< frames until it can have it: its new height counts from the next one on
  unsigned held_ = 0;            ///< ImGui id of the item that was active in the last frame
};

}  // namespace hariko
