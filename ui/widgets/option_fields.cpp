#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/tips.hpp"

#include <imgui_stdlib.h>

#include <cmath>
#include <vector>

#include "core/document/words.hpp"

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
  marks.item(id);
  if (ImGui::IsItemHovered()) show_tip(help);
  if (!ImGui::IsItemDeactivatedAfterEdit()) return false;
  const double before = value;
  if (const auto change = parse_change(text, quantity)) value = change->apply(quantity, value);
  text = format_quantity(quantity, value);
  return value != before;
}

std::optional<std::size_t> option_list(Marks& marks, const std::string& mark, float width,
                                       std::span<const std::string> labels, std::size_t current,
                                       std::span<const std::string> ids, const char* help) {
  std::optional<std::size_t> chosen;
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo(("##" + mark).c_str(), labels[current].c_str());
  marks.item(mark);
  if (open) {
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (ImGui::Selectable(labels[i].c_str(), i == current)) chosen = i;
      marks.item(mark + "." + (ids.empty() ? std::to_string(i) : ids[i]));
    }
    ImGui::EndCombo();
  } else if (*help && ImGui::IsItemHovered()) {
    show_tip(help);
  }
  return chosen;
}

std::optional<Unit> option_unit(Marks& marks, const std::string& mark, float width, Unit current,
                                const char* help) {
  const std::vector<std::string> symbols = enum_word_list<Unit>();
  const auto chosen =
      option_list(marks, mark, width, symbols, static_cast<std::size_t>(current), symbols, help);
  return chosen ? std::optional(static_cast<Unit>(*chosen)) : std::nullopt;
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
