// Commands of the Mesh menu: operations that make new faces and edges of those that are selected.

#include <algorithm>
#include <limits>

#include "core/modeling/cuts/cut.hpp"
#include "core/modeling/cuts/subdivide.hpp"
#include "core/modeling/operations/bevel_edges.hpp"
#include "core/modeling/operations/bevel_vertices.hpp"
#include "core/modeling/operations/extrude.hpp"
#include "core/modeling/operations/face_geometry.hpp"
#include "core/modeling/operations/inset.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/operations.hpp"
#include "ui/polyhedron/knife_tool.hpp"
#include "ui/polyhedron/loop_cut_tool.hpp"
#include "ui/view/amount_tool.hpp"
#include "ui/view/viewport.hpp"

namespace hariko {

namespace {

/// The middle of what is selected, in the document's space.
Vector3 middle_of_selection(const Editor& editor) {
  const Object& object = *editor.active_object();
  const PolyhedronSource& source = *object.polyhedron();
  Vector3 sum = Vector3::Zero();
  const auto vertices = touched_vertices(editor.selection.of_active(), source.polyhedron);
  for (const VertexId id : vertices)
    sum += source.polyhedron.position(source.polyhedron.find(id)) / static_cast<double>(vertices.size());
  return object.transform.apply(source.origin + sum);
}

AmountOperation operation_on_selection(const Editor& editor, const char* name, std::string label) {
  AmountOperation operation;
  operation.object = editor.selection.active;
  operation.name = name;
  operation.label = std::move(label);
  operation.anchor = middle_of_selection(editor);
  return operation;
}

/// Starts the tool, unless the operation refuses the selection whatever the amount.
void start(CommandHost& host, AmountOperation operation) {
  const PolyhedronSource& source = *host.editor.active_object()->polyhedron();
  const double limit = operation.limit ? operation.limit(source, operation.grouping) : 1;
  const double trial = std::isfinite(limit) ? limit / 2 : 1;
  const auto tried = edit_polyhedron(host.editor.history.current(), operation.object, [&](const auto& s) {
    return operation.apply(s, trial, operation.grouping);
  });
  if (!tried && !(tried.error().code == e_bad_amount)) return host.editor.notify(tried.error());
  host.viewport.start_modal(make_amount_tool(std::move(operation)));
}

/// Mean normal of the selected faces in the document's space; zero where they have none.
Vector3 normal_of_selection(const Editor& editor, const std::vector<FaceId>& faces) {
  const Object& object = *editor.active_object();
  std::vector<Index> dense;
  for (const FaceId id : faces) dense.push_back(object.polyhedron()->polyhedron.find(id));
  return direction_of(object.transform.apply_to_vector(mean_normal(object.polyhedron()->polyhedron, dense)));
}

void extrude(CommandHost& host, Grouping grouping) {
  const Editor& editor = host.editor;
  const auto faces = list_of(editor.selection.of_active().faces);
  if (faces.empty()) {
    const auto edges = list_of(editor.selection.of_active().edges);
    AmountOperation operation =
        operation_on_selection(editor, translatable("Extrude"), translatable("Extrude border"));
    operation.negative = true;
    operation.apply = [edges](const PolyhedronSource& source, double amount, Grouping) {
      return extrude_borders(source, edges, amount);
    };
    return start(host, std::move(operation));
  }
  AmountOperation operation = operation_on_selection(
      editor, translatable("Extrude"),
      faces.size() == 1 ? translatable("Extrude face")
                        : fill(translatable("Extrude {0} faces"), {std::to_string(faces.size())}));
  operation.axis = normal_of_selection(editor, faces);
  operation.negative = operation.grouped = true;
  operation.grouping = grouping;
  operation.apply = [faces](const PolyhedronSource& source, double amount, Grouping as) {
    return extrude_faces(source, faces, {amount, as});
  };
  start(host, std::move(operation));
}

void inset(CommandHost& host) {
  const auto faces = list_of(host.editor.selection.of_active().faces);
  AmountOperation operation = operation_on_selection(
      host.editor, translatable("Inset"),
      faces.size() == 1 ? translatable("Inset face")
                        : fill(translatable("Inset {0} faces"), {std::to_string(faces.size())}));
  operation.grouped = true;
  operation.apply = [faces](const PolyhedronSource& source, double amount, Grouping as) {
    return inset_faces(source, faces, {amount, InsetOptions::Measure::distance, as});
  };
  operation.limit = [faces](const PolyhedronSource& source, Grouping as) {
    const auto limit = largest_inset(source, faces, as);
    return limit ? *limit : std::numeric_limits<double>::infinity();
  };
  start(host, std::move(operation));
}

void bevel_selected_edges(CommandHost& host) {
  const auto edges = list_of(host.editor.selection.of_active().edges);
  AmountOperation operation = operation_on_selection(
      host.editor, translatable("Bevel"),
      edges.size() == 1 ? translatable("Bevel edge")
                        : fill(translatable("Bevel {0} edges"), {std::to_string(edges.size())}));
  operation.apply = [edges](const PolyhedronSource& source, double amount, Grouping) {
    return bevel_edges(source, edges, amount);
  };
  operation.limit = [edges](const PolyhedronSource& source, Grouping) {
    const auto limit = largest_edge_bevel(source, edges);
    return limit ? *limit : std::numeric_limits<double>::infinity();
  };
  start(host, std::move(operation));
}

void bevel_selected_vertices(CommandHost& host) {
  constexpr auto measure = BevelVerticesOptions::Measure::distance;
  const auto vertices = list_of(host.editor.selection.of_active().vertices);
  AmountOperation operation = operation_on_selection(
      host.editor, translatable("Bevel"),
      vertices.size() == 1 ? translatable("Bevel vertex")
                           : fill(translatable("Bevel {0} vertices"), {std::to_string(vertices.size())}));
  operation.apply = [vertices](const PolyhedronSource& source, double amount, Grouping) {
    return bevel_vertices(source, vertices, {amount, measure});
  };
  operation.limit = [vertices](const PolyhedronSource& source, Grouping) {
    const auto limit = largest_vertex_bevel(source, vertices, measure);
    return limit ? *limit : std::numeric_limits<double>::infinity();
  };
  start(host, std::move(operation));
}

void add_dragged(CommandHost& host) {
  CommandTable& table = host.table;
  const Editor& editor = host.editor;
  table.add({"mesh.extrude",
             "Mesh",
             "Extrude",
             "Move the selected faces out and put walls round them, or continue the selected open edges.",
             "E",
             icon::extrude,
             true,
             false,
             [&host] { extrude(host, Grouping::region); },
             needs_elements(editor, {.edges = true, .faces = true}),
             {},
             Context::face | Context::edge});
  table.add({"mesh.extrude_each",
             "Mesh",
             "Extrude each face",
             "Move every selected face out by itself, along its own normal.",
             "Shift+E",
             "",
             true,
             false,
             [&host] { extrude(host, Grouping::individual); },
             needs_elements(editor, {.faces = true}),
             {},
             Context::face});
  table.add({"mesh.inset",
             "Mesh",
             "Inset",
             "Put a band of even width inside the rim of the selected faces.",
             "I",
             icon::inset,
             true,
             false,
             [&host] { inset(host); },
             needs_elements(editor, {.faces = true}),
             {},
             Context::face});
  table.add({"mesh.bevel_edges",
             "Mesh",
             "Bevel edges",
             "Turn the selected edges into flat bands.",
             "Ctrl+B",
             icon::bevel,
             true,
             false,
             [&host] { bevel_selected_edges(host); },
             needs_elements(editor, {.edges = true}),
             {},
             Context::edge});
  table.add({"mesh.bevel_vertices",
             "Mesh",
             "Bevel vertices",
             "Cut the selected corners off.",
             "Ctrl+Shift+B",
             icon::bevel,
             true,
             false,
             [&host] { bevel_selected_vertices(host); },
             needs_elements(editor, {.vertices = true}),
             {},
             Context::vertex});
}

void add_cuts(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  table.add({"mesh.loop_cut",
             "Mesh",
             "Loop cut",
             "Cut a ring of four-sided faces from edge to edge.",
             "Ctrl+R",
             icon::loop_cut,
             true,
             true,
             [&host] { host.viewport.start_modal(make_loop_cut_tool()); },
             needs_polyhedron(editor),
             {},
             Context::edge});
  table.add({"mesh.knife",
             "Mesh",
             "Knife",
             "Cut faces from point to point along a path.",
             "K",
             icon::knife,
             true,
             false,
             [&host] { host.viewport.start_modal(make_knife_tool()); },
             needs_polyhedron(editor),
             {},
             any_element});
  table.add({"mesh.connect",
             "Mesh",
             "Connect",
             "Split faces between the selected vertices, and between the middles of the selected edges.",
             "J",
             "",
             true,
             false,
             [&editor] {
               const ElementSet& set = editor.selection.of_active();
               const auto vertices = list_of(set.vertices);
               const auto edges = list_of(set.edges);
               run_refinement(
                   editor,
                   [&](const auto& source, const SurfaceForm* on) {
                     return connect_points(source, vertices, edges, on);
                   },
                   translatable("Connect"));
             },
             needs_elements(editor, {.vertices = true, .edges = true}),
             {},
             Context::vertex | Context::edge});
  table.add({"mesh.subdivide",
             "Mesh",
             "Subdivide",
             "Divide the selected faces into quads, or put a vertex on the middle of the selected edges.",
             "",
             "",
             true,
             true,
             [&editor] {
               const ElementSet& set = editor.selection.of_active();
               const auto faces = list_of(set.faces);
               const auto edges = list_of(set.edges);
               run_refinement(
                   editor,
                   [&](const auto& source, const SurfaceForm* on) {
                     return faces.empty() ? subdivide_edges(source, edges, 1, on)
                                          : subdivide_faces(source, faces, on);
                   },
                   faces.empty() ? translatable("Subdivide edges") : translatable("Subdivide faces"));
             },
             needs_elements(editor, {.edges = true, .faces = true}),
             {},
             Context::edge | Context::face});
  table.add({"mesh.poke",
             "Mesh",
             "Poke faces",
             "Put a vertex into the middle of each selected face, with triangles round it.",
             "",
             "",
             true,
             false,
             [&editor] {
               const auto faces = list_of(editor.selection.of_active().faces);
               run_refinement(
                   editor,
                   [&](const auto& source, const SurfaceForm* on) { return poke_faces(source, faces, on); },
                   translatable("Poke faces"));
             },
             needs_elements(editor, {.faces = true}),
             {},
             Context::face});
  table.add(
      {"mesh.on_surface",
       "Mesh",
       "Refine on the surface",
       "Cuts and subdivisions put new points on the surface, which keeps its form; off: on straight edges.",
       "",
       "",
       false,
       false,
       [&editor] { editor.settings.refine_on_surface = !editor.settings.refine_on_surface; },
       {},
       [&editor] { return editor.settings.refine_on_surface; }});
}

}  // namespace

void add_mesh_commands(CommandHost& host) {
  add_dragged(host);
  add_cuts(host);
}

}  // namespace hariko
