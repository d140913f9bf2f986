#include "ui/analysis/display_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/object_shape.hpp"
#include "ui/analysis/section_curve_edits.hpp"
#include "ui/editor/legend_source.hpp"
#include "ui/widgets/binding.hpp"
#include "ui/widgets/choice.hpp"
#include "ui/widgets/command_services.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

constexpr std::array pull_choices{
    Choice{"X", translatable("The part leaves its mould along x")},
    Choice{"Y", translatable("The part leaves its mould along y")},
    Choice{"Z", translatable("The part leaves its mould along z")},
    Choice{"\u2212X", translatable("The part leaves its mould against x")},
    Choice{"\u2212Y", translatable("The part leaves its mould against y")},
    Choice{"\u2212Z", translatable("The part leaves its mould against z")},
    Choice{translatable("From the view"), translatable("Towards the eye, as the view is now")},
};
constexpr int from_view = 6;

Vector3 pull_axis(int choice) {
  return (choice < 3 ? 1.0 : -1.0) * Vector3::Unit(choice % 3);
}

void pull_row(PanelContext& context) {
  Editor& editor = context.editor;
  const Vector3& pull = editor.document().making.pull;
  int current = 0;
  while (current < from_view && pull_axis(current) != pull) ++current;
  const auto chosen =
      choose(context, "pull", "Pull", "Direction in which the part leaves its mould", pull_choices, current);
  if (!chosen) return;
  MakingSettings making = editor.history.current().making;
  making.pull = *chosen == from_view ? editor.camera().towards_eye() : pull_axis(*chosen);
  editor.commit(set_making(editor.history.current(), making), "Pull direction");
}

/// A number of the settings, shown in a unit that has so many of what is stored. `size`: a value like it.
void limit_row(PanelContext& context, const PropertyRow& texts, double MakingSettings::*member,
               double unit = 1, double size = 1) {
  const MakingSettings now = context.editor.document().making;
  const Binding<MakingSettings> settings(
      context, {&now},
      [](const Document& document, const std::function<void(MakingSettings&)>& change) {
        MakingSettings making = document.making;
        change(making);
        return set_making(document, making);
      },
      size);
  settings.row(
      texts, [=](const MakingSettings& making) { return making.*member / unit; },
      [=](MakingSettings& making, double value) { making.*member = value * unit; });
}

void draft_row(PanelContext& context) {
  PropertyRange angles{.low = 0, .high = MakingSettings::max_draft, .standard = MakingSettings().draft};
  angles.unit = PropertyUnit::degrees;
  limit_row(context,
            {"draft_limit", "Least draft", "Walls with less than this angle to the pull are marked",
             "Least draft", angles},
            &MakingSettings::draft);
}

void length_row(PanelContext& context, PropertyRow texts, double MakingSettings::*member) {
  const Document& document = context.editor.document();
  const double unit = millimetres_per(document.unit);
  constexpr double least = 1e-6, most = 1e6;  // millimetres: within what the settings allow
  texts.range = {.low = least / unit,
                 .high = most / unit,
                 .standard = MakingSettings().*member / unit,
                 .unit = PropertyUnit::length};
  // Two decimals behind the leading digit: tools and walls are seldom finer.
  limit_row(context, texts, member, unit, 10 * document.making.*member / unit);
}

void reference_row(PanelContext& context) {
  Editor& editor = context.editor;
  const Language& tr = context.tr;
  const Document& document = editor.document();
  const Object* now = document.find(document.making.reference);
  row_label(context, "Reference", "The object that the others deviate from");
  const OpenScope list = list_scope(context.marks, "combo.reference", now ? now->name : tr("None"), -1);
  point_out(context, "reference");
  if (!list) return;
  const auto offer = [&](ObjectId id, const std::string& name) {
    if (!selectable_row(context.marks, "reference." + std::to_string(id.value), name,
                        id == document.making.reference))
      return;
    MakingSettings making = editor.history.current().making;
    making.reference = id;
    later(context, set_making(editor.history.current(), making), "Reference of deviations");
  };
  offer(ObjectId{}, tr("None"));
  for (const auto& object : document.objects)
    if (object->visible && has_shape(*object)) offer(object->id, object->name);
}

}  // namespace

void making_rows(PanelContext& context, SurfaceMap map) {
  if (map == SurfaceMap::draft) {
    pull_row(context);
    draft_row(context);
  }
  if (map == SurfaceMap::radius)
    length_row(context,
               {"radius_limit", "Least radius", "What is bent more tightly, no tool of this radius can make",
                "Least radius"},
               &MakingSettings::radius);
  if (map == SurfaceMap::thickness)
    length_row(context,
               {"thickness_limit", "Least wall", "Walls that are thinner than this are marked", "Least wall"},
               &MakingSettings::thickness);
  if (map == SurfaceMap::deviation) reference_row(context);
}

