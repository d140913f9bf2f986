// Commands on files: open, save, import, export, paste, record scripts, close, quit.

#include <imgui.h>

#include <algorithm>
#include <cstdlib>

#include "core/base/files/file_ending.hpp"
#include "core/base/files/pasted_paths.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/object_shape.hpp"
#include "core/modeling/objects/primitives.hpp"
#include "render/reference_image.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/new_object.hpp"
#include "ui/files/file_dialogs.hpp"
#include "ui/shell/shell_commands.hpp"
#include "ui/shell/workbench.hpp"
#include "ui/widgets/application_services.hpp"

namespace hariko {

namespace {

void open_box(Editor& editor) {
  Document empty;
  empty.unit = editor.settings.unit;
  const double size = 2 * first_object_radius(empty.unit);
  const auto mesh = make_primitive(BoxShape{{size, size, size}, {1, 1, 1}, {}});
  if (!mesh.ok()) return editor.notify(mesh.error());
  auto source = PolyhedronSource::from_mesh(*mesh);
  if (!source.ok()) return editor.notify(source.error());
  auto made = add_object(std::move(empty), editor.language("Box"), as_new(std::move(source).value()));
  if (!made.ok()) return editor.notify(made.error());
  editor.open(std::move(made).value().document, {});
}

bool any_visible(const Editor& editor) {
  return std::ranges::any_of(editor.document().objects, [](const auto& object) { return object->visible; });
}

bool any_visible_control_mesh(const Editor& editor) {
  return std::ranges::any_of(editor.document().objects,
                             [](const auto& object) { return object->visible && has_control_mesh(*object); });
}

bool any_recovery(const Offers& offers) {
  return offers.crash || !offers.recoveries.empty();
}

void add_opening(CommandTable& table, Editor& editor, Workbench& workbench) {
  MenuRows rows(table, "File");
  rows.add("file.new", "New", "Begin an empty document.", [&workbench] { workbench.new_document(); }, {},
           {.keys = "Ctrl+N", .icon = icon::file, .needs_window = true});
  rows.add("file.new_from_box", "New from box", "Begin a document with a box.",
           [&workbench, &editor] { workbench.guarded([&editor] { open_box(editor); }); }, {},
           {.icon = icon::object, .script = {.run = [&editor](const Arguments&) { open_box(editor); }}});
  rows.add("file.open", "Open\u2026", "Open a Hariko document or a mesh.",
           [&workbench] {
             workbench.files().open([&workbench](const auto& path) { workbench.open_guarded(path); });
           },
           {}, {.keys = "Ctrl+O", .icon = icon::open, .needs_window = true});
  rows.add("file.recent", "Open recent\u2026", "Open a file that was used before.",
           [&workbench] { workbench.show_recent(); },
           only_if([&workbench] { return !workbench.offers().recent.empty(); },
                   "No file was opened or saved yet."),
           {.keys = "Ctrl+Shift+O", .needs_window = true});
  rows.add("file.samples", "Open a sample\u2026",
           "Open a model that came with Hariko, as a copy without a file.",
           [&workbench] { workbench.show_samples(); },
           only_if([&workbench] { return !workbench.samples().empty(); }, "The samples are not installed."),
           {.needs_window = true});
  rows.add("file.recover", "Recover\u2026", "Open unsaved work of a session that ended without saving.",
           [&workbench] { workbench.show_recoveries(); },
           only_if([&workbench] { return any_recovery(workbench.offers()); },
                   "There is no unsaved work of an earlier session."),
           {.needs_window = true});
}

void add_saving(CommandHost& host, Workbench& workbench) {
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  MenuRows rows(host.table, "File");
  rows.add("file.save", "Save", "Save the document.", [&workbench] { workbench.save({}); }, document,
           {.keys = "Ctrl+S", .icon = icon::save, .needs_window = true});
  rows.add("file.save_as", "Save as\u2026", "Save the document under another name.",
           [&workbench] { workbench.files().save_as({}); }, document,
           {.keys = "Ctrl+Shift+S", .needs_window = true});
  rows.add("file.save_copy", "Save a copy\u2026", "Save under another name and go on with this file.",
           [&workbench] { workbench.files().save_copy(); }, document,
           {.keys = "Ctrl+Alt+S", .needs_window = true});
  rows.add_edit(
      "file.revert", "Revert to the file", "Bring back what the file holds. Undo takes it back.",
      [&host] { host.application.revert(); },
      only_if([&editor] { return editor.has_document && editor.path.has_value(); },
              "The document was never saved."));
}

Reason no_cad_files(const Editor& editor) {
  if (const auto missing = why_no_cad_files())
    return editor.language.text_of(*missing) + " " + editor.language.remedy_of(*missing);
  return {};
}

void add_exports(CommandTable& table, Editor& editor, Workbench& workbench) {
  const WhyNot document = needs_document(editor);
  MenuRows rows(table, "File");
  rows.add("file.export", "Export\u2026", "Write the surfaces as triangles.",
           [&workbench] { workbench.files().export_triangles(); }, document,
           {.keys = "Ctrl+E", .icon = icon::export_file, .needs_window = true});
  rows.add(
      "file.export_cad", "Export for CAD\u2026",
      "Write the surfaces as STEP or IGES: splines with common edges, and solids where they are closed.",
      [&workbench] { workbench.files().export_cad(); },
      [&editor, document] {
        auto reason = document();
        return reason ? reason : no_cad_files(editor);
      },
      {.needs_window = true});
  rows.add("file.export_control", "Export control meshes\u2026",
           "Write the control meshes of skins, with their creases, for programs that subdivide themselves.",
           [&workbench] { workbench.files().export_control(); },
           only_if(
               document, [&editor] { return any_visible_control_mesh(editor); },
               "No skin is visible. Only skins have control meshes."),
           {.needs_window = true});
}

void add_pictures(CommandTable& table, Editor& editor, Workbench& workbench) {
  const WhyNot something_shown = only_if(
      needs_document(editor), [&editor] { return any_visible(editor); },
      "No object is visible. Show one or add one.");
  MenuRows rows(table, "File");
  rows.add("file.export_picture", "Export picture\u2026",
           "Write what the active view shows as a PNG picture, or its lines as SVG.",
           [&workbench] { workbench.files().picture(false); }, something_shown,
           {.separator_before = true, .needs_window = true});
  rows.add("file.export_turntable", "Export turntable\u2026",
           "Write a series of pictures that goes once round the model.",
           [&workbench] { workbench.files().picture(true); }, something_shown, {.needs_window = true});
}

}  // namespace

void add_file_commands(CommandHost& host, Workbench& workbench) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  add_opening(table, editor, workbench);
  add_saving(host, workbench);
  MenuRows rows(host.table, "File");
  rows.add_edit(
      "file.import", "Import\u2026", "Add the polyhedron of a mesh file to the document.",
      [&workbench] { workbench.files().import(); }, {},
      {.keys = "Ctrl+I", .icon = icon::import_file, .separator_before = true, .needs_window = true});
  add_picture_commands(host);
  add_exports(table, editor, workbench);
  add_pictures(table, editor, workbench);
  rows.add(
      "file.cancel_job", "Cancel work on files",
      "Stop the import, export, picture or long edit in progress; files and model stay as they were.",
      [&editor] { editor.cancellable_job()->cancel.cancel(); },
      only_if([&editor] { return editor.cancellable_job() != nullptr; },
              "Nothing that can be cancelled is in progress."));
  rows.add("file.close", "Close", "Close the document and go to the start page.",
           [&workbench] { workbench.close_document(); }, needs_document(editor),
           {.keys = "Ctrl+W", .separator_before = true, .needs_window = true});
  rows.add("file.quit", "Quit", "Leave Hariko.", [&workbench] { workbench.quit(); }, {},
           {.keys = "Ctrl+Q", .needs_window = true});
  use_files_in_scripts(host);
}

