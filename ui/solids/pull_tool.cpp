#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/document/edits/edit_solids.hpp"
#include "core/envelope/solid_shape.hpp"
#include "ui/solids/new_solids.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

namespace {

constexpr double handle_radius = 10;  ///< design pixels
constexpr double usual_radius = 0.3;  ///< radius of a new pull, relative to its solid's diagonal
constexpr double wheel_factor = 1.1;
/// Limits of the radius, relative to the solid's diagonal.
constexpr double least_radius = 0.01, most_radius = 4;

/// Number of the handle nearest to a pixel, if it is within the radius (design pixels). Handles have their
/// place as `at`.
template <class Handles>
std::optional<std::size_t> nearest_handle(const Handles& handles, const Vector2& pixel, double radius) {
  std::optional<std::size_t> best;
  double least = radius * double(ImGui::GetIO().DisplayFramebufferScale.x);
  for (std::size_t i = 0; i < handles.size(); ++i)
    if (const double distance = (handles[i].at - pixel).norm(); distance <= least) {
      least = distance;
      best = i;
    }
  return best;
}

/// Pull of a solid, which may have to be made.
struct GrabbedPull {
  std::uint32_t solid = 0;
  std::size_t index = 0;  ///< among the solid's pulls; their number for a new one
  double radius = 1;
  double diagonal = 1;             ///< the solid's
  Vector3 from = Vector3::Zero();  ///< point that was grabbed, in the document's space
  bool fresh = false;
};

/// Place of a pull over the picture.
struct PullHandle {
  Vector2 at;
  std::uint32_t solid;
  std::size_t index;
  Vector3 place;  ///< in the document's space
  double radius;
};

std::vector<PullHandle> pull_handles(const ToolContext& context) {
  std::vector<PullHandle> out;
  const Object* object = active_solids(context.editor);
  if (!object) return out;
  for (const Solid& solid : object->solids()->input->solids)
    for (std::size_t i = 0; i < solid.pulls.size(); ++i) {
      const Vector3 place = object->transform.apply(placed(solid, solid.pulls[i].place));
      if (const auto at = context.projector().project(place))
        out.push_back({at->head<2>(), solid.id, i, place, solid.pulls[i].radius});
    }
  return out;
}

/// Solid whose surface is nearest to a point, both in the object's axes.
const Solid& nearest_solid(const EnvelopeInput& input, const Vector3& point) {
  const auto distance = [&](const Solid& solid) {
    return std::abs(SolidShape(solid, Vector3::Zero()).distance(point));
  };
  return *std::ranges::min_element(input.solids, {}, distance);
}

class PullTool final : public PointingTool {
  using PullChoice = std::optional<GrabbedPull>;

 public:
  ToolState update(ToolContext& context, const PointerEvent& event) override {
    pointer_ = event.pixel;
    switch (event.kind) {
      case PointerEvent::Kind::press:
        look(context);
        if (hot_) grab();
        return ToolState::stay;
      case PointerEvent::Kind::release:
        return grabbed_ ? let_go(context) : ToolState::stay;
      case PointerEvent::Kind::move:
        if (grabbed_)
          drag(context);
        else
          look(context);
    }
    return ToolState::stay;
  }

  bool wheel(ToolContext& context, double steps, const PointerEvent&) override {
    if (!grabbed_) return false;
    grabbed_->radius = std::clamp(grabbed_->radius * std::pow(wheel_factor, steps),
                                  least_radius * grabbed_->diagonal, most_radius * grabbed_->diagonal);
    turned_ = true;
    drag(context);
    return true;
  }

  std::optional<ToolState> key(ToolContext& context, const KeyPress& press) override {
    const bool removes = press.chord.key == Key::delete_forward || press.chord.key == Key::backspace;
    if (!removes || grabbed_ || !hot_ || hot_->fresh) return {};
    const auto result = change_solids(context.editor.history.current(), context.editor.selection.active,
                                      std::array{hot_->solid}, [index = hot_->index](Solid& solid) {
                                        if (index < solid.pulls.size())
                                          solid.pulls.erase(solid.pulls.begin() + std::ptrdiff_t(index));
                                      });
    return context.editor.commit(result, translatable("Remove pull")) ? ToolState::commit : ToolState::cancel;
  }

  /// Goes on with the next place.
  std::unique_ptr<Tool> successor() override { return make_pull_tool(); }

