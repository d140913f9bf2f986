#include "ui/widgets/items.hpp"

#include <algorithm>

#include "ui/base/text_lines.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

void plain_text(std::string_view text) {
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void coloured_text(ImU32 colour, std::string_view text) {
  const TextColour in_colour(colour);
  plain_text(text);
}

void dim_text(std::string_view text) {
  coloured_text(palette().dim_text, text);
}

void aligned_text(std::string_view text) {
  ImGui::AlignTextToFramePadding();
  plain_text(text);
}

void text_in_lines(std::string_view text, float right) {
  const float room = right > 0 ? right - ImGui::GetCursorPosX() : ImGui::GetContentRegionAvail().x;
  plain_text(in_lines(text, std::max(room, 1.0F)));
}

void coloured_lines(ImU32 colour, std::string_view text, float right) {
  const TextColour in_colour(colour);
  text_in_lines(text, right);
}

bool text_button(Marks& marks, const std::string& mark, const std::string& text, float width) {
  const bool pressed = ImGui::Button((text + "###" + mark).c_str(), {width, 0});
  marks.item(mark);
  return pressed;
}

bool radio_button(Marks& marks, const std::string& mark, const std::string& text, bool on) {
  const bool pressed = ImGui::RadioButton((text + "###" + mark).c_str(), on);
  marks.item(mark);
  return pressed;
}

bool arrow_button(Marks& marks, const std::string& mark, ImGuiDir direction, const char* tip) {
  const bool pressed = ImGui::ArrowButton(mark.c_str(), direction);
  marks.item(mark);
  if (ImGui::IsItemHovered()) show_tip(tip);
  return pressed;
}

bool job_bar(Marks& marks, const std::string& mark, const Job& job, float bar, const std::string& stop,
             float width) {
  ImGui::ProgressBar(static_cast<float>(std::max(0.0, job.progress.fraction())), {bar, 0},
                     (std::to_string(percent_of(job)) + " %").c_str());
  ImGui::SameLine();
  return text_button(marks, mark, stop, width);
}

bool pointer_area(Marks& marks, const std::string& mark, const PanelRect& rect, ImGuiButtonFlags buttons) {
  ImGui::SetCursorScreenPos(rect.min);
  ImGui::InvisibleButton(mark.c_str(), {rect.width(), rect.height()}, buttons);
  marks.item(mark);
  return ImGui::IsItemHovered();
}

bool border_area(Marks& marks, const std::string& mark, ImVec2 size, ImGuiMouseCursor cursor) {
  ImGui::InvisibleButton(mark.c_str(), size);
  marks.item(mark);
  const bool held = ImGui::IsItemActive();
  if (held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(cursor);
  return held;
}

}  // namespace hariko
