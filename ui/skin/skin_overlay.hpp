#pragma once

// The sections, points and correspondence lines of the active skin over the picture.

#include "ui/base/marks.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

class SkinOverlay {
 public:
  /// Draws where the active object is a skin. `pointer`: in pixels, where nothing is being dragged: what is
  /// under it is lit. Marks, in the active view only: "skin.point.<id>", "skin.limit.<id>",
  /// "skin.path.<number>", "skin.rail.<number>" (of the second rail), "skin.place.<section>",
  /// "skin.diamond.<id>", "skin.mirror" (a corner of its plane).
  void draw(const Editor& editor, const Projector& projector, const ToolOverlay& overlay,
            const std::optional<Vector2>& pointer, Marks* marks);

 private:
  SkinViewCache cache_;
};

}  // namespace hariko
