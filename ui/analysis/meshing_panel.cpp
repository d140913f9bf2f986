// Triangles under tolerances, in a column beside the viewport: what is asked for, what came out, and where it
// is off.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "ui/base/icons.hpp"
#include "ui/base/quantity.hpp"
#include "ui/view/legend.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

constexpr float track_column = 136, number_width = 84, histogram_height = 48;

struct Row {
  const char *id, *label, *help;
  double low, high;  ///< lengths: times the object's size
  bool length = false;
  const char* format = "%.3g\u00b0";
};
constexpr std::array<Row, mesh_criterion_count> rows{{
    {"distance", translatable("Distance"),
     translatable("The farthest that the surface may be from its triangles"), 1e-5, 0.1, true},
    {"normal", translatable("Normal angle"),
     translatable("The largest angle between the normals of the surface and of its triangles"), 0.5, 60},
    {"fold", translatable("Fold angle"),
     translatable("The largest angle between neighbouring triangles, creases apart"), 0.5, 60},
    {"luminance", translatable("Brightness"),
     translatable("The largest difference of brightness; it does not bound the shape, so combine it"), 0.005,
     0.5, false, "%.3g"},
    {"edge", translatable("Longest edge"), translatable("No edge is longer"), 1e-3, 1, true},
    {"angle", translatable("Smallest angle"),
     translatable("Triangles that are too sharp are cut where that helps"), 1, 35},
}};

constexpr std::array shown_names{translatable("Triangles"), translatable("Distance"), translatable("Angle"),
                                 translatable("Folds")};

constexpr std::array place_names{translatable("Over the surface"), translatable("Alone")};

/// Lengths start in proportion to the object.
void adapt(Meshing& meshing, const Object& object) {
  const Box3 box = box_at_own_place(object);
  const double size = box.isEmpty() ? 1 : box.diagonal().norm();
  if (meshing.size > 0 && size < 8 * meshing.size && meshing.size < 8 * size) return;
  meshing.size = size;
  const double unit = std::pow(10.0, std::floor(std::log10(size * 2e-3)));
  meshing.settings.of(MeshCriterion::distance).value = std::floor(size * 2e-3 / unit) * unit;
  meshing.settings.of(MeshCriterion::edge).value = std::floor(size * 0.1 / unit) * unit;
}

void criterion_row(PanelContext& context, Meshing& meshing, std::size_t index) {
  const Row& row = rows[index];
  MeshingSettings::Tolerance& own = meshing.settings.tolerances[index];
  ImGui::PushID(row.id);
  const std::string mark = std::string("meshing.") + row.id;
  option_check(context, (mark + ".on").c_str(), row.label, row.help, own.on);
  point_out(context, mark.c_str());
  ImGui::SameLine(context.metrics.px(track_column));
  const double factor = row.length ? meshing.size : 1;
  const double low = row.low * factor, high = row.high * factor;
  const std::string format =
      row.length ? "%.3g " + std::string(to_string(context.editor.document().unit)) : std::string(row.format);
  {
    const Disabled disabled(!own.on);
    number_slider(context.marks, mark,
                  {low, high, format.c_str(), ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoRoundToFormat,
                   context.metrics.px(number_width)},
                  own.value);
  }
  if (!std::isfinite(own.value)) own.value = low;
  ImGui::PopID();
}

void way_rows(PanelContext& context, MeshingSettings& settings) {
  {
    const Disabled disabled(settings.optimise || settings.balanced);
    if (const auto chosen = choose(context, "meshing.start", "Start",
                                   "What is cut: for patches with four sides", std::optional(settings.start)))
      settings.start = *chosen;
    if (const auto chosen = choose(context, "meshing.split", "Cut", "Which edge is cut, and where",
                                   std::optional(settings.split)))
      settings.split = *chosen;
  }
  option_check(context, "meshing.optimise", "Fewest",
               "Looks for the smallest mesh within the tolerance. Takes many times longer.",
               settings.optimise);
  point_out(context, "meshing.optimise");
  ImGui::SameLine(context.metrics.px(track_column));
  option_check(context, "meshing.balanced", "Balanced",
               "Vertices may leave the surface where it is bent one way only: fewer still",
               settings.balanced);
  point_out(context, "meshing.balanced");
}

