#include "ui/view/legend.hpp"
#include "ui/widgets/tips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "render/region_picking.hpp"
#include "render/tension_colors.hpp"
#include "ui/base/text_lines.hpp"
#include "ui/editor/legend_source.hpp"
#include "ui/widgets/enum_labels.hpp"

namespace hariko {

namespace {

constexpr float color_bar_height = 150, bar_width = 14, histogram_width = 36;

/// An end of the range: a label that a click turns into a field.
void range_end(PanelContext& context, const LegendSource& source, bool high) {
  const ValueRange shown = source.range;
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID editing = ImGui::GetID(high ? "edit_high" : "edit_low");
  const double value = high ? shown.high : shown.low;
  const float width = context.metrics.px(96);
  const std::string mark = high ? "legend.high" : "legend.low";
  // Frames since the click that asked for the field, plus one; the keyboard comes a frame or two later.
  constexpr int patience = 8;
  if (const int frames = storage.GetInt(editing); frames != 0) {
    ImGui::SetNextItemWidth(width);
    double typed = value;
    const bool waiting = frames < patience;
    if (waiting) focus_next_field();
    if (ImGui::InputDouble(high ? "##high" : "##low", &typed, 0, 0, "%.6g",
                           ImGuiInputTextFlags_AutoSelectAll))
      context.state.typed = typed;
    context.marks.item(mark);
    const bool active = ImGui::IsItemActive();
    if (waiting) storage.SetInt(editing, active ? patience : frames + 1);
    if (waiting && !active) context.state.field_opening = true;
    if (ImGui::IsItemDeactivated()) {
      if (ImGui::IsItemDeactivatedAfterEdit()) {
        MapRange range{RangeMode::manual, shown.low, shown.high};
        (high ? range.high : range.low) = context.state.typed;
        set_range(context.editor, source, range);
      }
      storage.SetInt(editing, 0);
    } else if (!waiting && !active) {
      storage.SetInt(editing, 0);  // something else took the keyboard
    }
    return;
  }
  const std::string label = format_number(value, 4);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton(high ? "high" : "low", {width, ImGui::GetTextLineHeight()})) {
    storage.SetInt(editing, 1);
    context.state.typed = value;
    context.state.field_opening = true;
  }
  context.marks.item(mark);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) show_tip(context.tr("Click to type; right click resets"));
  ImGui::GetWindowDrawList()->AddText(at, hovered ? palette().secondary : palette().text, label.c_str());
}

void draw_bar(PanelContext& context, const LegendSource& source) {
  const Metrics& m = context.metrics;
  const bool safe = context.editor.settings.colour_blind_maps;
  const float height = m.px(color_bar_height), width = m.px(bar_width);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::Dummy({m.px(150), height});
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto y_of = [&](double fraction) { return low.y + height * static_cast<float>(1 - fraction); };
  const auto colour = [&](double fraction) {
    const double value = source.range.low + fraction * (source.range.high - source.range.low);
    return to_imgui(color_of_value(source.map, source.range, safe, value));
  };
  // A colour that begins with a step has a part of one colour.
  const bool steps = has_limit(source.map);
  const int parts = steps ? 150 : 64;
  for (int i = 0; i < parts; ++i) {
    const double a = double(i) / parts, b = double(i + 1) / parts, middle = (a + b) / 2;
    const ImU32 above = colour(steps ? middle : b), below = colour(steps ? middle : a);
    draw.AddRectFilledMultiColor({low.x, y_of(b)}, {low.x + width, y_of(a)}, above, above, below, below);
  }
  const std::size_t bins = source.histogram->size();
  const ImU32 grey = with_alpha(palette().text, 0.32F);
  for (std::size_t i = 0; i < bins; ++i)
    draw.AddRectFilled({low.x + width + m.px(4), y_of(double(i + 1) / double(bins))},
                       {low.x + width + m.px(4) + (*source.histogram)[i] * m.px(histogram_width),
                        y_of(double(i) / double(bins))},
                       grey);
  const float half = ImGui::GetTextLineHeight() / 2;
  for (const Tick& tick : legend_ticks(source.range)) {
    const float y = y_of(tick.fraction);
    draw.AddLine({low.x + width - m.px(4), y}, {low.x + width, y}, IM_COL32(0, 0, 0, 160));
    if (tick.fraction < 0.06 || tick.fraction > 0.94) continue;  // the ends have their own numbers
    draw.AddText({low.x + width + m.px(histogram_width + 12), y - half}, palette().text, tick.label.c_str());
  }
}

