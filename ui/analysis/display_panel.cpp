#include "ui/analysis/display_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/document/edits/edits.hpp"
#include "ui/editor/object_size.hpp"
#include "ui/widgets/binding.hpp"
#include "ui/widgets/inputs.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/option_fields.hpp"

namespace hariko {

namespace {

constexpr std::array axis_choices{Choice{"X", ""}, Choice{"Y", ""}, Choice{"Z", ""}};

using Displays = Binding<DisplaySettings>;

const DisplaySettings* display_of_object(const Object& object) {
  return &object.display;
}
const DisplaySettings* display_of_polyhedron(const Object& object) {
  return object.polyhedron() ? &object.display : nullptr;
}
constexpr auto display_part = whole_part<DisplaySettings, &display_of_object, &set_display>();
constexpr auto polyhedron_part = whole_part<DisplaySettings, &display_of_polyhedron, &set_display>();

constexpr Property<DisplaySettings> material_property{
    list_row("material", "Material", "How the surface takes the light", "Material", enum_choices<Material>,
             enum_words<Material>),
    [](const DisplaySettings& display) { return double(display.material); },
    [](DisplaySettings& display, double material) {
      display = with_material(display, static_cast<Material>(std::lround(material)));
    }};
constexpr auto wire_property = member_property<&DisplaySettings::wire>(
    {"wire", "Lines", "Lines over the surface", "Lines over the surface"});
constexpr std::array all_display_properties{
    member_property<&DisplaySettings::map>({"map", "Map", "What colours the surface", "Map"}),
    material_property,
    wire_property,
};
constexpr std::array density_properties{member_property<&DisplaySettings::density>(
    {"density", "Density", "Least intervals a patch side on the screen; small models are drawn finer",
     "Display density",
     whole_range(DisplaySettings::min_density, DisplaySettings::max_density, DisplaySettings().density,
                 SliderKind::linear)})};

template <class Test>
bool any_of(const Objects& objects, const Test& test) {
  return std::ranges::any_of(objects, [&](const auto& object) { return test(*object); });
}

struct Flag {
  const char *label, *mark, *show_step, *hide_step;
  bool DisplaySettings::*flag;
};
constexpr Flag surface_flag{translatable("surface"), "surface", translatable("Show surface"),
                            translatable("Hide surface"), &DisplaySettings::surface};
constexpr Flag network_flag{translatable("network"), "network", translatable("Show network"),
                            translatable("Hide network"), &DisplaySettings::network};
constexpr Flag polyhedron_flag{translatable("polyhedron"), "polyhedron", translatable("Show polyhedron"),
                               translatable("Hide polyhedron"), &DisplaySettings::polyhedron};
constexpr Flag edges_flag{translatable("edges"), "polyhedron", translatable("Show edges"),
                          translatable("Hide edges"), &DisplaySettings::polyhedron};
constexpr Flag points_flag{translatable("points"), "points", translatable("Show points"),
                           translatable("Hide points"), &DisplaySettings::points};
constexpr Flag tensions_flag{translatable("tensions"), "tensions", translatable("Show tensions"),
                             translatable("Hide tensions"), &DisplaySettings::tensions};
constexpr Flag marks_flag{"G0 G1 G2", "marks", translatable("Show continuity of edges"),
                          translatable("Hide continuity of edges"), &DisplaySettings::marks};

void show_flag(PanelContext& context, const Displays& displays, const Flag& flag) {
  if (const auto on = mixed_check(context.marks, std::string("check.") + flag.mark, context.tr(flag.label),
                                  displays.common_value(flag.flag)))
    displays.commit(*on ? flag.show_step : flag.hide_step,
                    [&](DisplaySettings& display) { display.*flag.flag = *on; });
}

/// Three buttons and a ball: the direction is a point of the ball's visible half, dragged.
void direction_row(PanelContext& context, ZebraSettings& zebra) {
  const Metrics& m = context.metrics;
  row_label(context, context.tr("Direction"), context.tr("Drag the dot over the ball"));
  const Matrix3 to_camera = context.editor.camera().picture_orientation().conjugate().toRotationMatrix();
  const bool turned = zebra.lock != StripeLock::view;
  Vector3 seen = turned ? Vector3(to_camera * zebra.direction) : zebra.direction;
  const float radius = m.px(24);
  const ImVec2 at = ImGui::GetCursorScreenPos(), middle(at.x + radius, at.y + radius);
  pointer_button(context.marks, "ball.stripes", {2 * radius, 2 * radius});
  point_out(context, "stripes_direction");
  if (ImGui::IsItemActive()) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    Vector2 on_ball((mouse.x - middle.x) / radius, (middle.y - mouse.y) / radius);
    if (on_ball.norm() > 0.999) on_ball *= 0.999 / on_ball.norm();
    seen = {on_ball.x(), on_ball.y(), std::sqrt(1 - on_ball.squaredNorm())};
    zebra.direction = turned ? Vector3(to_camera.transpose() * seen) : seen;
  }
  if (seen.norm() > 0) seen.normalize();
  if (seen.z() < 0) seen = -seen;  // both ends of the axis mean the same stripes
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddCircleFilled(middle, radius, palette().field, 32);
  draw.AddCircle(middle, radius, palette().separator, 32);
  const ImVec2 dot(middle.x + radius * static_cast<float>(seen.x()),
                   middle.y - radius * static_cast<float>(seen.y()));
  draw.AddLine(middle, dot, palette().dim_text, m.px(1));
  draw.AddCircleFilled(dot, m.px(4), palette().accent, 16);
  for (int axis = 0; axis < 3; ++axis) {
    ImGui::SameLine(0, m.px(axis == 0 ? 12 : 4));
    const char* name = axis_choices[static_cast<std::size_t>(axis)].label;
    if (text_button(context.marks, std::string("stripes.") + name, name))
      zebra.direction = Vector3::Unit(axis);
  }
}

void stripe_rows(PanelContext& context) {
  ZebraSettings& zebra = context.editor.view.zebra;
  slider_row(context, "stripes", translatable("Stripes"), translatable("Number of dark stripes"),
             {2, 64, "%d"}, zebra.stripes);
  if (const auto chosen = choose(context, "lock", "Locked to", "What the stripes stand still with",
                                 std::optional(zebra.lock)))
    zebra.lock = *chosen;
  direction_row(context, zebra);
}

void range_rows(PanelContext& context, const Displays& displays, const Object& object, SurfaceMap map) {
  const auto mode =
      displays.common_value([map](const DisplaySettings& display) { return range_of(display, map).mode; });
  if (const auto chosen =
          choose(context, "range", "Range", "Which values the colours span; kept for each map", mode)) {
    // A typed range begins with the one that was seen.
    const SurfaceView* view = context.editor.view_of(object.id);
    const bool seen = view && view->range.low < view->range.high;
    displays.commit("Range of the map", [&](DisplaySettings& display) {
      MapRange& changed = range_of(display, map);
      changed.mode = *chosen;
      if (changed != MapRange{RangeMode::manual} || !seen) return;
      changed.low = view->range.low;
      changed.high = view->range.high;
    });
  }
  if (mode != RangeMode::manual) return;
  row_label(context, context.tr("From, to"), context.tr("Ends of the range, in the map's unit"));
  const float spacing = context.metrics.px(4);
  const float width = (ImGui::GetContentRegionAvail().x - spacing) / 2;
  const MapRange& first = range_of(object.display, map);
  Quantity quantity = length_quantity(Unit::millimetre, std::max(std::abs(first.low), std::abs(first.high)));
  quantity.unit.clear();
  quantity.factors.clear();
  const auto end = [&](const char* id, double MapRange::*member) {
    const auto now = [map, member](const DisplaySettings& display) { return range_of(display, map).*member; };
    number_field(context, {id, "", "Ends of the range, in the map's unit", "Range of the map", quantity},
                 displays.common_value(now), width,
                 displays.edit_of(quantity, now, [map, member](DisplaySettings& display, double value) {
                   range_of(display, map).*member = value;
                 }));
  };
  end("range_low", &MapRange::low);
  ImGui::SameLine(0, spacing);
  end("range_high", &MapRange::high);
}

void colour_row(PanelContext& context, const Displays& displays, const Objects& objects) {
  row_label(context, context.tr("Colour"), context.tr("Of the outside; the inside stays blue"));
  const Color color = color_of(objects.front()->display.colour);
  std::array<float, 3> rgb{color.r, color.g, color.b};
  if (!displays.common_value(&DisplaySettings::colour)) {
    dim_text(context.tr("mixed"));
    ImGui::SameLine();
  }
  if (colour_field(context.marks, "field.colour", rgb)) {
    const auto byte = [](float part) {
      return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0F, 1.0F)));
    };
    context.editor.preview(displays.changed([&](DisplaySettings& display) {
      display.colour = {byte(rgb[0]), byte(rgb[1]), byte(rgb[2])};
    }));
  }
  if (ImGui::IsItemDeactivatedAfterEdit())
    context.editor.commit_preview(objects.size() == 1 ? "Colour of the object" : "Colour of objects");
  point_out(context, "colour");
}

