// Commands that set what shapes the surface: tensions, creases, tags.

#include <algorithm>

#include "core/document/edits.hpp"
#include "ui/commands/command_host.hpp"
#include "ui/icons.hpp"

namespace hariko {

namespace {

std::vector<VertexId> vertices_of(const Editor& editor) {
  const auto& ids = editor.selection.of_active().vertices;
  return {ids.begin(), ids.end()};
}

std::vector<EdgeId> edges_of(const Editor& editor) {
  const auto& ids = editor.selection.of_active().edges;
  return {ids.begin(), ids.end()};
}

}  // namespace

void add_shape_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot with_vertices = needs_elements(editor, {.vertices = true});
  const WhyNot with_edges = needs_elements(editor, {.edges = true});
  table.add({"shape.crease", "Shape", "Crease edges", "Make the selected edges sharp, or smooth again.", "C",
             "", true, false,
             [&editor] {
               const auto ids = edges_of(editor);
               const auto& crease = editor.active_object()->polyhedron()->shaping->crease;
               const bool all =
                   std::all_of(ids.begin(), ids.end(), [&](EdgeId id) { return crease.contains(id); });
               editor.commit(set_crease(editor.history.current(), editor.selection.active, ids, !all),
                             all ? "Smooth edges" : "Crease edges");
             },
             with_edges});
  table.add({"shape.corner", "Shape", "Corner vertices", "Tag the selected vertices as corners.", "K", "",
             true, false,
             [&editor] {
               editor.commit(set_vertex_tag(editor.history.current(), editor.selection.active,
                                            vertices_of(editor), VertexTag::corner),
                             "Corner vertices");
             },
             with_vertices});
  table.add({"shape.reset_tension", "Shape", "Reset tension",
             "Set \u03b1 of the selection to 0 and \u03b2 to 1.", "Shift+T", "", true, false,
             [&editor] {
               const ObjectId id = editor.selection.active;
               const auto first = set_alpha(editor.history.current(), id, vertices_of(editor), 0);
               if (!first.ok()) return editor.notify(first.error());
               editor.commit(set_beta(*first, id, edges_of(editor), 1), "Reset tension");
             },
             needs_elements(editor, {.vertices = true, .edges = true})});
}

}  // namespace hariko