/// Line of a table with what is known of one kind of error.
void error_line(PanelContext& context, MeshShown shown, const MeshErrors& errors) {
  const Language& tr = context.tr;
  const Unit unit = context.editor.document().unit;
  next_cell();
  dim_text(tr(shown_names[std::size_t(shown)]));
  next_cell();
  plain_text(short_text(shown, errors.largest, unit));
  if (errors.bound && ImGui::IsItemHovered())
    show_tip(fill(tr("No point is off by more than {0}: this is proven, not sampled."),
                  {short_text(shown, *errors.bound, unit)}));
  next_cell();
  plain_text(short_text(shown, errors.mean, unit));
  next_cell();
  coloured_text(errors.bound ? palette().good : palette().dim_text,
                errors.bound ? tr("proven") : tr("sampled"));
}

Quantity quantity_of(const PanelContext& context, MeshShown shown, double size) {
  return shown == MeshShown::distance ? length_quantity(context.editor.document().unit, size)
                                      : angle_quantity();
}

void result_table(PanelContext& context, const MeshingResult& result) {
  const Language& tr = context.tr;
  const OpenScope table = table_scope("errors", 4);
  if (!table) return;
  for (const char* head : {"", translatable("largest"), translatable("mean"), ""}) {
    next_cell();
    if (*head) dim_text(tr(head));
  }
  for (const MeshShown shown : {MeshShown::distance, MeshShown::normal, MeshShown::fold}) {
    error_line(context, shown, result.mesh.of(shown));
  }
}

/// Bars in the colours of the map, which makes them its legend.
void histogram(PanelContext& context, MeshShown shown, const MeshErrors& errors) {
  const Metrics& m = context.metrics;
  const ColorScale scale =
      scale_for(SurfaceMap::gaussian, errors.range, context.editor.settings.colour_blind_maps);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = m.px(histogram_height), bar = m.px(8);
  ImGui::Dummy({width, height + bar});
  context.marks.item("meshing.histogram");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto count = static_cast<float>(errors.histogram.size());
  for (std::size_t i = 0; i < errors.histogram.size(); ++i) {
    const float left = low.x + width * float(i) / count, right = low.x + width * float(i + 1) / count;
    const double value = errors.range.high * (double(i) + 0.5) / double(count);
    const ImU32 colour = to_imgui(color_at(scale, scale_fraction(scale, errors.range, value)));
    list.AddRectFilled({left, low.y + height + m.px(2)}, {right, low.y + height + bar}, colour);
    // Few are worth seeing too.
    const float share = errors.histogram[i] > 0 ? std::max(errors.histogram[i], 0.03F) : 0;
    list.AddRectFilled({left, low.y + height * (1 - share)}, {right - m.px(1), low.y + height},
                       with_alpha(palette().text, 0.45F));
  }
  const Quantity quantity = quantity_of(context, shown, errors.range.high);
  dim_text("0");
  const std::string end = format_quantity(quantity, errors.range.high);
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(end.c_str()).x);
  dim_text(end);
  if (errors.limited && errors.beyond > 0)
    coloured_lines(palette().warning, fill(context.tr("grey: above the tolerance, {0} triangles"),
                                           {std::to_string(errors.beyond)}));
}

/// Buttons side by side, of which one is down; the one that was pressed. Marks: "<mark>.<number>".
std::optional<std::size_t> button_row(PanelContext& context, const std::string& mark,
                                      std::span<const char* const> names,
                                      std::optional<std::size_t> current) {
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const auto count = static_cast<float>(names.size());
  const float width = (ImGui::GetContentRegionAvail().x - (count - 1) * gap) / count;
  std::optional<std::size_t> pressed;
  // The words need the room beside them.
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    const bool on = current == i;
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, palette().field_active);
    if (text_button(context.marks, mark + "." + std::to_string(i), context.tr(names[i]), width)) pressed = i;
    if (on) ImGui::PopStyleColor();
  }
  ImGui::PopStyleVar();
  return pressed;
}

