// Waists: the middle of a bridge's curve follows the pointer, which changes the factor on its waist.

#include <algorithm>
#include <cmath>

#include "core/document/edit_solids.hpp"
#include "ui/tools/overlay_drawing.hpp"
#include "ui/tools/waist_handles.hpp"

namespace hariko {

namespace {

constexpr double least_factor = 0.05, largest_factor = 2, fine = 0.2;
constexpr double step = 0.05;  ///< of the waist, with Ctrl

class WaistTool final : public Tool {
 public:
  WaistTool(ObjectId object, const EnvelopeBridge& bridge) : object_(object), bridge_(bridge) {}

  void begin(ToolContext& context, const PointerEvent& press) override {
    press_ = press;
    pointer_ = press.pixel;
    const Object* object = context.editor.document().find(object_);
    if (!object || !object->solids()) return;
    const EnvelopeSettings& settings = object->solids()->input->settings;
    waist_ = settings.waist;
    start_ = factor_ = settings.waists.get_or(bridge_.solids, 1.0);
    const Projector projector = context.projector();
    const auto from = projector.project(object->transform.apply(bridge_.middle));
    const auto to = projector.project(object->transform.apply(Vector3(bridge_.middle + bridge_.way)));
    if (!from || !to) return;
    at_ = from->head<2>();
    way_ = to->head<2>() - from->head<2>();
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    pointer_ = event.pixel;
    if (event.kind == PointerEvent::Kind::release) {
      if (!moved_) {
        select(context.editor, event);
        return ToolState::cancel;
      }
      context.editor.commit_preview(translatable("Waist of bridge"));
      return ToolState::commit;
    }
    if (!moved_ && (event.pixel - press_.pixel).norm() <= drag_threshold * context.editor.pixel_scale)
      return ToolState::stay;
    moved_ = true;
    if (!(way_.squaredNorm() > 0)) return ToolState::stay;
    const double share = (event.pixel - press_.pixel).dot(way_) / way_.squaredNorm();
    factor_ = start_ + (event.shift ? fine : 1) * share;
    if (event.control) factor_ = step * std::round(factor_ * waist_ / step) / waist_;
    factor_ = std::clamp(factor_, least_factor, largest_factor);
    context.editor.preview(change_waist(context.editor.history.current(), object_, bridge_.solids, factor_));
    return ToolState::stay;
  }

  void cancel(ToolContext& context) override { context.editor.cancel_preview(); }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    if (!moved_) return;
    draw_waist_ring(overlay, at_ + (factor_ - start_) * way_, way_, true);
    draw_value_label(overlay, pointer_, value_text(context.editor.language));
  }

  std::string hint(const Language& tr) const override {
    return value_text(tr) + "   |   " + tr("Drag changes the waist   Shift fine   Ctrl steps   Esc cancels");
  }

 private:
  /// A press without a drag takes the two solids, whose properties hold the number.
  void select(Editor& editor, const PointerEvent& event) const {
    ElementSelection elements;
    elements.vertices = {VertexId{bridge_.solids.low}, VertexId{bridge_.solids.high}};
    editor.selection.select(object_, elements, event.shift ? Selection::How::add : Selection::How::replace);
    editor.selection.active = object_;
  }

  std::string value_text(const Language& tr) const {
    return std::string(tr("Waist")) + "  " + fixed_text(factor_ * waist_, 3);
  }

  ObjectId object_;
  EnvelopeBridge bridge_;  ///< when the drag began
  PointerEvent press_;
  Vector2 pointer_ = Vector2::Zero(), at_ = Vector2::Zero();
  Vector2 way_ = Vector2::Zero();  ///< pixels for a factor that grows by one
  double waist_ = 0.5, start_ = 1, factor_ = 1;
  bool moved_ = false;
};

}  // namespace

std::unique_ptr<Tool> make_waist_tool(ObjectId object, const EnvelopeBridge& bridge) {
  return std::make_unique<WaistTool>(object, bridge);
}

}  // namespace hariko
