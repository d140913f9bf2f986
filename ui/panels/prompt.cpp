#include "ui/panels/prompt.hpp"
#include "ui/text_lines.hpp"

#include <imgui.h>

namespace hariko {

void Prompt::draw(PanelContext& context) {
  constexpr const char* id = "###prompt";
  const bool shown = ImGui::IsPopupOpen(id);
  if (!is_open() && !shown) return;
  if (!shown) ImGui::OpenPopup(id);
  const Metrics& m = context.metrics;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  const std::string title = (is_open() ? requests_.back().title : std::string()) + id;
  if (!ImGui::BeginPopupModal(title.c_str(), nullptr,
                              ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove))
    return;
  if (!is_open()) {
    ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return;
  }
  const Request request = requests_.back();
  text_in_lines(request.text, m.px(420));
  if (request.picture) request.picture();
  if (request.fields) request.fields(context);
  ImGui::Dummy({0, m.px(8)});
  const Answer* chosen = nullptr;
  for (const Answer& answer : request.answers) {
    const float width = std::max(m.px(110), ImGui::CalcTextSize(answer.label.c_str()).x + m.px(24));
    if (ImGui::Button(answer.label.c_str(), {width, 0})) chosen = &answer;
    context.marks.item("prompt." + answer.mark);
    ImGui::SameLine();
  }
  ImGui::NewLine();
  if (chosen) {
    requests_.pop_back();
    if (!is_open()) ImGui::CloseCurrentPopup();
    if (chosen->action) chosen->action();
  }
  ImGui::EndPopup();
}

}  // namespace hariko
