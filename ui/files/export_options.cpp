#include "ui/files/export_options.hpp"

#include <imgui.h>

#include <array>
#include <numbers>

#include "core/base/files/file_ending.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

constexpr double to_degrees = 180 / std::numbers::pi;
/// Of the size: about what an eye tells apart on a screen, and the finest that makes sense to ask for.
constexpr double usual_tolerance = 5e-4, finest_tolerance = 1e-6;

/// The format of this ending holds fewer digits than the document.
bool rounds(const std::string& extension) {
  return file_numbers("a" + extension, {}).kind != FileNumbers::Kind::exact;
}

Quantity degrees() {
  Quantity quantity = angle_quantity();
  quantity.low = 0;
  quantity.high = 80;
  return quantity;
}

}  // namespace

void ExportOptions::take_up(const std::filesystem::path& name) {
  const std::string extension = lower_ending(name);
  if (extension == extension_ || !written_format(name)) return;
  extension_ = extension;
  if (const auto found = remembered_.find(extension); found != remembered_.end()) settings_ = found->second;
  suit_size();
}

void ExportOptions::suit_size() {
  const bool suits = settings_.distance >= finest_tolerance * size_ && settings_.distance <= 0.1 * size_;
  if (!suits) settings_.distance = one_digit(usual_tolerance * size_);
  distance_text_ = angle_text_ = scale_text_ = {};
}

void ExportOptions::begin(const Editor& editor, const std::filesystem::path& name) {
  Box3 box;
  for (const auto& object : editor.document().objects)
    if (object->visible) box.extend(box_at_own_place(*object));
  size_ = box.isEmpty() ? 1 : box.diagonal().norm();
  take_up(name);
  suit_size();
  count_.reset();
}

void ExportOptions::tolerance_row(const Editor& editor, Marks& marks, const Metrics& metrics) {
  const Language& tr = editor.language;
  option_label(tr, metrics, translatable("Distance"));
  Quantity length = length_quantity(editor.document().unit, settings_.distance);
  length.low = finest_tolerance * size_;
  length.high = size_;
  option_field("export.distance", tr("The farthest that the surface may be from its triangles"), marks,
               metrics.px(110), length, distance_text_, settings_.distance);
  beside_or_below(metrics, labelled_width(tr("Angle"), metrics.px(80)));
  ImGui::TextUnformatted(tr("Angle"));
  ImGui::SameLine();
  double angle = settings_.angle * to_degrees;
  if (option_field("export.angle", tr("The largest angle between the surface and its triangles; 0 for any"),
                   marks, metrics.px(80), degrees(), angle_text_, angle))
    settings_.angle = angle / to_degrees;
  beside_or_below(metrics, check_width(tr("fewest triangles")));
  ImGui::Checkbox((std::string(tr("fewest triangles")) + "##optimise").c_str(), &settings_.optimise);
  marks.item("export.optimise");
  if (ImGui::IsItemHovered())
    show_tip(tr("Looks for the smallest mesh within the tolerance. Takes many times longer."));
}

void ExportOptions::result_row(const Editor& editor, Marks& marks) const {
  const Language& tr = editor.language;
  ImGui::AlignTextToFramePadding();
  if (!count_) return ImGui::TextDisabled("%s", tr("Counting triangles\u2026"));
  if (!count_->ok()) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette().error);
    const Message& error = count_->error();
    ImGui::TextWrapped("%s", (tr.text_of(error) + " " + tr.remedy_of(error)).c_str());
    return ImGui::PopStyleColor();
  }
  const ExportCount& count = count_->value();
  std::string text = fill(tr("triangles: {0}"), {std::to_string(count.triangles)});
  if (settings_.by == ExportSettings::By::tolerance) {
    const Quantity length = length_quantity(editor.document().unit, count.distance);
    text += "   \u00b7   " +
            fill(count.certain ? tr("off by {0} at the most") : tr("off by {0} at the most, by samples"),
                 {format_quantity(length, count.distance)}) +
            "   \u00b7   " +
            fill(tr("turned by {0} at the most"), {format_quantity(degrees(), count.angle * to_degrees)});
    if (!count.reached) text += "   \u00b7   " + std::string(tr("the tolerance is not reached everywhere"));
  }
  ImGui::TextWrapped("%s", text.c_str());
  marks.item("export.result");
}

