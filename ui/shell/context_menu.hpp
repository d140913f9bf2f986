#pragma once

// The context menu: what can be done with what is under the pointer. Opens on a right press without a drag.

#include <optional>

#include "ui/widgets/panels.hpp"

namespace hariko {

class ContextMenu {
 public:
  /// Each frame after the viewport handled the pointer, with what was hovered and whether a tool ran before.
  /// A press on something that is not selected selects it.
  void watch(Editor& editor, const PanelRect& viewport, const std::optional<ElementRef>& hovered,
             bool tool_ran);
  /// Opens at the pointer, for the key.
  void open(const Editor& editor);
  void draw(PanelContext& context);

 private:
  bool armed_ = false, wanted_ = false;
  std::optional<ElementRef> pressed_, about_;
  ImVec2 at_{};
};

}  // namespace hariko
