// The status line: the tool and its keys, counts, the state of the surface.

#include <algorithm>
#include <cmath>

#include "ui/icons.hpp"
#include "ui/panels/overlay_window.hpp"

namespace hariko {

namespace {

/// Computing that takes long enough to notice, with a button that stops it, or surfaces that are not up to
/// date, with one that brings them there. Both end at `right`.
void draw_recompute(PanelContext& context, float right) {
  const Editor& editor = context.editor;
  const Metrics& m = context.metrics;
  constexpr double noticeable = 0.3;  // seconds
  const bool computes =
      std::any_of(editor.stale_since.begin(), editor.stale_since.end(),
                  [&](const auto& entry) { return editor.now - entry.second > noticeable; });
  if (!computes && editor.recompute.outdated.empty()) return;
  const char* text = context.tr(computes ? "computing\u2026" : "not up to date");
  const char* button = context.tr(computes ? "Cancel" : "Recompute");
  const float padding = m.px(8), bar = computes ? m.px(72) : 0;
  const float words = ImGui::CalcTextSize(text).x, box = ImGui::CalcTextSize(button).x + 2 * padding;
  const float width = words + bar + box + 3 * padding;
  ImGui::SameLine(right - width);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(at, computes ? palette().text : palette().warning, text);
  if (computes) {
    // How long it will take is not known: a part wanders.
    const ImVec2 low(at.x + words + padding, at.y + height / 2 - m.px(2));
    const ImVec2 high(low.x + bar - padding, low.y + m.px(4));
    list.AddRectFilled(low, high, palette().field, m.px(2));
    const float phase = static_cast<float>(0.5 - 0.5 * std::cos(3 * editor.now)) * (high.x - low.x) * 0.7F;
    list.AddRectFilled({low.x + phase, low.y}, {low.x + phase + (high.x - low.x) * 0.3F, high.y},
                       palette().accent, m.px(2));
  }
  ImGui::SetCursorScreenPos({at.x + words + bar + padding, at.y - m.px(2)});
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + box, low.y + height + m.px(4));
  if (ImGui::InvisibleButton("recompute", {high.x - low.x, high.y - low.y}))
    context.run(computes ? "surface.cancel" : "surface.recompute");
  context.marks.item(computes ? "status.cancel" : "status.recompute");
  list.AddRectFilled(low, high, ImGui::IsItemHovered() ? palette().field_hover : palette().field, m.px(4));
  list.AddText({low.x + padding, low.y + m.px(2)}, palette().text, button);
}

}  // namespace

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
    }
    if (!editor.job.empty()) right = context.tr.phrase(editor.job) + "\u2026   " + right;
    const float width = ImGui::CalcTextSize(right.c_str()).x;
    const bool busy = !editor.stale_since.empty() || !editor.recompute.outdated.empty();
    // The state is short and always whole; the hint gives way to it.
    const std::string hint = context.tr.phrase(context.tool_hint);
    const float room = rect.width() - width - m.px(48) - (busy ? m.px(240) : 0);
    const std::string shown = elided(hint, std::max(room, m.px(120)));
    ImGui::TextUnformatted(shown.c_str());
    context.marks.item("status.left");
    if (shown != hint && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", hint.c_str());
    ImGui::SameLine(
        std::max(ImGui::GetItemRectMax().x - rect.min.x + m.px(16), rect.width() - width - m.px(12)));
    const TextColour text(colour);
    const float state_left = ImGui::GetCursorPosX();
    ImGui::TextUnformatted(right.c_str());
    context.marks.item("status.right");
    draw_recompute(context, state_left - m.px(12));
    ImGui::PopStyleColor();
  }
  ImGui::End();
}

}  // namespace hariko
