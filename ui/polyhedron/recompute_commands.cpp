// Commands that say when surfaces follow the polyhedra.

#include <algorithm>

#include "ui/editor/command_host.hpp"

namespace hariko {

void add_recompute_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  table.add({"surface.recompute", "Shape", "Recompute now", "Bring every surface up to date.", "F5", "",
             false, true, [&editor] { editor.recompute.wants_now = true; },
             [&editor, document]() -> Reason {
               if (auto reason = document()) return reason;
               if (!editor.recompute.outdated.empty()) return {};
               return translatable("Every surface is up to date or on its way.");
             }});
  table.add({"surface.cancel", "Shape", "Cancel computing",
             "Stop computing; the last surfaces stay until the next change.", "", "", false, false,
             [&editor] { editor.recompute.wants_cancel = true; },
             [&editor, document]() -> Reason {
               if (auto reason = document()) return reason;
               if (!editor.stale_since.empty()) return {};
               return translatable("Nothing is being computed.");
             }});
  const auto policy = [&](const char* id, const char* label, const char* help, RecomputePolicy value,
                          bool first) {
    table.add({id, "Shape", label, help, "", "", false, first,
               [&editor, value] { editor.recompute.policy = value; }, document,
               [&editor, value] { return editor.recompute.policy == value; }});
  };
  policy("surface.live", "Live", "Surfaces follow every change, also while dragging.", RecomputePolicy::live,
         true);
  policy("surface.on_release", "When released", "Surfaces follow when a drag ends.",
         RecomputePolicy::on_release, false);
  policy("surface.manual", "By hand", "Surfaces follow when Recompute now is chosen.",
         RecomputePolicy::manual, false);
}

}  // namespace hariko
