#include "ui/outline/outline_handles.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace hariko
