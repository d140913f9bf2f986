// The status line: the tool and its keys, counts, the state of the surface.

#include <algorithm>

#include "ui/icons.hpp"
#include "ui/panels/overlay_window.hpp"

namespace hariko {

void draw_status_line(PanelContext& context, const PanelRect& rect) {
  const Editor& editor = context.editor;
  const Metrics& m = context.metrics;
  if (begin_panel("Status", rect, palette().window, {m.px(12), m.px(5)}, ImGuiWindowFlags_NoScrollbar)) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette().dim_text);
    std::string right;
    ImU32 colour = palette().dim_text;
    if (const Object* object = editor.active_object(); object && editor.has_document) {
      if (const PolyhedronSource* source = object->polyhedron()) {
        const Polyhedron& p = source->polyhedron;
        right = fill(context.tr("{0} vertices  {1} edges  {2} faces"),
                     {std::to_string(p.vertex_count()), std::to_string(p.edge_count()),
                      std::to_string(p.face_count())});
      }
      const SurfaceView* view = editor.view_of(object->id);
      if (view && view->error) {
        right = context.tr.text_of(*view->error);
        colour = palette().error;
      } else if (view) {
        right += "   \u00b7   " + format_number(view->milliseconds, 3) + " ms";
        if (view->largest_normal_jump)
          right += *view->largest_normal_jump < 1e-9
                       ? std::string("   \u00b7   ") + context.tr("tangent-continuous")
                       : "   \u00b7   " + fill(context.tr("largest kink {0}\u00b0"),
                                               {format_number(*view->largest_normal_jump * 57.29577951, 3)});
      }
      if (!editor.stale_since.empty()) right = std::string(context.tr("computing\u2026")) + "   " + right;
    }
    if (!editor.job.empty()) right = context.tr.phrase(editor.job) + "\u2026   " + right;
    const float width = ImGui::CalcTextSize(right.c_str()).x;
    // The state is short and always whole; the hint gives way to it.
    const std::string hint = context.tr.phrase(context.tool_hint);
    const float room = rect.width() - width - m.px(48);
    const std::string shown = elided(hint, std::max(room, m.px(120)));
    ImGui::TextUnformatted(shown.c_str());
    context.marks.item("status.left");
    if (shown != hint && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", hint.c_str());
    ImGui::SameLine(
        std::max(ImGui::GetItemRectMax().x - rect.min.x + m.px(16), rect.width() - width - m.px(12)));
    const TextColour text(colour);
    ImGui::TextUnformatted(right.c_str());
    context.marks.item("status.right");
    ImGui::PopStyleColor();
  }
  ImGui::End();
}

}  // namespace hariko
