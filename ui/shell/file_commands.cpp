// Commands on files: open, save, import, export, close, quit.

#include <algorithm>

#include "core/cad/kernel/cad_file.hpp"
#include "core/document/edits/edits.hpp"
#include "core/modeling/objects/primitives.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/new_object.hpp"
#include "ui/shell/shell_commands.hpp"
#include "ui/shell/workbench.hpp"
#include "ui/widgets/application_services.hpp"

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

bool any_visible(const Editor& editor) {
  const auto& objects = editor.document().objects;
  return std::any_of(objects.begin(), objects.end(), [](const auto& object) { return object->visible; });
}

bool any_visible_skin(const Editor& editor) {
  const auto& objects = editor.document().objects;
  return std::any_of(objects.begin(), objects.end(),
                     [](const auto& object) { return object->visible && object->skin(); });
}

bool any_recovery(const Offers& offers) {
  return offers.crash || !offers.recoveries.empty();
}

void add_opening(CommandTable& table, Editor& editor, Workbench& workbench) {
  table.add({.id = "file.new",
             .menu = "File",
             .label = "New",
             .help = "Begin an empty document.",
             .keys = "Ctrl+N",
             .icon = icon::file,
             .needs_window = true,
             .run = [&workbench] { workbench.new_document(); }});
  table.add({.id = "file.new_from_box",
             .menu = "File",
             .label = "New from box",
             .help = "Begin a document with a box.",
             .icon = icon::object,
             .run = [&workbench, &editor] { workbench.guarded([&editor] { open_box(editor); }); },
             .script = {.run = [&editor](const Arguments&) { open_box(editor); }}});
  table.add({.id = "file.open",
             .menu = "File",
             .label = "Open\u2026",
             .help = "Open a Hariko document or a mesh.",
             .keys = "Ctrl+O",
             .icon = icon::open,
             .needs_window = true,
             .run = [&workbench] {
               workbench.files().open([&workbench](const auto& path) { workbench.open_guarded(path); });
             }});
  table.add({.id = "file.recent",
             .menu = "File",
             .label = "Open recent\u2026",
             .help = "Open a file that was used before.",
             .keys = "Ctrl+Shift+O",
             .needs_window = true,
             .run = [&workbench] { workbench.show_recent(); },
             .why_not = only_if([&workbench] { return !workbench.offers().recent.empty(); },
                                "No file was opened or saved yet.")});
  table.add({.id = "file.samples",
             .menu = "File",
             .label = "Open a sample\u2026",
             .help = "Open a model that came with Hariko, as a copy without a file.",
             .needs_window = true,
             .run = [&workbench] { workbench.show_samples(); },
             .why_not = only_if([&workbench] { return !workbench.samples().empty(); },
                                "The samples are not installed.")});
  table.add({.id = "file.recover",
             .menu = "File",
             .label = "Recover\u2026",
             .help = "Open unsaved work of a session that ended without saving.",
             .needs_window = true,
             .run = [&workbench] { workbench.show_recoveries(); },
             .why_not = only_if([&workbench] { return any_recovery(workbench.offers()); },
                                "There is no unsaved work of an earlier session.")});
}

void add_saving(CommandHost& host, Workbench& workbench) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  table.add({.id = "file.save",
             .menu = "File",
             .label = "Save",
             .help = "Save the document.",
             .keys = "Ctrl+S",
             .icon = icon::save,
             .needs_window = true,
             .run = [&workbench] { workbench.save({}); },
             .why_not = document});
  table.add({.id = "file.save_as",
             .menu = "File",
             .label = "Save as\u2026",
             .help = "Save the document under another name.",
             .keys = "Ctrl+Shift+S",
             .needs_window = true,
             .run = [&workbench] { workbench.files().save_as({}); },
             .why_not = document});
  table.add({.id = "file.save_copy",
             .menu = "File",
             .label = "Save a copy\u2026",
             .help = "Save under another name and go on with this file.",
             .keys = "Ctrl+Alt+S",
             .needs_window = true,
             .run = [&workbench] { workbench.files().save_copy(); },
             .why_not = document});
  table.add({.id = "file.revert",
             .menu = "File",
             .label = "Revert to the file",
             .help = "Bring back what the file holds. Undo takes it back.",
             .changes_document = true,
             .run = [&host] { host.application.revert(); },
             .why_not = only_if([&editor] { return editor.has_document && editor.path.has_value(); },
                                "The document was never saved.")});
}

