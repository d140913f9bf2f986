// Over the picture of a mesh: where its error is the largest, and what each of four compared pictures shows.

#include "ui/view/mesh_overlay.hpp"

#include <algorithm>

#include "ui/base/quantity.hpp"

namespace hariko {

namespace {

void plate(ImDrawList& list, const Metrics& m, ImVec2 at, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  list.AddRectFilled({at.x - m.px(5), at.y - m.px(2)}, {at.x + size.x + m.px(5), at.y + size.y + m.px(2)},
                     palette().overlay, m.px(3));
  list.AddText(at, palette().text, text.c_str());
}

std::string value_text(const PanelContext& context, MeshShown shown, double value) {
  if (shown != MeshShown::distance) return format_quantity(angle_quantity(), value);
  return format_number(value, 3) + " " + std::string(to_string(context.editor.document().unit));
}

/// Which of the four pictures a view shows: they are read line by line.
std::size_t place_of(const Editor& editor, std::size_t view) {
  const std::vector<Pane> panes = editor.layout.panes();
  const auto at = std::find_if(panes.begin(), panes.end(),
                               [&](const Pane& pane) { return std::size_t(pane.view) == view; });
  return std::size_t(at - panes.begin());
}

/// A ring round the place, with its value beside it.
void marker(const PanelContext& context, const Projector& projector, const PanelRect& pane, MeshShown shown,
            const MeshErrors& errors, const Similarity& transform, const Vector3& origin) {
  if (!(errors.largest > 0)) return;
  const auto pixel = projector.project(transform.apply(origin + errors.place));
  if (!pixel) return;
  const Metrics& m = context.metrics;
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  const ImVec2 at(pane.min.x + float(pixel->x()) / scale.x, pane.min.y + float(pixel->y()) / scale.y);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircle(at, m.px(9), IM_COL32(0, 0, 0, 200), 0, m.px(4));
  list.AddCircle(at, m.px(9), palette().hot, 0, m.px(2));
  plate(list, m, {at.x + m.px(15), at.y - ImGui::GetTextLineHeight() / 2},
        value_text(context, shown, errors.largest));
  context.marks.rect("meshing.largest", {at.x - 2, at.y - 2}, {at.x + 2, at.y + 2});
}

}  // namespace

void draw_mesh_overlay(const PanelContext& context, const Camera& camera, PixelSize size,
                       const PanelRect& pane, std::size_t view) {
  const Editor& editor = context.editor;
  const Meshing& meshing = editor.meshing;
  const auto object = meshed_object(editor.document(), editor.selection.active);
  const MeshingResult* result = object ? meshing.shown_for(object) : nullptr;
  if (!result) return;
  const Projector projector(camera, size);
  const bool compared = meshing.comparing() && result->compared;
  const ComparedPicture picture = compared_picture(place_of(editor, view) % ViewLayout::count);
  const MeshShown shown = compared ? picture.shown : meshing.shown;
  if (shown == MeshShown::facets) return;
  const MeshPreview& mesh = compared ? (*result->compared)[picture.mesh] : result->mesh;
  const MeshErrors& errors = mesh.of(shown);
  marker(context, projector, pane, shown, errors, object->transform, mesh.mesh->origin());
  if (!compared) return;
  const Language& tr = context.tr;
  const char* made = picture.mesh == 0 ? tr("made by distance") : tr("made by normal angle");
  const char* what = shown == MeshShown::distance ? tr("distance") : tr("normal angle");
  const std::string first = fill(tr("{0}: {1} triangles"), {made, std::to_string(mesh.facets)});
  const std::string second = fill(tr("{0}: mean {1}"), {what, value_text(context, shown, errors.mean)});
  const Metrics& m = context.metrics;
  const float line = ImGui::GetTextLineHeight() + m.px(4);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float left = pane.min.x + m.px(12);
  plate(list, m, {left, pane.max.y - m.px(10) - 2 * line}, first);
  plate(list, m, {left, pane.max.y - m.px(8) - line}, second);
  context.marks.rect("meshing.picture." + std::to_string(view), pane.min, pane.max);
}

}  // namespace hariko
