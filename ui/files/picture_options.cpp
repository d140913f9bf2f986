#include "ui/files/picture_options.hpp"

#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/drawing/write_drawing_svg.hpp"
#include "render/picture.hpp"
#include "ui/base/quantity.hpp"
#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

void check(const Language& tr, Marks& marks, const char* id, const char* text, const char* help,
           bool& value) {
  ImGui::Checkbox((std::string(tr(text)) + "##" + id).c_str(), &value);
  marks.item(std::string("picture.") + id);
  if (ImGui::IsItemHovered()) show_tip(tr(help));
}

void whole_number(Marks& marks, const Metrics& metrics, const char* id, int& value, int most) {
  ImGui::SetNextItemWidth(metrics.px(72));
  if (ImGui::InputInt((std::string("##") + id).c_str(), &value, 0)) value = std::clamp(value, 1, most);
  marks.item(std::string("picture.") + id);
}

std::string text_of(PixelSize size) {
  return std::to_string(size.width) + " \u00d7 " + std::to_string(size.height);
}

void size_row(const Language& tr, PixelSize view, Marks& marks, const Metrics& metrics,
              PictureSettings& settings) {
  using Size = PictureSettings::Size;
  const std::array names{fill(tr("As the view, {0}"), {text_of(view)}), std::string("1920 \u00d7 1080"),
                         std::string("3840 \u00d7 2160 (4K)"), std::string(tr("Custom"))};
  option_label(tr, metrics, translatable("Size"));
  if (const auto chosen =
          option_list(marks, "picture.size", metrics.px(220), names, static_cast<std::size_t>(settings.size)))
    settings.size = static_cast<Size>(*chosen);
  if (settings.size != Size::custom) return;
  ImGui::SameLine();
  whole_number(marks, metrics, "width", settings.custom.width, max_picture_side);
  ImGui::SameLine();
  ImGui::TextUnformatted("\u00d7");
  ImGui::SameLine();
  whole_number(marks, metrics, "height", settings.custom.height, max_picture_side);
}

}  // namespace

void DrawingOptions::page_row(const Editor& editor, Marks& marks, const Metrics& metrics) {
  const Language& tr = editor.language;
  Quantity length = length_quantity(Unit::millimetre, most_page_side);
  length.low = least_page_side;
  length.high = most_page_side;
  option_label(tr, metrics, translatable("Width"));
  option_field("picture.page_width", tr("Of the page. Lines have the same widths on pages of all sizes."),
               marks, metrics.px(110), length, width_text_, settings_.width);
  ImGui::SameLine();
  const double height = page_of(settings_, editor.viewport).y();
  ImGui::TextUnformatted(
      fill(tr("\u00d7 {0}, as the view"), {format_quantity(length, std::round(10 * height) / 10)}).c_str());
}

void DrawingOptions::remember(const DrawingSettings& settings) {
  settings_ = settings;
  width_text_.clear();
}

void DrawingOptions::draw(const Editor& editor, Marks& marks, const Metrics& metrics) {
  const Language& tr = editor.language;
  page_row(editor, marks, metrics);
  option_label(tr, metrics, translatable("Lines"));
  check(
      tr, marks, "network", translatable("network"),
      translatable("The curves that the surfaces are spanned by. Outlines, borders, creases and sections are "
                   "always drawn."),
      settings_.network);
  beside_or_below(metrics, check_width(tr("hidden lines")));
  check(tr, marks, "hidden", translatable("hidden lines"),
        translatable("What surfaces hide, as dashes in layers of their own."), settings_.hidden);
}

void draw_picture_options(const Editor& editor, Marks& marks, const Metrics& metrics,
                          PictureSettings& settings, bool turntable) {
  const Language& tr = editor.language;
  size_row(tr, editor.viewport, marks, metrics, settings);
  option_label(tr, metrics, translatable("Show"));
  check(tr, marks, "transparent", translatable("transparent background"),
        translatable("Only the model is drawn; what lies behind shows through."), settings.transparent);
  beside_or_below(metrics, check_width(tr("grid")));
  check(tr, marks, "grid", translatable("grid"), translatable("Where the view shows it."), settings.grid);
  beside_or_below(metrics, check_width(tr("selection")));
  check(tr, marks, "selection", translatable("selection"), translatable("The marks of what is selected."),
        settings.selection);
  beside_or_below(metrics, check_width(tr("legend")));
  check(tr, marks, "legend", translatable("legend"),
        translatable("The scale of the map of the chosen object, where one shows."), settings.legend);
  if (!turntable) return;
  option_label(tr, metrics, translatable("Pictures"));
  whole_number(marks, metrics, "count", settings.turntable_pictures, most_turntable_pictures);
  beside_or_below(metrics, check_width(tr("whole model in every picture")));
  check(tr, marks, "fit", translatable("whole model in every picture"),
        translatable("Moves the camera back as far as the model needs while it turns."), settings.fit);
}

}  // namespace hariko