void missing_map_row(PanelContext& context) {
  const auto missing = missing_map(context.editor);
  if (!missing || !missing->object.empty()) return;
  coloured_lines(palette().warning,
                 context.tr.text_of(*missing->reason) + " " + context.tr.remedy_of(*missing->reason));
  context.marks.item("map.missing");
}

namespace {

/// A button with the name of the file, which asks for another one.
void environment_file_row(PanelContext& context, const EnvironmentSettings& environment) {
  const std::string name = sanitized_utf8(std::filesystem::path(environment.file).filename().string());
  context.editor.show_text(name);
  row_label(context, context.tr("File"), "");
  if (text_button(context.marks, "button.environment_file", name, -1)) context.services.choose_environment();
  if (ImGui::IsItemHovered()) show_tip(sanitized_utf8(environment.file));
}

}  // namespace

void environment_rows(PanelContext& context) {
  Editor& editor = context.editor;
  EnvironmentSettings& environment = editor.settings.environment;
  if (const auto chosen = choose(context, "environment", "Environment", "What shaded surfaces reflect",
                                 std::optional(environment.kind))) {
    if (*chosen == EnvironmentKind::file && environment.file.empty())
      context.services.choose_environment();
    else
      editor.show_environment(*chosen);
  }
  if (environment.kind == EnvironmentKind::file) environment_file_row(context, environment);
  slider_row(context, "environment_turn", translatable("Turn"),
             translatable("Turns the environment about z: drag, and highlights run over the surface"),
             {0, 360, "%.0f\u00b0"}, environment.turn);
  slider_row(context, "environment_exposure", translatable("Exposure"),
             translatable("Stops: each doubles the light of the environment"),
             {-Environment::most_exposure, Environment::most_exposure, "%+.1f"}, environment.exposure);
}

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
  const std::string format = std::string("%.4g ") + std::string(to_string(context.editor.document().unit));
  number_drag(context.marks, std::string("drag.") + id,
              {low, std::numeric_limits<double>::max(), format.c_str(), ImGuiSliderFlags_NoRoundToFormat},
              step, value);
  point_out(context, id);
}

void plane_rows(PanelContext& context, SectionCurves& curves) {
  SectionPlanes& planes = curves.planes;
  across_row(context, curves);
  slider_row(context, "section_count", translatable("Planes"), translatable("Number of section planes"),
             {1, 50, "%d", ImGuiSliderFlags_AlwaysClamp}, planes.count);
  planes.count = std::clamp(planes.count, 1, SectionPlanes::most);
  constexpr double share = 0.01;  // share of the spacing for each pixel of a drag
  length_drag(context, "section_first", "First at", "Place of the first plane along the direction",
              planes.first, share * planes.spacing, std::numeric_limits<double>::lowest());
  if (planes.count > 1)
    length_drag(context, "section_spacing", "Spacing", "From plane to plane", planes.spacing,
                share * planes.spacing, least_section_spacing);
  if (text_button(context.marks, "button.section_spread", context.tr("Spread evenly")))
    spread_sections(context.editor);
}

void comb_row(PanelContext& context, SectionCurves& curves) {
  if (const auto on = check_row(context, "section_combs", "Teeth",
                                "Curvature combs on the section curves, of one scale", curves.combs.shown))
    curves.combs.shown = *on;
  if (!curves.combs.shown) return;
  ImGui::SameLine();
  number_slider(
      context.marks, "slider.section_scale",
      {SectionCombs::least_scale, SectionCombs::most_scale, "%.2f\u00d7",
       ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoRoundToFormat},
      curves.combs.scale);
  if (!std::isfinite(curves.combs.scale)) curves.combs.scale = 1;
}

}  // namespace

void section_curve_rows(PanelContext& context) {
  SectionCurves& curves = context.editor.sections;
  if (const auto on = check_row(context, "section_curves", "Section lines",
                                "Curves of several planes through all visible surfaces", curves.shown))
    show_section_curves(context.editor, *on);
  if (!curves.shown) return;
  plane_rows(context, curves);
  comb_row(context, curves);
  if (!curves.error) return;
  coloured_lines(palette().warning,
                 context.tr.text_of(*curves.error) + " " + context.tr.remedy_of(*curves.error));
  context.marks.item("sections.error");
}

}  // namespace hariko
