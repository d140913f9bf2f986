#include "ui/view/snap_catcher.hpp"

#include <algorithm>
#include <utility>

#include "ui/view/overlay_drawing.hpp"

namespace hariko {

namespace {

/// The mark of a kind of place: each has a shape of its own.
void draw_snap_mark(ImDrawList& list, SnapTarget::Kind kind, const ImVec2& c, float r, ImU32 colour,
                    float width) {
  const auto line = [&](float x0, float y0, float x1, float y1) {
    list.AddLine({c.x + x0 * r, c.y + y0 * r}, {c.x + x1 * r, c.y + y1 * r}, colour, width);
  };
  switch (kind) {
    case SnapTarget::Kind::vertex:
      return list.AddRect({c.x - r, c.y - r}, {c.x + r, c.y + r}, colour, 0, 0, width);
    case SnapTarget::Kind::midpoint:
      return list.AddTriangle({c.x, c.y - r}, {c.x + r, c.y + 0.75F * r}, {c.x - r, c.y + 0.75F * r}, colour,
                              width);
    case SnapTarget::Kind::centre:
      list.AddCircle(c, r, colour, 0, width);
      return list.AddCircleFilled(c, 0.3F * r, colour);
    case SnapTarget::Kind::crossing:
      line(-1, -1, 1, 1);
      return line(-1, 1, 1, -1);
    case SnapTarget::Kind::perpendicular:  // a right angle with its square
      line(-1, -1, -1, 1);
      line(-1, 1, 1, 1);
      line(-1, 0, 0, 0);
      return line(0, 0, 0, 1);
    case SnapTarget::Kind::tangent:
      list.AddCircle(c, 0.75F * r, colour, 0, width);
      return line(-1.2F, -0.75F, 1.2F, -0.75F);
    case SnapTarget::Kind::curve:  // an hourglass
      line(-1, -1, 1, -1);
      line(1, -1, -1, 1);
      line(-1, 1, 1, 1);
      return line(1, 1, -1, -1);
    case SnapTarget::Kind::surface:  // a diamond
      return list.AddQuad({c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}, {c.x - r, c.y}, colour, width);
    case SnapTarget::Kind::grid:
      line(-1, 0, 1, 0);
      return line(0, -1, 0, 1);
  }
}

}  // namespace

void SnapCatcher::update(const ToolContext& context) {
  const Editor& editor = context.editor;
  std::vector<std::shared_ptr<const DisplayMesh>> meshes;
  for (const SceneObject& object : context.scene.scene().objects) meshes.push_back(object.mesh);
  const bool same = places_ && kinds_ == editor.settings.snaps && document_ == editor.documents &&
                    serial_ == editor.history.serial() && meshes_ == meshes;
  if (same) return;
  meshes_ = std::move(meshes);
  kinds_ = editor.settings.snaps;
  document_ = editor.documents;
  serial_ = editor.history.serial();
  places_ = std::make_shared<const SnapPlaces>(context, kinds_);
}

std::optional<SnapTarget> SnapCatcher::find(const ToolContext& context, const Vector2& pixel,
                                            const std::optional<Vector3>& from, const Vector3& normal) const {
  if (!places_) return {};
  return places_->nearest(context, {kinds_, from, normal, nullptr}, pixel);
}

void draw_snap_target(const ToolContext& context, const ToolOverlay& overlay, const SnapTarget& target,
                      bool warning) {
  const auto at = context.projector().project(target.point);
  if (!at) return;
  const Metrics& m = overlay.metrics;
  const ImVec2 c = on_screen(overlay, at->head<2>());
  const float r = m.px(7), thick = m.px(1.8F);
  draw_snap_mark(overlay.list, target.kind, c, r, with_alpha(palette().window, 0.8F), 2.2F * thick);
  draw_snap_mark(overlay.list, target.kind, c, r, warning ? palette().warning : palette().hot, thick);
  const char* name = context.editor.language(snap_name(target.kind));
  const ImVec2 size = ImGui::CalcTextSize(name), padding(m.px(5), m.px(2));
  const ImVec2 low = overlay.list.GetClipRectMin(), high = overlay.list.GetClipRectMax();
  // Above the mark: the value stands below it.
  const float x = std::clamp(c.x + m.px(12), low.x, std::max(low.x, high.x - size.x - 2 * padding.x));
  const float y = std::max(low.y, c.y - m.px(14) - size.y - 2 * padding.y);
  overlay.list.AddRectFilled({x, y}, {x + size.x + 2 * padding.x, y + size.y + 2 * padding.y},
                             with_alpha(palette().popup, 0.9F), m.px(3));
  overlay.list.AddText({x + padding.x, y + padding.y}, palette().text, name);
}

}  // namespace hariko