namespace {

constexpr Code e_paste_nothing{"E_PASTE_NOTHING"};

/// Whether the name is that of a picture, a document or a model. CAD files count where they cannot be read,
/// too: the import says what is missing.
bool names_file_to_take(const std::filesystem::path& path) {
  const std::vector<std::string> endings = openable_endings(true);
  return is_reference_file(path) ||
         std::find(endings.begin(), endings.end(), lower_ending(path)) != endings.end();
}

void paste_files(CommandHost& host) {
  const char* text = ImGui::GetClipboardText();
  const char* home = std::getenv("HOME");
  const auto files = pasted_paths(text ? text : "", home ? home : "", names_file_to_take);
  if (!files) return host.editor.notify(files.error());
  if (files->empty())
    return host.editor.notify(
        make_error(e_paste_nothing, "The clipboard names no picture, model or document.",
                   "Copy such a file in a file manager, or its path, and paste again."));
  host.application.drop_files(*files);
}

}  // namespace

void add_paste_commands(CommandHost& host) {
  MenuRows(host.table, "Edit")
      .add_edit("edit.paste", "Paste files",
                "Take the pictures and models whose paths are in the clipboard, as if they were dropped on "
                "the window.",
                [&host] { paste_files(host); }, {},
                {.keys = "Ctrl+V", .needs_window = true, .contexts = Context::empty});
}

void add_record_commands(CommandHost& host, Workbench& workbench) {
  Editor& editor = host.editor;
  MenuRows rows(host.table, "Edit");
  rows.add("edit.record_script", translatable("Record a script\u2026"),
           translatable("Write the commands that you use from here on to a file that repeats "
                        "them without the window."),
           [&workbench] { workbench.files().record_script(); },
           only_if(
               needs_document(editor), [&editor] { return !editor.script_recording; },
               translatable("A script is being recorded already.")),
           {.icon = icon::record, .separator_before = true, .needs_window = true});
  rows.add("edit.stop_script", translatable("Stop the script"),
           translatable("End the script that is being recorded, and write its file."),
           [&host] { host.application.stop_script(); },
           only_if([&editor] { return editor.script_recording.has_value(); },
                   translatable("No script is being recorded.")),
           {.while_tool_runs = true, .needs_window = true});
}

}  // namespace hariko
