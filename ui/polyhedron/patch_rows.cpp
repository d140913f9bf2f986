#include "ui/polyhedron/patch_rows.hpp"

#include <algorithm>

#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

/// "5 × 2", or "1 … 5" where patches differ.
std::string degree_text(const std::vector<BezierPatch>& patches) {
  const auto degrees = [](const BezierPatch& patch) { return std::pair(patch.degree_s, patch.degree_t); };
  const bool equal = std::all_of(patches.begin(), patches.end(), [&](const BezierPatch& patch) {
    return degrees(patch) == degrees(patches[0]);
  });
  if (equal) return std::to_string(patches[0].degree_s) + " \u00d7 " + std::to_string(patches[0].degree_t);
  int least = max_bezier_degree, most = 1;
  for (const BezierPatch& patch : patches) {
    least = std::min({least, patch.degree_s, patch.degree_t});
    most = std::max({most, patch.degree_s, patch.degree_t});
  }
  return std::to_string(least) + " \u2026 " + std::to_string(most);
}

void text_row(PanelContext& context, const char* mark, const char* label, const char* help,
              const std::string& text) {
  row_label(context, label, help);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text.c_str());
  context.marks.item(mark);
}

}  // namespace

void patch_section(PanelContext& context, const Object& object) {
  const BezierSource* source = object.bezier();
  if (!source) return;
  const std::vector<BezierPatch>& patches = *source->patches;
  text_row(context, "patches.count", translatable("Patches"),
           translatable("One surface: sides that are equal are joined"), std::to_string(patches.size()));
  text_row(context, "patches.degree", translatable("Degree"),
           translatable("Of the polynomials along both sides"), degree_text(patches));
  const auto rational = std::count_if(patches.begin(), patches.end(),
                                      [](const BezierPatch& patch) { return patch.rational(); });
  if (rational > 0)
    text_row(context, "patches.weights", translatable("Weights"),
             translatable("Patches whose control points have weights"), std::to_string(rational));
  if (patches.size() < 2 || object.locked) return;
  row_label(context, "", "");
  if (ImGui::Button((std::string(context.tr("Separate patches")) + "###separate_patches").c_str(), {-1, 0}))
    context.run("shape.separate_patches");
  if (ImGui::IsItemHovered())
    show_tip(context.tr("Control points are edited patch by patch; welding joins them again."));
  context.marks.item("button.separate_patches");
}

}  // namespace hariko
