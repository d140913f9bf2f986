// Commands on files: open, save, import, export, close, quit.

#include <algorithm>

#include "core/cad/kernel/cad_file.hpp"
#include "core/document/edits/edits.hpp"
#include "core/modeling/objects/primitives.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/new_object.hpp"
#include "ui/shell/shell_commands.hpp"
#include "ui/shell/workbench.hpp"

namespace hariko {

namespace {

void open_box(Editor& editor) {
  const Unit unit = editor.settings.unit;
  const double size = 2 * first_object_radius(unit);
  const auto mesh = make_primitive(BoxShape{{size, size, size}, {1, 1, 1}, {}});
  if (!mesh.ok()) return editor.notify(mesh.error());
  auto made = document_from_mesh(*mesh, editor.language("Box"));
  if (!made.ok()) return editor.notify(made.error());
  Document document = std::move(made).value();
  document.unit = unit;
  editor.open(std::move(document), {});
}

}  // namespace

void add_file_commands(CommandHost& host, Workbench& workbench) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  table.add({"file.new", "File", "New", "Begin an empty document.", "Ctrl+N", icon::file, false, false,
             [&workbench] { workbench.new_document(); }});
  table.add({"file.new_from_box", "File", "New from box", "Begin a document with a box.", "", icon::object,
             false, false, [&workbench, &editor] { workbench.guarded([&editor] { open_box(editor); }); }});
  table.add({"file.open", "File", "Open\u2026", "Open a Hariko document or a mesh.", "Ctrl+O", icon::open,
             false, false, [&workbench] {
               workbench.files().open([&workbench](const auto& path) { workbench.open_guarded(path); });
             }});
  table.add({"file.recent", "File", "Open recent\u2026", "Open a file that was used before.", "Ctrl+Shift+O",
             "", false, false, [&workbench] { workbench.show_recent(); },
             [&workbench]() -> Reason {
               if (!workbench.offers().recent.empty()) return {};
               return "No file was opened or saved yet.";
             }});
  table.add({"file.samples", "File", "Open a sample\u2026",
             "Open a model that came with Hariko, as a copy without a file.", "", "", false, false,
             [&workbench] { workbench.show_samples(); },
             [&workbench]() -> Reason {
               if (!workbench.samples().empty()) return {};
               return "The samples are not installed.";
             }});
  table.add({"file.recover", "File", "Recover\u2026",
             "Open unsaved work of a session that ended without saving.", "", "", false, false,
             [&workbench] { workbench.show_recoveries(); },
             [&workbench]() -> Reason {
               const Offers& offers = workbench.offers();
               if (offers.crash || !offers.recoveries.empty()) return {};
               return "There is no unsaved work of an earlier session.";
             }});
  table.add({"file.save", "File", "Save", "Save the document.", "Ctrl+S", icon::save, false, false,
             [&workbench] { workbench.save({}); }, document});
  table.add({"file.save_as", "File", "Save as\u2026", "Save the document under another name.", "Ctrl+Shift+S",
             "", false, false, [&workbench] { workbench.files().save_as({}); }, document});
  table.add({"file.save_copy", "File", "Save a copy\u2026",
             "Save under another name and go on with this file.", "Ctrl+Alt+S", "", false, false,
             [&workbench] { workbench.files().save_copy(); }, document});
  table.add({"file.revert", "File", "Revert to the file",
             "Bring back what the file holds. Undo takes it back.", "", "", true, false,
             [&host] { host.application.revert(); },
             [&editor]() -> Reason {
               if (!editor.has_document || !editor.path) return "The document was never saved.";
               return {};
             }});
  table.add({"file.import", "File", "Import\u2026", "Add the polyhedron of a mesh file to the document.",
             "Ctrl+I", icon::import_file, true, true, [&workbench] { workbench.files().import(); }});
  add_picture_commands(host);
  table.add({"file.export", "File", "Export\u2026", "Write the surfaces as triangles.", "Ctrl+E",
             icon::export_file, false, false, [&workbench] { workbench.files().export_triangles(); },
             document});
  table.add(
      {"file.export_cad", "File", "Export for CAD\u2026",
       "Write the surfaces as STEP or IGES: splines with common edges, and solids where they are closed.", "",
       "", false, false, [&workbench] { workbench.files().export_cad(); },
       [document, &editor]() -> Reason {
         if (auto reason = document()) return reason;
         if (const auto missing = why_no_cad_files())
           return editor.language.text_of(*missing) + " " + editor.language.remedy_of(*missing);
         return {};
       }});
  table.add({"file.export_control", "File", "Export control meshes\u2026",
             "Write the control meshes of skins, with their creases, for programs that subdivide themselves.",
             "", "", false, false, [&workbench] { workbench.files().export_control(); },
             [&editor, document]() -> Reason {
               if (auto reason = document()) return reason;
               const auto& objects = editor.document().objects;
               const auto skin = [](const auto& object) { return object->visible && object->skin(); };
               if (std::any_of(objects.begin(), objects.end(), skin)) return {};
               return "No skin is visible. Only skins have control meshes.";
             }});
  const WhyNot something_shown = [&editor, document]() -> Reason {
    if (auto reason = document()) return reason;
    const auto& objects = editor.document().objects;
    if (std::any_of(objects.begin(), objects.end(), [](const auto& object) { return object->visible; }))
      return {};
    return "No object is visible. Show one or add one.";
  };
  table.add({"file.export_picture", "File", "Export picture\u2026",
             "Write what the active view shows as a PNG picture, or its lines as SVG.", "", "", false, true,
             [&workbench] { workbench.files().picture(false); }, something_shown});
  table.add({"file.export_turntable", "File", "Export turntable\u2026",
             "Write a series of pictures that goes once round the model.", "", "", false, false,
             [&workbench] { workbench.files().picture(true); }, something_shown});
  table.add({"file.cancel_job", "File", "Cancel work on files",
             "Stop the import, export or picture in progress; files stay as they were.", "", "", false, false,
             [&editor] { editor.cancellable_job()->cancel.cancel(); },
             [&editor]() -> Reason {
               if (editor.cancellable_job()) return {};
               return "Nothing that can be cancelled is in progress.";
             }});
  table.add({"file.close", "File", "Close", "Close the document and go to the start page.", "Ctrl+W", "",
             false, true, [&workbench] { workbench.close_document(); }, document});
  table.add({"file.quit", "File", "Quit", "Leave Hariko.", "Ctrl+Q", "", false, false,
             [&workbench] { workbench.quit(); }});
}

}  // namespace hariko