void range_menu(PanelContext& context, const LegendSource& source) {
  const MapRange range = range_settings(context.editor, source);
  const std::string label = std::string(context.tr(enum_choice(range.mode).label)) + "##mode";
  if (ImGui::SmallButton(label.c_str())) ImGui::OpenPopup("range_modes");
  context.marks.item("legend.mode");
  if (!ImGui::BeginPopup("range_modes")) return;
  for (const RangeMode mode : enum_values<RangeMode>()) {
    if (ImGui::MenuItem(context.tr(enum_choice(mode).label), nullptr, mode == range.mode)) {
      MapRange changed = range;
      changed.mode = mode;
      set_range(context.editor, source, changed);
    }
    context.marks.item("legend.mode." + std::to_string(static_cast<int>(mode)));
  }
  ImGui::EndPopup();
}

/// The parts below the limit and below the floor of the map, with their colours.
void limit_rows(PanelContext& context, const LegendSource& source) {
  if (!has_limit(source.map)) return;
  const Metrics& m = context.metrics;
  const bool safe = context.editor.settings.colour_blind_maps;
  const auto row = [&](const Color& color, const std::string& text, const char* mark) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetTextLineHeight();
    ImGui::Dummy({m.px(bar_width) + m.px(6), side});
    ImGui::GetWindowDrawList()->AddRectFilled(
        {at.x, at.y + m.px(3)}, {at.x + m.px(bar_width), at.y + side - m.px(3)}, to_imgui(color));
    ImGui::SameLine(0, 0);
    ImGui::TextUnformatted(text.c_str());
    context.marks.item(mark);
  };
  const std::string unit = unit_of(source.map, to_string(context.editor.document().unit));
  const std::string limit =
      format_number(source.range.centre, 4) + (source.map == SurfaceMap::draft ? "" : " ") + unit;
  row(color_at(safe ? ColorScale::limit_safe : ColorScale::limit, 0.2),
      fill(context.tr("less than {0}"), {limit}), "legend.limit");
  if (const auto floor = floor_of(source.map, safe))
    row(floor->color, context.tr("undercut"), "legend.floor");
}

void missing_section(PanelContext& context, const MissingMap& missing) {
  const std::string text = context.tr.text_of(*missing.reason),
                    remedy = context.tr.remedy_of(*missing.reason);
  const float width = context.metrics.px(200);
  const TextColour colour(palette().warning);
  ImGui::TextUnformatted(
      in_lines((missing.object.empty() ? text : missing.object + ": " + text) + " " + remedy, width).c_str());
  context.marks.item("legend.missing");
}

void map_section(PanelContext& context, const LegendSource& source) {
  std::string title = context.tr(std::string(title_of(source.map)));
  const std::string unit = unit_of(source.map, to_string(context.editor.document().unit));
  if (!unit.empty()) title += "  " + unit;
  ImGui::TextUnformatted(title.c_str());
  range_end(context, source, true);
  draw_bar(context, source);
  range_end(context, source, false);
  range_menu(context, source);
  limit_rows(context, source);
  if (ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
      ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    MapRange reset = range_settings(context.editor, source);
    reset.mode = RangeMode::symmetric;
    set_range(context.editor, source, reset);
  }
}

void marks_section(PanelContext& context, const EdgeMarks* marks) {
  if (!marks) {
    ImGui::TextDisabled("%s", context.tr("Measuring the edges\u2026"));
    return;
  }
  const Metrics& m = context.metrics;
  static constexpr std::array names{"G0", "G1", "G2"};
  static constexpr std::array meanings{translatable("kink"), translatable("curvature jumps"),
                                       translatable("curvature runs on")};
  static constexpr std::array<float, 3> widths{4.4F, 3.2F, 1.8F};
  for (std::size_t k = 0; k < names.size(); ++k) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float length = m.px(34), y = at.y + ImGui::GetTextLineHeight() / 2;
    ImGui::Dummy({length + m.px(6), ImGui::GetTextLineHeight()});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 colour = to_imgui(mark_color(static_cast<Continuity>(k)));
    // As the picture draws them: G1 is dashed.
    const float dash = k == 1 ? m.px(9) : length, step = k == 1 ? m.px(12.5F) : length;
    for (float x = 0; x < length; x += step)
      draw.AddLine({at.x + x, y}, {at.x + std::min(x + dash, length), y}, colour, m.px(widths[k]));
    ImGui::SameLine(0, 0);
    ImGui::Text("%s  %zu", names[k], marks->classes[k].curves);
    ImGui::SameLine();
    ImGui::TextDisabled("%s", context.tr(meanings[k]));
  }
  const ContinuityTolerance& tolerance = context.editor.view.tolerance;
  ImGui::TextDisabled("\u2264 %s\u00b0, %s %%", format_number(tolerance.angle, 3).c_str(),
                      format_number(100 * tolerance.curvature, 3).c_str());
}

