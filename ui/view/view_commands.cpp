// Commands that change how the model is seen.

#include <utility>

#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/view/viewport.hpp"

namespace hariko {

namespace {

/// A row of the menu. Views may change while a tool runs.
void add_view_row(CommandHost& host, Command row) {
  row.menu = "View";
  row.while_tool_runs = true;
  host.table.add(std::move(row));
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
  const WhyNot document = needs_document(editor);
  add_view_row(host, {.id = "view.frame_all",
                      .label = "Frame all",
                      .help = "Show everything.",
                      .keys = "Home",
                      .icon = icon::frame,
                      .run = [&editor] { editor.frame_all(); },
                      .why_not = document});
  add_view_row(host, {.id = "view.frame_all_views",
                      .label = "Frame all in every view",
                      .help = "Show everything in every view.",
                      .keys = "Shift+Home",
                      .run = [&editor] { editor.wants_framing = true; },
                      .why_not = document});
  add_view_row(host, {.id = "view.frame_selection",
                      .label = "Frame selection",
                      .help = "Come close to what is selected.",
                      .keys = "F",
                      .run = [&editor] { editor.frame_selection(); },
                      .why_not = document});
  add_view_row(host, {.id = "view.previous",
                      .label = "Previous view",
                      .help = "Back to where the camera was.",
                      .run = [&editor] { editor.layout.active_view().go_back(editor.now); },
                      .why_not = only_if(
                          document, [&editor] { return editor.layout.active_view().can_go_back(); },
                          translatable("The camera has not moved yet."))});
  add_view_row(host, {.id = "view.next",
                      .label = "Next view",
                      .help = "Forward again to where the camera was.",
                      .run = [&editor] { editor.layout.active_view().go_forward(editor.now); },
                      .why_not = only_if(
                          document, [&editor] { return editor.layout.active_view().can_go_forward(); },
                          translatable("Nothing to go forward to: Previous view comes first."))});
}

void add_side_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  const auto side = [&](const char* id, const char* label, const char* keys, StandardView view, bool first) {
    add_view_row(host, {.id = id,
                        .label = label,
                        .help = "Look from this side.",
                        .keys = keys,
                        .separator_before = first,
                        .run = [&editor, view] { editor.layout.active_view().look_from(view, editor.now); },
                        .why_not = document});
  };
  side("view.front", "Front", "Num 1", StandardView::front, true);
  side("view.back", "Back", "Ctrl+Num 1", StandardView::back, false);
  side("view.right", "Right", "Num 3", StandardView::right, false);
  side("view.left", "Left", "Ctrl+Num 3", StandardView::left, false);
  side("view.top", "Top", "Num 7", StandardView::top, false);
  side("view.bottom", "Bottom", "Ctrl+Num 7", StandardView::bottom, false);
  side("view.iso", "Three-quarter", "Num 0", StandardView::iso, false);
  add_view_row(host, {.id = "view.orthographic",
                      .label = "Orthographic",
                      .help = "Parallel instead of perspective projection.",
                      .keys = "Num 5",
                      .separator_before = true,
                      .run = [&editor] { editor.layout.active_view().toggle_orthographic(); },
                      .why_not = document,
                      .checked = [&editor] { return editor.camera().orthographic; }});
  add_view_row(host, {.id = "view.lock",
                      .label = "Keep direction",
                      .help = "This view pans and zooms but does not turn.",
                      .run = [&editor] { keep_direction(editor); },
                      .why_not = document,
                      .checked = [&editor] { return !editor.layout.active_view().turns; }});
}

void add_arrangement_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  const auto arrange = [&](const char* id, const char* label, const char* help, const char* keys,
                           Arrangement arrangement, bool first) {
    add_view_row(host,
                 {.id = id,
                  .label = label,
                  .help = help,
                  .keys = keys,
                  .separator_before = first,
                  .run = [&editor, arrangement] { arrange_views(editor, arrangement); },
                  .why_not = document,
                  .checked = [&editor, arrangement] { return editor.layout.arrangement() == arrangement; }});
  };
  arrange("view.four", "Four views", "Top, front and right beside the free view.", "Ctrl+Alt+Q",
          Arrangement::four, true);
  arrange("view.two", "Two views", "A plan beside the free view.", "Ctrl+Alt+W", Arrangement::two, false);
  add_view_row(host, {.id = "view.maximise",
                      .label = "Maximise view",
                      .help = "The view under the pointer alone, or all again.",
                      .keys = "Ctrl+Space",
                      .run = [&editor] { editor.layout.toggle_maximised(); },
                      .why_not = document,
                      .checked = [&editor] { return editor.layout.arrangement() == Arrangement::one; }});
}

}  // namespace

void add_view_commands(CommandHost& host) {
  add_framing_commands(host);
  add_side_commands(host);
  add_arrangement_commands(host);
  Editor& editor = host.editor;
  add_view_row(
      host,
      {.id = "view.keep_probe",
       .label = "Keep probe",
       .help = "Keep the readings of the surface under the pointer on the screen; over nothing, let them go.",
       .keys = "Ctrl+Alt+P",
       .separator_before = true,
       .needs_window = true,
       .run = [&editor, &host] { editor.kept_probe = host.viewport.pointed_at(); },
       .why_not = needs_document(editor),
       .checked = [&editor] { return editor.kept_probe.has_value(); }});
  add_view_row(host, {.id = "view.frame_times",
                      .label = "Frame times",
                      .help = "Show how long frames take and which part of that is our own work.",
                      .keys = "F12",
                      .run = [&editor] { show_frame_times(editor); },
                      .checked = [&editor] { return editor.frame_times.visible; }});
  add_view_row(host, switching({.id = "view.x_ray",
                                .label = "X-ray",
                                .help = "See and pick through the surface.",
                                .keys = "Alt+X",
                                .icon = icon::shown,
                                .separator_before = true},
                               editor.view.x_ray));
  add_view_row(
      host,
      {.id = "view.surfaces_only",
       .label = "Surfaces only",
       .help =
           "Hide all curves, points, polyhedra and marks of the selection, for judging; again shows them.",
       .keys = "V",
       .run = [&editor] { show_surfaces_only(editor); },
       .why_not = needs_document(editor),
       .checked = [&editor] { return editor.view.surfaces_only; }});
  add_view_row(host, switching({.id = "view.solids",
                                .label = "Solids in the surface",
                                .help = "See the bodies of solids through the surface round them.",
                                .keys = "Alt+B"},
                               editor.view.bodies));
  add_view_row(host, switching({.id = "view.grid",
                                .label = "Grid",
                                .help = "Show the ground, and behind side views a grid with numbers.",
                                .keys = "Shift+G"},
                               editor.view.grid));
}

}  // namespace hariko
