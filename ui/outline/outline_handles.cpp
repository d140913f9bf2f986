#include "ui/outline/outline_handles.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "ui/editor/outlines.hpp"
#include "ui/view/overlay_drawing.hpp"

namespace hariko {

namespace {

/// Beyond this many points arrows would cover the model and cost more than a frame.
constexpr std::size_t most_arrows = 600;
/// A head nearer to its point than this, in design pixels, cannot be taken.
constexpr double least_arrow = 12;

}  // namespace

void OutlineHandles::update(const ToolContext& context, bool /*tool_runs*/) {
  const Editor& editor = context.editor;
  arrows_.clear();
  const Object* object = active_outline(editor);
  if (!object || !object->visible || !object->display.polyhedron || editor.view.surfaces_only ||
      editor.paper.covers_model())
    return;
  const std::size_t count = object->outline()->outline->point_count();
  if (count > most_arrows) return;
  const Projector projector(editor.camera(), editor.viewport);
  const std::set<Index> selected = selected_points(editor, *object);
  const SurfaceView* view = editor.view_of(object->id);
  for (Index i = 0; i < count; ++i) {
    const OutlinePlace place = place_of_point(*object, i);
    const double length = arrow_length * editor.pixel_scale * projector.pixel_length_at(place.point);
    const auto from = projector.project(place.point),
               to = projector.project(place.point + length * place.normal);
    Arrow arrow;
    arrow.seen = from && to;
    if (arrow.seen) {
      arrow.from = from->head<2>();
      arrow.to = to->head<2>();
    }
    arrow.selected = selected.contains(i);
    arrow.wrong = view && view->error && view->error->element == element_of(VertexId{i});
    arrows_.push_back(arrow);
  }
}

std::optional<Index> OutlineHandles::hit(const Vector2& pixel) const {
  std::optional<Index> best;
  const double scale = ImGui::GetIO().DisplayFramebufferScale.x;
  double least = hit_radius * scale;
  for (Index i = 0; i < arrows_.size(); ++i) {
    const Arrow& arrow = arrows_[i];
    if (!arrow.seen || (arrow.to - arrow.from).norm() < least_arrow * scale) continue;
    const double distance = (arrow.to - pixel).norm();
    if (distance > least) continue;
    least = distance;
    best = i;
  }
  return best;
}

bool OutlineHandles::hover(const ToolContext&, const Vector2& pixel) {
  hot_ = hit(pixel);
  return hot_.has_value();
}

std::optional<std::unique_ptr<Tool>> OutlineHandles::press(const ToolContext& context,
                                                           const PointerEvent& press) {
  const auto arrow = press.plain_left() ? hit(press.pixel) : std::nullopt;
  if (!arrow) return {};
  return make_normal_tool(context.editor.selection.active, *arrow);
}

const char* OutlineHandles::hint() const {
  return hot_ ? translatable("Drag turns the normal   click selects the point") : nullptr;
}

void OutlineHandles::draw(const ToolContext&, const LayerPane& pane) {
  if (!pane.active) return;
  const ToolOverlay& overlay = pane.overlay;
  const Metrics& m = overlay.metrics;
  for (Index i = 0; i < arrows_.size(); ++i) {
    const Arrow& arrow = arrows_[i];
    if (!arrow.seen) continue;
    const bool is_hot = hot_ == i;
    const ImU32 colour = arrow.wrong      ? palette().error
                         : is_hot         ? palette().hot
                         : arrow.selected ? palette().accent
                                          : with_alpha(palette().secondary, 0.85F);
    const ImVec2 from = on_screen(overlay, arrow.from), to = on_screen(overlay, arrow.to);
    overlay.list.AddLine(from, to, with_alpha(palette().window, 0.55F), m.px(is_hot ? 4.5F : 3.2F));
    overlay.list.AddLine(from, to, colour, m.px(is_hot ? 2.6F : 1.5F));
    const float radius = m.px(is_hot || arrow.selected ? 4.5F : 3.4F);
    overlay.list.AddCircleFilled(to, radius + m.px(1), with_alpha(palette().window, 0.7F));
    overlay.list.AddCircleFilled(to, radius, colour);
    if (arrow.wrong) overlay.list.AddCircle(from, m.px(8), palette().error, 0, m.px(2));
  }
  mark(pane.marks, overlay);
}

void OutlineHandles::mark(Marks& marks, const ToolOverlay& overlay) const {
  for (Index i = 0; i < arrows_.size(); ++i) {
    if (!arrows_[i].seen) continue;
    const auto name = [&](const char* kind, const Vector2& pixel) {
      const ImVec2 at = on_screen(overlay, pixel);
      marks.rect(std::string("outline.") + kind + "." + std::to_string(i), {at.x - 2, at.y - 2},
                 {at.x + 2, at.y + 2});
    };
    name("point", arrows_[i].from);
    name("normal", arrows_[i].to);
  }
}

// Turning normals: the head of an arrow follows the pointer round the loop's tangent.

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
    // The pointer's distance from the head when it takes it stays.
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
          Phrase::counted(points_.size(), translatable("Turn normal"), translatable("Turn {0} normals")));
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

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    if (!moved_) return;
    // The way of the head.
    std::vector<Vector3> way;
    for (int i = -48; i <= 48; ++i) way.push_back(tip(context, i * std::numbers::pi / 48));
    draw_polyline(overlay, context.projector(), way, with_alpha(palette().text, 0.35F), 1.2F);
    draw_value_label(overlay, pointer_, value_text());
  }

  std::string hint(const Language& tr) const override {
    return value_text() + "   |   " + tr("Drag turns the normal   Ctrl: steps of 5 degrees   Esc cancels");
  }

 private:
  /// Head of the arrow when the normal has turned so far, in the document's space.
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
