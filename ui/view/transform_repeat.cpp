#include "ui/view/transform_tool.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "core/modeling/edit_result.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/view/snapping.hpp"

namespace hariko {

namespace {

/// The transformation along other local axes.
Transformation along_axes(const DoneTransform& done, const Matrix3& axes) {
  Transformation out = done.transformation;
  if (!done.local) return out;
  const Matrix3 turn = axes * done.axes.transpose();
  out.translation = turn * out.translation;
  out.axis = turn * out.axis;
  out.frame = turn * out.frame;
  return out;
}

Result<BegunOperation> transform_again(const Editor& editor, const DoneTransform& done) {
  TransformTarget target = TransformTarget::of(editor);
  if (target.empty())
    return make_error(e_wrong_selection, "Nothing is selected that can be moved.",
                      "Select something that is neither hidden nor locked.");
  const SoftSelection& soft = editor.transform.soft;
  target.follow(soft.on ? soft.radius : 0, soft.falloff);
  const Transformation again = along_axes(done, target.local_frame());
  BegunOperation begun;
  begun.written = [steps = written_transform(editor, {done.verb, target.local_frame(), again, done.local})](
                      std::span<const OperationNumber>) { return steps; };
  begun.label = done.verb + " " + target.describe();
  begun.make = [target = std::move(target), again, local = done.local](
                   const Document& document, std::span<const OperationNumber>) -> Result<OperationResult> {
    Result<Document> moved = target.apply(document, again, local);
    if (!moved) return moved.error();
    OperationResult result{std::move(moved).value(), {}};
    result.keeps_selection = true;
    return result;
  };
  return begun;
}

/// Column of the frame along an axis, or against it: then the sign is -1. Nothing where there is none.
std::optional<std::pair<int, double>> column_along(const Matrix3& frame, const Vector3& axis) {
  constexpr double same = 1 - 1e-14;
  for (int k = 0; k < 3; ++k)
    if (const double along = frame.col(k).dot(axis); std::abs(along) > same) return {{k, along < 0 ? -1 : 1}};
  return {};
}

/// Arguments of the command, but for those that all three have; nothing where it cannot do the same.
std::optional<WrittenCommand> written_change(const DoneTransform& done) {
  const Transformation& change = done.transformation;
  const Matrix3 frame = done.local ? done.axes : Matrix3(Matrix3::Identity());
  if (done.verb == "Move") {
    const Vector3 by = done.local ? Vector3(frame.transpose() * change.translation) : change.translation;
    return WrittenCommand{"transform.move", {written("by", by)}};
  }
  if (!change.translation.isZero(0)) return {};
  if (done.verb == "Rotate") {
    const auto column = column_along(frame, change.axis);
    if (!column) return {};
    return WrittenCommand{"transform.rotate",
                          {written("angle", column->second * change.degrees),
                           written("axis", std::string(1, static_cast<char>('x' + column->first)))}};
  }
  const Vector3& factors = change.factors;
  const bool even = factors.x() == factors.y() && factors.y() == factors.z();
  return WrittenCommand{"transform.scale",
                        {even ? written("factor", factors.x()) : written("factors", factors)}};
}

}  // namespace

std::vector<WrittenCommand> written_transform(const Editor& editor, const DoneTransform& done) {
  auto step = written_change(done);
  if (!step) return {};
  if (done.local) step->arguments.push_back(written_switch("local", true));
  if (const SoftSelection& soft = editor.transform.soft; soft.on && soft.radius > 0)
    step->arguments.push_back(written("soft_radius", soft.radius));
  return {*std::move(step)};
}

void remember_transform(Editor& editor, const DoneTransform& done) {
  OperationStep step;
  step.label = editor.history.undo_label();
  editor.tell_script(written_transform(editor, done));
  step.begin = [done](const Editor& now) { return transform_again(now, done); };
  editor.last_operation.take_up(editor, {}, std::move(step));
}

// Drawing of the transform tool: the axes of a lock, the reach of the soft selection, snaps, the value.

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
