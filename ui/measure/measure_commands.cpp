// Commands that measure.

#include <imgui.h>

#include <algorithm>

#include "core/document/edits/edit_dimensions.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/measure/dimension_text.hpp"
#include "ui/measure/measure_tool.hpp"
#include "ui/view/viewport.hpp"

namespace hariko {

namespace {

/// Condition of measuring: a document whose objects are shown.
WhyNot needs_model(const Editor& editor) {
  return only_if(
      needs_document(editor), [&editor] { return !editor.paper.covers_model(); },
      translatable("The folded paper stands in the place of the objects. Show the objects first."));
}

bool shows_a_surface(const Editor& editor) {
  const auto& objects = editor.document().objects;
  return std::any_of(objects.begin(), objects.end(), [](const auto& object) {
    return object->visible && object->display.surface && object->has_surface();
  });
}

WhyNot needs_dimensions(const Editor& editor) {
  return only_if(
      needs_document(editor), [&editor] { return !editor.document().dimensions->empty(); },
      translatable("The document has no dimensions. Measure a distance, an angle or a radius first."));
}

const ShownDimension* chosen_dimension(const Editor& editor) {
  const auto chosen = editor.dimensions.chosen(editor);
  for (const ShownDimension& shown : editor.dimensions.all())
    if (chosen == shown.dimension.id) return &shown;
  return nullptr;
}

void begin_measuring(CommandHost& host, DimensionKind kind) {
  host.editor.view.dimensions = true;  // what is measured is to be seen
  host.viewport.start_modal(make_measure_tool(kind));
}

void copy_value(const Editor& editor) {
  const ShownDimension* shown = chosen_dimension(editor);
  if (!shown || !shown->measured) return;
  ImGui::SetClipboardText(
      exact_dimension_text(shown->dimension.kind, *shown->measured, editor.document().unit).c_str());
}

void delete_dimensions(Editor& editor) {
  std::vector<DimensionId> ids;
  for (const Dimension& dimension : *editor.history.current().dimensions) ids.push_back(dimension.id);
  editor.commit(remove_dimensions(editor.history.current(), ids), translatable("Delete all dimensions"));
}

void add_measuring(CommandHost& host, const std::string& menu) {
  Editor& editor = host.editor;
  const WhyNot model = needs_model(editor);
  host.table.add({.id = "measure.distance",
                  .menu = menu,
                  .label = "Measure distance",
                  .help = "Click two points: their distance stays in the view and follows what it measures.",
                  .keys = "D",
                  .icon = icon::measure,
                  .changes_document = true,
                  .needs_window = true,
                  .run = [&host] { begin_measuring(host, DimensionKind::distance); },
                  .why_not = model});
  host.table.add({.id = "measure.angle",
                  .menu = menu,
                  .label = "Measure angle",
                  .help = "Click a point, the corner and another point: the angle stays in the view.",
                  .keys = "Alt+D",
                  .changes_document = true,
                  .needs_window = true,
                  .run = [&host] { begin_measuring(host, DimensionKind::angle); },
                  .why_not = model});
  host.table.add({.id = "measure.radius",
                  .menu = menu,
                  .label = "Measure radius",
                  .help = "Click a point of a surface: both radii of its curvature there stay in the view.",
                  .keys = "Ctrl+Alt+D",
                  .changes_document = true,
                  .needs_window = true,
                  .run = [&host] { begin_measuring(host, DimensionKind::radius); },
                  .why_not = only_if(
                      model, [&editor] { return shows_a_surface(editor); },
                      translatable("No visible object has a smooth surface to measure."))});
}

}  // namespace

void add_measure_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const std::string menu = submenu("Analyse", translatable("Measure"));
  add_measuring(host, menu);
  host.table.add(switching({.id = "measure.show",
                            .menu = "View",
                            .label = "Show dimensions",
                            .help = "Show or hide all dimensions in the views.",
                            .while_tool_runs = true},
                           editor.view.dimensions));
  host.table.add({.id = "measure.copy",
                  .menu = menu,
                  .label = "Copy value",
                  .help = "Copy the value of the chosen dimension with all its digits.",
                  .needs_window = true,
                  .run = [&editor] { copy_value(editor); },
                  .why_not = only_if(
                      needs_dimensions(editor),
                      [&editor] {
                        const ShownDimension* shown = chosen_dimension(editor);
                        return shown && shown->measured;
                      },
                      translatable("No dimension is chosen. Click the value of one."))});
  host.table.add({.id = "measure.delete_all",
                  .menu = menu,
                  .label = "Delete all dimensions",
                  .help = "Take all distances, angles and radii out of the document.",
                  .changes_document = true,
                  .run = [&editor] { delete_dimensions(editor); },
                  .why_not = needs_dimensions(editor)});
}

}  // namespace hariko
