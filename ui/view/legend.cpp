#include "ui/view/legend.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "render/element_colors.hpp"
#include "ui/base/text_lines.hpp"
#include "ui/editor/legend_source.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/tips.hpp"

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
    double typed = value;
    const bool waiting = frames < patience;
    if (waiting) focus_next_field();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (number_input(context.marks, mark, width, {-infinity, infinity, "%.6g"}, typed))
      context.state.typed = typed;
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
  if (area_button(context.marks, mark, {width, ImGui::GetTextLineHeight()})) {
    storage.SetInt(editing, 1);
    context.state.typed = value;
    context.state.field_opening = true;
  }
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
  MapRange range = range_settings(context.editor, source);
  const auto chosen =
      choice_menu(context, "legend.mode", enum_choices<RangeMode>, static_cast<int>(range.mode));
  if (!chosen) return;
  range.mode = static_cast<RangeMode>(*chosen);
  set_range(context.editor, source, range);
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
    plain_text(text);
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
  const std::string whole = (missing.object.empty() ? text : missing.object + ": " + text) + " " + remedy;
  coloured_text(palette().warning, in_lines(whole, width).c_str());
  context.marks.item("legend.missing");
}

void map_section(PanelContext& context, const LegendSource& source) {
  std::string title = context.tr(std::string(title_of(source.map)));
  const std::string unit = unit_of(source.map, to_string(context.editor.document().unit));
  if (!unit.empty()) title += "  " + unit;
  plain_text(title);
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
  if (!marks) return dim_text(context.tr("Measuring the edges\u2026"));
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
    plain_text(std::string(names[k]) + "  " + std::to_string(marks->classes[k].curves));
    ImGui::SameLine();
    dim_text(context.tr(meanings[k]));
  }
  const ContinuityTolerance& tolerance = context.editor.view.tolerance;
  dim_text("\u2264 " + format_number(tolerance.angle, 3) + "\u00b0, " +
           format_number(100 * tolerance.curvature, 3) + " %");
}

void combs_section(PanelContext& context, const CombLines& combs) {
  plain_text(std::string(context.tr("Longest tooth")) + "  " + format_number(combs.greatest, 3) + " 1/" +
             std::string(to_string(context.editor.document().unit)));
}

void tensions_section(PanelContext& context) {
  const Metrics& m = context.metrics;
  plain_text(context.tr("Tension"));
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
  dim_text(context.tr("loose"));
  const char* tight = context.tr("tight");
  ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + width - ImGui::CalcTextSize(tight).x);
  dim_text(tight);
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

// Over the picture of a mesh: where its error is the largest, and what each of four compared pictures shows.

namespace {

void plate(ImDrawList& list, const Metrics& m, ImVec2 at, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  list.AddRectFilled({at.x - m.px(5), at.y - m.px(2)}, {at.x + size.x + m.px(5), at.y + size.y + m.px(2)},
                     palette().overlay, m.px(3));
  list.AddText(at, palette().text, text.c_str());
}

/// Number of the picture, out of four, that a view shows: they are read line by line.
std::size_t place_of(const Editor& editor, std::size_t view) {
  const std::vector<Pane> panes = editor.layout.panes();
  const auto at =
      std::ranges::find_if(panes, [&](const Pane& pane) { return std::size_t(pane.view) == view; });
  return std::size_t(at - panes.begin());
}

/// A ring round the place, with its value beside it.
void marker(const PanelContext& context, const Projector& projector, const PanelRect& pane, MeshShown shown,
            const MeshErrors& errors, const Similarity& transform, const Vector3& origin) {
  if (!(errors.largest > 0)) return;
  const auto pixel = projector.project(transform.apply(origin + errors.place));
  if (!pixel) return;
  const Metrics& m = context.metrics;
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  const ImVec2 at(pane.min.x + float(pixel->x()) / scale.x, pane.min.y + float(pixel->y()) / scale.y);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircle(at, m.px(9), IM_COL32(0, 0, 0, 200), 0, m.px(4));
  list.AddCircle(at, m.px(9), palette().hot, 0, m.px(2));
  // The value stands at the left where the view ends before it.
  const std::string value = short_text(shown, errors.largest, context.editor.document().unit);
  const float width = ImGui::CalcTextSize(value.c_str()).x, beside = m.px(15);
  const bool right = at.x + beside + width + m.px(5) <= pane.max.x;
  plate(list, m, {right ? at.x + beside : at.x - beside - width, at.y - ImGui::GetTextLineHeight() / 2},
        value);
  context.marks.rect("meshing.largest", {at.x - 2, at.y - 2}, {at.x + 2, at.y + 2});
}

}  // namespace

void draw_mesh_overlay(const PanelContext& context, const Camera& camera, PixelSize size,
                       const PanelRect& pane, std::size_t view) {
  const Editor& editor = context.editor;
  const Meshing& meshing = editor.meshing;
  const auto object = meshed_object(editor.document(), editor.selection.active);
  const MeshingResult* result = object ? meshing.shown_for(object) : nullptr;
  if (!result) return;
  const Projector projector(camera, size);
  const bool compared = meshing.comparing() && result->compared;
  const ComparedPicture picture = compared_picture(place_of(editor, view) % ViewLayout::count);
  const MeshShown shown = compared ? picture.shown : meshing.shown;
  if (shown == MeshShown::facets) return;
  const MeshPreview& mesh = compared ? (*result->compared)[picture.mesh] : result->mesh;
  const MeshErrors& errors = mesh.of(shown);
  marker(context, projector, pane, shown, errors, object->transform, mesh.mesh->origin());
  if (!compared) return;
  const Language& tr = context.tr;
  const char* made = picture.mesh == 0 ? tr("made by distance") : tr("made by normal angle");
  const char* what = shown == MeshShown::distance ? tr("distance") : tr("normal angle");
  const std::string first = fill(tr("{0}: {1} triangles"), {made, std::to_string(mesh.facets)});
  const std::string second =
      fill(tr("{0}: mean {1}"), {what, short_text(shown, errors.mean, editor.document().unit)});
  const Metrics& m = context.metrics;
  const float line = ImGui::GetTextLineHeight() + m.px(4);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float left = pane.min.x + m.px(12);
  plate(list, m, {left, pane.max.y - m.px(10) - 2 * line}, first);
  plate(list, m, {left, pane.max.y - m.px(8) - line}, second);
  context.marks.rect("meshing.picture." + std::to_string(view), pane.min, pane.max);
}

}  // namespace hariko
