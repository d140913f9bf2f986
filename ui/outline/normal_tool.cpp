// Turning normals: the head of an arrow follows the pointer round the loop's tangent.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "ui/editor/outlines.hpp"
#include "ui/outline/outline_handles.hpp"
#include "ui/view/overlay_drawing.hpp"

namespace hariko {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double snap_step = 5 / degrees;

class NormalTool final : public Tool {
 public:
  NormalTool(ObjectId object, Index number) : object_(object), number_(number) {}

  void begin(ToolContext& context, const PointerEvent& press) override {
    pointer_ = press.pixel;
    press_ = press.pixel;
    Editor& editor = context.editor;
    const Object& object = *editor.document().find(object_);
    points_ = selected_points(editor, object);
    // An arrow beside the selection is turned alone.
    if (!points_.contains(number_)) points_ = {number_};
    place_ = place_of_point(object, number_);
    const Vector3 normal = place_.normal - place_.normal.dot(place_.tangent) * place_.tangent;
    start_ = normal.norm() > 1e-6 ? Vector3(normal.normalized()) : place_.tangent.unitOrthogonal();
    // What the pointer is beside the head when it takes it stays.
    if (const auto head = context.projector().project(tip(context, 0)))
      offset_ = press.pixel - head->head<2>();
  }

  ToolState update(ToolContext& context, const PointerEvent& event) override {
    pointer_ = event.pixel;
    if (event.kind == PointerEvent::Kind::release) {
      if (!moved_) {
        click(context, event);
        return ToolState::cancel;
      }
      context.editor.commit_preview(
          points_.size() == 1 ? std::string(translatable("Turn normal"))
                              : fill(translatable("Turn {0} normals"), {std::to_string(points_.size())}));
      return ToolState::commit;
    }
    if (!moved_ && (event.pixel - press_).norm() <= drag_threshold * context.editor.pixel_scale)
      return ToolState::stay;
    moved_ = true;
    turn_ = nearest_turn(context, event.pixel - offset_);
    if (event.control) turn_ = snap_step * std::round(turn_ / snap_step);
    context.editor.preview(edit_outline(
        context.editor.history.current(), object_,
        [&](const Outline& outline) -> Result<Outline> { return tilted(outline, points_, turn_); }));
    return ToolState::stay;
  }

  void cancel(ToolContext& context) override { context.editor.cancel_preview(); }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    if (!moved_) return;
    // The way of the head.
    const Projector projector = context.projector();
    std::optional<Vector2> last;
    for (int i = -48; i <= 48; ++i) {
      const auto at = projector.project(tip(context, i * std::numbers::pi / 48));
      if (at && last)
        overlay.list.AddLine(on_screen(overlay, *last), on_screen(overlay, at->head<2>()),
                             with_alpha(palette().text, 0.35F), overlay.metrics.px(1.2F));
      last = at ? std::optional<Vector2>(at->head<2>()) : std::nullopt;
    }
    draw_value_label(overlay, pointer_, value_text());
  }

  std::string hint(const Language& tr) const override {
    return value_text() + "   |   " + tr("Drag turns the normal   Ctrl: steps of 5 degrees   Esc cancels");
  }

 private:
  /// Where the head is when the normal has turned so far, in the document's space.
  Vector3 tip(const ToolContext& context, double turn) const {
    const double length = OutlineHandles::arrow_length * context.editor.pixel_scale *
                          context.projector().pixel_length_at(place_.point);
    return place_.point + length * (Eigen::AngleAxisd(turn, place_.tangent) * start_);
  }

  /// The turn with the head nearest to a pixel; of equally near ones, as where the circle is seen from the
  /// side, the one nearest to the present.
  double nearest_turn(const ToolContext& context, const Vector2& pixel) const {
    const Projector projector = context.projector();
    const auto cost = [&](double turn) {
      const auto at = projector.project(tip(context, turn));
      if (!at) return HUGE_VAL;
      const double change = std::abs(std::remainder(turn - turn_, 2 * std::numbers::pi));
      return (at->head<2>() - pixel).norm() + 3 * context.editor.pixel_scale * change;
    };
    constexpr int samples = 180;
    double best = turn_, least = cost(turn_);
    for (int i = 0; i < samples; ++i) {
      const double turn = turn_ + (2 * std::numbers::pi * i) / samples;
      if (const double here = cost(turn); here < least) {
        least = here;
        best = turn;
      }
    }
    for (double step = std::numbers::pi / samples; step > 1e-4; step /= 2)
      for (const double turn : {best - step, best + step})
        if (const double here = cost(turn); here < least) {
          least = here;
          best = turn;
        }
    return std::remainder(best, 2 * std::numbers::pi);
  }

  /// A press without a drag takes the point.
  void click(ToolContext& context, const PointerEvent& event) const {
    context.editor.mode = ElementMode::vertex;
    context.editor.selection.select({object_, element_of(VertexId{number_})},
                                    event.shift ? Selection::How::add : Selection::How::replace);
  }

  std::string value_text() const { return fixed_text(turn_ * degrees, 1) + "\u00b0"; }

  ObjectId object_;
  Index number_;
  std::set<Index> points_;
  OutlinePlace place_;
  Vector3 start_ = Vector3::UnitZ();  ///< the normal when the drag began, in the document's space
  Vector2 pointer_ = Vector2::Zero(), press_ = Vector2::Zero(), offset_ = Vector2::Zero();
  double turn_ = 0;
  bool moved_ = false;
};

}  // namespace

std::unique_ptr<Tool> make_normal_tool(ObjectId object, Index number) {
  return std::make_unique<NormalTool>(object, number);
}

}  // namespace hariko
