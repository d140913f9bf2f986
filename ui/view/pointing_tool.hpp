#pragma once

// PointingTool: what modal tools share that find out what is under the pointer.

#include "ui/view/tool.hpp"

namespace hariko {

class PointingTool : public Tool {
 public:
  bool modal() const override { return true; }
  void begin(ToolContext& context, const PointerEvent& press) override {
    pointer_ = press.pixel;
    look(context);
  }

 protected:
  /// Finds what is under `pointer_`.
  virtual void look(const ToolContext& context) = 0;

  Vector2 pointer_ = Vector2::Zero();  ///< framebuffer pixels
};

}  // namespace hariko
