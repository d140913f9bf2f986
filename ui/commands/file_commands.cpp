// Commands on files: open, save, import, export, close, quit.

#include "ui/commands/command_host.hpp"
#include "ui/icons.hpp"
#include "ui/workbench.hpp"

namespace hariko {

void add_file_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  Workbench& workbench = host.workbench;
  const WhyNot document = needs_document(editor);
  table.add({"file.open", "File", "Open\u2026", "Open a Hariko document or a mesh.", "Ctrl+O", icon::open,
             false, false, [&workbench] { workbench.show_open_dialog(); }});
  table.add({"file.save", "File", "Save", "Save the document.", "Ctrl+S", icon::save, false, false,
             [&workbench] { workbench.save({}); }, document});
  table.add({"file.save_as", "File", "Save as\u2026", "Save the document under another name.", "Ctrl+Shift+S",
             "", false, false, [&workbench] { workbench.save_as({}); }, document});
  table.add({"file.import", "File", "Import\u2026", "Add the polyhedron of a mesh file to the document.",
             "Ctrl+I", icon::import_file, true, true, [&workbench] { workbench.show_import_dialog(); }});
  table.add({"file.export", "File", "Export\u2026", "Write the surfaces as triangles.", "Ctrl+E",
             icon::export_file, false, false, [&workbench] { workbench.show_export_dialog(); }, document});
  table.add({"file.close", "File", "Close", "Close the document and go to the start page.", "Ctrl+W", "",
             false, true, [&workbench] { workbench.close_document(); }, document});
  table.add({"file.quit", "File", "Quit", "Leave Hariko.", "Ctrl+Q", "", false, false,
             [&workbench] { workbench.quit(); }});
}

}  // namespace hariko