void combs_section(PanelContext& context, const CombLines& combs) {
  const std::string unit = "1/" + std::string(to_string(context.editor.document().unit));
  ImGui::Text("%s  %s %s", context.tr("Longest tooth"), format_number(combs.greatest, 3).c_str(),
              unit.c_str());
}

void tensions_section(PanelContext& context) {
  const Metrics& m = context.metrics;
  ImGui::TextUnformatted(context.tr("Tension"));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = m.px(150), height = m.px(10);
  ImGui::Dummy({width, height});
  constexpr int parts = 30;
  for (int i = 0; i < parts; ++i) {
    const double place = (2 * (i + 0.5) / parts) - 1;
    ImGui::GetWindowDrawList()->AddRectFilled(
        {at.x + width * static_cast<float>(i) / parts, at.y},
        {at.x + width * static_cast<float>(i + 1) / parts, at.y + height}, to_imgui(tension_color(place)));
  }
  ImGui::TextDisabled("%s", context.tr("loose"));
  const char* tight = context.tr("tight");
  ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + width - ImGui::CalcTextSize(tight).x);
  ImGui::TextDisabled("%s", tight);
}

/// Rectangles that labels occupy already.
class Room {
 public:
  bool take(const ImVec2& low, const ImVec2& high) {
    for (const auto& [a, b] : taken_)
      if (low.x < b.x && high.x > a.x && low.y < b.y && high.y > a.y) return false;
    taken_.push_back({low, high});
    return true;
  }
  std::size_t size() const { return taken_.size(); }

 private:
  std::vector<std::pair<ImVec2, ImVec2>> taken_;
};

struct NumberLabel {
  Vector3 world;
  double value;
  double place;  ///< of the tension's colour
  const char* letter;
};

std::vector<NumberLabel> labels_of(const Object& object) {
  const PolyhedronSource& source = *object.polyhedron();
  const Polyhedron& polyhedron = source.polyhedron;
  const Shaping& shaping = *source.shaping;
  constexpr Index few = 40;
  const bool all = polyhedron.vertex_count() + polyhedron.edge_count() <= few;
  const Matrix4 to_world = matrix_of(object.transform);
  const auto world = [&](const Vector3& local) -> Vector3 {
    return to_world.topLeftCorner<3, 3>() * (source.origin + local) + to_world.topRightCorner<3, 1>();
  };
  std::vector<NumberLabel> labels;
  const auto add_vertex = [&](Index v, double alpha) {
    labels.push_back({world(polyhedron.position(v)), alpha, alpha_place(alpha), "\u03b1 "});
  };
  const auto add_edge = [&](Index e, double beta) {
    const Index h = polyhedron.topology().half_edge_of_edge(e);
    labels.push_back({world((polyhedron.position(polyhedron.topology().origin(h)) +
                             polyhedron.position(polyhedron.topology().target(h))) /
                            2),
                      beta, beta_place(beta), "\u03b2 "});
  };
  if (all) {
    for (Index v = 0; v < polyhedron.vertex_count(); ++v)
      add_vertex(v, shaping.alpha.get_or(polyhedron.vertex_id(v), 0));
    for (Index e = 0; e < polyhedron.edge_count(); ++e)
      add_edge(e, shaping.beta.get_or(polyhedron.edge_id(e), 1));
    return labels;
  }
  for (const auto& [id, alpha] : shaping.alpha)
    if (const Index v = polyhedron.find(id); v != no_index && alpha != 0) add_vertex(v, alpha);
  for (const auto& [id, beta] : shaping.beta)
    if (const Index e = polyhedron.find(id); e != no_index && beta != 1) add_edge(e, beta);
  return labels;
}

/// What the objects hide that are drawn solid, coarsely: a number need not vanish to the pixel.
Occlusion hiding_of(const Scene& scene, const Projector& projector) {
  constexpr int coarse = 4;  // pixels a side, of one that is looked at
  Scene solid;
  solid.section = scene.section;
  solid.pixel_scale = scene.pixel_scale;
  for (const SceneObject& object : scene.objects)
    if (object.mesh && object.show_surface) solid.objects.push_back(object);
  const PixelSize size{std::max(1, projector.size().width / coarse),
                       std::max(1, projector.size().height / coarse)};
  return {solid, Projector(projector.camera(), size)};
}

}  // namespace

