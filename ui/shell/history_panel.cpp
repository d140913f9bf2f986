// The history panel: the steps by name, oldest first; a click goes there.

#include "ui/base/icons.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

/// "12.3 MB": what the steps need beside the document itself.
std::string megabytes(std::size_t bytes) {
  const std::size_t tenths = bytes * 10 / 1'000'000;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " MB";
}

void step_row(PanelContext& context, const std::string& label, std::size_t position) {
  Editor& editor = context.editor;
  const std::size_t current = editor.history.position();
  const bool is_current = position == current;
  // Steps that could be redone are dim.
  const TextColour colour(position > current ? palette().dim_text : palette().text);
  if (selectable_row(context.marks, "step." + std::to_string(position), "", is_current,
                     {0, context.metrics.px(22)}) &&
      !is_current)
    editor.go_to_step(position);
  ImGui::SameLine(context.metrics.px(14));
  plain_text(is_current ? icon::current : " ");
  ImGui::SameLine(context.metrics.px(34));
  plain_text(label);
}

}  // namespace

float history_height(const PanelContext& context, float available) {
  const float header = context.metrics.px(32);
  if (!context.state.history_open) return header;
  const auto rows = static_cast<float>(context.editor.history.labels().size() + 1);
  return std::min(header + context.metrics.px(24) * rows + context.metrics.px(10),
                  std::max(available * 0.3F, context.metrics.px(110)));
}

void draw_history(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  Editor& editor = context.editor;
  if (begin_panel("History", rect, palette().panel, {m.px(12), m.px(4)}, ImGuiWindowFlags_NoScrollbar)) {
    ImGui::SetNextItemOpen(context.state.history_open);
    const bool open =
        folding_heading(context, "history", translatable("History"), ImGuiTreeNodeFlags_FramePadding);
    context.state.history_open = open;
    const std::string used = megabytes(editor.history.bytes());
    ImGui::SameLine(rect.width() - ImGui::CalcTextSize(used.c_str()).x - m.px(14));
    dim_text(used);
    if (ImGui::IsItemHovered())
      show_tip(fill(context.tr("Memory of all steps, of {0} at the most; the oldest are forgotten first."),
                    {megabytes(editor.history.byte_limit())}));
    if (open) {
      ImGui::BeginChild("steps", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
      const std::vector<Phrase> labels = editor.history.phrases();
      ImGuiListClipper clipper;
      clipper.Begin(static_cast<int>(labels.size()) + 1);
      while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
          step_row(context,
                   i == 0 ? std::string(context.tr("Beginning"))
                          : context.tr(labels[static_cast<std::size_t>(i - 1)]),
                   static_cast<std::size_t>(i));
      // New steps come into view.
      if (context.state.history_shown != editor.history.serial()) {
        context.state.history_shown = editor.history.serial();
        const float row = m.px(22) + ImGui::GetStyle().ItemSpacing.y;
        ImGui::SetScrollY(row * static_cast<float>(editor.history.position()) - ImGui::GetWindowHeight() / 2);
      }
      ImGui::EndChild();
    }
  }
  ImGui::End();
}

}  // namespace hariko
