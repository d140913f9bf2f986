#include "ui/files/cad_options.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "core/cad/kernel/cad_file.hpp"
#include "ui/files/export_text.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/option_fields.hpp"

namespace hariko {

namespace {

/// Shares of the size: the finest and coarsest that make sense to ask for.
constexpr double finest = 1e-9, coarsest = 1e-2;
constexpr double degree = std::numbers::pi / 180;
constexpr std::array quality_names{translatable("light"), translatable("balanced"), translatable("fine")};
static_assert(quality_names.size() == enum_words<CadQuality>.size());

}  // namespace

void CadOptions::begin(const Editor& editor) {
  Box3 box;
  for (const auto& object : editor.document().objects)
    if (object->visible && object->has_surface()) box.extend(box_at_own_place(*object));
  size_ = box.isEmpty() ? 1 : std::max(box.diagonal().norm(), 1e-9);
  double& tolerance = settings_.choices.tolerance;
  const bool suits = tolerance >= finest * size() && tolerance <= coarsest * size();
  const Unit unit = editor.document().unit;
  if (!suits) take_quality(settings_.choices.quality, unit);
  if (settings_.choices.angle == 0) settings_.choices.angle = grade_of(settings_.choices.quality).angle;
  tolerance_text_ = angle_text_ = scale_text_ = {};
  settings_.wall = {};  // another part has another one
  wall_options_.begin();
  count_.reset();
}

double CadOptions::tolerance_of(CadQuality quality, Unit unit) const {
  const CadGrade grade = grade_of(quality);
  return one_digit(std::max(grade.millimetres / millimetres_per(unit), grade.share * size()));
}

void CadOptions::take_quality(CadQuality quality, Unit unit) {
  settings_.choices.quality = quality;
  settings_.choices.tolerance = std::clamp(tolerance_of(quality, unit), finest * size(), coarsest * size());
  settings_.choices.angle = grade_of(quality).angle;
  tolerance_text_ = angle_text_ = {};
}

void CadOptions::quality_row(PanelContext& context) {
  const Unit unit = context.editor.document().unit;
  const auto chosen = [&](CadQuality quality) {
    return settings_.choices.angle == grade_of(quality).angle &&
           settings_.choices.tolerance ==
               std::clamp(tolerance_of(quality, unit), finest * size(), coarsest * size());
  };
  option_label(context, "Quality");
  for (const CadQuality quality : enum_values<CadQuality>()) {
    const char* name = context.tr(quality_names[static_cast<std::size_t>(quality)]);
    if (quality != CadQuality::light) beside_or_below(context, check_width(name));
    if (radio_button(context.marks, "export.cad_quality." + std::string(enum_word(quality)), name,
                     chosen(quality)))
      take_quality(quality, unit);
  }
  check_beside(context, "export.cad_exact", "exact splines",
               "What is a spline stays it, also where fewer control points would do", settings_.choices.exact,
               16);
  check_beside(context, "export.cad_whole_faces", "whole faces",
               "Each face with four sides stays one face in the file, also where several weigh less",
               settings_.choices.whole_faces, 16);
}

void CadOptions::tolerance_row(PanelContext& context) {
  option_label(context, "Tolerance");
  Quantity length = length_quantity(context.editor.document().unit, settings_.choices.tolerance);
  length.low = finest * size();
  length.high = coarsest * size();
  option_field(context, "export.cad_tolerance",
               "The farthest that faces may be from the surface where they cannot be the surface itself", 110,
               length, tolerance_text_, settings_.choices.tolerance);
  words_beside(context, "Angle", 80, 16);
  Quantity turn = angle_quantity();
  turn.decimals = 3;
  turn.low = 0.001;
  turn.high = 10;
  turn.step = 0.01;
  double degrees = settings_.choices.angle / degree;
  if (option_field(context, "export.cad_angle",
                   "The most that normals may jump between faces along smooth edges", 80, turn, angle_text_,
                   degrees))
    settings_.choices.angle = degrees * degree;
}

void CadOptions::unit_row(PanelContext& context) {
  CadChoices& choices = settings_.choices;
  option_label(context, "Unit");
  if (const auto chosen = option_unit(context, "export.cad_unit", 110, choices.unit,
                                      "Of the numbers in the file. Sizes stay what they are."))
    choices.unit = *chosen;
  words_beside(context, "Scale", 80, 16);
  const double before = choices.scale;
  if (!option_field(context, "export.cad_scale", "All lengths are multiplied by it", 80, scale_quantity(),
                    scale_text_, choices.scale))
    return;
  choices.tolerance *= choices.scale / before;  // the faces stay the same
  tolerance_text_ = {};
}

void CadOptions::add_schema(PanelContext& context, const std::filesystem::path& name) {
  constexpr float both = 140;
  words_beside(context, "STEP schema", both, 24);
  const Disabled disabled(cad_format_of(name) == CadFormat::iges);
  bool& ap242 = settings_.choices.ap242;
  if (radio_button(context.marks, "export.ap214", "AP214", !ap242)) ap242 = false;
  ImGui::SameLine();
  if (radio_button(context.marks, "export.ap242", "AP242", ap242)) ap242 = true;
}

void CadOptions::result_rows(PanelContext& context) const {
  const Language& tr = context.tr;
  // Rows below must not move when the result comes.
  const float below = ImGui::GetCursorPosY() + 2 * ImGui::GetFrameHeightWithSpacing();
  ImGui::AlignTextToFramePadding();
  if (!count_) {
    dim_text(tr("Fitting faces\u2026"));
  } else {
    if (count_->ok())
      text_in_lines(cad_count_text(tr, count_->value(), context.editor.document().unit));
    else
      coloured_lines(palette().error, tr.text_of(count_->error()));
    context.marks.item("export.result");
  }
  ImGui::SetCursorPosY(std::max(below, ImGui::GetCursorPosY()));
}

bool CadOptions::draw(PanelContext& context, const std::filesystem::path& name) {
  const CadSettings before = settings_;
  quality_row(context);
  tolerance_row(context);
  option_label(context, "Objects");
  option_check(context, "export.cad_selected", "selected objects only", "", settings_.only_selected);
  add_schema(context, name);
  wall_options_.draw(context, size_, settings_.wall);
  unit_row(context);
  result_rows(context);
  if (settings_.same_faces(before)) return false;
  count_.reset();
  return true;
}

void CadOptions::take(const CadSettings& settings, const Result<CadTotals>& count) {
  if (settings.same_faces(settings_)) count_ = count;
}

}  // namespace hariko
