#include "ui/widgets/number_slider.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <string>

#include "ui/base/theme.hpp"

namespace hariko {

namespace {

template <class T>
constexpr ImGuiDataType slider_type = sizeof(T) == sizeof(double) ? ImGuiDataType_Double : ImGuiDataType_S32;

template <class T>
std::string slider_number(const SliderRange& range, T value) {
  std::array<char, 64> text{};
  ImGui::DataTypeFormatString(text.data(), int(text.size()), slider_type<T>, &value, range.format);
  return text.data();
}

/// Room for the numbers of a range, so that the track keeps its length while it is dragged: for those of both
/// ends and of some between, which have more digits, and for the present one.
template <class T>
float number_room(const SliderRange& range, T value) {
  float out = ImGui::CalcTextSize(slider_number(range, value).c_str()).x;
  for (const double share : {0.0, 1.0 / 7, 1.0 / 3, 2.0 / 3, 1.0}) {
    const auto sample = static_cast<T>(range.low + share * (range.high - range.low));
    out = std::max(out, ImGui::CalcTextSize(slider_number(range, sample).c_str()).x);
  }
  return out;
}

template <class T>
bool slider_beside_number(const char* id, const SliderRange& range, T& value, float width) {
  constexpr float most_for_number = 0.6F;  // share of the width
  const ImGuiStyle& style = ImGui::GetStyle();
  const float room = width > 0 ? width : ImGui::GetContentRegionAvail().x;
  const float number = std::min(number_room(range, value), most_for_number * room);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetNextItemWidth(room - number - style.ItemInnerSpacing.x);
  const auto low = static_cast<T>(range.low), high = static_cast<T>(range.high);
  bool changed = false;
  {
    // The track writes its number, too: visible only where it is typed.
    const bool typed = ImGui::TempInputIsActive(ImGui::GetID(id));
    const TextColour colour(typed ? ImGui::GetColorU32(ImGuiCol_Text) : IM_COL32_BLACK_TRANS);
    changed = ImGui::SliderScalar(id, slider_type<T>, &value, &low, &high, range.format, range.flags);
  }
  ImGui::GetWindowDrawList()->AddText({at.x + room - number, at.y + style.FramePadding.y},
                                      ImGui::GetColorU32(ImGuiCol_Text), slider_number(range, value).c_str());
  // The number belongs to the row, but is no item: those asked about afterwards are the track.
  auto& layout = ImGui::GetCurrentWindow()->DC;
  layout.CursorMaxPos.x = std::max(layout.CursorMaxPos.x, at.x + room);
  layout.CursorPosPrevLine.x = at.x + room;
  return changed;
}

}  // namespace

bool number_slider(const char* id, const SliderRange& range, double& value, float width) {
  return slider_beside_number(id, range, value, width);
}

bool number_slider(const char* id, const SliderRange& range, int& value, float width) {
  return slider_beside_number(id, range, value, width);
}

}  // namespace hariko
