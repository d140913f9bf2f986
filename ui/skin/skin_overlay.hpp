#pragma once

// The sections, points and correspondence lines of the active skin over the picture.

#include "ui/editor/skin_view.hpp"
#include "ui/view/view_layer.hpp"

namespace hariko {

class SkinOverlay final : public ViewLayer {
 public:
  std::optional<std::unique_ptr<Tool>> press(const ToolContext& context, const PointerEvent& press) override;
  /// Draws where the active object is a skin. Marks, in the active view only: "skin.point.<id>",
  /// "skin.limit.<id>", "skin.path.<number>", "skin.rail.<number>" (of the second rail),
  /// "skin.place.<section>", "skin.diamond.<id>", "skin.mirror" (a corner of its plane).
  void draw(const ToolContext& context, const LayerPane& pane) override;

 private:
  SkinViewCache cache_;
};

}  // namespace hariko
