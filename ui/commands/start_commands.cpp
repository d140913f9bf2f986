// Commands to begin with: a box, and the guided first model.

#include "core/document/edits.hpp"
#include "core/modeling/primitives.hpp"
#include "ui/commands/command_host.hpp"
#include "ui/commands/new_object.hpp"
#include "ui/icons.hpp"
#include "ui/workbench.hpp"

namespace hariko {

void add_start_commands(CommandHost& host) {
  Editor& editor = host.editor;
  Workbench& workbench = host.workbench;
  host.table.add({"file.new_from_box", "File", "New from box", "Begin a document with a box.", "",
                  icon::object, false, false, [&editor, &workbench] {
                    workbench.guarded([&editor] {
                      const Unit unit = editor.settings.unit;
                      const double size = 2 * first_object_radius(unit);
                      const auto mesh = make_primitive(BoxShape{{size, size, size}, {1, 1, 1}, {}});
                      if (!mesh.ok()) return editor.notify(mesh.error());
                      auto made = document_from_mesh(*mesh, editor.language("Box"));
                      if (!made.ok()) return editor.notify(made.error());
                      Document document = std::move(made).value();
                      document.unit = unit;
                      editor.open(std::move(document), {});
                    });
                  }});
  host.table.add({"help.guide",
                  "Help",
                  "Your first model",
                  "Make a model in two minutes, step by step.",
                  "",
                  icon::info,
                  false,
                  false,
                  [&editor] {
                    if (!editor.has_document) editor.open({}, {});
                    editor.guide.start({editor.history.current(), editor.exports});
                  },
                  {},
                  [&editor] { return editor.guide.shown(); }});
}

}  // namespace hariko
