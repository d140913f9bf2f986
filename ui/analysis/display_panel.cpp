#include "ui/analysis/display_panel.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>

#include "core/document/edits/edits.hpp"
#include "ui/analysis/environment_rows.hpp"
#include "ui/analysis/making_rows.hpp"
#include "ui/analysis/section_curve_rows.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

constexpr std::array axis_choices{Choice{"X", ""}, Choice{"Y", ""}, Choice{"Z", ""}};

/// Changes how all objects are shown. Those that are gone by now are left out.
Result<Document> edit_displays(const Document& document, const Objects& objects,
                               const std::function<void(DisplaySettings&)>& change) {
  Result<Document> result = document;
  for (const auto& object : objects) {
    const Object* found = result.ok() ? result->find(object->id) : nullptr;
    if (!found) continue;
    DisplaySettings display = found->display;
    change(display);
    result = set_display(*result, object->id, display);
  }
  return result;
}

/// The edit of a number of the display settings: how to read it and how to write it.
template <class Read, class Write>
EditValues display_values(const Objects& objects, const Quantity& quantity, const Read& read,
                          const Write& write) {
  return [=](const Document& document, const ValueChange& change) {
    return edit_displays(document, objects, [&](DisplaySettings& display) {
      write(display, change.apply(quantity, read(display)));
    });
  };
}

void commit(PanelContext& context, const Objects& objects, const std::string& step,
            const std::function<void(DisplaySettings&)>& change) {
  context.editor.commit(edit_displays(context.editor.history.current(), objects, change), step);
}

/// Value that all objects have in common; nothing where they differ.
template <class T, class Get>
std::optional<T> shown_alike(const Objects& objects, const Get& get) {
  return common<T>(objects, [&](const auto& object) -> T { return get(object->display); });
}

