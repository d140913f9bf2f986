#include "ui/panels/display_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/document/edits.hpp"
#include "ui/panels/choice.hpp"
#include "ui/panels/value_fields.hpp"

namespace hariko {

namespace {

constexpr std::array map_choices{
    Choice{
        translatable("As the view"),
        translatable("The map that the menu Analyse shows on all surfaces, or a material in studio light")},
    Choice{translatable("Patches"), translatable("One colour for each patch")},
    Choice{translatable("Zebra"),
           translatable("Reflected stripes: a kink in a stripe shows a jump of curvature")},
    Choice{translatable("Gaussian curvature"),
           translatable("Product of the principal curvatures: red dome, blue saddle")},
    Choice{translatable("Mean curvature"), translatable("Mean of the principal curvatures")},
    Choice{translatable("Greatest curvature"), translatable("The larger principal curvature k1")},
    Choice{translatable("Least curvature"), translatable("The smaller principal curvature k2")},
    Choice{translatable("Continuity"), translatable("How much curvature jumps across the edges")},
    Choice{translatable("Isophotes"),
           translatable("Bands of equal angle between the surface and a direction")},
};
constexpr std::array material_choices{
    Choice{translatable("Clay"), translatable("Matt: shows the form")},
    Choice{translatable("Porcelain"), translatable("White gloss: shows where highlights run")},
    Choice{translatable("Metal"), translatable("Mirrors the studio: shows every dent")},
    Choice{translatable("Wax"), translatable("Soft light under the skin")},
    Choice{translatable("Rubber"), translatable("Dark and dull: shows outlines")},
    Choice{translatable("Plastic"), translatable("Coloured gloss")},
};
constexpr std::array range_choices{
    Choice{translatable("Symmetric"), translatable("As far below zero as above, without the outermost 2 %")},
    Choice{translatable("Percentile"), translatable("From the 2 % to the 98 % quantile")},
    Choice{translatable("Full"), translatable("From the least to the greatest value")},
    Choice{translatable("Typed"), translatable("From and to the values below")},
};
constexpr std::array lock_choices{
    Choice{translatable("View"), translatable("Stripes keep their place on the screen")},
    Choice{translatable("World"), translatable("Stripes stand in the room")},
    Choice{translatable("Object"), translatable("Stripes turn with the object")},
};
constexpr std::array wire_choices{
    Choice{translatable("None"), translatable("No lines over the surface")},
    Choice{translatable("Patch borders"), translatable("Where patches meet")},
    Choice{translatable("Display mesh"), translatable("The triangles on the screen")},
};
constexpr std::array axis_choices{Choice{"X", ""}, Choice{"Y", ""}, Choice{"Z", ""}};

/// The edit of a number of the display settings of one object: how to read it and how to write it.
template <class Read, class Write>
EditValues display_values(ObjectId id, const Quantity& quantity, const Read& read, const Write& write) {
  return [=](const Document& document, const ValueChange& change) -> Result<Document> {
    const Object* found = document.find(id);
    if (!found) return document;
    DisplaySettings display = found->display;
    write(display, change.apply(quantity, read(display)));
    return set_display(document, id, display);
  };
}

void commit(PanelContext& context, const Object& object, const DisplaySettings& display,
            const std::string& step) {
  context.editor.commit(set_display(context.editor.history.current(), object.id, display), step);
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

void show_flag(PanelContext& context, const Object& object, const Flag& flag) {
  bool on = object.display.*flag.flag;
  if (ImGui::Checkbox((std::string(context.tr(flag.label)) + "##" + flag.mark).c_str(), &on)) {
    DisplaySettings display = object.display;
    display.*flag.flag = on;
    commit(context, object, display, on ? flag.show_step : flag.hide_step);
  }
  context.marks.item(std::string("check.") + flag.mark);
}

/// Three buttons and a ball: the direction is a point of the ball's visible half, dragged.
void direction_row(PanelContext& context, ZebraSettings& zebra) {
  const Metrics& m = context.metrics;
  row_label(context, context.tr("Direction"), context.tr("Drag the dot over the ball"));
  const Matrix3 to_camera = context.editor.camera().orientation.conjugate().toRotationMatrix();
  const bool turned = zebra.lock != StripeLock::view;
  Vector3 seen = turned ? Vector3(to_camera * zebra.direction) : zebra.direction;
  const float radius = m.px(24);
  const ImVec2 at = ImGui::GetCursorScreenPos(), middle(at.x + radius, at.y + radius);
  ImGui::InvisibleButton("##ball", {2 * radius, 2 * radius});
  context.marks.item("ball.stripes");
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
    if (ImGui::Button(axis_choices[static_cast<std::size_t>(axis)].label))
      zebra.direction = Vector3::Unit(axis);
    context.marks.item(std::string("stripes.") + axis_choices[static_cast<std::size_t>(axis)].label);
  }
}

void stripe_rows(PanelContext& context) {
  ZebraSettings& zebra = context.editor.view.zebra;
  row_label(context, context.tr("Stripes"), context.tr("Number of dark stripes"));
  ImGui::SetNextItemWidth(-1);
  ImGui::SliderInt("##stripes", &zebra.stripes, 2, 64, "%d", ImGuiSliderFlags_AlwaysClamp);
  context.marks.item("slider.stripes");
  if (const auto chosen = choose(context, "lock", "Locked to", "What the stripes stand still with",
                                 lock_choices, static_cast<int>(zebra.lock)))
    zebra.lock = static_cast<StripeLock>(*chosen);
  direction_row(context, zebra);
}

void range_rows(PanelContext& context, const Object& object) {
  const SurfaceMap map = object.display.map;
  const MapRange& range = range_of(object.display, map);
  if (const auto chosen =
          choose(context, "range", "Range", "Which values the colours span; kept for each map", range_choices,
                 static_cast<int>(range.mode))) {
    DisplaySettings display = object.display;
    MapRange& changed = range_of(display, map);
    changed.mode = static_cast<RangeMode>(*chosen);
    // What is typed begins with what was seen.
    const SurfaceView* view = context.editor.view_of(object.id);
    if (changed.mode == RangeMode::manual && changed == MapRange{RangeMode::manual} && view &&
        view->range.low < view->range.high) {
      changed.low = view->range.low;
      changed.high = view->range.high;
    }
    commit(context, object, display, "Range of the map");
  }
  if (range.mode != RangeMode::manual) return;
  row_label(context, context.tr("From, to"), context.tr("Ends of the range, in the map's unit"));
  const float spacing = context.metrics.px(4);
  const float width = (ImGui::GetContentRegionAvail().x - spacing) / 2;
  const double span = std::max(std::abs(range.low), std::abs(range.high));
  Quantity quantity = length_quantity(Unit::millimetre, span);
  quantity.unit.clear();
  quantity.factors.clear();
  number_field(context,
               {"range_low", "", "Ends of the range, in the map's unit", "Range of the map", quantity},
               range.low, width,
               display_values(
                   object.id, quantity, [map](DisplaySettings& d) { return range_of(d, map).low; },
                   [map](DisplaySettings& d, double value) { range_of(d, map).low = value; }));
  ImGui::SameLine(0, spacing);
  number_field(context,
               {"range_high", "", "Ends of the range, in the map's unit", "Range of the map", quantity},
               range.high, width,
               display_values(
                   object.id, quantity, [map](DisplaySettings& d) { return range_of(d, map).high; },
                   [map](DisplaySettings& d, double value) { range_of(d, map).high = value; }));
}

void colour_row(PanelContext& context, const Object& object) {
  Editor& editor = context.editor;
  row_label(context, context.tr("Colour"), context.tr("Of the outside; the inside stays blue"));
  const Color color = color_of(object.display.colour);
  std::array<float, 3> rgb{color.r, color.g, color.b};
  ImGui::SetNextItemWidth(-1);
  if (ImGui::ColorEdit3("##colour", rgb.data(), ImGuiColorEditFlags_DisplayHex)) {
    DisplaySettings display = object.display;
    const auto byte = [](float part) {
      return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0F, 1.0F)));
    };
    display.colour = {byte(rgb[0]), byte(rgb[1]), byte(rgb[2])};
    editor.preview(set_display(editor.history.current(), object.id, display));
  }
  if (ImGui::IsItemDeactivatedAfterEdit()) editor.commit_preview("Colour of the object");
  context.marks.item("field.colour");
}

