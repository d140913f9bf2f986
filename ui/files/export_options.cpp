#include "ui/files/export_options.hpp"

#include <imgui.h>

#include <array>
#include <numbers>

#include "core/base/files/file_ending.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/option_fields.hpp"

namespace hariko {

namespace {

constexpr double to_degrees = 180 / std::numbers::pi;
/// Tolerances relative to the size: about what an eye tells apart on a screen, and the finest to ask for.
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
  const Wall wall = settings_.wall;  // belongs to the part, whatever the format
  if (const auto found = remembered_.find(extension); found != remembered_.end()) settings_ = found->second;
  settings_.wall = wall;
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
  settings_.wall = {};  // another part has another one
  wall_options_.begin();
  count_.reset();
}

void ExportOptions::tolerance_row(PanelContext& context) {
  option_label(context, "Distance");
  Quantity length = length_quantity(context.editor.document().unit, settings_.distance);
  length.low = finest_tolerance * size_;
  length.high = size_;
  option_field(context, "export.distance", "The farthest that the surface may be from its triangles", 110,
               length, distance_text_, settings_.distance);
  words_beside(context, "Angle", 80);
  double angle = settings_.angle * to_degrees;
  if (option_field(context, "export.angle",
                   "The largest angle between the surface and its triangles; 0 for any", 80, degrees(),
                   angle_text_, angle))
    settings_.angle = angle / to_degrees;
  check_beside(context, "export.optimise", "fewest triangles",
               "Looks for the smallest mesh within the tolerance. Takes many times longer.",
               settings_.optimise);
}

void ExportOptions::result_row(PanelContext& context) const {
  const Language& tr = context.tr;
  ImGui::AlignTextToFramePadding();
  if (!count_) return dim_text(tr("Counting triangles\u2026"));
  if (!count_->ok()) {
    const Message& error = count_->error();
    return coloured_lines(palette().error, tr.text_of(error) + " " + tr.remedy_of(error));
  }
  const ExportCount& count = count_->value();
  std::string text = fill(tr("triangles: {0}"), {std::to_string(count.triangles)});
  if (settings_.by == ExportSettings::By::tolerance) {
    const Quantity length = length_quantity(context.editor.document().unit, count.distance);
    text += "   \u00b7   " +
            fill(count.certain ? tr("off by {0} at the most") : tr("off by {0} at the most, by samples"),
                 {format_quantity(length, count.distance)}) +
            "   \u00b7   " +
            fill(tr("turned by {0} at the most"), {format_quantity(degrees(), count.angle * to_degrees)});
    if (!count.reached) text += "   \u00b7   " + std::string(tr("the tolerance is not reached everywhere"));
  }
  text_in_lines(text);
  context.marks.item("export.result");
}

void ExportOptions::kind_row(PanelContext& context) {
  const std::array<std::string, 2> names{context.tr("Within a tolerance"), context.tr("By density")};
  option_label(context, "Triangles");
  if (const auto chosen =
          option_list(context, "export.by", 220, names, static_cast<std::size_t>(settings_.by)))
    settings_.by = static_cast<ExportSettings::By>(*chosen);
  check_beside(context, "export.selected", "selected objects only", "", settings_.only_selected);
  check_beside(context, "export.zero", "move to zero",
               "The middle of all that is written comes to lie at zero, which keeps models far away precise "
               "in formats of few digits.",
               settings_.choices.to_zero);
}

void ExportOptions::file_row(PanelContext& context, const FormatChoices& format) {
  const Language& tr = context.tr;
  FileChoices& choices = settings_.choices;
  option_label(context, "Unit");
  if (format.unit) {
    const Unit own = context.editor.document().unit;
    if (const auto chosen = option_unit(context, "export.unit", 80, choices.unit.value_or(own)))
      choices.unit = *chosen == own ? std::nullopt : chosen;
  } else {
    plain_text(tr("metres, as the format says"));
  }
  words_beside(context, "Scale", 80, 16);
  option_field(context, "export.scale", "All lengths are multiplied by it", 80, scale_quantity(), scale_text_,
               choices.scale);
  beside_or_below(context, labelled_width(tr("Up"), 4 * ImGui::GetFrameHeight()), 16);
  if (!format.up) return plain_text(format.unit ? tr("z is up") : tr("y is up"));
  plain_text(tr("Up"));
  for (const bool y_up : {false, true}) {
    ImGui::SameLine();
    if (radio_button(context.marks, y_up ? "export.up.y" : "export.up.z", y_up ? "Y" : "Z",
                     choices.y_up == y_up))
      choices.y_up = y_up;
  }
  if (!format.encoding) return;
  check_beside(context, "export.ascii", "as text",
               "ASCII instead of binary, for programs that read nothing else. The file gets larger.",
               choices.ascii, 16);
}

bool ExportOptions::draw(PanelContext& context, const std::filesystem::path& name) {
  const ExportSettings before = settings_;
  const std::string extension_before = extension_;
  take_up(name);
  kind_row(context);
  if (settings_.by == ExportSettings::By::tolerance) {
    tolerance_row(context);
  } else {
    option_label(context, "Density");
    number_slider(context.marks, "export.density", {1, 64, "%d", ImGuiSliderFlags_AlwaysClamp},
                  settings_.density, context.metrics.px(220));
    ImGui::SameLine();
    plain_text(context.tr("intervals a patch side"));
  }
  wall_options_.draw(context, size_, settings_.wall);
  file_row(context, written_format(name).value_or(FormatChoices{}));
  result_row(context);
  if (!extension_.empty()) (remembered_[extension_] = settings_).wall = {};
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