void material_rows(PanelContext& context, const Displays& displays, const Objects& objects) {
  if (any_of(objects, [](const Object& object) { return object.display.map == SurfaceMap::shaded; }))
    displays.row(material_property);
  colour_row(context, displays, objects);
}

void comb_rows(PanelContext& context, const Displays& displays) {
  const char* step = translatable("Curvature combs");
  displays.row(member_property<&DisplaySettings::combs, &CombSettings::shown>(
      {"combs", "Combs", "Teeth as long as the curves of the network are curved", step}));
  if (displays.common_value([](const DisplaySettings& d) { return d.combs.shown; }) != true) return;
  ImGui::SameLine();
  if (text_button(context.marks, "combs.shorter", "\u00f7 2"))
    displays.commit(step, [](DisplaySettings& d) {
      d.combs.scale = std::max(d.combs.scale / 2, CombSettings::min_scale);
    });
  ImGui::SameLine(0, context.metrics.px(4));
  if (text_button(context.marks, "combs.longer", "\u00d7 2"))
    displays.commit(step, [](DisplaySettings& d) {
      d.combs.scale = std::min(d.combs.scale * 2, CombSettings::max_scale);
    });
  ImGui::SameLine();
  const auto scale = displays.common_value([](const DisplaySettings& d) { return d.combs.scale; });
  dim_text(scale ? "\u00d7 " + format_number(*scale, 3) : std::string(context.tr("mixed")));
  displays.row(member_property<&DisplaySettings::combs, &CombSettings::density>(
      {"comb_density", "Teeth", "Intervals on each curve", step,
       whole_range(CombSettings::min_density, CombSettings::max_density, CombSettings().density,
                   SliderKind::logarithmic)}));
}