void material_rows(PanelContext& context, const Object& object) {
  if (object.display.map == SurfaceMap::shaded)
    if (const auto chosen = choose(context, "material", "Material", "How the surface takes the light",
                                   material_choices, static_cast<int>(object.display.material)))
      commit(context, object, with_material(object.display, static_cast<Material>(*chosen)), "Material");
  colour_row(context, object);
}

void comb_rows(PanelContext& context, const Object& object) {
  const CombSettings& combs = object.display.combs;
  const auto change = [&](auto&& set) {
    DisplaySettings display = object.display;
    set(display.combs);
    commit(context, object, display, "Curvature combs");
  };
  row_label(context, context.tr("Combs"),
            context.tr("Teeth as long as the curves of the network are curved"));
  bool shown = combs.shown;
  if (ImGui::Checkbox("##combs", &shown)) change([&](CombSettings& c) { c.shown = shown; });
  context.marks.item("check.combs");
  if (!combs.shown) return;
  ImGui::SameLine();
  if (ImGui::Button("\u00f7 2"))
    change([](CombSettings& c) { c.scale = std::max(c.scale / 2, c.min_scale); });
  context.marks.item("combs.shorter");
  ImGui::SameLine(0, context.metrics.px(4));
  if (ImGui::Button("\u00d7 2"))
    change([](CombSettings& c) { c.scale = std::min(c.scale * 2, c.max_scale); });
  context.marks.item("combs.longer");
  ImGui::SameLine();
  ImGui::TextDisabled("\u00d7 %s", format_number(combs.scale, 3).c_str());
  const Quantity teeth =
      whole_quantity(CombSettings::min_density, CombSettings::max_density, CombSettings().density);
  slider_row(
      context, {"comb_density", "Teeth", "Intervals on each curve", "Curvature combs", teeth}, teeth.low,
      teeth.high, true, combs.density,
      display_values(
          object.id, teeth, [](const DisplaySettings& d) { return static_cast<double>(d.combs.density); },
          [](DisplaySettings& d, double value) { d.combs.density = static_cast<int>(value); }));
}

