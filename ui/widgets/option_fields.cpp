#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/inputs.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/tips.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/document/words.hpp"

namespace hariko {

namespace {

constexpr float option_column = 96;  ///< place at which fields begin, design pixels

}  // namespace

void option_label(const PanelContext& context, const char* text) {
  aligned_text(context.tr(text));
  ImGui::SameLine(context.metrics.px(option_column));
}

void beside_or_below(const PanelContext& context, float width, float gap) {
  ImGui::SameLine(0, context.metrics.px(gap));
  if (ImGui::GetCursorPosX() + width <= ImGui::GetWindowContentRegionMax().x) return;
  ImGui::NewLine();
  ImGui::SetCursorPosX(context.metrics.px(option_column));
}

float check_width(const char* words) {
  return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(words).x;
}

float labelled_width(const char* words, float field) {
  return ImGui::CalcTextSize(words).x + ImGui::GetStyle().ItemSpacing.x + field;
}

bool option_check(const PanelContext& context, const char* id, const char* text, const char* help,
                  bool& value) {
  const bool pressed = ImGui::Checkbox((std::string(context.tr(text)) + "##" + id).c_str(), &value);
  context.marks.item(id);
  if (*help && ImGui::IsItemHovered()) show_tip(context.tr(help));
  return pressed;
}

std::optional<bool> mixed_check(Marks& marks, const std::string& mark, const std::string& text,
                                std::optional<bool> value) {
  bool on = value.value_or(false);
  ImGui::PushItemFlag(ImGuiItemFlags_MixedValue, !value);
  const bool pressed = ImGui::Checkbox((text + "###" + mark).c_str(), &on);
  ImGui::PopItemFlag();
  marks.item(mark);
  return pressed ? std::optional(on) : std::nullopt;
}

void check_beside(const PanelContext& context, const char* id, const char* text, const char* help,
                  bool& value, float gap) {
  beside_or_below(context, check_width(context.tr(text)), gap);
  option_check(context, id, text, help, value);
}

void words_beside(const PanelContext& context, const char* text, float field, float gap) {
  beside_or_below(context, labelled_width(context.tr(text), context.metrics.px(field)), gap);
  plain_text(context.tr(text));
  ImGui::SameLine();
}

bool option_field(const PanelContext& context, const char* id, const char* help, float width,
                  const Quantity& quantity, std::string& text, double& value) {
  if (text.empty()) text = format_quantity(quantity, value);
  text_field(context.marks, id, text, context.metrics.px(width), "", ImGuiInputTextFlags_AutoSelectAll);
  if (ImGui::IsItemHovered()) show_tip(context.tr(help));
  if (!ImGui::IsItemDeactivatedAfterEdit()) return false;
  const double before = value;
  if (const auto change = parse_change(text, quantity)) value = change->apply(quantity, value);
  text = format_quantity(quantity, value);
  return value != before;
}

std::optional<std::size_t> option_list(const PanelContext& context, const std::string& mark, float width,
                                       std::span<const std::string> labels, std::size_t current,
                                       std::span<const std::string> ids, const char* help) {
  std::optional<std::size_t> chosen;
  const float room = std::min(context.metrics.px(width), ImGui::GetContentRegionAvail().x);
  const OpenScope list = list_scope(context.marks, mark, labels[current], room);
  if (!list && *help && ImGui::IsItemHovered()) show_tip(context.tr(help));
  for (std::size_t i = 0; list && i < labels.size(); ++i)
    if (selectable_row(context.marks, mark + "." + (ids.empty() ? std::to_string(i) : ids[i]), labels[i],
                       i == current))
      chosen = i;
  return chosen;
}

std::optional<Unit> option_unit(const PanelContext& context, const std::string& mark, float width,
                                Unit current, const char* help) {
  const std::vector<std::string> symbols = enum_word_list<Unit>();
  const auto chosen =
      option_list(context, mark, width, symbols, static_cast<std::size_t>(current), symbols, help);
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
