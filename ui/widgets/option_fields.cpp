#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/tips.hpp"

#include <imgui_stdlib.h>

#include <cmath>

namespace hariko {

namespace {

constexpr float option_column = 96;  ///< where fields begin, design pixels

}  // namespace

void option_label(const Language& tr, const Metrics& metrics, const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(tr(text));
  ImGui::SameLine(metrics.px(option_column));
}

void beside_or_below(const Metrics& metrics, float width, float gap) {
  ImGui::SameLine(0, metrics.px(gap));
  if (ImGui::GetCursorPosX() + width <= ImGui::GetWindowContentRegionMax().x) return;
  ImGui::NewLine();
  ImGui::SetCursorPosX(metrics.px(option_column));
}

float check_width(const char* words) {
  return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(words).x;
}

float labelled_width(const char* words, float field) {
  return ImGui::CalcTextSize(words).x + ImGui::GetStyle().ItemSpacing.x + field;
}

bool option_field(const char* id, const char* help, Marks& marks, float width, const Quantity& quantity,
                  std::string& text, double& value) {
  if (text.empty()) text = format_quantity(quantity, value);
  ImGui::SetNextItemWidth(width);
  ImGui::InputText((std::string("##") + id).c_str(), &text, ImGuiInputTextFlags_AutoSelectAll);
  marks.item(std::string("export.") + id);
  if (ImGui::IsItemHovered()) show_tip(help);
  if (!ImGui::IsItemDeactivatedAfterEdit()) return false;
  const double before = value;
  if (const auto change = parse_change(text, quantity)) value = change->apply(quantity, value);
  text = format_quantity(quantity, value);
  return value != before;
}

Quantity scale_quantity() {
  Quantity quantity = plain_quantity(6, 0.1);
  quantity.multiplies = true;
  quantity.low = 1e-6;
  quantity.high = 1e6;
  return quantity;
}

double one_digit(double value) {
  if (!(value > 0)) return 1;
  const double unit = std::pow(10.0, std::floor(std::log10(value)));
  return std::floor(value / unit) * unit;
}

}  // namespace hariko
