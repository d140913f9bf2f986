#include "ui/analysis/section_curve_rows.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "ui/analysis/section_curve_edits.hpp"
#include "ui/base/text_lines.hpp"
#include "ui/widgets/choice.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

constexpr std::array across_choices{
    Choice{"X", ""},
    Choice{"Y", ""},
    Choice{"Z", ""},
    Choice{translatable("Working plane"), translatable("Along the plane in which tools draw")},
};
constexpr int along_working_plane = 3;

void across_row(PanelContext& context, SectionCurves& curves) {
  int current = 0;
  while (current < along_working_plane && curves.planes.direction != Vector3::Unit(current)) ++current;
  const auto chosen = choose(context, "section_across", "Across",
                             "The direction that the planes are square to", across_choices, current);
  if (chosen)
    turn_section_planes(context.editor, *chosen == along_working_plane
                                            ? context.editor.working_plane.frame.normal()
                                            : Vector3(Vector3::Unit(*chosen)));
}

/// A length along the direction, dragged or typed; the value is kept within `low`.
void length_drag(PanelContext& context, const char* id, const char* label, const char* help, double& value,
                 double step, double low) {
  row_label(context, context.tr(label), context.tr(help));
  ImGui::SetNextItemWidth(-1);
  const std::string format = std::string("%.4g ") + std::string(to_string(context.editor.document().unit));
  double edited = value;
  if (ImGui::DragScalar((std::string("##") + id).c_str(), ImGuiDataType_Double, &edited,
                        static_cast<float>(step), nullptr, nullptr, format.c_str(),
                        ImGuiSliderFlags_NoRoundToFormat) &&
      std::isfinite(edited))
    value = std::max(edited, low);
  context.marks.item(std::string("drag.") + id);
}

void plane_rows(PanelContext& context, SectionCurves& curves) {
  SectionPlanes& planes = curves.planes;
  across_row(context, curves);
  row_label(context, context.tr("Planes"), context.tr("Number of section planes"));
  int count = planes.count;
  if (number_slider("##section_count", {1, 50, "%d", ImGuiSliderFlags_None}, count))
    planes.count = std::clamp(count, 1, SectionPlanes::most);
  context.marks.item("slider.section_count");
  constexpr double share = 0.01;  // share of the spacing for each pixel of a drag
  length_drag(context, "section_first", "First at", "Place of the first plane along the direction",
              planes.first, share * planes.spacing, std::numeric_limits<double>::lowest());
  if (planes.count > 1)
    length_drag(context, "section_spacing", "Spacing", "From plane to plane", planes.spacing,
                share * planes.spacing, least_section_spacing);
  if (ImGui::Button(context.tr("Spread evenly"))) spread_sections(context.editor);
  context.marks.item("button.section_spread");
}

void comb_row(PanelContext& context, SectionCurves& curves) {
  row_label(context, context.tr("Teeth"), context.tr("Curvature combs on the section curves, of one scale"));
  ImGui::Checkbox("##section_combs", &curves.combs.shown);
  context.marks.item("check.section_combs");
  point_out(context, "section_combs");
  if (!curves.combs.shown) return;
  ImGui::SameLine();
  number_slider(
      "##section_scale",
      {SectionCombs::least_scale, SectionCombs::most_scale, "%.2f\u00d7",
       ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoRoundToFormat},
      curves.combs.scale);
  if (!std::isfinite(curves.combs.scale)) curves.combs.scale = 1;
  context.marks.item("slider.section_scale");
}

}  // namespace

void section_curve_rows(PanelContext& context) {
  SectionCurves& curves = context.editor.sections;
  row_label(context, context.tr("Section lines"),
            context.tr("Curves of several planes through all visible surfaces"));
  bool shown = curves.shown;
  if (ImGui::Checkbox("##section_curves", &shown)) show_section_curves(context.editor, shown);
  context.marks.item("check.section_curves");
  if (!curves.shown) return;
  plane_rows(context, curves);
  comb_row(context, curves);
  if (!curves.error) return;
  const TextColour colour(palette().warning);
  text_in_lines(context.tr.text_of(*curves.error) + " " + context.tr.remedy_of(*curves.error));
  context.marks.item("sections.error");
}

}  // namespace hariko