Reason no_cad_files(const Editor& editor) {
  if (const auto missing = why_no_cad_files())
    return editor.language.text_of(*missing) + " " + editor.language.remedy_of(*missing);
  return {};
}

void add_exports(CommandTable& table, Editor& editor, Workbench& workbench) {
  const WhyNot document = needs_document(editor);
  table.add({.id = "file.export",
             .menu = "File",
             .label = "Export\u2026",
             .help = "Write the surfaces as triangles.",
             .keys = "Ctrl+E",
             .icon = icon::export_file,
             .needs_window = true,
             .run = [&workbench] { workbench.files().export_triangles(); },
             .why_not = document});
  table.add(
      {.id = "file.export_cad",
       .menu = "File",
       .label = "Export for CAD\u2026",
       .help =
           "Write the surfaces as STEP or IGES: splines with common edges, and solids where they are closed.",
       .needs_window = true,
       .run = [&workbench] { workbench.files().export_cad(); },
       .why_not =
           [&editor, document] {
             auto reason = document();
             return reason ? reason : no_cad_files(editor);
           }});
  table.add(
      {.id = "file.export_control",
       .menu = "File",
       .label = "Export control meshes\u2026",
       .help =
           "Write the control meshes of skins, with their creases, for programs that subdivide themselves.",
       .needs_window = true,
       .run = [&workbench] { workbench.files().export_control(); },
       .why_not = only_if(
           document, [&editor] { return any_visible_skin(editor); },
           "No skin is visible. Only skins have control meshes.")});
}

void add_pictures(CommandTable& table, Editor& editor, Workbench& workbench) {
  const WhyNot something_shown = only_if(
      needs_document(editor), [&editor] { return any_visible(editor); },
      "No object is visible. Show one or add one.");
  table.add({.id = "file.export_picture",
             .menu = "File",
             .label = "Export picture\u2026",
             .help = "Write what the active view shows as a PNG picture, or its lines as SVG.",
             .separator_before = true,
             .needs_window = true,
             .run = [&workbench] { workbench.files().picture(false); },
             .why_not = something_shown});
  table.add({.id = "file.export_turntable",
             .menu = "File",
             .label = "Export turntable\u2026",
             .help = "Write a series of pictures that goes once round the model.",
             .needs_window = true,
             .run = [&workbench] { workbench.files().picture(true); },
             .why_not = something_shown});
}

}  // namespace

void add_file_commands(CommandHost& host, Workbench& workbench) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  add_opening(table, editor, workbench);
  add_saving(host, workbench);
  table.add({.id = "file.import",
             .menu = "File",
             .label = "Import\u2026",
             .help = "Add the polyhedron of a mesh file to the document.",
             .keys = "Ctrl+I",
             .icon = icon::import_file,
             .changes_document = true,
             .separator_before = true,
             .needs_window = true,
             .run = [&workbench] { workbench.files().import(); }});
  add_picture_commands(host);
  add_exports(table, editor, workbench);
  add_pictures(table, editor, workbench);
  table.add({.id = "file.cancel_job",
             .menu = "File",
             .label = "Cancel work on files",
             .help =
                 "Stop the import, export, picture or long edit in progress; files and model stay as they "
                 "were.",
             .run = [&editor] { editor.cancellable_job()->cancel.cancel(); },
             .why_not = only_if([&editor] { return editor.cancellable_job() != nullptr; },
                                "Nothing that can be cancelled is in progress.")});
  table.add({.id = "file.close",
             .menu = "File",
             .label = "Close",
             .help = "Close the document and go to the start page.",
             .keys = "Ctrl+W",
             .separator_before = true,
             .needs_window = true,
             .run = [&workbench] { workbench.close_document(); },
             .why_not = needs_document(editor)});
  table.add({.id = "file.quit",
             .menu = "File",
             .label = "Quit",
             .help = "Leave Hariko.",
             .keys = "Ctrl+Q",
             .needs_window = true,
             .run = [&workbench] { workbench.quit(); }});
  use_files_in_scripts(host);
}

}  // namespace hariko
