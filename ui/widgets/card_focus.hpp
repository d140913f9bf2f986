#pragma once

// CardFocus: the card or button of a page that the keyboard is at.

#include <imgui.h>

#include <string>
#include <vector>

#include "ui/base/key_chord.hpp"

namespace hariko {

class CardFocus {
 public:
  /// Arrows go to the neighbour on the screen, Tab and Shift+Tab to the next and the previous one, Home and
  /// End to the first and the last; Enter and the space bar choose. True when the key was one of these and
  /// had an effect.
  bool key(const KeyChord& chord);

  /// Round the drawing of the page, inside of its window.
  void begin();
  void end();
  /// Takes the last item of ImGui into the page, with a ring where the keyboard is at it. True when it is
  /// chosen by keys. `rounding`: of the ring's corners, pixels.
  bool item(const std::string& id, float rounding);

  const std::string& focused() const { return focused_; }
  /// Puts the keyboard at an item.
  void go_to(const std::string& id) { focused_ = id; }

 private:
  struct Placed {
    std::string id;
    ImVec2 low, high;
  };
  /// Its place among the items that were drawn last; their number where it is none of them.
  std::size_t place() const;
  std::size_t beside(std::size_t from, int step) const;    ///< in its row
  std::size_t in_row(std::size_t from, bool below) const;  ///< nearest of the next row
  void go(std::size_t to);

  std::vector<Placed> items_, drawn_;  ///< items of the last frame, and of this one
  std::string focused_;
  bool scroll_ = false;  ///< until it can be seen
  bool choose_ = false;
};

}  // namespace hariko