void mark_rows(PanelContext& context, const Object& object) {
  row_label(context, context.tr("Edges"), context.tr("Continuity across the edges within the tolerance"));
  show_flag(context, object, marks_flag);
  if (!object.display.marks) return;
  ContinuityTolerance& tolerance = context.editor.view.tolerance;
  row_label(context, context.tr("Tolerance"),
            context.tr("Largest angle between normals, and largest jump of curvature relative to it"));
  const float spacing = context.metrics.px(4), width = (ImGui::GetContentRegionAvail().x - spacing) / 2;
  ImGui::SetNextItemWidth(width);
  double angle = tolerance.angle;
  if (ImGui::InputDouble("##angle", &angle, 0, 0, "%.4g\u00b0") && std::isfinite(angle))
    tolerance.angle = std::clamp(angle, 0.0, 90.0);
  context.marks.item("field.tolerance_angle");
  ImGui::SameLine(0, spacing);
  ImGui::SetNextItemWidth(width);
  double percent = tolerance.curvature * 100;
  if (ImGui::InputDouble("##jump", &percent, 0, 0, "%.4g %%") && std::isfinite(percent))
    tolerance.curvature = std::clamp(percent / 100, 0.0, 2.0);
  context.marks.item("field.tolerance_jump");
}

void show_rows(PanelContext& context, const Object& object) {
  row_label(context, context.tr("Show"), "");
  const float start = ImGui::GetCursorPosX(), second = start + context.metrics.px(112);
  show_flag(context, object, surface_flag);
  if (!object.polyhedron()) {
    ImGui::SameLine(second);
    show_flag(context, object, edges_flag);
    if (!object.solids()) return;
    ImGui::SetCursorPosX(start);
    ImGui::BeginDisabled(!object.display.polyhedron);
    ImGui::Checkbox(context.tr("bodies"), &context.editor.view.bodies);
    ImGui::EndDisabled();
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("%s", context.tr("See the bodies of solids through the surface round them."));
    context.marks.item("check.bodies");
    return;
  }
  ImGui::SameLine(second);
  show_flag(context, object, points_flag);
  ImGui::SetCursorPosX(start);
  show_flag(context, object, polyhedron_flag);
  ImGui::SameLine(second);
  show_flag(context, object, tensions_flag);
  ImGui::SetCursorPosX(start);
  show_flag(context, object, network_flag);
}

