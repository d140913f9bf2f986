// Commands that say when surfaces follow the polyhedra.

#include <algorithm>

#include "ui/editor/command_host.hpp"

namespace hariko {

void add_recompute_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  table.add({.id = "surface.recompute",
             .menu = "Shape",
             .label = "Recompute now",
             .help = "Bring every surface up to date.",
             .keys = "F5",
             .separator_before = true,
             .run = [&editor] { editor.recompute.wants_now = true; },
             .why_not = only_if(
                 document, [&editor] { return !editor.recompute.outdated.empty(); },
                 translatable("Every surface is up to date or on its way."))});
  table.add({.id = "surface.cancel",
             .menu = "Shape",
             .label = "Cancel computing",
             .help = "Stop computing; the last surfaces stay until the next change.",
             .run = [&editor] { editor.recompute.wants_cancel = true; },
             .why_not = only_if(
                 document, [&editor] { return !editor.stale_since.empty(); },
                 translatable("Nothing is being computed."))});
  const auto policy = [&](const char* id, const char* label, const char* help, RecomputePolicy value,
                          bool first) {
    table.add({.id = id,
               .menu = "Shape",
               .label = label,
               .help = help,
               .separator_before = first,
               .run = [&editor, value] { editor.recompute.policy = value; },
               .why_not = document,
               .checked = [&editor, value] { return editor.recompute.policy == value; }});
  };
  policy("surface.live", "Live", "Surfaces follow every change, also while dragging.", RecomputePolicy::live,
         true);
  policy("surface.on_release", "When released", "Surfaces follow when a drag ends.",
         RecomputePolicy::on_release, false);
  policy("surface.manual", "By hand", "Surfaces follow when Recompute now is chosen.",
         RecomputePolicy::manual, false);
}

}  // namespace hariko