ImU32 to_imgui(const Color& c) {
  return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, c.a});
}

void draw_legend(PanelContext& context, const PanelRect& viewport, const SceneBuilder& scene) {
  const auto map = legend_source(context.editor, scene);
  const Object* object = context.editor.active_object();
  const SurfaceView* view = object && object->visible ? context.editor.view_of(object->id) : nullptr;
  if (view && !view->mesh) view = nullptr;
  const DisplaySettings display = view ? object->display : DisplaySettings();
  const auto combs = display.combs.shown ? view->combs : nullptr;
  const auto missing = missing_map(context.editor);
  if (!map && !missing && !combs && !display.marks && !display.tensions) return;
  std::shared_ptr<const EdgeMarks> marks;
  for (std::size_t i = 0; view && i < scene.scene().objects.size(); ++i)
    if (scene.object_id(i) == object->id) marks = scene.scene().objects[i].marks;

  const Metrics& m = context.metrics;
  ImGui::SetNextWindowPos({viewport.min.x + m.px(8), viewport.max.y - m.px(8)}, ImGuiCond_Always, {0, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(m.px(10), m.px(8)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, m.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().overlay);
  ImGui::Begin(legend_window, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_AlwaysAutoResize);
  bool first = true;
  const auto section = [&](bool shown, auto&& draw) {
    if (!shown) return;
    if (!first) ImGui::Dummy({0, m.px(4)});
    first = false;
    draw();
  };
  section(display.tensions, [&] { tensions_section(context); });
  section(combs != nullptr, [&] { combs_section(context, *combs); });
  section(display.marks, [&] { marks_section(context, marks.get()); });
  section(map.has_value(), [&] { map_section(context, *map); });
  section(missing.has_value(), [&] { missing_section(context, *missing); });
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

void draw_tension_numbers(PanelContext& context, const PanelRect& view, const Camera& camera,
                          const Scene& scene) {
  const Editor& editor = context.editor;
  constexpr std::size_t most = 400;
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  const Projector projector(camera, {std::max(1, static_cast<int>(view.width() * scale.x)),
                                     std::max(1, static_cast<int>(view.height() * scale.y))});
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Metrics& m = context.metrics;
  const bool through = editor.view.x_ray || editor.selecting.through;
  std::optional<Occlusion> occlusion;
  Room room;
  for (const auto& object : editor.document().objects) {
    if (!object->visible || !object->polyhedron() || !object->display.tensions || !object->display.polyhedron)
      continue;
    if (!occlusion) occlusion = hiding_of(scene, projector);
    struct Seen {
      NumberLabel label;
      Vector3 at;
      bool hidden;
    };
    std::vector<Seen> seen;
    for (const NumberLabel& label : labels_of(*object)) {
      const auto at = projector.project(label.world);
      if (!at || (scene.section && scene.section->cuts(label.world))) continue;
      const bool hidden = !occlusion->visible(label.world);
      if (!hidden || through) seen.push_back({label, *at, hidden});
    }
    // What can be seen has room first, of that the nearest; what only shows through is pale.
    std::stable_sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) {
      return a.hidden != b.hidden ? b.hidden : a.at.z() < b.at.z();
    });
    for (const Seen& one : seen) {
      if (room.size() >= most) break;
      const std::string text = one.label.letter + format_number(one.label.value, 3);
      const ImVec2 size = ImGui::CalcTextSize(text.c_str());
      const ImVec2 at(view.min.x + static_cast<float>(one.at.x()) / scale.x + m.px(8),
                      view.min.y + static_cast<float>(one.at.y()) / scale.y - size.y - m.px(4));
      const ImVec2 low(at.x - m.px(4), at.y - m.px(1)),
          high(at.x + size.x + m.px(4), at.y + size.y + m.px(1));
      if (high.x < view.min.x || low.x > view.max.x || high.y < view.min.y || low.y > view.max.y) continue;
      if (!room.take(low, high)) continue;
      const float strength = one.hidden ? 0.45F : 1.0F;
      draw.AddRectFilled(low, high, with_alpha(palette().window, 0.78F * strength), m.px(4));
      if (one.label.place != 0)
        draw.AddRectFilled(low, {low.x + m.px(3), high.y},
                           with_alpha(to_imgui(tension_color(one.label.place)), strength), m.px(2));
      draw.AddText(at, with_alpha(one.label.place != 0 ? palette().text : palette().dim_text, strength),
                   text.c_str());
    }
  }
}

}  // namespace hariko