void mark_rows(PanelContext& context, const Displays& displays, const Objects& objects) {
  row_label(context, context.tr("Edges"), context.tr("Continuity across the edges within the tolerance"));
  show_flag(context, displays, marks_flag);
  if (!any_of(objects, [](const Object& object) { return object.display.marks; })) return;
  ContinuityTolerance& tolerance = context.editor.view.tolerance;
  row_label(context, context.tr("Tolerance"),
            context.tr("Largest angle between normals, and largest jump of curvature relative to it"));
  const float spacing = context.metrics.px(4), width = (ImGui::GetContentRegionAvail().x - spacing) / 2;
  number_input(context.marks, "field.tolerance_angle", width, {0, 90, "%.4g\u00b0"}, tolerance.angle);
  point_out(context, "tolerance");
  ImGui::SameLine(0, spacing);
  double percent = tolerance.curvature * 100;
  if (number_input(context.marks, "field.tolerance_jump", width, {0, 200, "%.4g %%"}, percent))
    tolerance.curvature = percent / 100;
}

/// A check box for what all kinds show, and those that polyhedra or solids have as well.
void show_rows(PanelContext& context, const Displays& displays, const Objects& objects) {
  row_label(context, context.tr("Show"), "");
  const float start = ImGui::GetCursorPosX(), second = start + context.metrics.px(112);
  show_flag(context, displays, surface_flag);
  ImGui::SameLine(second);
  const bool polyhedra =
      std::ranges::all_of(objects, [](const auto& object) { return object->polyhedron(); });
  if (!polyhedra) {
    show_flag(context, displays, edges_flag);
    if (!any_of(objects, [](const Object& object) { return object.solids() != nullptr; })) return;
    ImGui::SetCursorPosX(start);
    {
      const Disabled disabled(
          !any_of(objects, [](const Object& object) { return object.display.polyhedron; }));
      option_check(context, "check.bodies", translatable("bodies"),
                   "See the bodies of solids through the surface round them.", context.editor.view.bodies);
    }
    return;
  }
  show_flag(context, displays, points_flag);
  ImGui::SetCursorPosX(start);
  show_flag(context, displays, polyhedron_flag);
  ImGui::SameLine(second);
  show_flag(context, displays, tensions_flag);
  ImGui::SetCursorPosX(start);
  show_flag(context, displays, network_flag);
}

