#include "ui/widgets/number_slider.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <type_traits>

#include "ui/base/theme.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

template <class T>
constexpr ImGuiDataType slider_type = std::is_same_v<T, double>  ? ImGuiDataType_Double
                                      : std::is_same_v<T, float> ? ImGuiDataType_Float
                                                                 : ImGuiDataType_S32;
template <class T>
constexpr ImGuiInputTextFlags typed_flags =
    std::is_same_v<T, double> ? ImGuiInputTextFlags_CharsScientific : ImGuiInputTextFlags_None;

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

/// Takes a number that a field gave.
template <class T>
bool take_number(bool changed, T given, const SliderRange& range, T& value) {
  if (!changed || !std::isfinite(static_cast<double>(given))) return false;
  value = std::clamp(given, static_cast<T>(range.low), static_cast<T>(range.high));
  return true;
}

}  // namespace

template <class Number>
bool number_slider(Marks& marks, const std::string& mark, const SliderRange& range, Number& value,
                   float width) {
  constexpr float most_for_number = 0.6F;  // share of the width
  const ImGuiStyle& style = ImGui::GetStyle();
  const std::string label = "##" + mark;
  const float room = width > 0 ? width : ImGui::GetContentRegionAvail().x;
  const float number = std::min(std::max(number_room(range, value), range.room), most_for_number * room);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetNextItemWidth(room - number - style.ItemInnerSpacing.x);
  const auto low = static_cast<Number>(range.low), high = static_cast<Number>(range.high);
  bool changed = false;
  {
    // The track writes its number, too: visible only where it is typed.
    const bool typed = ImGui::TempInputIsActive(ImGui::GetID(label.c_str()));
    const TextColour colour(typed ? ImGui::GetColorU32(ImGuiCol_Text) : IM_COL32_BLACK_TRANS);
    changed = ImGui::SliderScalar(label.c_str(), slider_type<Number>, &value, &low, &high, range.format,
                                  range.flags);
    marks.item(mark);
  }
  ImGui::GetWindowDrawList()->AddText({at.x + room - number, at.y + style.FramePadding.y},
                                      ImGui::GetColorU32(ImGuiCol_Text), slider_number(range, value).c_str());
  // The number belongs to the row, but is no item: those asked about afterwards are the track.
  auto& layout = ImGui::GetCurrentWindow()->DC;
  layout.CursorMaxPos.x = std::max(layout.CursorMaxPos.x, at.x + room);
  layout.CursorPosPrevLine.x = at.x + room;
  return changed;
}

template <class Number>
void slider_row(PanelContext& context, const std::string& id, const char* label, const char* help,
                const SliderRange& range, Number& value) {
  row_label(context, label, help);
  Number wanted = value;
  // As long as the tracks of rows with a field beside them.
  const ImGuiStyle& style = ImGui::GetStyle();
  SliderRange own = range;
  own.room = context.metrics.px(number_field_width) + style.ItemSpacing.x - style.ItemInnerSpacing.x;
  number_slider(context.marks, "slider." + id, own, wanted);
  if (std::isfinite(static_cast<double>(wanted))) value = wanted;
  point_out(context, id.c_str());
}

template <class Number>
bool number_input(Marks& marks, const std::string& mark, float width, const SliderRange& range,
                  Number& value) {
  ImGui::SetNextItemWidth(width);
  Number typed = value;
  const bool changed = ImGui::InputScalar(("##" + mark).c_str(), slider_type<Number>, &typed, nullptr,
                                          nullptr, range.format, typed_flags<Number>);
  marks.item(mark);
  return take_number(changed, typed, range, value);
}

template <class Number>
bool track_slider(Marks& marks, const std::string& mark, float width, Number most, Number& value) {
  const Number least = 0;
  ImGui::SetNextItemWidth(width);
  const bool moved = ImGui::SliderScalar(("##" + mark).c_str(), slider_type<Number>, &value, &least, &most,
                                         "", ImGuiSliderFlags_NoInput);
  marks.item(mark);
  return moved;
}

template bool number_slider(Marks&, const std::string&, const SliderRange&, double&, float);
template bool number_slider(Marks&, const std::string&, const SliderRange&, int&, float);
template void slider_row(PanelContext&, const std::string&, const char*, const char*, const SliderRange&,
                         double&);
template void slider_row(PanelContext&, const std::string&, const char*, const char*, const SliderRange&,
                         int&);
template bool number_input(Marks&, const std::string&, float, const SliderRange&, double&);
template bool number_input(Marks&, const std::string&, float, const SliderRange&, int&);
template bool track_slider(Marks&, const std::string&, float, float, float&);
template bool track_slider(Marks&, const std::string&, float, int, int&);

bool number_drag(Marks& marks, const std::string& mark, const SliderRange& range, double step,
                 double& value) {
  ImGui::SetNextItemWidth(-1);
  double given = value;
  const bool changed =
      ImGui::DragScalar(("##" + mark).c_str(), ImGuiDataType_Double, &given, static_cast<float>(step),
                        nullptr, nullptr, range.format, range.flags);
  marks.item(mark);
  return take_number(changed, given, range, value);
}

}  // namespace hariko
