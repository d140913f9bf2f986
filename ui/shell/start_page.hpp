#pragma once

// The start page: ways to begin, work to recover, recent files and samples.

#include "ui/widgets/card_focus.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

class StartPage {
 public:
  /// Arrows, Tab, Enter and the space bar choose among what is shown. True when the key was taken.
  bool key(const KeyChord& chord) { return focus_.key(chord); }
  void draw(PanelContext& context, const PanelRect& rect);
  const std::string& focused() const { return focus_.focused(); }

 private:
  CardFocus focus_;
};

}  // namespace hariko