void ExportOptions::kind_row(const Editor& editor, Marks& marks, const Metrics& metrics) {
  const Language& tr = editor.language;
  const std::array<std::string, 2> names{tr("Within a tolerance"), tr("By density")};
  option_label(tr, metrics, translatable("Triangles"));
  if (const auto chosen =
          option_list(marks, "export.by", metrics.px(220), names, static_cast<std::size_t>(settings_.by)))
    settings_.by = static_cast<ExportSettings::By>(*chosen);
  beside_or_below(metrics, check_width(tr("selected objects only")));
  ImGui::Checkbox((std::string(tr("selected objects only")) + "##selected").c_str(),
                  &settings_.only_selected);
  marks.item("export.selected");
  beside_or_below(metrics, check_width(tr("move to zero")));
  ImGui::Checkbox((std::string(tr("move to zero")) + "##zero").c_str(), &settings_.choices.to_zero);
  marks.item("export.zero");
  if (ImGui::IsItemHovered())
    show_tip(
        tr("The middle of all that is written comes to lie at zero, which keeps models far "
           "away precise in formats of few digits."));
}

void ExportOptions::file_row(const Editor& editor, Marks& marks, const Metrics& metrics,
                             const FormatChoices& format) {
  const Language& tr = editor.language;
  FileChoices& choices = settings_.choices;
  option_label(tr, metrics, translatable("Unit"));
  if (format.unit) {
    const Unit own = editor.document().unit;
    if (const auto chosen = option_unit(marks, "export.unit", metrics.px(80), choices.unit.value_or(own)))
      choices.unit = *chosen == own ? std::nullopt : chosen;
  } else {
    ImGui::TextUnformatted(tr("metres, as the format says"));
  }
  beside_or_below(metrics, labelled_width(tr("Scale"), metrics.px(80)), 16);
  ImGui::TextUnformatted(tr("Scale"));
  ImGui::SameLine();
  option_field("export.scale", tr("All lengths are multiplied by it"), marks, metrics.px(80),
               scale_quantity(), scale_text_, choices.scale);
  beside_or_below(metrics, labelled_width(tr("Up"), 4 * ImGui::GetFrameHeight()), 16);
  if (!format.up) return ImGui::TextUnformatted(format.unit ? tr("z is up") : tr("y is up"));
  ImGui::TextUnformatted(tr("Up"));
  for (const bool y_up : {false, true}) {
    ImGui::SameLine();
    if (ImGui::RadioButton(y_up ? "Y" : "Z", choices.y_up == y_up)) choices.y_up = y_up;
    marks.item(y_up ? "export.up.y" : "export.up.z");
  }
  if (!format.encoding) return;
  beside_or_below(metrics, check_width(tr("as text")), 16);
  ImGui::Checkbox((std::string(tr("as text")) + "##ascii").c_str(), &choices.ascii);
  marks.item("export.ascii");
  if (ImGui::IsItemHovered())
    show_tip(tr("ASCII instead of binary, for programs that read nothing else. The file gets larger."));
}

bool ExportOptions::draw(const Editor& editor, Marks& marks, const Metrics& metrics,
                         const std::filesystem::path& name) {
  const Language& tr = editor.language;
  const ExportSettings before = settings_;
  const std::string extension_before = extension_;
  take_up(name);
  kind_row(editor, marks, metrics);
  if (settings_.by == ExportSettings::By::tolerance) {
    tolerance_row(editor, marks, metrics);
  } else {
    option_label(tr, metrics, translatable("Density"));
    number_slider("##density", {1, 64, "%d", ImGuiSliderFlags_None}, settings_.density, metrics.px(220));
    marks.item("export.density");
    ImGui::SameLine();
    ImGui::TextUnformatted(tr("intervals a patch side"));
  }
  file_row(editor, marks, metrics, written_format(name).value_or(FormatChoices{}));
  result_row(editor, marks);
  if (!extension_.empty()) remembered_[extension_] = settings_;
  // In a format whose digits count, all that changes the numbers does.
  const bool digits = rounds(extension_) || rounds(extension_before);
  if (digits ? extension_ == extension_before && settings_.same_digits(before)
             : settings_.same_triangles(before))
    return false;
  count_.reset();
  return true;
}

void ExportOptions::take(const ExportSettings& settings, const Result<ExportCount>& count) {
  if (rounds(extension_) ? settings.same_digits(settings_) : settings.same_triangles(settings_))
    count_ = count;
}

}  // namespace hariko
