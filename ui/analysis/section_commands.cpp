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

Box3 box_to_cut(const Editor& editor) {
  Box3 box;
  for (const auto& object : editor.document().objects)
    if (object->visible && has_shape(*object)) box.extend(world_box(*object));
  return box;
}

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
        const auto& objects = editor.document().objects;
        return std::any_of(objects.begin(), objects.end(), [](const auto& object) {
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
  host.table.add(switching({.id = "analyse.section_combs",
                            .menu = menu,
                            .label = "Combs on section curves",
                            .help = "Show teeth as long as the section curves are curved, all of one scale.",
                            .separator_before = true,
                            .why_not = needs_section_curves(editor)},
                           editor.sections.combs.shown));
  const WhyNot combs = only_if(
      needs_section_curves(editor), [&editor] { return editor.sections.combs.shown; },
      translatable("The combs on section curves are not shown."));
  const auto add = [&](const char* id, const char* label, const char* help, double factor) {
    host.table.add({.id = id,
                    .menu = menu,
                    .label = label,
                    .help = help,
                    .run = [&editor, factor] { scale_section_combs(editor, factor); },
                    .why_not = combs});
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
  host.table.add(
      {.id = "analyse.section_curves",
       .menu = menu,
       .label = "Section curves",
       .help = "Show the curves in which several planes cut all visible surfaces, with curvature combs.",
       .run = [&editor] { show_section_curves(editor, !editor.sections.shown); },
       .why_not = needs_something_to_cut(editor),
       .checked = [&editor] { return editor.sections.shown; }});
  host.table.add({.id = "analyse.section_spread",
                  .menu = menu,
                  .label = "Spread section planes",
                  .help = "Spread the section planes evenly over what is visible.",
                  .run = [&editor] { spread_sections(editor); },
                  .why_not = needs_section_curves(editor)});
  add_section_combs(host, menu);
  host.table.add({.id = "analyse.section_export",
                  .menu = menu,
                  .label = "Export section curves\u2026",
                  .help = "Write the section curves at full size as SVG or DXF.",
                  .separator_before = true,
                  .needs_window = true,
                  .run = [&services = host.services] { services.export_sections(); },
                  .why_not = needs_section_curves(editor)});
  use_sections_in_scripts(host);
}

}  // namespace hariko
