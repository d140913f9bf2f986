// Commands of section curves: several planes through all visible surfaces, with combs.

#include <algorithm>
#include <cmath>
#include <string>

#include "core/document/object_shape.hpp"
#include "ui/analysis/section_curve_edits.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/widgets/command_services.hpp"

namespace hariko {

namespace {

/// Whether a plane of the set meets a box.
bool meets_box(const SectionPlanes& planes, const Box3& box) {
  const double half = 0.5 * planes.direction.cwiseAbs().dot(box.sizes()),
               middle = planes.direction.dot(box.center());
  for (int k = 0; k < planes.count; ++k)
    if (std::abs(planes.offset(k) - middle) <= half) return true;
  return false;
}

WhyNot needs_something_to_cut(const Editor& editor) {
  return only_if(
      needs_document(editor),
      [&editor] {
        return std::ranges::any_of(editor.document().objects, [](const auto& object) {
          return object->visible && object->display.surface && has_shape(*object);
        });
      },
      translatable("No visible object shows a surface or facets to cut."));
}

WhyNot needs_section_curves(const Editor& editor) {
  return only_if(
      needs_something_to_cut(editor), [&editor] { return editor.sections.shown; },
      translatable("The section curves are not shown. Choose Section curves first."));
}

void scale_section_combs(Editor& editor, double factor) {
  double& scale = editor.sections.combs.scale;
  scale = std::clamp(scale * factor, SectionCombs::least_scale, SectionCombs::most_scale);
}

void add_section_combs(CommandHost& host, const std::string& menu) {
  Editor& editor = host.editor;
  MenuRows(host.table, menu)
      .add_switch("analyse.section_combs", "Combs on section curves",
                  "Show teeth as long as the section curves are curved, all of one scale.",
                  editor.sections.combs.shown,
                  {.separator_before = true, .why_not = needs_section_curves(editor)});
  const WhyNot combs = only_if(
      needs_section_curves(editor), [&editor] { return editor.sections.combs.shown; },
      translatable("The combs on section curves are not shown."));
  const auto add = [&](const char* id, const char* label, const char* help, double factor) {
    MenuRows(host.table, menu)
        .add(
            id, label, help, [&editor, factor] { scale_section_combs(editor, factor); }, combs);
  };
  add("analyse.section_longer", "Longer section teeth", "Double the length of the teeth on section curves.",
      2);
  add("analyse.section_shorter", "Shorter section teeth", "Halve the length of the teeth on section curves.",
      0.5);
}

}  // namespace

void spread_sections(Editor& editor) {
  editor.sections.planes = spread_over_visible(editor, editor.sections.planes);
  editor.sections.placed = true;
}

void show_section_curves(Editor& editor, bool shown) {
  editor.sections.shown = shown;
  const Box3 box = box_to_cut(editor);
  if (!shown || box.isEmpty()) return;
  if (!editor.sections.placed || !meets_box(editor.sections.planes, box)) spread_sections(editor);
}

void turn_section_planes(Editor& editor, const Vector3& direction) {
  editor.sections.planes.direction = direction.normalized();
  spread_sections(editor);
}

void add_section_curve_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const std::string menu = submenu("Analyse", translatable("Section curves"));
  MenuRows rows(host.table, menu);
  rows.add("analyse.section_curves", "Section curves",
           "Show the curves in which several planes cut all visible surfaces, with curvature combs.",
           [&editor] { show_section_curves(editor, !editor.sections.shown); }, needs_something_to_cut(editor),
           {.checked = [&editor] { return editor.sections.shown; }});
  rows.add(
      "analyse.section_spread", "Spread section planes",
      "Spread the section planes evenly over what is visible.", [&editor] { spread_sections(editor); },
      needs_section_curves(editor));
  add_section_combs(host, menu);
  rows.add("analyse.section_export", "Export section curves\u2026",
           "Write the section curves at full size as SVG or DXF.",
           [&services = host.services] { services.export_sections(); }, needs_section_curves(editor),
           {.separator_before = true, .needs_window = true});
  use_sections_in_scripts(host);
}

}  // namespace hariko
