#include "ui/widgets/prompt.hpp"
#include <imgui.h>

#include <algorithm>

#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"

namespace hariko {

void Prompt::draw(PanelContext& context) {
  constexpr const char* id = "###prompt";
  const bool shown = ImGui::IsPopupOpen(id);
  if (!is_open()) shown_ = 0;
  if (!is_open() && !shown) return;
  if (!shown) ImGui::OpenPopup(id);
  const Metrics& m = context.metrics;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  // A prompt that is higher than the window scrolls.
  ImGui::SetNextWindowSizeConstraints({0, 0}, {screen.x, screen.y - std::min(m.px(40), screen.y / 20)});
  const std::string title = (is_open() ? requests_.back().title : std::string()) + id;
  const OpenScope dialog = dialog_scope(title, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove);
  if (!dialog) return;
  if (!is_open()) return ImGui::CloseCurrentPopup();
  const Request request = requests_.back();
  const float wide = std::min(m.px(420), screen.x - m.px(64));
  text_in_lines(request.text, wide);
  if (request.picture) request.picture();
  if (request.fields) {
    ImGui::Dummy({0, m.px(8)});
    request.fields(context);
  }
  ImGui::Dummy({0, m.px(8)});
  const Answer* chosen = nullptr;
  focus_.begin();
  // Enter takes the first answer until the keys go to another one.
  if (shown_ != requests_.size() && !request.answers.empty()) focus_.go_to(request.answers.front().mark);
  shown_ = requests_.size();
  for (const Answer& answer : request.answers) {
    const bool first = &answer == &request.answers.front();
    const float width = std::max(m.px(110), ImGui::CalcTextSize(answer.label.c_str()).x + m.px(24));
    // Below each other where the window is narrow.
    if (!first) {
      ImGui::SameLine();
      if (ImGui::GetCursorPosX() + width > std::max(wide, ImGui::GetWindowWidth()) && screen.x < m.px(900))
        ImGui::NewLine();
    }
    const std::string mark = "prompt." + answer.mark;
    const bool pressed = first ? main_button(context.marks, mark, answer.label, width)
                               : text_button(context.marks, mark, answer.label, width);
    if (focus_.item(answer.mark, m.px(4)) || pressed) chosen = &answer;
  }
  focus_.end();
  if (chosen) {
    requests_.pop_back();
    shown_ = 0;  // the answer may ask something else at once, which has a default of its own
    if (!is_open()) ImGui::CloseCurrentPopup();
    if (chosen->action) chosen->action();
  }
}

}  // namespace hariko