  void draw(const ToolContext& context, const ToolOverlay& overlay) const override {
    for (const PullHandle& handle : pull_handles(context)) {
      const PullChoice& chosen = grabbed_ ? grabbed_ : hot_;
      const bool hot = chosen && chosen->solid == handle.solid && chosen->index == handle.index;
      const ImU32 colour = hot ? palette().hot : palette().text;
      overlay.list.AddCircleFilled(on_screen(overlay, handle.at), overlay.metrics.px(5), palette().overlay);
      overlay.list.AddCircleFilled(on_screen(overlay, handle.at), overlay.metrics.px(3.5F), colour);
    }
    if (grabbed_) return draw_way(context, overlay);
    if (!hot_) return;
    if (const auto at = context.projector().project(hot_->from))
      overlay.list.AddCircle(on_screen(overlay, at->head<2>()), overlay.metrics.px(6), palette().hot, 0,
                             overlay.metrics.px(1.5F));
  }

  std::string hint(const Language& tr) const override {
    return std::string(tr("Pull surface")) + "   |   " +
           tr(grabbed_ ? translatable("The wheel changes how far about it the surface follows   Esc cancels")
                       : translatable("Drag the surface, or a place that was pulled   Del removes it   "
                                      "Esc ends"));
  }

 private:
  void look(const ToolContext& context) override {
    hot_.reset();
    const Object* object = active_solids(context.editor);
    if (!object) return;
    const std::vector<PullHandle> handles = pull_handles(context);
    if (const auto found = nearest_handle(handles, pointer_, handle_radius)) {
      const PullHandle& handle = handles[*found];
      const double diagonal = box_of(*find_solid(*object, handle.solid)).diagonal().norm();
      hot_ = {handle.solid, handle.index, handle.radius, diagonal, handle.place, false};
      return;
    }
    const auto hit = pick_surface(context.scene.scene(), context.projector().ray(pointer_));
    if (!hit || context.scene.object_id(hit->object) != object->id ||
        context.scene.scene().objects[hit->object].copy)
      return;
    const Solid& solid =
        nearest_solid(*object->solids()->input, object->transform.inverse().apply(hit->point));
    const double diagonal = box_of(solid).diagonal().norm();
    hot_ = {solid.id, solid.pulls.size(), usual_radius * diagonal, diagonal, hit->point, true};
  }

  void grab() {
    grabbed_ = hot_;
    pressed_ = pointer_;
    moved_ = turned_ = false;
  }

  void drag(ToolContext& context) {
    moved_ = moved_ || (pointer_ - pressed_).norm() >= drag_threshold * context.editor.pixel_scale;
    if (!moved_ && !turned_) return;
    const Object* object = context.editor.history.current().find(context.editor.selection.active);
    const Projector projector = context.projector();
    to_ = moved_ ? projector.on_facing_plane(pointer_, grabbed_->from) +
                       (grabbed_->from - projector.on_facing_plane(pressed_, grabbed_->from))
                 : grabbed_->from;
    const Vector3 point = object->transform.inverse().apply(to_);
    context.editor.preview(change_solids(
        context.editor.history.current(), object->id, std::array{grabbed_->solid}, [&](Solid& solid) {
          solid.pulls.resize(std::max(solid.pulls.size(), grabbed_->index + 1));
          solid.pulls[grabbed_->index] = {own_place(solid, point), grabbed_->radius};
        }));
  }

  ToolState let_go(ToolContext& context) {
    const bool changed = moved_ || turned_, fresh = grabbed_->fresh;
    grabbed_.reset();
    if (!changed) return ToolState::stay;
    const bool done =
        context.editor.commit_preview(fresh ? translatable("Pull surface") : translatable("Move pull"));
    return done ? ToolState::commit : ToolState::cancel;
  }

  /// Way of the place, and how far about it the surface follows.
  void draw_way(const ToolContext& context, const ToolOverlay& overlay) const {
    if (!moved_) return;
    const auto from = context.projector().project(grabbed_->from), to = context.projector().project(to_);
    if (!from || !to) return;
    draw_dashed_line(overlay, from->head<2>(), to->head<2>(), palette().hot);
    const Object* object = active_solids(context.editor);
    const double scale = object ? object->transform.scale : 1;
    const double pixels = scale * grabbed_->radius / context.projector().pixel_length_at(to_);
    overlay.list.AddCircle(on_screen(overlay, to->head<2>()), float(pixels), with_alpha(palette().hot, 0.5F),
                           64, overlay.metrics.px(1));
    draw_value_label(overlay, pointer_,
                     length_text(context.editor, (to_ - grabbed_->from).norm()) + "   " +
                         length_text(context.editor, scale * grabbed_->radius));
  }

  PullChoice hot_, grabbed_;
  Vector2 pressed_ = Vector2::Zero();
  Vector3 to_ = Vector3::Zero();
  bool moved_ = false, turned_ = false;
};

}  // namespace

std::unique_ptr<Tool> make_pull_tool() {
  return std::make_unique<PullTool>();
}

}  // namespace hariko
