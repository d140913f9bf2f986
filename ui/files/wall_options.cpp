#include "ui/files/wall_options.hpp"

#include <array>

#include "ui/widgets/option_fields.hpp"

namespace hariko {

namespace {

constexpr std::array wall_sides{translatable("on the inside"), translatable("on the outside"),
                                translatable("on both sides")};
static_assert(wall_sides.size() == enum_words<WallSide>.size());

}  // namespace

void WallOptions::draw(PanelContext& context, double size, Wall& wall) {
  constexpr float field = 90, list = 140;
  constexpr double usual_share = 0.01;  // share of the size, for the digits of the numbers
  option_label(context, "Wall");
  Quantity length = length_quantity(context.editor.document().unit, usual_share * size);
  length.low = 0;
  length.high = size;
  option_field(context, "export.thickness",
               "The thickness of walls along the surface, which make a closed body; 0 for the surface itself",
               field, length, thickness_text_, wall.thickness);
  std::array<std::string, wall_sides.size()> sides;
  for (std::size_t i = 0; i < sides.size(); ++i) sides[i] = context.tr(wall_sides[i]);
  beside_or_below(context, context.metrics.px(list));
  if (const auto chosen =
          option_list(context, "export.wall_side", list, sides, static_cast<std::size_t>(wall.side),
                      enum_word_list<WallSide>(), "The side of the surface on which the wall is"))
    wall.side = static_cast<WallSide>(*chosen);
  words_beside(context, "Offset", field, 16);
  length.low = -size;
  option_field(context, "export.offset", "Moves the surface first: so far outwards, or inwards with a minus",
               field, length, offset_text_, wall.offset);
}

}  // namespace hariko