void shown_rows(PanelContext& context, Meshing& meshing) {
  const bool comparing = meshing.comparing();
  const auto pressed = button_row(context, "meshing.show", shown_names,
                                  comparing ? std::nullopt : std::optional(std::size_t(meshing.shown)));
  if (pressed) {
    meshing.shown = static_cast<MeshShown>(*pressed);
    if (comparing) context.run("analyse.mesh_compare");
  }
  if (comparing || meshing.shown != MeshShown::facets) return;
  if (const auto place = button_row(context, "meshing.place", place_names, meshing.alone ? 1U : 0U))
    meshing.alone = *place == 1;
}

void progress_row(PanelContext& context, Meshing& meshing) {
  if (!meshing.job) {
    if (meshing.stopped) {
      hint_text(context, "Stopped. Change something to go on.");
      context.marks.item("meshing.stopped");
    } else {
      ImGui::Dummy({0, ImGui::GetFrameHeight()});
    }
    return;
  }
  const float button = context.metrics.px(72);
  const float bar = ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x;
  if (!job_bar(context.marks, "meshing.stop", *meshing.job, bar, context.tr("Stop"), button)) return;
  meshing.job->cancel.cancel();
  meshing.stopped = true;
}

void results(PanelContext& context, Meshing& meshing, const std::shared_ptr<const Object>& object) {
  const Language& tr = context.tr;
  const MeshingResult* result =
      meshing.result && meshing.result->object->id == object->id ? meshing.result.get() : nullptr;
  if (!result) return hint_text(context, "Making triangles\u2026");
  if (result->error) return coloured_lines(palette().error, tr.text_of(*result->error));
  const bool present = result->settings == meshing.settings && result->object == object;
  coloured_text(present ? palette().text : palette().dim_text,
                fill(tr("{0} triangles, {1} vertices"),
                     {std::to_string(result->mesh.facets), std::to_string(result->mesh.vertices)})
                    .c_str());
  context.marks.item("meshing.count." + std::to_string(result->mesh.facets));
  result_table(context, *result);
  for (const Message& warning : result->mesh.warnings) coloured_lines(palette().warning, tr.text_of(warning));
}

}  // namespace

void draw_meshing(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  Editor& editor = context.editor;
  Meshing& meshing = editor.meshing;
  const Language& tr = context.tr;
  if (begin_panel("Meshing", rect, palette().panel, {m.px(14), m.px(12)})) {
    heading(context, "Triangles");
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - m.px(24));
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - m.px(4));  // its middle is that of the heading
    if (icon_button(context, icon::close, "meshing.close", "Close", false, 24)) context.run("analyse.mesh");
    const auto object = meshed_object(editor.document(), editor.selection.active);
    if (!object) {
      hint_text(context, "There is no visible surface to mesh.");
      ImGui::End();
      return;
    }
    adapt(meshing, *object);
    dim_text(object->name);
    ImGui::Dummy({0, m.px(4)});
    const MeshingSettings before = meshing.settings;
    for (std::size_t i = 0; i < rows.size(); ++i) criterion_row(context, meshing, i);
    ImGui::Dummy({0, m.px(4)});
    way_rows(context, meshing.settings);
    if (!(meshing.settings == before)) meshing.stopped = false;
    ImGui::Dummy({0, m.px(4)});
    progress_row(context, meshing);
    heading(context, "Result");
    results(context, meshing, object);
    ImGui::Dummy({0, m.px(6)});
    heading(context, "Show");
    shown_rows(context, meshing);
    const MeshingResult* shown = meshing.shown_for(object);
    if (shown && meshing.shown != MeshShown::facets && !meshing.comparing())
      histogram(context, meshing.shown, shown->mesh.of(meshing.shown));
    ImGui::Dummy({0, m.px(2)});
    const bool comparing = meshing.comparing();
    if (text_button(context.marks, "meshing.compare",
                    comparing ? tr("Back to one picture") : tr("Compare four pictures"), -1))
      context.run("analyse.mesh_compare");
    if (ImGui::IsItemHovered())
      show_tip(tr("Meshes made by distance and by normal angle, each with both of its errors, side by side"));
    if (text_button(context.marks, "meshing.export", tr("Export\u2026"), -1)) context.run("file.export");
  }
  ImGui::End();
}

}  // namespace hariko
