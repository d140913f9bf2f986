// Commands of the Transform menu: move, rotate, scale, and how they do it.

#include <algorithm>

#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/view/command_scripts.hpp"
#include "ui/view/transform_tool.hpp"
#include "ui/view/viewport.hpp"

namespace hariko {

namespace {

Reason nothing_to_transform(const Editor& editor) {
  if (auto reason = needs_document(editor)()) return reason;
  const auto changes = [&](ObjectId id) {
    const Object* object = editor.document().find(id);
    return object && object->visible && !object->locked;
  };
  const char* fixed = translatable("What is selected is hidden or locked.");
  if (editor.mode == ElementMode::object) {
    const auto objects = selected_objects(editor);
    if (std::ranges::any_of(objects, changes)) return {};
    return objects.empty() ? translatable("No object is selected. Click one.") : fixed;
  }
  for (const auto& entry : editor.selection.elements())
    if (changes(entry.first)) return {};
  if (!editor.selection.elements().empty()) return fixed;
  return translatable("Nothing is selected. Click a vertex, an edge or a face.");
}

void add_tools(CommandHost& host) {
  Editor& editor = host.editor;
  Viewport& viewport = host.viewport;
  const auto tool = [&](const char* id, const char* label, const char* help, const char* keys,
                        const char* symbol, TransformKind kind) {
    MenuRows(host.table, "Transform")
        .add_edit(
            id, label, help, [&viewport, kind] { viewport.start_modal(make_transform_tool(kind)); },
            [&editor] { return nothing_to_transform(editor); },
            {.keys = keys,
             .icon = symbol,
             .needs_window = true,
             .script = transform_in_scripts(editor, kind)});
  };
  tool("transform.move", "Move", "Move the selection with the pointer or by typed lengths.", "G", icon::pan,
       TransformKind::move);
  tool("transform.rotate", "Rotate", "Turn the selection about the pivot.", "R", icon::orbit,
       TransformKind::rotate);
  tool("transform.scale", "Scale", "Make the selection larger or smaller about the pivot.", "S", icon::scale,
       TransformKind::scale);
}

void add_switches(CommandHost& host) {
  Editor& editor = host.editor;
  TransformSettings& settings = editor.transform;
  MenuRows rows(host.table, "Transform");
  rows.add_switch("transform.gizmo", "Gizmo", "Show handles at the selection that move, turn and scale it.",
                  settings.gizmo, {.keys = "Shift+W", .separator_before = true});
  rows.add_switch("transform.local", "Local axes",
                  "The handles follow the axes of the object instead of those of the document.",
                  settings.local_axes, {.keys = "Alt+L"});
  rows.add_switch(
      "transform.local_edit", "Local editing",
      "Vertices change the faces round them only: tangents there are fixed, and turning or scaling changes "
      "the tangent plane.",
      settings.local_edit, {.keys = "Shift+O"});
  rows.add_switch("transform.soft", "Soft selection",
                  "Vertices near the selection follow in part. The wheel changes the radius while dragging.",
                  settings.soft.on, {.keys = "O", .separator_before = true});
  const auto falloff = [&](const char* id, const char* label, Falloff value) {
    rows.add(id, label, "How the influence of the soft selection fades with the distance.",
             [&settings, value] { settings.soft.falloff = value; }, {},
             {.checked = [&settings, value] { return settings.soft.falloff == value; }});
  };
  falloff("transform.falloff_smooth", "Smooth falloff", Falloff::smooth);
  falloff("transform.falloff_linear", "Linear falloff", Falloff::linear);
  falloff("transform.falloff_sharp", "Sharp falloff", Falloff::sharp);
}

void add_pivots(CommandHost& host) {
  TransformSettings& settings = host.editor.transform;
  MenuRows rows(host.table, "Transform");
  rows.next_group();
  const auto pivot = [&](const char* id, const char* label, const char* help, PivotMode value) {
    rows.add(id, label, help, [&settings, value] { settings.pivot = value; }, {},
             {.checked = [&settings, value] { return settings.pivot == value; }});
  };
  pivot("transform.pivot_median", "Pivot: median", "Turn and scale about the mean of the selected points.",
        PivotMode::median);
  pivot("transform.pivot_box", "Pivot: box centre", "Turn and scale about the centre of the selection's box.",
        PivotMode::box_centre);
  pivot("transform.pivot_individual", "Pivot: individual",
        "Each connected part of the selection has its own pivot.", PivotMode::individual);
  pivot("transform.pivot_active", "Pivot: active", "Turn and scale about the element that was selected last.",
        PivotMode::active);
}

}  // namespace

void add_transform_commands(CommandHost& host) {
  add_tools(host);
  add_switches(host);
  add_pivots(host);
}

}  // namespace hariko
