#include "render/style.hpp"

namespace hariko::gl {

namespace {

Color with_alpha(Color color, float alpha) {
  color.a = alpha;
  return color;
}

}  // namespace

Style style_of(Background background) {
  const bool light = background == Background::light;
  const Color accent = color_from_hex("#ffa51f"), secondary = color_from_hex("#4aa3df");
  // Differs from the selection's orange in hue and in lightness, for every kind of colour vision.
  const Color fold = color_from_hex("#c2185b");
  const Color ink = color_from_hex("#17181a");
  Style s;
  s.top = color_from_hex(light ? "#f4f5f7" : "#3a3d42");
  s.bottom = color_from_hex(light ? "#d9dce1" : "#24262a");
  s.grid = color_from_hex(light ? "#5b6068" : "#aeb4bc");
  s.grid_strength = light ? 0.26F : 0.20F;
  s.axis_x = color_from_hex("#e5484d");
  s.axis_y = color_from_hex("#46a758");
  s.axis_z = color_from_hex("#3e82f7");
  s.inside = color_from_hex("#5f7f96");
  s.undefined = undefined_color;
  s.wire = with_alpha(ink, 0.38F);
  // Pale line with a thin dark casing, readable on the surface and on the background.
  s.polyhedron = {with_alpha(color_from_hex(light ? "#3a3f47" : "#e6e6e6"), 0.60F), 1.2F,
                  with_alpha(light ? Color{1, 1, 1, 1} : ink, 0.28F), 0.9F};
  s.network = {with_alpha(color_from_hex("#22252a"), 0.78F), 1.6F};
  s.zebra_network = {with_alpha(secondary, 0.95F), 1.6F};  // readable on black and on white
  s.split = {with_alpha(color_from_hex("#22252a"), 0.34F), 1.0F};
  s.quiet_network = {with_alpha(color_from_hex("#22252a"), 0.25F), 1.0F};
  s.facet_edge = {with_alpha(ink, 0.55F), 1.0F};
  s.crease = {fold, 2.4F, with_alpha(light ? ink : Color{1, 1, 1, 1}, 0.30F), 0.7F};
  s.boundary = {color_from_hex("#3dbb6c"), 2.0F, with_alpha(ink, 0.30F), 0.6F};
  s.continuity = {Color{1, 1, 1, 1}, 2.6F, with_alpha(ink, 0.55F), 0.9F};
  s.selected_edge = {accent, 4.4F, with_alpha(ink, 0.70F), 1.2F};
  s.hovered_edge = {secondary, 3.6F, with_alpha(ink, 0.60F), 1.0F};
  s.failed_edge = {color_from_hex("#ff3b30"), 3.4F, with_alpha(Color{1, 1, 1, 1}, 0.75F), 1.0F};
  s.tension = {Color{1, 1, 1, 1}, 3.0F, with_alpha(ink, 0.60F), 0.9F};
  s.tension_on_line = {Color{1, 1, 1, 1}, 1.5F};
  s.comb_tooth = {with_alpha(color_from_hex(light ? "#1f6fb2" : "#6fc3ff"), 0.55F), 1.0F};
  s.comb_envelope = {color_from_hex(light ? "#14508a" : "#a5dbff"), 1.6F,
                     with_alpha(ink, light ? 0.0F : 0.35F), light ? 0.0F : 0.6F};
  s.section = {accent, 2.2F, with_alpha(ink, 0.45F), 0.7F};
  constexpr std::array<float, 3> mark_widths{4.4F, 3.2F, 1.8F};
  for (std::size_t i = 0; i < 3; ++i)
    s.marks[i] = {mark_color(static_cast<Continuity>(i)), mark_widths[i], with_alpha(ink, 0.60F), 0.8F};
  s.mark_dashes = {{{0, 1}, {16, 0.60F}, {0, 1}}};
  s.point = {color_from_hex("#f4f4f2"), with_alpha(ink, 0.90F), 7.0F, 1.25F};
  s.selected_point = {accent, with_alpha(ink, 0.95F), 10.0F, 1.5F};
  s.hovered_point = {secondary, with_alpha(ink, 0.95F), 9.0F, 1.5F};
  s.corner = {fold, with_alpha(ink, 0.95F), 11.0F, 1.5F, PointShape::square};
  s.smooth = {color_from_hex("#3dbb6c"), with_alpha(ink, 0.95F), 12.0F, 1.2F, PointShape::ring};
  s.pinned = {color_from_hex("#c58cff"), with_alpha(ink, 0.95F), 9.0F, 1.2F, PointShape::diamond};
  s.failed_point = {color_from_hex("#ff3b30"), with_alpha(Color{1, 1, 1, 1}, 0.95F), 12.0F, 2.0F};
  s.selected_fill = with_alpha(accent, 0.30F);
  s.hovered_fill = with_alpha(secondary, 0.22F);
  s.failed_fill = with_alpha(color_from_hex("#ff3b30"), 0.28F);
  const auto body = [](const Color& front, float in_front, const Color& rim, float at_rim) {
    return BodyStyle{with_alpha(front, in_front), with_alpha(rim, at_rim), 0.85F};
  };
  const Color glass = color_from_hex("#8ec4ee"), deep = color_from_hex("#143048");
  const Color amber = color_from_hex("#ffc477"), brown = color_from_hex("#7a4200");
  s.bodies = {body(glass, 0.20F, deep, 0.62F), body(amber, 0.42F, brown, 0.70F),
              body(color_from_hex("#9ed8ff"), 0.40F, color_from_hex("#0d4a78"), 0.70F)};
  s.bodies_over_map = {body(deep, 0, deep, 0.50F), body(accent, 0.10F, brown, 0.75F),
                       body(secondary, 0.10F, color_from_hex("#0d4a78"), 0.70F)};
  for (BodyStyle* one : {&s.bodies_over_map.plain, &s.bodies_over_map.selected, &s.bodies_over_map.hovered})
    one->reach = 0.7F;
  return s;
}

}  // namespace hariko::gl
