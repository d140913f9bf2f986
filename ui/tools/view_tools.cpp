// Orbit and pan: change the camera only, never the document.

#include "ui/tools/tool.hpp"

namespace hariko {

namespace {

constexpr double orbit_speed = 0.008;  ///< radians a pixel

class ViewTool : public Tool {
 public:
  void begin(ToolContext& context, const PointerEvent& press) override {
    before_ = context.editor.camera();
    last_ = press.pixel;
  }
  ToolState update(ToolContext& context, const PointerEvent& event) override {
    const Vector2 by = event.pixel - last_;
    last_ = event.pixel;
    if (by != Vector2::Zero()) context.editor.set_camera(moved(context.editor, by));
    return event.kind == PointerEvent::Kind::release ? ToolState::commit : ToolState::stay;
  }
  void cancel(ToolContext& context) override { context.editor.set_camera(before_); }

 private:
  virtual Camera moved(const Editor& editor, const Vector2& by) const = 0;
  Camera before_;
  Vector2 last_ = Vector2::Zero();
};

class OrbitTool final : public ViewTool {
 public:
  std::string hint(const Language& tr) const override { return tr("Orbit   Esc goes back"); }

 private:
  Camera moved(const Editor& editor, const Vector2& by) const override {
    return editor.camera().orbit(by.x() * orbit_speed, by.y() * orbit_speed);
  }
};

class PanTool final : public ViewTool {
 public:
  std::string hint(const Language& tr) const override { return tr("Pan   Esc goes back"); }

 private:
  Camera moved(const Editor& editor, const Vector2& by) const override {
    return editor.camera().pan(by.x(), by.y(), editor.viewport);
  }
};

}  // namespace

std::unique_ptr<Tool> make_orbit_tool() {
  return std::make_unique<OrbitTool>();
}
std::unique_ptr<Tool> make_pan_tool() {
  return std::make_unique<PanTool>();
}

}  // namespace hariko
