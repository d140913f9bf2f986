#include "ui/files/picture_options.hpp"

#include <imgui.h>

#include <array>
#include <cmath>
#include <string>

#include "core/drawing/write_drawing_svg.hpp"
#include "render/picture.hpp"
#include "ui/base/quantity.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/option_fields.hpp"

namespace hariko {

namespace {

constexpr float count_width = 72;  ///< design pixels

std::string text_of(PixelSize size) {
  return std::to_string(size.width) + " \u00d7 " + std::to_string(size.height);
}

void size_row(PanelContext& context, PictureSettings& settings) {
  using Size = PictureSettings::Size;
  const Language& tr = context.tr;
  const std::array names{fill(tr("As the view, {0}"), {text_of(context.editor.viewport)}),
                         std::string("1920 \u00d7 1080"), std::string("3840 \u00d7 2160 (4K)"),
                         std::string(tr("Custom"))};
  option_label(context, "Size");
  if (const auto chosen =
          option_list(context, "picture.size", 220, names, static_cast<std::size_t>(settings.size)))
    settings.size = static_cast<Size>(*chosen);
  if (settings.size != Size::custom) return;
  ImGui::SameLine();
  constexpr SliderRange sides{1, max_picture_side, "%d"};
  number_input(context.marks, "picture.width", context.metrics.px(count_width), sides, settings.custom.width);
  ImGui::SameLine();
  plain_text("\u00d7");
  ImGui::SameLine();
  number_input(context.marks, "picture.height", context.metrics.px(count_width), sides,
               settings.custom.height);
}

}  // namespace

void DrawingOptions::page_row(PanelContext& context) {
  Quantity length = length_quantity(Unit::millimetre, most_page_side);
  length.low = least_page_side;
  length.high = most_page_side;
  option_label(context, "Width");
  option_field(context, "picture.page_width",
               "Of the page. Lines have the same widths on pages of all sizes.", 110, length, width_text_,
               settings_.width);
  ImGui::SameLine();
  const double height = page_of(settings_, context.editor.viewport).y();
  plain_text(
      fill(context.tr("\u00d7 {0}, as the view"), {format_quantity(length, std::round(10 * height) / 10)}));
}

void DrawingOptions::remember(const DrawingSettings& settings) {
  settings_ = settings;
  width_text_.clear();
}

void DrawingOptions::draw(PanelContext& context) {
  page_row(context);
  option_label(context, "Lines");
  option_check(context, "picture.network", translatable("network"),
               "The curves that the surfaces are spanned by. Outlines, borders, creases and sections are "
               "always drawn.",
               settings_.network);
  check_beside(context, "picture.hidden", "hidden lines",
               "What surfaces hide, as dashes in layers of their own.", settings_.hidden);
}

void draw_picture_options(PanelContext& context, PictureSettings& settings, bool turntable) {
  size_row(context, settings);
  option_label(context, "Show");
  option_check(context, "picture.transparent", "transparent background",
               "Only the model is drawn; what lies behind shows through.", settings.transparent);
  check_beside(context, "picture.grid", translatable("grid"), "Where the view shows it.", settings.grid);
  check_beside(context, "picture.selection", translatable("selection"), "The marks of what is selected.",
               settings.selection);
  check_beside(context, "picture.legend", translatable("legend"),
               "The scale of the map of the chosen object, where one shows.", settings.legend);
  if (!turntable) return;
  option_label(context, "Pictures");
  number_input(context.marks, "picture.count", context.metrics.px(count_width),
               {1, most_turntable_pictures, "%d"}, settings.turntable_pictures);
  check_beside(context, "picture.fit", "whole model in every picture",
               "Moves the camera back as far as the model needs while it turns.", settings.fit);
}

}  // namespace hariko
