#include "ui/files/cad_options.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "core/cad/kernel/cad_file.hpp"
#include "ui/files/export_text.hpp"
#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/tips.hpp"

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

void CadOptions::quality_row(const Editor& editor, Marks& marks, const Metrics& metrics) {
  const Language& tr = editor.language;
  const Unit unit = editor.document().unit;
  const auto chosen = [&](CadQuality quality) {
    return settings_.choices.angle == grade_of(quality).angle &&
           settings_.choices.tolerance ==
               std::clamp(tolerance_of(quality, unit), finest * size(), coarsest * size());
  };
  option_label(tr, metrics, translatable("Quality"));
  for (const CadQuality quality : enum_values<CadQuality>()) {
    const char* name = tr(quality_names[static_cast<std::size_t>(quality)]);
    if (quality != CadQuality::light) beside_or_below(metrics, check_width(name));
    if (ImGui::RadioButton((std::string(name) + "##cad_quality").c_str(), chosen(quality)))
      take_quality(quality, unit);
    marks.item("export.cad_quality." + std::string(enum_word(quality)));
  }
  beside_or_below(metrics, check_width(tr("exact splines")), 16);
  ImGui::Checkbox((std::string(tr("exact splines")) + "##cad_exact").c_str(), &settings_.choices.exact);
  marks.item("export.cad_exact");
  if (ImGui::IsItemHovered())
    show_tip(tr("What is a spline stays it, also where fewer control points would do"));
  beside_or_below(metrics, check_width(tr("whole faces")), 16);
  ImGui::Checkbox((std::string(tr("whole faces")) + "##cad_whole_faces").c_str(),
                  &settings_.choices.whole_faces);
  marks.item("export.cad_whole_faces");
  if (ImGui::IsItemHovered())
    show_tip(tr("Each face with four sides stays one face in the file, also where several weigh less"));
}

void CadOptions::tolerance_row(const Editor& editor, Marks& marks, const Metrics& metrics) {
  const Language& tr = editor.language;
  option_label(tr, metrics, translatable("Tolerance"));
  Quantity length = length_quantity(editor.document().unit, settings_.choices.tolerance);
  length.low = finest * size();
  length.high = coarsest * size();
  option_field("export.cad_tolerance",
               tr("The farthest that faces may be from the surface where they cannot be the surface itself"),
               marks, metrics.px(110), length, tolerance_text_, settings_.choices.tolerance);
  beside_or_below(metrics, labelled_width(tr("Angle"), metrics.px(80)), 16);
  ImGui::TextUnformatted(tr("Angle"));
  ImGui::SameLine();
  Quantity turn = angle_quantity();
  turn.decimals = 3;
  turn.low = 0.001;
  turn.high = 10;
  turn.step = 0.01;
  double degrees = settings_.choices.angle / degree;
  if (option_field("export.cad_angle", tr("The most that normals may jump between faces along smooth edges"),
                   marks, metrics.px(80), turn, angle_text_, degrees))
    settings_.choices.angle = degrees * degree;
}

void CadOptions::selected_row(const Language& tr, Marks& marks, const Metrics& metrics) {
  option_label(tr, metrics, translatable("Objects"));
  ImGui::Checkbox((std::string(tr("selected objects only")) + "##cad_selected").c_str(),
                  &settings_.only_selected);
  marks.item("export.cad_selected");
}

void CadOptions::unit_row(const Editor& editor, Marks& marks, const Metrics& metrics) {
  const Language& tr = editor.language;
  CadChoices& choices = settings_.choices;
  option_label(tr, metrics, translatable("Unit"));
  if (const auto chosen = option_unit(marks, "export.cad_unit", metrics.px(110), choices.unit,
                                      tr("Of the numbers in the file. Sizes stay what they are.")))
    choices.unit = *chosen;
  beside_or_below(metrics, labelled_width(tr("Scale"), metrics.px(80)), 16);
  ImGui::TextUnformatted(tr("Scale"));
  ImGui::SameLine();
  const double before = choices.scale;
  if (!option_field("export.cad_scale", tr("All lengths are multiplied by it"), marks, metrics.px(80),
                    scale_quantity(), scale_text_, choices.scale))
    return;
  choices.tolerance *= choices.scale / before;  // the faces stay the same
  tolerance_text_ = {};
}

void CadOptions::schema_row(const Language& tr, Marks& marks, const Metrics& metrics,
                            const std::filesystem::path& name) {
  constexpr std::array schemas{"AP214", "AP242"};
  option_label(tr, metrics, translatable("STEP schema"));
  const Disabled disabled(cad_format_of(name) == CadFormat::iges);
  if (ImGui::RadioButton(schemas[0], !settings_.choices.ap242)) settings_.choices.ap242 = false;
  marks.item("export.ap214");
  ImGui::SameLine();
  if (ImGui::RadioButton(schemas[1], settings_.choices.ap242)) settings_.choices.ap242 = true;
  marks.item("export.ap242");
}

void CadOptions::result_rows(const Editor& editor, Marks& marks) const {
  const Language& tr = editor.language;
  // What comes below must not move when the result comes.
  const float below = ImGui::GetCursorPosY() + 2 * ImGui::GetFrameHeightWithSpacing();
  ImGui::AlignTextToFramePadding();
  if (!count_) {
    ImGui::TextDisabled("%s", tr("Fitting faces\u2026"));
  } else if (count_->ok()) {
    ImGui::TextWrapped("%s", cad_count_text(tr, count_->value(), editor.document().unit).c_str());
    marks.item("export.result");
  } else {
    const TextColour colour(palette().error);
    ImGui::TextWrapped("%s", tr.text_of(count_->error()).c_str());
    marks.item("export.result");
  }
  ImGui::SetCursorPosY(std::max(below, ImGui::GetCursorPosY()));
}

bool CadOptions::draw(const Editor& editor, Marks& marks, const Metrics& metrics,
                      const std::filesystem::path& name) {
  const CadSettings before = settings_;
  quality_row(editor, marks, metrics);
  tolerance_row(editor, marks, metrics);
  selected_row(editor.language, marks, metrics);
  unit_row(editor, marks, metrics);
  schema_row(editor.language, marks, metrics, name);
  result_rows(editor, marks);
  if (settings_.same_faces(before)) return false;
  count_.reset();
  return true;
}

void CadOptions::take(const CadSettings& settings, const Result<CadTotals>& count) {
  if (settings.same_faces(settings_)) count_ = count;
}

}  // namespace hariko
