// Commands that measure.

#include <imgui.h>

#include <algorithm>

#include "core/document/edits/edit_dimensions.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/measure/dimension_drawing.hpp"
#include "ui/measure/measure_snap.hpp"
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
  return std::ranges::any_of(editor.document().objects, [](const auto& object) {
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
  host.editor.view.dimensions = true;  // measured things are to be seen
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
  MenuRows rows(host.table, menu);
  rows.add_edit("measure.distance", "Measure distance",
                "Click two points: their distance stays in the view and follows what it measures.",
                [&host] { begin_measuring(host, DimensionKind::distance); }, model,
                {.keys = "D", .icon = icon::measure, .needs_window = true});
  rows.add_edit("measure.angle", "Measure angle",
                "Click a point, the corner and another point: the angle stays in the view.",
                [&host] { begin_measuring(host, DimensionKind::angle); }, model,
                {.keys = "Alt+D", .needs_window = true});
  rows.add_edit("measure.radius", "Measure radius",
                "Click a point of a surface: both radii of its curvature there stay in the view.",
                [&host] { begin_measuring(host, DimensionKind::radius); },
                only_if(
                    model, [&editor] { return shows_a_surface(editor); },
                    translatable("No visible object has a smooth surface to measure.")),
                {.keys = "Ctrl+Alt+D", .needs_window = true});
}

}  // namespace

void add_measure_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const std::string menu = submenu("Analyse", translatable("Measure"));
  add_measuring(host, menu);
  MenuRows(host.table, "View")
      .add_switch("measure.show", "Show dimensions", "Show or hide all dimensions in the views.",
                  editor.view.dimensions, {.while_tool_runs = true});
  MenuRows rows(host.table, menu);
  rows.add("measure.copy", "Copy value", "Copy the value of the chosen dimension with all its digits.",
           [&editor] { copy_value(editor); },
           only_if(
               needs_dimensions(editor),
               [&editor] {
                 const ShownDimension* shown = chosen_dimension(editor);
                 return shown && shown->measured;
               },
               translatable("No dimension is chosen. Click the value of one.")),
           {.needs_window = true});
  rows.add_edit(
      "measure.delete_all", "Delete all dimensions",
      "Take all distances, angles and radii out of the document.", [&editor] { delete_dimensions(editor); },
      needs_dimensions(editor));
}

}  // namespace hariko