/// World box of what is visible, for the offset's slider.
Box3 shown_box(const Editor& editor) {
  Box3 box;
  for (const auto& object : editor.document().objects)
    if (object->visible) box.extend(world_box(*object));
  return box;
}

void section_rows(PanelContext& context) {
  ViewSettings::Section& section = context.editor.view.section;
  row_label(context, context.tr("Section"),
            context.tr("Cuts away what is beyond a plane, in this view only"));
  const Box3 box = shown_box(context.editor);
  if (ImGui::Checkbox("##section", &section.shown) && section.shown && !box.isEmpty() &&
      !(section.offset >= box.min()[section.axis] && section.offset <= box.max()[section.axis]))
    section.offset = box.center()[section.axis];
  context.marks.item("check.section");
  if (!section.shown) return;
  ImGui::SameLine();
  ImGui::Checkbox(context.tr("other side"), &section.flipped);
  context.marks.item("check.section_flipped");
  if (const auto chosen = choose(context, "section_axis", "Across", "The axis that the plane is square to",
                                 axis_choices, section.axis)) {
    section.axis = *chosen;
    if (!box.isEmpty()) section.offset = box.center()[section.axis];
  }
  row_label(context, context.tr("Offset"), context.tr("Of the plane along its axis"));
  ImGui::SetNextItemWidth(-1);
  const double low = box.isEmpty() ? -1 : box.min()[section.axis],
               high = box.isEmpty() ? 1 : box.max()[section.axis];
  const std::string format = std::string("%.4g ") + std::string(to_string(context.editor.document().unit));
  ImGui::SliderScalar("##offset", ImGuiDataType_Double, &section.offset, &low, &high, format.c_str(),
                      ImGuiSliderFlags_NoRoundToFormat);
  if (!std::isfinite(section.offset)) section.offset = 0;
  context.marks.item("slider.section");
}

void x_ray_row(PanelContext& context) {
  ViewSettings& view = context.editor.view;
  if (!view.x_ray) return;
  row_label(context, context.tr("X-ray"), context.tr("Strength of what lies behind the surface"));
  ImGui::SetNextItemWidth(-1);
  constexpr double low = 0.05, high = 1;
  ImGui::SliderScalar("##x_ray", ImGuiDataType_Double, &view.x_ray_strength, &low, &high, "%.2f",
                      ImGuiSliderFlags_AlwaysClamp);
  context.marks.item("slider.x_ray");
}

}  // namespace

void draw_display(PanelContext& context, const Object& object) {
  heading(context, context.tr("Display"));
  const DisplaySettings& display = object.display;
  const SurfaceMap shown = shown_map(context.editor.view.map, object);
  if (const auto chosen = choose(context, "map", "Map", "What colours this surface, whatever the view shows",
                                 map_choices, static_cast<int>(display.map))) {
    DisplaySettings changed = display;
    changed.map = static_cast<SurfaceMap>(*chosen);
    commit(context, object, changed,
           fill(translatable("Map {0}"), {map_choices[static_cast<std::size_t>(*chosen)].label}));
  }
  if (shown == SurfaceMap::zebra || shown == SurfaceMap::isophotes) stripe_rows(context);
  if (has_values(display.map)) range_rows(context, object);
  if (shown == SurfaceMap::shaded || shown == SurfaceMap::isophotes) material_rows(context, object);
  show_rows(context, object);
  if (const auto chosen = choose(context, "wire", "Lines", "Lines over the surface", wire_choices,
                                 static_cast<int>(display.wire))) {
    DisplaySettings changed = display;
    changed.wire = static_cast<PatchWire>(*chosen);
    commit(context, object, changed, "Lines over the surface");
  }
  if (object.has_surface()) {
    mark_rows(context, object);
    comb_rows(context, object);
  }
  if (object.polyhedron()) {
    const Quantity density =
        whole_quantity(DisplaySettings::min_density, DisplaySettings::max_density, DisplaySettings().density);
    slider_row(
        context,
        {"density", "Density", "Least intervals a patch side on the screen; small models are drawn finer",
         "Display density", density},
        density.low, density.high, false, display.density,
        display_values(
            object.id, density, [](const DisplaySettings& d) { return static_cast<double>(d.density); },
            [](DisplaySettings& d, double value) { d.density = static_cast<int>(value); }));
  }
  section_rows(context);
  x_ray_row(context);
}

}  // namespace hariko
