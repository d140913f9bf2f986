// Drawing of the transform tool: the axes of a lock, the reach of the soft selection, snaps, the value.

#include "ui/view/overlay_drawing.hpp"
#include "ui/view/snap_catcher.hpp"
#include "ui/view/transform_tool.hpp"

namespace hariko {

void TransformTool::draw(const ToolContext& context, const ToolOverlay& overlay) const {
  if (target_.empty()) return;
  draw_guides(context, overlay);
  if (context.editor.transform.soft.on && target_.of_elements()) draw_falloff(context, overlay);
  if (snap_) draw_snap_target(context, overlay, *snap_);
  Vector2 beside = pointer_;
  if (by_ == DrivenBy::typing)
    if (const auto pivot = context.projector().project(target_.pivot())) beside = pivot->head<2>();
  if (error_.empty())
    draw_value_label(overlay, beside, value_text(context.editor.language));
  else
    draw_value_label(overlay, beside, value_text(context.editor.language) + "   " + error_, true);
}

void TransformTool::draw_guides(const ToolContext& context, const ToolOverlay& overlay) const {
  const Projector projector = context.projector();
  const Vector3 through = kind_ == TransformKind::move ? anchor_ : target_.pivot();
  for (int i = 0; i < 3; ++i) {
    const bool shown = lock_.kind == AxisLock::Kind::axis
                           ? i == lock_.axis
                           : lock_.kind == AxisLock::Kind::plane && i != lock_.axis;
    if (shown) draw_axis_line(overlay, projector, through, frame().col(i), axis_colour(i, 190));
  }
  if (kind_ == TransformKind::move || by_ == DrivenBy::typing) return;
  if (const auto pivot = projector.project(target_.pivot()))
    draw_dashed_line(overlay, pivot->head<2>(), pointer_, with_alpha(palette().text, 0.6F));
}

void TransformTool::draw_falloff(const ToolContext& context, const ToolOverlay& overlay) const {
  const Projector projector = context.projector();
  const auto pivot = projector.project(target_.pivot() + done_.translation);
  if (!pivot) return;
  const double pixels = context.editor.transform.soft.radius / projector.pixel_length_at(target_.pivot());
  if (pixels < 20000)
    overlay.list.AddCircle(on_screen(overlay, pivot->head<2>()),
                           static_cast<float>(pixels) / ImGui::GetIO().DisplayFramebufferScale.x,
                           with_alpha(palette().text, 0.7F), 96, overlay.metrics.px(1.2F));
  for (const TransformTarget::Follower& follower : target_.followers()) {
    const auto at = projector.project(done_.apply(follower.place, target_.pivot(), follower.weight));
    if (!at) continue;
    // From blue where little follows to the accent of the selection.
    const auto mix = [&](int low, int high) {
      return static_cast<int>(low + follower.weight * (high - low));
    };
    const ImVec2 centre = on_screen(overlay, at->head<2>());
    overlay.list.AddCircleFilled(centre, overlay.metrics.px(4.5F), IM_COL32(20, 21, 24, 220));
    overlay.list.AddCircleFilled(centre, overlay.metrics.px(3.5F),
                                 IM_COL32(mix(0x4a, 0xf2), mix(0xa3, 0x9e), mix(0xdf, 0x38), 255));
  }
}

}  // namespace hariko