template <class Test>
bool any_of(const Objects& objects, const Test& test) {
  return std::any_of(objects.begin(), objects.end(), [&](const auto& object) { return test(*object); });
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

void show_flag(PanelContext& context, const Objects& objects, const Flag& flag) {
  const auto alike =
      shown_alike<bool>(objects, [&](const DisplaySettings& display) { return display.*flag.flag; });
  bool on = alike.value_or(false);
  ImGui::PushItemFlag(ImGuiItemFlags_MixedValue, !alike);
  const bool pressed = ImGui::Checkbox((std::string(context.tr(flag.label)) + "##" + flag.mark).c_str(), &on);
  ImGui::PopItemFlag();
  context.marks.item(std::string("check.") + flag.mark);
  if (pressed)
    commit(context, objects, on ? flag.show_step : flag.hide_step,
           [&](DisplaySettings& display) { display.*flag.flag = on; });
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
  pointer_button("##ball", {2 * radius, 2 * radius});
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
  number_slider("##stripes", {2, 64, "%d"}, zebra.stripes);
  context.marks.item("slider.stripes");
  if (const auto chosen = choose(context, "lock", "Locked to", "What the stripes stand still with",
                                 std::optional(zebra.lock)))
    zebra.lock = *chosen;
  direction_row(context, zebra);
}

void range_rows(PanelContext& context, const Objects& objects, SurfaceMap map) {
  const auto mode = shown_alike<RangeMode>(
      objects, [map](const DisplaySettings& display) { return range_of(display, map).mode; });
  if (const auto chosen =
          choose(context, "range", "Range", "Which values the colours span; kept for each map", mode)) {
    // What is typed begins with what was seen.
    const SurfaceView* view = context.editor.view_of(objects.front()->id);
    const bool seen = view && view->range.low < view->range.high;
    commit(context, objects, "Range of the map", [&](DisplaySettings& display) {
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
  const MapRange& first = range_of(objects.front()->display, map);
  Quantity quantity = length_quantity(Unit::millimetre, std::max(std::abs(first.low), std::abs(first.high)));
  quantity.unit.clear();
  quantity.factors.clear();
  const auto end = [&](const char* id, double MapRange::*member) {
    number_field(context, {id, "", "Ends of the range, in the map's unit", "Range of the map", quantity},
                 shown_alike<double>(
                     objects, [&](const DisplaySettings& display) { return range_of(display, map).*member; }),
                 width,
                 display_values(
                     objects, quantity,
                     [map, member](DisplaySettings& display) { return range_of(display, map).*member; },
                     [map, member](DisplaySettings& display, double value) {
                       range_of(display, map).*member = value;
                     }));
  };
  end("range_low", &MapRange::low);
  ImGui::SameLine(0, spacing);
  end("range_high", &MapRange::high);
}

void colour_row(PanelContext& context, const Objects& objects) {
  Editor& editor = context.editor;
  row_label(context, context.tr("Colour"), context.tr("Of the outside; the inside stays blue"));
  const bool alike = common<bool>(objects, [&](const auto& object) {
                       return object->display.colour == objects.front()->display.colour;
                     }).value_or(false);
  const Color color = color_of(objects.front()->display.colour);
  std::array<float, 3> rgb{color.r, color.g, color.b};
  if (!alike) {
    ImGui::TextDisabled("%s", context.tr("mixed"));
    ImGui::SameLine();
  }
  ImGui::SetNextItemWidth(-1);
  if (ImGui::ColorEdit3("##colour", rgb.data(), ImGuiColorEditFlags_DisplayHex)) {
    const auto byte = [](float part) {
      return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0F, 1.0F)));
    };
    editor.preview(edit_displays(editor.history.current(), objects, [&](DisplaySettings& display) {
      display.colour = {byte(rgb[0]), byte(rgb[1]), byte(rgb[2])};
    }));
  }
  if (ImGui::IsItemDeactivatedAfterEdit())
    editor.commit_preview(objects.size() == 1 ? "Colour of the object" : "Colour of objects");
  context.marks.item("field.colour");
}

void material_rows(PanelContext& context, const Objects& objects) {
  if (any_of(objects, [](const Object& object) { return object.display.map == SurfaceMap::shaded; })) {
    const auto material =
        shown_alike<Material>(objects, [](const DisplaySettings& display) { return display.material; });
    if (const auto chosen =
            choose(context, "material", "Material", "How the surface takes the light", material))
      commit(context, objects, "Material",
             [&](DisplaySettings& display) { display = with_material(display, *chosen); });
  }
  colour_row(context, objects);
}

void comb_rows(PanelContext& context, const Objects& objects) {
  const auto change = [&](const std::function<void(CombSettings&)>& set) {
    commit(context, objects, "Curvature combs", [&](DisplaySettings& display) { set(display.combs); });
  };
  const auto alike =
      shown_alike<bool>(objects, [](const DisplaySettings& display) { return display.combs.shown; });
  if (const auto on = check_row(context, "combs", "Combs",
                                "Teeth as long as the curves of the network are curved", alike))
    change([&](CombSettings& c) { c.shown = *on; });
  if (alike != true) return;
  ImGui::SameLine();
  if (ImGui::Button("\u00f7 2"))
    change([](CombSettings& c) { c.scale = std::max(c.scale / 2, c.min_scale); });
  context.marks.item("combs.shorter");
  ImGui::SameLine(0, context.metrics.px(4));
  if (ImGui::Button("\u00d7 2"))
    change([](CombSettings& c) { c.scale = std::min(c.scale * 2, c.max_scale); });
  context.marks.item("combs.longer");
  ImGui::SameLine();
  const auto scale =
      shown_alike<double>(objects, [](const DisplaySettings& display) { return display.combs.scale; });
  ImGui::TextDisabled("%s", scale ? ("\u00d7 " + format_number(*scale, 3)).c_str() : context.tr("mixed"));
  const Quantity teeth =
      whole_quantity(CombSettings::min_density, CombSettings::max_density, CombSettings().density);
  const auto density = [](const DisplaySettings& d) { return static_cast<double>(d.combs.density); };
  slider_row(context, {"comb_density", "Teeth", "Intervals on each curve", "Curvature combs", teeth},
             teeth.low, teeth.high, true, shown_alike<double>(objects, density),
             display_values(objects, teeth, density, [](DisplaySettings& d, double value) {
               d.combs.density = static_cast<int>(value);
             }));
}

void mark_rows(PanelContext& context, const Objects& objects) {
  row_label(context, context.tr("Edges"), context.tr("Continuity across the edges within the tolerance"));
  show_flag(context, objects, marks_flag);
  if (!any_of(objects, [](const Object& object) { return object.display.marks; })) return;
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

/// A check box for what all kinds show, and those that polyhedra or solids have as well.
void show_rows(PanelContext& context, const Objects& objects) {
  row_label(context, context.tr("Show"), "");
  const float start = ImGui::GetCursorPosX(), second = start + context.metrics.px(112);
  show_flag(context, objects, surface_flag);
  ImGui::SameLine(second);
  const bool polyhedra =
      std::all_of(objects.begin(), objects.end(), [](const auto& object) { return object->polyhedron(); });
  if (!polyhedra) {
    show_flag(context, objects, edges_flag);
    if (!any_of(objects, [](const Object& object) { return object.solids() != nullptr; })) return;
    ImGui::SetCursorPosX(start);
    {
      const Disabled disabled(
          !any_of(objects, [](const Object& object) { return object.display.polyhedron; }));
      ImGui::Checkbox(context.tr("bodies"), &context.editor.view.bodies);
    }
    if (ImGui::IsItemHovered())
      show_tip(context.tr("See the bodies of solids through the surface round them."));
    context.marks.item("check.bodies");
    return;
  }
  show_flag(context, objects, points_flag);
  ImGui::SetCursorPosX(start);
  show_flag(context, objects, polyhedron_flag);
  ImGui::SameLine(second);
  show_flag(context, objects, tensions_flag);
  ImGui::SetCursorPosX(start);
  show_flag(context, objects, network_flag);
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
  const double low = box.isEmpty() ? -1 : box.min()[section.axis],
               high = box.isEmpty() ? 1 : box.max()[section.axis];
  const std::string format = std::string("%.4g ") + std::string(to_string(context.editor.document().unit));
  number_slider("##offset", {low, high, format.c_str(), ImGuiSliderFlags_NoRoundToFormat}, section.offset);
  if (!std::isfinite(section.offset)) section.offset = 0;
  context.marks.item("slider.section");
}

void x_ray_row(PanelContext& context) {
  ViewSettings& view = context.editor.view;
  if (!view.x_ray) return;
  row_label(context, context.tr("X-ray"), context.tr("Strength of what lies behind the surface"));
  number_slider("##x_ray", {0.05, 1, "%.2f"}, view.x_ray_strength);
  context.marks.item("slider.x_ray");
}

}  // namespace

void draw_display(PanelContext& context, const Objects& objects) {
  heading(context, context.tr("Display"));
  const auto map =
      shown_alike<SurfaceMap>(objects, [](const DisplaySettings& display) { return display.map; });
  if (const auto chosen =
          choose(context, "map", "Map", "What colours this surface, whatever the view shows", map))
    commit(context, objects, fill(translatable("Map {0}"), {enum_choice(*chosen).label}),
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
  if (map && has_values(*map)) range_rows(context, objects, *map);
  if (shows(SurfaceMap::shaded) || shows(SurfaceMap::isophotes)) material_rows(context, objects);
  show_rows(context, objects);
  const auto wire =
      shown_alike<PatchWire>(objects, [](const DisplaySettings& display) { return display.wire; });
  if (const auto chosen = choose(context, "wire", "Lines", "Lines over the surface", wire))
    commit(context, objects, "Lines over the surface",
           [&](DisplaySettings& display) { display.wire = *chosen; });
  Objects surfaces, polyhedra;
  std::copy_if(objects.begin(), objects.end(), std::back_inserter(surfaces),
               [](const auto& object) { return object->has_surface(); });
  if (!surfaces.empty()) {
    mark_rows(context, surfaces);
    comb_rows(context, surfaces);
  }
  std::copy_if(objects.begin(), objects.end(), std::back_inserter(polyhedra),
               [](const auto& object) { return object->polyhedron() != nullptr; });
  if (!polyhedra.empty()) {
    const Quantity density =
        whole_quantity(DisplaySettings::min_density, DisplaySettings::max_density, DisplaySettings().density);
    const auto now = [](const DisplaySettings& d) { return static_cast<double>(d.density); };
    slider_row(
        context,
        {"density", "Density", "Least intervals a patch side on the screen; small models are drawn finer",
         "Display density", density},
        density.low, density.high, false, shown_alike<double>(polyhedra, now),
        display_values(polyhedra, density, now,
                       [](DisplaySettings& d, double value) { d.density = static_cast<int>(value); }));
  }
  section_rows(context);
  section_curve_rows(context);
  x_ray_row(context);
}

}  // namespace hariko
