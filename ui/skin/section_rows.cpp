#include "ui/skin/skin_properties.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/skinning/sections/section_deviation.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

/// Measuring takes up to some milliseconds, and frames are drawn more often than surfaces are made.
struct MeasuredSections {
  Surface surface;
  std::vector<SectionMiss> misses;
};

namespace {

// Fractions of the size of the sections.
constexpr double good_distance = 1e-4, bad_distance = 1e-2;
/// Distances at which bars begin, and below which all is rounding.
constexpr double least_distance = 1e-6, no_distance = 1e-9;

const std::vector<SectionMiss>& measured(PanelContext& context, const Surface& surface,
                                         const SubdivisionPatchSet& patches) {
  auto& known = context.state.measured_sections;
  if (!known || &known->surface.patches() != &surface.patches())
    known = std::make_shared<const MeasuredSections>(
        MeasuredSections{surface, section_deviations(*patches.skin(), patches)});
  return known->misses;
}

/// 0 at one fraction .. 1 at another.
float between(double low, double high, double fraction) {
  if (!(fraction > low)) return 0;
  return float(std::min(1.0, std::log(fraction / low) / std::log(high / low)));
}

/// From good over warning to error.
ImU32 colour_of(float badness) {
  const ImVec4 good = ImGui::ColorConvertU32ToFloat4(palette().good),
               middle = ImGui::ColorConvertU32ToFloat4(palette().warning),
               bad = ImGui::ColorConvertU32ToFloat4(palette().error);
  return ImGui::ColorConvertFloat4ToU32(badness < 0.5F ? ImLerp(good, middle, 2 * badness)
                                                       : ImLerp(middle, bad, 2 * badness - 1));
}

double size_of_sections(const Skin& skin) {
  Box3 box;
  for (const SkinSection& section : skin.sections)
    for (const SectionPoint& p : section.points) box.extend(p.position);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

std::string distance_text(const PanelContext& context, double distance) {
  return format_number(distance, 2) + " " + std::string(to_string(context.editor.document().unit));
}

/// The value of a row with a bar; `fraction` of the size of the sections, 0 for none.
void draw_value(const PanelContext& context, const std::string& text, double fraction) {
  const ImU32 colour = colour_of(between(good_distance, bad_distance, fraction));
  coloured_text(colour, text.c_str());
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float begin = low.x + context.metrics.px(96), middle = 0.5F * (low.y + high.y),
              half = context.metrics.px(2.5F);
  const float end = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  if (fraction <= 0 || end <= begin || high.x > begin) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({begin, middle - half}, {end, middle + half}, palette().field, half);
  const float width = (end - begin) * std::max(between(least_distance, bad_distance, fraction), 0.06F);
  list.AddRectFilled({begin, middle - half}, {begin + width, middle + half}, colour, half);
}

void draw_row(PanelContext& context, const std::string& name, const std::string& value, double fraction,
              const std::string& help, const std::string& mark) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 end{corner.x + ImGui::GetContentRegionAvail().x, corner.y + ImGui::GetFrameHeight()};
  row_label(context, name.c_str(), "");
  draw_value(context, value, fraction);
  context.marks.rect(mark, corner, end);
  if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(corner, end)) show_tip(help.c_str());
}

}  // namespace

void draw_section_rows(PanelContext& context, const Object& object) {
  const Surface* surface = shown_surface(context.editor, object);
  const SubdivisionPatchSet* patches = surface ? subdivision_patches(*surface) : nullptr;
  if (!patches || !patches->skin()) return;
  const Language& tr = context.tr;
  const Skin& skin = patches->skin()->skin;
  const double size = size_of_sections(skin), scale = object.transform.scale;
  const std::vector<SectionMiss>& misses = measured(context, *surface, *patches);
  const auto exact = [&](const SectionMiss& miss) { return !(miss.largest > no_distance * size); };
  heading(context, "Distance to sections");
  // They are read, not pressed, and may be many.
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, 0});
  constexpr std::size_t most_rows = 10;
  if (std::ranges::all_of(misses, exact)) {
    draw_row(context, tr("All sections"), tr("exact"), 0, tr("The surface goes through all sections."),
             "skin.miss.all");
  } else {
    const bool many = misses.size() > most_rows;
    if (many)
      ImGui::BeginChild("skin_misses", {0, (float(most_rows) + 0.5F) * ImGui::GetFrameHeightWithSpacing()},
                        false, ImGuiWindowFlags_NavFlattened);
    for (std::size_t k = 0; k < misses.size(); ++k) {
      const std::string number = std::to_string(k + 1), name = fill(tr("Section {0}"), {number}),
                        mark = "skin.miss." + std::to_string(k);
      const SectionMiss& miss = misses[k];
      if (exact(miss)) {
        draw_row(context, name, tr("exact"), 0, fill(tr("The surface goes through section {0}."), {number}),
                 mark);
        continue;
      }
      const std::string largest = distance_text(context, miss.largest * scale);
      draw_row(context, name, largest, size > 0 ? miss.largest / size : 0,
               fill(tr("Section {0}: the surface is up to {1} away, {2} in the root mean square."),
                    {number, largest, distance_text(context, miss.root_mean_square * scale)}),
               mark);
    }
    if (many) ImGui::EndChild();
  }
  ImGui::PopStyleVar();
}

}  // namespace hariko
