// Commands that change how the model is seen.

#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/view/viewport.hpp"

namespace hariko {

namespace {

void add_framing_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  table.add({.id = "view.frame_all",
             .menu = "View",
             .label = "Frame all",
             .help = "Show everything.",
             .keys = "Home",
             .icon = icon::frame,
             .while_tool_runs = true,
             .run = [&editor] { editor.frame_all(); },
             .why_not = document});
  table.add({.id = "view.frame_all_views",
             .menu = "View",
             .label = "Frame all in every view",
             .help = "Show everything in every view.",
             .keys = "Shift+Home",
             .while_tool_runs = true,
             .run = [&editor] { editor.wants_framing = true; },
             .why_not = document});
  table.add({.id = "view.frame_selection",
             .menu = "View",
             .label = "Frame selection",
             .help = "Come close to what is selected.",
             .keys = "F",
             .while_tool_runs = true,
             .run = [&editor] { editor.frame_selection(); },
             .why_not = document});
  table.add({.id = "view.previous",
             .menu = "View",
             .label = "Previous view",
             .help = "Back to where the camera was.",
             .while_tool_runs = true,
             .run = [&editor] { editor.layout.active_view().go_back(editor.now); },
             .why_not = only_if(
                 document, [&editor] { return editor.layout.active_view().can_go_back(); },
                 translatable("The camera has not moved yet."))});
  table.add({.id = "view.next",
             .menu = "View",
             .label = "Next view",
             .help = "Forward again to where the camera was.",
             .while_tool_runs = true,
             .run = [&editor] { editor.layout.active_view().go_forward(editor.now); },
             .why_not = only_if(
                 document, [&editor] { return editor.layout.active_view().can_go_forward(); },
                 translatable("Nothing to go forward to: Previous view comes first."))});
}

void add_side_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  const auto side = [&](const char* id, const char* label, const char* keys, StandardView view, bool first) {
    table.add({.id = id,
               .menu = "View",
               .label = label,
               .help = "Look from this side.",
               .keys = keys,
               .separator_before = first,
               .while_tool_runs = true,
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
  table.add({.id = "view.orthographic",
             .menu = "View",
             .label = "Orthographic",
             .help = "Parallel instead of perspective projection.",
             .keys = "Num 5",
             .separator_before = true,
             .while_tool_runs = true,
             .run = [&editor] { editor.layout.active_view().toggle_orthographic(); },
             .why_not = document,
             .checked = [&editor] { return editor.camera().orthographic; }});
  table.add({.id = "view.lock",
             .menu = "View",
             .label = "Keep direction",
             .help = "This view pans and zooms but does not turn.",
             .while_tool_runs = true,
             .run =
                 [&editor] {
                   View& view = editor.layout.active_view();
                   view.turns = !view.turns;
                 },
             .why_not = document,
             .checked = [&editor] { return !editor.layout.active_view().turns; }});
}

void add_arrangement_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  const auto arrange = [&](const char* id, const char* label, const char* help, const char* keys,
                           Arrangement arrangement, bool first) {
    table.add({.id = id,
               .menu = "View",
               .label = label,
               .help = help,
               .keys = keys,
               .separator_before = first,
               .while_tool_runs = true,
               .run =
                   [&editor, arrangement] {
                     ViewLayout& layout = editor.layout;
                     // The key of an arrangement that is on leaves it.
                     layout.arrange(layout.arrangement() == arrangement ? Arrangement::one : arrangement);
                   },
               .why_not = document,
               .checked = [&editor, arrangement] { return editor.layout.arrangement() == arrangement; }});
  };
  arrange("view.four", "Four views", "Top, front and right beside the free view.", "Ctrl+Alt+Q",
          Arrangement::four, true);
  arrange("view.two", "Two views", "A plan beside the free view.", "Ctrl+Alt+W", Arrangement::two, false);
  table.add({.id = "view.maximise",
             .menu = "View",
             .label = "Maximise view",
             .help = "The view under the pointer alone, or all again.",
             .keys = "Ctrl+Space",
             .while_tool_runs = true,
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
  host.table.add(
      {.id = "view.keep_probe",
       .menu = "View",
       .label = "Keep probe",
       .help = "Keep the readings of the surface under the pointer on the screen; over nothing, let them go.",
       .keys = "Ctrl+Alt+P",
       .separator_before = true,
       .while_tool_runs = true,
       .run = [&editor, &host] { editor.kept_probe = host.viewport.pointed_at(); },
       .why_not = needs_document(editor),
       .checked = [&editor] { return editor.kept_probe.has_value(); }});
  host.table.add({.id = "view.frame_times",
                  .menu = "View",
                  .label = "Frame times",
                  .help = "Show how long frames take and which part of that is our own work.",
                  .keys = "F12",
                  .while_tool_runs = true,
                  .run =
                      [&editor] {
                        editor.frame_times.clear();
                        editor.frame_times.visible = !editor.frame_times.visible;
                      },
                  .checked = [&editor] { return editor.frame_times.visible; }});
  host.table.add({.id = "view.x_ray",
                  .menu = "View",
                  .label = "X-ray",
                  .help = "See and pick through the surface.",
                  .keys = "Alt+X",
                  .icon = icon::shown,
                  .separator_before = true,
                  .while_tool_runs = true,
                  .run = [&editor] { editor.view.x_ray = !editor.view.x_ray; },
                  .checked = [&editor] { return editor.view.x_ray; }});
  host.table.add(
      {.id = "view.surfaces_only",
       .menu = "View",
       .label = "Surfaces only",
       .help =
           "Hide all curves, points, polyhedra and marks of the selection, for judging; again shows them.",
       .keys = "V",
       .while_tool_runs = true,
       .run =
           [&editor] {
             editor.view.surfaces_only = !editor.view.surfaces_only;
             editor.hovered.reset();
           },
       .why_not = needs_document(editor),
       .checked = [&editor] { return editor.view.surfaces_only; }});
  host.table.add({.id = "view.solids",
                  .menu = "View",
                  .label = "Solids in the surface",
                  .help = "See the bodies of solids through the surface round them.",
                  .keys = "Alt+B",
                  .while_tool_runs = true,
                  .run = [&editor] { editor.view.bodies = !editor.view.bodies; },
                  .checked = [&editor] { return editor.view.bodies; }});
  host.table.add({.id = "view.grid",
                  .menu = "View",
                  .label = "Grid",
                  .help = "Show the ground, and behind side views a grid with numbers.",
                  .keys = "Shift+G",
                  .while_tool_runs = true,
                  .run = [&editor] { editor.view.grid = !editor.view.grid; },
                  .checked = [&editor] { return editor.view.grid; }});
}

}  // namespace hariko
