#include "ui/panels/cad_options.hpp"

#include <imgui_stdlib.h>

#include <array>
#include <cmath>

namespace hariko {

namespace {

constexpr float label_width = 96;
/// Of the size: what CAD programs take for smooth, and the finest and coarsest that make sense to ask for.
constexpr double usual = 1e-5, finest = 1e-9, coarsest = 1e-2;

void label(const Language& tr, const Metrics& metrics, const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(tr(text));
  ImGui::SameLine(metrics.px(label_width));
}

/// One leading digit: 0.0347 becomes 0.03.
double rounded(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)));
  return std::floor(value / unit) * unit;
}

}  // namespace

void CadOptions::begin(const Editor& editor) {
  Box3 box;
  for (const auto& object : editor.document().objects)
    if (object->visible && object->has_surface()) box.extend(world_box(*object));
  size_ = box.isEmpty() ? 1 : std::max(box.diagonal().norm(), 1e-9);
  const bool suits = choices_.tolerance >= finest * size_ && choices_.tolerance <= coarsest * size_;
  if (!suits) choices_.tolerance = rounded(usual * size_);
  tolerance_text_ = {};
}

void CadOptions::tolerance_row(const Editor& editor, Marks& marks, const Metrics& metrics) {
  const Language& tr = editor.language;
  label(tr, metrics, translatable("Tolerance"));
  Quantity length = length_quantity(editor.document().unit, choices_.tolerance);
  length.low = finest * size_;
  length.high = coarsest * size_;
  if (tolerance_text_.empty()) tolerance_text_ = format_quantity(length, choices_.tolerance);
  ImGui::SetNextItemWidth(metrics.px(110));
  ImGui::InputText("##cad_tolerance", &tolerance_text_);
  marks.item("export.cad_tolerance");
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip(
        "%s", tr("The farthest that faces may be from the surface where they cannot be the surface itself"));
  if (!ImGui::IsItemDeactivatedAfterEdit()) return;
  if (const auto change = parse_change(tolerance_text_, length))
    choices_.tolerance = change->apply(length, choices_.tolerance);
  tolerance_text_ = format_quantity(length, choices_.tolerance);
}

void CadOptions::unit_row(const Editor& editor, Marks& marks, const Metrics& metrics) {
  const Language& tr = editor.language;
  constexpr std::array units{Unit::millimetre, Unit::centimetre, Unit::metre, Unit::inch};
  label(tr, metrics, translatable("Unit"));
  ImGui::SetNextItemWidth(metrics.px(110));
  const bool open = ImGui::BeginCombo("##cad_unit", std::string(to_string(choices_.unit)).c_str());
  marks.item("export.cad_unit");
  if (open) {
    for (const Unit unit : units) {
      const std::string name(to_string(unit));
      if (ImGui::Selectable(name.c_str(), choices_.unit == unit)) choices_.unit = unit;
      marks.item("export.cad_unit." + name);
    }
    ImGui::EndCombo();
  }
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("%s", tr("Of the numbers in the file. Sizes stay what they are."));
}

void CadOptions::draw(const Editor& editor, Marks& marks, const Metrics& metrics) {
  const Language& tr = editor.language;
  tolerance_row(editor, marks, metrics);
  unit_row(editor, marks, metrics);
  constexpr std::array schemas{"AP214", "AP242"};
  label(tr, metrics, translatable("STEP schema"));
  if (ImGui::RadioButton(schemas[0], !choices_.ap242)) choices_.ap242 = false;
  marks.item("export.ap214");
  ImGui::SameLine();
  if (ImGui::RadioButton(schemas[1], choices_.ap242)) choices_.ap242 = true;
  marks.item("export.ap242");
}

}  // namespace hariko
