// Commands that change how the model is seen.

#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/view/viewport.hpp"

namespace hariko {

namespace {

/// Views may change while a tool runs.
MenuRows rows_of_views(CommandHost& host) {
  return {host.table, "View", true};
}

void keep_direction(Editor& editor) {
  View& view = editor.layout.active_view();
  view.turns = !view.turns;
}

/// The key of an arrangement that is on leaves it.
void arrange_views(Editor& editor, Arrangement arrangement) {
  ViewLayout& layout = editor.layout;
  layout.arrange(layout.arrangement() == arrangement ? Arrangement::one : arrangement);
}

void show_frame_times(Editor& editor) {
  editor.frame_times.clear();
  editor.frame_times.visible = !editor.frame_times.visible;
}

void show_surfaces_only(Editor& editor) {
  editor.view.surfaces_only = !editor.view.surfaces_only;
  editor.hovered.reset();
}

void add_framing_commands(CommandHost& host) {
  Editor& editor = host.editor;
  MenuRows rows = rows_of_views(host);
  const WhyNot document = needs_document(editor);
  rows.add("view.frame_all", "Frame all", "Show everything.", [&editor] { editor.frame_all(); }, document,
           {.keys = "Home", .icon = icon::frame});
  rows.add("view.frame_all_views", "Frame all in every view", "Show everything in every view.",
           [&editor] { editor.wants_framing = true; }, document, {.keys = "Shift+Home"});
  rows.add("view.frame_selection", "Frame selection", "Come close to what is selected.",
           [&editor] { editor.frame_selection(); }, document, {.keys = "F"});
  rows.add(
      "view.previous", "Previous view", "Back to where the camera was.",
      [&editor] { editor.layout.active_view().go_back(editor.now); },
      only_if(
          document, [&editor] { return editor.layout.active_view().can_go_back(); },
          translatable("The camera has not moved yet.")));
  rows.add(
      "view.next", "Next view", "Forward again to where the camera was.",
      [&editor] { editor.layout.active_view().go_forward(editor.now); },
      only_if(
          document, [&editor] { return editor.layout.active_view().can_go_forward(); },
          translatable("Nothing to go forward to: Previous view comes first.")));
}

void add_side_commands(CommandHost& host) {
  Editor& editor = host.editor;
  MenuRows rows = rows_of_views(host);
  const WhyNot document = needs_document(editor);
  const auto side = [&](const char* id, const char* label, const char* keys, StandardView view, bool first) {
    rows.add(id, label, "Look from this side.",
             [&editor, view] { editor.layout.active_view().look_from(view, editor.now); }, document,
             {.keys = keys, .separator_before = first});
  };
  side("view.front", "Front", "Num 1", StandardView::front, true);
  side("view.back", "Back", "Ctrl+Num 1", StandardView::back, false);
  side("view.right", "Right", "Num 3", StandardView::right, false);
  side("view.left", "Left", "Ctrl+Num 3", StandardView::left, false);
  side("view.top", "Top", "Num 7", StandardView::top, false);
  side("view.bottom", "Bottom", "Ctrl+Num 7", StandardView::bottom, false);
  side("view.iso", "Three-quarter", "Num 0", StandardView::iso, false);
  rows.add("view.orthographic", "Orthographic", "Parallel instead of perspective projection.",
           [&editor] { editor.layout.active_view().toggle_orthographic(); }, document,
           {.keys = "Num 5", .separator_before = true, .checked = [&editor] {
              return editor.camera().orthographic;
            }});
  rows.add("view.lock", "Keep direction", "This view pans and zooms but does not turn.",
           [&editor] { keep_direction(editor); }, document,
           {.checked = [&editor] { return !editor.layout.active_view().turns; }});
}

void add_arrangement_commands(CommandHost& host) {
  Editor& editor = host.editor;
  MenuRows rows = rows_of_views(host);
  const WhyNot document = needs_document(editor);
  const auto arrange = [&](const char* id, const char* label, const char* help, const char* keys,
                           Arrangement arrangement, bool first) {
    rows.add(id, label, help, [&editor, arrangement] { arrange_views(editor, arrangement); }, document,
             {.keys = keys, .separator_before = first, .checked = [&editor, arrangement] {
                return editor.layout.arrangement() == arrangement;
              }});
  };
  arrange("view.four", "Four views", "Top, front and right beside the free view.", "Ctrl+Alt+Q",
          Arrangement::four, true);
  arrange("view.two", "Two views", "A plan beside the free view.", "Ctrl+Alt+W", Arrangement::two, false);
  rows.add("view.maximise", "Maximise view", "The view under the pointer alone, or all again.",
           [&editor] { editor.layout.toggle_maximised(); }, document,
           {.keys = "Ctrl+Space",
            .checked = [&editor] { return editor.layout.arrangement() == Arrangement::one; }});
}

}  // namespace

void add_view_commands(CommandHost& host) {
  add_framing_commands(host);
  add_side_commands(host);
  add_arrangement_commands(host);
  Editor& editor = host.editor;
  MenuRows rows = rows_of_views(host);
  rows.add("view.keep_probe", "Keep probe",
           "Keep the readings of the surface under the pointer on the screen; over nothing, let them go.",
           [&editor, &host] { editor.kept_probe = host.viewport.pointed_at(); }, needs_document(editor),
           {.keys = "Ctrl+Alt+P", .separator_before = true, .needs_window = true, .checked = [&editor] {
              return editor.kept_probe.has_value();
            }});
  rows.add("view.frame_times", "Frame times",
           "Show how long frames take and which part of that is our own work.",
           [&editor] { show_frame_times(editor); }, {},
           {.keys = "F12", .checked = [&editor] { return editor.frame_times.visible; }});
  rows.add_switch("view.x_ray", "X-ray", "See and pick through the surface.", editor.view.x_ray,
                  {.keys = "Alt+X", .icon = icon::shown, .separator_before = true});
  rows.add("view.surfaces_only", "Surfaces only",
           "Hide all curves, points, polyhedra and marks of the selection, for judging; again shows them.",
           [&editor] { show_surfaces_only(editor); }, needs_document(editor),
           {.keys = "V", .checked = [&editor] { return editor.view.surfaces_only; }});
  rows.add_switch("view.solids", "Solids in the surface",
                  "See the bodies of solids through the surface round them.", editor.view.bodies,
                  {.keys = "Alt+B"});
  rows.add_switch("view.grid", "Grid", "Show the ground, and behind side views a grid with numbers.",
                  editor.view.grid, {.keys = "Shift+G"});
}

}  // namespace hariko