void section_rows(PanelContext& context) {
  ViewSettings::Section& section = context.editor.view.section;
  const Box3 box = box_of_visible(context.editor.document());
  const auto shown = check_row(context, "section", "Section",
                               "Cuts away what is beyond a plane, in this view only", section.shown);
  section.shown = shown.value_or(section.shown);
  if (shown == true && !box.isEmpty() &&
      !(section.offset >= box.min()[section.axis] && section.offset <= box.max()[section.axis]))
    section.offset = box.center()[section.axis];
  if (!section.shown) return;
  ImGui::SameLine();
  option_check(context, "check.section_flipped", "other side", "", section.flipped);
  if (const auto chosen = choose(context, "section_axis", "Across", "The axis that the plane is square to",
                                 axis_choices, section.axis)) {
    section.axis = *chosen;
    if (!box.isEmpty()) section.offset = box.center()[section.axis];
  }
  const double low = box.isEmpty() ? -1 : box.min()[section.axis],
               high = box.isEmpty() ? 1 : box.max()[section.axis];
  const std::string format = std::string("%.4g ") + std::string(to_string(context.editor.document().unit));
  slider_row(context, "section_offset", translatable("Offset"), translatable("Of the plane along its axis"),
             {low, high, format.c_str(), ImGuiSliderFlags_NoRoundToFormat}, section.offset);
}

void x_ray_row(PanelContext& context) {
  ViewSettings& view = context.editor.view;
  if (!view.x_ray) return;
  slider_row(context, "x_ray", translatable("X-ray"),
             translatable("Strength of what lies behind the surface"), {0.05, 1, "%.2f"},
             view.x_ray_strength);
}

}  // namespace

void draw_display(PanelContext& context, const Objects& objects) {
  heading(context, context.tr("Display"));
  const Displays displays = bind_part(context, objects, display_part);
  const auto map = displays.common_value(&DisplaySettings::map);
  if (const auto chosen =
          choose(context, "map", "Map", "What colours this surface, whatever the view shows", map))
    displays.commit(fill(translatable("Map {0}"), {enum_choice(*chosen).label}),
                    [&](DisplaySettings& display) { display.map = *chosen; });
  const auto shows = [&](SurfaceMap wanted) {
    return any_of(objects,
                  [&](const Object& object) { return shown_map(context.editor.view.map, object) == wanted; });
  };
  if (shows(SurfaceMap::zebra) || shows(SurfaceMap::isophotes)) stripe_rows(context);
  if (context.editor.view.environment && shows(SurfaceMap::shaded)) environment_rows(context);
  for (const SurfaceMap making :
       {SurfaceMap::draft, SurfaceMap::radius, SurfaceMap::thickness, SurfaceMap::deviation})
    if (shows(making)) making_rows(context, making);
  missing_map_row(context);
  if (map && has_values(*map)) range_rows(context, displays, *objects.front(), *map);
  if (shows(SurfaceMap::shaded) || shows(SurfaceMap::isophotes)) material_rows(context, displays, objects);
  show_rows(context, displays, objects);
  displays.row(wire_property);
  const Objects surfaces = objects_where(objects, &Object::has_surface);
  if (!surfaces.empty()) {
    const Displays of_surfaces = bind_part(context, surfaces, display_part);
    mark_rows(context, of_surfaces, surfaces);
    comb_rows(context, of_surfaces);
  }
  bind_part(context, objects, polyhedron_part).rows(density_properties);
  section_rows(context);
  section_curve_rows(context);
  x_ray_row(context);
}

ObjectProperties<DisplaySettings> display_properties() {
  return {display_part, all_display_properties};
}

ObjectProperties<DisplaySettings> polyhedron_display_properties() {
  return {polyhedron_part, density_properties};
}

}  // namespace hariko
