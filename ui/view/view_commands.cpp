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
  table.add({"view.frame_all", "View", "Frame all", "Show everything.", "Home", icon::frame, false, false,
             [&editor] { editor.frame_all(); }, document});
  table.add({"view.frame_all_views", "View", "Frame all in every view", "Show everything in every view.",
             "Shift+Home", "", false, false, [&editor] { editor.wants_framing = true; }, document});
  table.add({"view.frame_selection", "View", "Frame selection", "Come close to what is selected.", "F", "",
             false, false, [&editor] { editor.frame_selection(); }, document});
  table.add({"view.previous", "View", "Previous view", "Back to where the camera was.", "", "", false, false,
             [&editor] { editor.layout.active_view().go_back(editor.now); },
             [&editor, document]() -> Reason {
               if (auto reason = document()) return reason;
               if (editor.layout.active_view().can_go_back()) return {};
               return translatable("The camera has not moved yet.");
             }});
  table.add({"view.next", "View", "Next view", "Forward again to where the camera was.", "", "", false, false,
             [&editor] { editor.layout.active_view().go_forward(editor.now); },
             [&editor, document]() -> Reason {
               if (auto reason = document()) return reason;
               if (editor.layout.active_view().can_go_forward()) return {};
               return translatable("Nothing to go forward to: Previous view comes first.");
             }});
}

void add_side_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  const auto side = [&](const char* id, const char* label, const char* keys, StandardView view, bool first) {
    table.add({id, "View", label, "Look from this side.", keys, "", false, first,
               [&editor, view] { editor.layout.active_view().look_from(view, editor.now); }, document});
  };
  side("view.front", "Front", "Num 1", StandardView::front, true);
  side("view.back", "Back", "Ctrl+Num 1", StandardView::back, false);
  side("view.right", "Right", "Num 3", StandardView::right, false);
  side("view.left", "Left", "Ctrl+Num 3", StandardView::left, false);
  side("view.top", "Top", "Num 7", StandardView::top, false);
  side("view.bottom", "Bottom", "Ctrl+Num 7", StandardView::bottom, false);
  side("view.iso", "Three-quarter", "Num 0", StandardView::iso, false);
  table.add({"view.orthographic", "View", "Orthographic", "Parallel instead of perspective projection.",
             "Num 5", "", false, true, [&editor] { editor.layout.active_view().toggle_orthographic(); },
             document, [&editor] { return editor.camera().orthographic; }});
  table.add({"view.lock", "View", "Keep direction", "This view pans and zooms but does not turn.", "", "",
             false, false,
             [&editor] {
               View& view = editor.layout.active_view();
               view.turns = !view.turns;
             },
             document, [&editor] { return !editor.layout.active_view().turns; }});
}

void add_arrangement_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  const auto arrange = [&](const char* id, const char* label, const char* help, const char* keys,
                           Arrangement arrangement, bool first) {
    table.add({id, "View", label, help, keys, "", false, first,
               [&editor, arrangement] {
                 ViewLayout& layout = editor.layout;
                 // The key of an arrangement that is on leaves it.
                 layout.arrange(layout.arrangement() == arrangement ? Arrangement::one : arrangement);
               },
               document, [&editor, arrangement] { return editor.layout.arrangement() == arrangement; }});
  };
  arrange("view.four", "Four views", "Top, front and right beside the free view.", "Ctrl+Alt+Q",
          Arrangement::four, true);
  arrange("view.two", "Two views", "A plan beside the free view.", "Ctrl+Alt+W", Arrangement::two, false);
  table.add({"view.maximise", "View", "Maximise view", "The view under the pointer alone, or all again.",
             "Ctrl+Space", "", false, false, [&editor] { editor.layout.toggle_maximised(); }, document,
             [&editor] { return editor.layout.arrangement() == Arrangement::one; }});
}

}  // namespace

void add_view_commands(CommandHost& host) {
  add_framing_commands(host);
  add_side_commands(host);
  add_arrangement_commands(host);
  Editor& editor = host.editor;
  host.table.add(
      {"view.keep_probe", "View", "Keep probe",
       "Keep the readings of the surface under the pointer on the screen; over nothing, let them go.",
       "Ctrl+Alt+P", "", false, true, [&editor, &host] { editor.kept_probe = host.viewport.pointed_at(); },
       needs_document(editor), [&editor] { return editor.kept_probe.has_value(); }});
  host.table.add({"view.frame_times",
                  "View",
                  "Frame times",
                  "Show how long frames take and which part of that is our own work.",
                  "F12",
                  "",
                  false,
                  false,
                  [&editor] {
                    editor.frame_times.clear();
                    editor.frame_times.visible = !editor.frame_times.visible;
                  },
                  {},
                  [&editor] { return editor.frame_times.visible; }});
  host.table.add({"view.x_ray",
                  "View",
                  "X-ray",
                  "See and pick through the surface.",
                  "Alt+X",
                  icon::shown,
                  false,
                  true,
                  [&editor] { editor.view.x_ray = !editor.view.x_ray; },
                  {},
                  [&editor] { return editor.view.x_ray; }});
  host.table.add(
      {"view.surfaces_only", "View", "Surfaces only",
       "Hide all curves, points, polyhedra and marks of the selection, for judging; again shows them.", "V",
       "", false, false,
       [&editor] {
         editor.view.surfaces_only = !editor.view.surfaces_only;
         editor.hovered.reset();
       },
       needs_document(editor), [&editor] { return editor.view.surfaces_only; }});
  host.table.add({"view.solids",
                  "View",
                  "Solids in the surface",
                  "See the bodies of solids through the surface round them.",
                  "Alt+B",
                  "",
                  false,
                  false,
                  [&editor] { editor.view.bodies = !editor.view.bodies; },
                  {},
                  [&editor] { return editor.view.bodies; }});
  host.table.add({"view.grid",
                  "View",
                  "Grid",
                  "Show the ground, and behind side views a grid with numbers.",
                  "Shift+G",
                  "",
                  false,
                  false,
                  [&editor] { editor.view.grid = !editor.view.grid; },
                  {},
                  [&editor] { return editor.view.grid; }});
}

}  // namespace hariko
