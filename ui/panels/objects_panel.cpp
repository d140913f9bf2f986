// The outliner: objects of the document in order.

#include <algorithm>

#include "ui/icons.hpp"
#include "ui/panels/panels.hpp"

namespace hariko {

void draw_objects(PanelContext& context, const PanelRect& rect) {
  Editor& editor = context.editor;
  if (begin_panel("Objects", rect, palette().panel, {context.metrics.px(12), context.metrics.px(8)})) {
    heading(context, "Objects");
    const Document document = editor.document();
    for (const auto& object : document.objects) {
      ImGui::PushID(static_cast<int>(object->id.value));
      const bool active = object->id == editor.selection.active;
      const float side = context.metrics.px(26);
      const float row = ImGui::GetContentRegionAvail().x;
      if (ImGui::Selectable("##row", active, ImGuiSelectableFlags_AllowItemOverlap, {0, side})) {
        if (!active) editor.selection.clear_elements();
        const ImGuiIO& io = ImGui::GetIO();
        editor.selection.select({object->id, element_of(object->id)}, io.KeyCtrl ? Selection::How::remove
                                                                      : io.KeyShift
                                                                          ? Selection::How::add
                                                                          : Selection::How::replace);
      }
      context.marks.item("object." + std::to_string(object->id.value));
      ImGui::SetItemAllowOverlap();
      ImGui::SameLine(context.metrics.px(18));
      ImGui::AlignTextToFramePadding();
      ImGui::Text("%s  %s", icon::object, object->name.c_str());
      const SurfaceView* view = editor.view_of(object->id);
      const bool failed = view && view->error;
      const bool warned = view && !view->warnings.empty();
      if (failed || warned) {
        ImGui::SameLine(row - side + context.metrics.px(-14));
        const TextColour colour(failed ? palette().error : palette().warning);
        ImGui::TextUnformatted(failed ? icon::error : icon::warning);
        if (ImGui::IsItemHovered())
          ImGui::SetTooltip("%s", failed ? view->error->text.c_str() : view->warnings.front().text.c_str());
      }
      ImGui::SameLine(row - side + context.metrics.px(12));
      if (icon_button(context, object->visible ? icon::shown : icon::hidden, "visible",
                      object->visible ? "Hide" : "Show", false, 26))
        editor.commit(set_visible(editor.history.current(), object->id, !object->visible),
                      object->visible ? "Hide object" : "Show object");
      ImGui::PopID();
    }
    if (document.objects.empty()) ImGui::TextDisabled("No objects. Import a mesh to begin.");
  }
  ImGui::End();
}

}  // namespace hariko
