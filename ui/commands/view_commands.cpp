// Commands that change how the model is seen.

#include "core/document/edits.hpp"
#include "ui/commands/command_host.hpp"
#include "ui/icons.hpp"

namespace hariko {

void add_view_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  table.add({"view.frame_all", "View", "Frame all", "Show everything.", "Home", icon::frame, false, false,
             [&editor] { editor.frame_all(); }, document});
  table.add({"view.frame_selection", "View", "Frame selection", "Come close to what is selected.", "F", "",
             false, false, [&editor] { editor.frame_selection(); }, document});
  const auto standard = [&](const char* id, const char* label, const char* keys, StandardView view,
                            bool first) {
    table.add({id, "View", label, "Look from this side.", keys, "", false, first,
               [&editor, view] {
                 Camera camera = editor.camera();
                 camera.orientation = Camera::standard(view).orientation;
                 editor.fly_to(camera);
               },
               document});
  };
  standard("view.front", "Front", "Num 1", StandardView::front, true);
  standard("view.back", "Back", "Ctrl+Num 1", StandardView::back, false);
  standard("view.right", "Right", "Num 3", StandardView::right, false);
  standard("view.left", "Left", "Ctrl+Num 3", StandardView::left, false);
  standard("view.top", "Top", "Num 7", StandardView::top, false);
  standard("view.bottom", "Bottom", "Ctrl+Num 7", StandardView::bottom, false);
  standard("view.iso", "Three-quarter", "Num 0", StandardView::iso, false);
  table.add({"view.orthographic", "View", "Orthographic", "Parallel instead of perspective projection.",
             "Num 5", "", false, true,
             [&editor] {
               Camera camera = editor.camera();
               camera.orthographic = !camera.orthographic;
               editor.set_camera(camera);
             },
             document, [&editor] { return editor.camera().orthographic; }});
  table.add({"view.x_ray",
             "View",
             "X-ray",
             "See and pick through the surface.",
             "Alt+X",
             icon::shown,
             false,
             false,
             [&editor] { editor.view.x_ray = !editor.view.x_ray; },
             {},
             [&editor] { return editor.view.x_ray; }});
  table.add({"view.grid",
             "View",
             "Ground grid",
             "Show the ground.",
             "Shift+G",
             "",
             false,
             false,
             [&editor] { editor.view.grid = !editor.view.grid; },
             {},
             [&editor] { return editor.view.grid; }});
}

}  // namespace hariko
