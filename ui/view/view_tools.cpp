// Orbit, pan and zoom by dragging, and the axis gizmo: change the camera only, never the document.

#include <cmath>

#include "ui/view/navigation.hpp"

namespace hariko {

namespace {

constexpr double orbit_speed = 0.008;  ///< radians a design pixel
constexpr double zoom_speed = 0.006;   ///< change of the distance's logarithm, a design pixel

class ViewTool : public Tool {
 public:
  void begin(ToolContext& context, const PointerEvent& press) override {
    before_ = context.editor.layout.active_view();
    press_ = press;
    last_ = press.pixel;
    prepare(context, press);
  }
  ToolState update(ToolContext& context, const PointerEvent& event) override {
    const Vector2 by = event.pixel - last_;
    last_ = event.pixel;
    if (by != Vector2::Zero()) context.editor.set_camera(moved(context, by));
    if (event.kind != PointerEvent::Kind::release) return ToolState::stay;
    // Alt with the left button turns the view, and a click selects: what lies behind, or an edge loop.
    const bool still = (event.pixel - press_.pixel).norm() <= drag_threshold * context.editor.pixel_scale;
    clicks_ = still && press_.alt && press_.button == PointerButton::left;
    if (clicks_) cancel(context);
    return ToolState::commit;
  }
  void cancel(ToolContext& context) override { context.editor.layout.active_view() = before_; }
  std::unique_ptr<Tool> successor() override { return clicks_ ? make_select_tool() : nullptr; }

 protected:
  virtual void prepare(ToolContext& context, const PointerEvent&) {
    context.editor.layout.active_view().remember();
  }

 private:
  virtual Camera moved(const ToolContext& context, const Vector2& by) = 0;
  View before_;
  PointerEvent press_;
  bool clicks_ = false;
  Vector2 last_ = Vector2::Zero();
};

class OrbitTool final : public ViewTool {
 public:
  std::string hint(const Language& tr) const override { return tr("Orbit   Esc goes back"); }

 private:
  void prepare(ToolContext& context, const PointerEvent&) override {
    Editor& editor = context.editor;
    pivot_ = editor.camera().target;
    if (editor.settings.orbit_selection)
      if (const Box3 box = editor.selected_box(); !box.isEmpty()) pivot_ = box.center();
  }
  Camera moved(const ToolContext& context, const Vector2& by) override {
    Editor& editor = context.editor;
    // Only now: a press alone changes nothing.
    if (!turning_) editor.layout.active_view().begin_turning(editor.now);
    turning_ = true;
    const Vector2 angles = by * (orbit_speed * editor.settings.orbit_speed / editor.pixel_scale);
    const Camera camera = editor.camera();
    return editor.settings.trackball ? camera.trackball(angles.x(), angles.y(), pivot_)
                                     : camera.orbit(angles.x(), angles.y(), pivot_);
  }
  Vector3 pivot_ = Vector3::Zero();
  bool turning_ = false;
};

class PanTool final : public ViewTool {
 public:
  std::string hint(const Language& tr) const override { return tr("Pan   Esc goes back"); }

 private:
  Camera moved(const ToolContext& context, const Vector2& by) override {
    return context.editor.camera().pan(by.x(), by.y(), context.editor.viewport);
  }
};

class ZoomTool final : public ViewTool {
 public:
  std::string hint(const Language& tr) const override { return tr("Zoom   up comes closer   Esc goes back"); }

 private:
  void prepare(ToolContext& context, const PointerEvent& press) override {
    ViewTool::prepare(context, press);
    at_ = press.pixel;
  }
  Camera moved(const ToolContext& context, const Vector2& by) override {
    const Editor& editor = context.editor;
    const double way = (by.y() - by.x()) * editor.settings.zoom_speed / editor.pixel_scale;
    return zoomed(context, std::exp(zoom_speed * way), at_);
  }
  Vector2 at_ = Vector2::Zero();
};

/// A click on a ball of the axis gizmo looks from there, dragging the gizmo orbits.
class AxisGizmoTool final : public Tool {
 public:
  explicit AxisGizmoTool(std::optional<StandardView> side) : side_(side) {}
  void begin(ToolContext&, const PointerEvent& press) override { press_ = press; }
  ToolState update(ToolContext& context, const PointerEvent& event) override {
    Editor& editor = context.editor;
    if (event.kind == PointerEvent::Kind::release) {
      if (side_) editor.layout.active_view().look_from(*side_, editor.now);
      return ToolState::commit;
    }
    drags_ = (event.pixel - press_.pixel).norm() > drag_threshold * editor.pixel_scale &&
             editor.layout.active_view().turns;
    return drags_ ? ToolState::commit : ToolState::stay;
  }
  void cancel(ToolContext&) override {}
  std::string hint(const Language& tr) const override {
    return tr("Click looks along the axis   drag orbits");
  }
  std::unique_ptr<Tool> successor() override { return drags_ ? make_orbit_tool() : nullptr; }

 private:
  std::optional<StandardView> side_;
  PointerEvent press_;
  bool drags_ = false;
};

}  // namespace

std::unique_ptr<Tool> make_orbit_tool() {
  return std::make_unique<OrbitTool>();
}
std::unique_ptr<Tool> make_pan_tool() {
  return std::make_unique<PanTool>();
}
std::unique_ptr<Tool> make_axis_gizmo_tool(std::optional<StandardView> side) {
  return std::make_unique<AxisGizmoTool>(side);
}

std::unique_ptr<Tool> make_navigation_tool(NavigationAction action) {
  switch (action) {
    case NavigationAction::orbit:
      return make_orbit_tool();
    case NavigationAction::pan:
      return make_pan_tool();
    case NavigationAction::zoom:
      return std::make_unique<ZoomTool>();
  }
  return nullptr;
}

}  // namespace hariko
