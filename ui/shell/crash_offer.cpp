#include "ui/shell/crash_offer.hpp"
#include "ui/base/text_lines.hpp"

#include "ui/base/icons.hpp"
#include "ui/shell/offers_panel.hpp"
#include "ui/widgets/application_services.hpp"

namespace hariko {

void draw_crash_offer(PanelContext& context, float width) {
  if (!context.offers.crash) return;
  const CrashOffer offer = *context.offers.crash;  // a button may take it away
  const Metrics& m = context.metrics;
  const Language& tr = context.tr;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float margin = m.px(16), left = at.x + margin;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.ChannelsSplit(2);  // the card's height is that of its text
  draw.ChannelsSetCurrent(1);

  ImGui::SetCursorScreenPos({left, at.y + m.px(10)});
  ImGui::BeginGroup();
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width - 2 * margin);
  ImGui::TextWrapped("%s",
                     fill(tr("Hariko closed unexpectedly on {0}."), {local_time_text(offer.at)}).c_str());
  ImGui::PushStyleColor(ImGuiCol_Text, palette().dim_text);
  ImGui::TextWrapped("%s", tr("The report helps to find the mistake. It holds what the program was doing, "
                              "the graphics driver and names of files, nothing of their contents."));
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, m.px(2)});
  if (ImGui::Button(tr("Copy report"))) {
    ImGui::SetClipboardText(offer.report.c_str());
    context.editor.notify(Notice::Kind::info, tr("The report is in the clipboard."));
  }
  context.marks.item("crash.copy");
  ImGui::SameLine();
  if (ImGui::Button(tr("Open folder"))) context.application.show_log_folder();
  context.marks.item("crash.folder");
  ImGui::SameLine();
  if (ImGui::Button(tr("Dismiss"))) context.application.dismiss_crash();
  context.marks.item("crash.dismiss");
  ImGui::EndGroup();

  const float bottom = ImGui::GetItemRectMax().y + m.px(10), radius = m.px(6);
  draw.ChannelsSetCurrent(0);
  draw.AddRectFilled(at, {at.x + width, bottom}, palette().panel, radius);
  draw.AddRectFilled(at, {at.x + m.px(4), bottom}, palette().warning, radius, ImDrawFlags_RoundCornersLeft);
  draw.ChannelsMerge();
  ImGui::SetCursorScreenPos({at.x, bottom + m.px(8)});
  ImGui::Dummy({width, 1});
}

}  // namespace hariko
