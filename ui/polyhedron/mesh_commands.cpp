// Commands of the Mesh menu: operations that make new faces and edges of those that are selected.

#include <limits>

#include "core/modeling/cuts/cut.hpp"
#include "core/modeling/cuts/loop_cut.hpp"
#include "core/modeling/cuts/subdivide.hpp"
#include "core/modeling/operations/bevel_edges.hpp"
#include "core/modeling/operations/bevel_vertices.hpp"
#include "core/modeling/operations/extrude.hpp"
#include "core/modeling/operations/face_geometry.hpp"
#include "core/modeling/operations/inset.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/operations.hpp"
#include "ui/polyhedron/amount_tool.hpp"
#include "ui/polyhedron/cutting_tools.hpp"
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

AmountOperation operation_on_selection(const Editor& editor, const char* name, Phrase label) {
  AmountOperation operation;
  operation.object = editor.selection.active;
  operation.name = name;
  operation.label = std::move(label);
  operation.anchor = middle_of_selection(editor);
  return operation;
}

using BuildAmount = std::function<AmountOperation(const Editor&)>;

/// Adds the command and the argument of scripts.
BuildAmount named(std::string command, std::string argument, BuildAmount build) {
  return [command = std::move(command), argument = std::move(argument),
          build = std::move(build)](const Editor& editor) {
    AmountOperation operation = build(editor);
    operation.command = command;
    operation.argument = argument;
    return operation;
  };
}

/// Starts the tool, unless the operation refuses the selection whatever the amount. It is built of what is
/// selected, which has to have elements of these kinds, and anew when it is repeated.
void start(CommandHost& host, NeededElements kinds, const BuildAmount& build) {
  AmountOperation operation = build(host.editor);
  operation.again = [kinds, build](const Editor& editor) -> Result<AmountOperation> {
    if (const Reason reason = needs_elements(editor, kinds)()) return make_error(e_wrong_selection, *reason);
    return build(editor);
  };
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

AmountOperation extrusion(const Editor& editor, Grouping grouping) {
  const auto faces = list_of(editor.selection.of_active().faces);
  if (faces.empty()) {
    const auto edges = list_of(editor.selection.of_active().edges);
    AmountOperation operation =
        operation_on_selection(editor, translatable("Extrude"), translatable("Extrude border"));
    operation.negative = true;
    operation.apply = [edges](const PolyhedronSource& source, double amount, Grouping) {
      return extrude_borders(source, edges, amount);
    };
    return operation;
  }
  AmountOperation operation = operation_on_selection(
      editor, translatable("Extrude"),
      Phrase::counted(faces.size(), translatable("Extrude face"), translatable("Extrude {0} faces")));
  operation.axis = normal_of_selection(editor, faces);
  operation.negative = operation.grouped = true;
  operation.grouping = grouping;
  operation.apply = [faces](const PolyhedronSource& source, double amount, Grouping as) {
    return extrude_faces(source, faces, {amount, as});
  };
  return operation;
}

double limit_or_none(const Result<double>& limit) {
  return limit ? *limit : std::numeric_limits<double>::infinity();
}

AmountOperation insetting(const Editor& editor) {
  const auto faces = list_of(editor.selection.of_active().faces);
  AmountOperation operation = operation_on_selection(
      editor, translatable("Inset"),
      Phrase::counted(faces.size(), translatable("Inset face"), translatable("Inset {0} faces")));
  operation.grouped = true;
  operation.apply = [faces](const PolyhedronSource& source, double amount, Grouping as) {
    return inset_faces(source, faces, {amount, InsetOptions::Measure::distance, as});
  };
  operation.limit = [faces](const PolyhedronSource& source, Grouping as) {
    return limit_or_none(largest_inset(source, faces, as));
  };
  return operation;
}

AmountOperation bevel_of_edges(const Editor& editor) {
  const auto edges = list_of(editor.selection.of_active().edges);
  AmountOperation operation = operation_on_selection(
      editor, translatable("Bevel"),
      Phrase::counted(edges.size(), translatable("Bevel edge"), translatable("Bevel {0} edges")));
  operation.apply = [edges](const PolyhedronSource& source, double amount, Grouping) {
    return bevel_edges(source, edges, amount);
  };
  operation.limit = [edges](const PolyhedronSource& source, Grouping) {
    return limit_or_none(largest_edge_bevel(source, edges));
  };
  return operation;
}

AmountOperation bevel_of_vertices(const Editor& editor) {
  constexpr auto measure = BevelVerticesOptions::Measure::distance;
  const auto vertices = list_of(editor.selection.of_active().vertices);
  AmountOperation operation = operation_on_selection(
      editor, translatable("Bevel"),
      Phrase::counted(vertices.size(), translatable("Bevel vertex"), translatable("Bevel {0} vertices")));
  operation.apply = [vertices](const PolyhedronSource& source, double amount, Grouping) {
    return bevel_vertices(source, vertices, {amount, measure});
  };
  operation.limit = [vertices](const PolyhedronSource& source, Grouping) {
    return limit_or_none(largest_vertex_bevel(source, vertices, measure));
  };
  return operation;
}

/// Makes the step at once, with an amount in the document's unit.
void make_amount(Editor& editor, const AmountOperation& operation, double amount) {
  const double scale = editor.active_object()->transform.scale;
  run_operation(
      editor,
      [&](const PolyhedronSource& source) {
        return operation.apply(source, amount / scale, operation.grouping);
      },
      operation.label);
}

ScriptUse amount_in_scripts(Editor& editor, const ArgumentSpec& amount, const BuildAmount& build) {
  return {.arguments = {amount}, .run = [&editor, name = amount.name, build](const Arguments& given) {
            make_amount(editor, build(editor), given.number(name));
          }};
}

/// Cuts the ring of the one selected edge.
void cut_ring(Editor& editor, const LoopCutOptions& options) {
  const auto edges = list_of(editor.selection.of_active().edges);
  if (edges.size() != 1)
    return editor.notify(
        make_error(e_wrong_selection, "A loop cut needs one selected edge.", "Select one edge of the ring."));
  run_refinement(
      editor,
      [&](const auto& source, const SurfaceForm* on) { return loop_cut(source, edges.front(), options, on); },
      Phrase::counted(options.count, translatable("Loop cut"), translatable("{0} loop cuts")));
}

void connect_selected(Editor& editor) {
  const ElementSet& set = editor.selection.of_active();
  const auto vertices = list_of(set.vertices);
  const auto edges = list_of(set.edges);
  run_refinement(
      editor,
      [&](const auto& source, const SurfaceForm* on) { return connect_points(source, vertices, edges, on); },
      translatable("Connect"));
}

/// `points`: on each edge, where edges are selected and no faces.
void subdivide_selected(Editor& editor, int points) {
  const ElementSet& set = editor.selection.of_active();
  const auto faces = list_of(set.faces);
  const auto edges = list_of(set.edges);
  run_refinement(
      editor,
      [&](const auto& source, const SurfaceForm* on) {
        return faces.empty() ? subdivide_edges(source, edges, points, on)
                             : subdivide_faces(source, faces, on);
      },
      faces.empty() ? translatable("Subdivide edges") : translatable("Subdivide faces"));
}

void poke_selected(Editor& editor) {
  const auto faces = list_of(editor.selection.of_active().faces);
  run_refinement(
      editor, [&](const auto& source, const SurfaceForm* on) { return poke_faces(source, faces, on); },
      translatable("Poke faces"));
}

void add_dragged(CommandHost& host) {
  Editor& editor = host.editor;
  MenuRows rows(host.table, "Mesh");
  const auto dragged = [&](const char* id, const char* label, const char* help, const ArgumentSpec& amount,
                           NeededElements kinds, const BuildAmount& build, Command more) {
    more.needs_window = true;
    more.script = amount_in_scripts(editor, amount, build);
    rows.add_edit(
        id, label, help, [&host, kinds, of = named(id, amount.name, build)] { start(host, kinds, of); },
        needs_elements(editor, kinds), std::move(more));
  };
  const ArgumentSpec distance = length_argument("distance", translatable("Distance"), {}),
                     width = length_argument("width", translatable("Width"), {});
  dragged("mesh.extrude", "Extrude",
          "Move the selected faces out and put walls round them, or continue the selected open edges.",
          distance, {.edges = true, .faces = true},
          [](const Editor& of) { return extrusion(of, Grouping::region); },
          {.keys = "E", .icon = icon::extrude, .contexts = Context::face | Context::edge});
  dragged("mesh.extrude_each", "Extrude each face",
          "Move every selected face out by itself, along its own normal.", distance, {.faces = true},
          [](const Editor& of) { return extrusion(of, Grouping::individual); },
          {.keys = "Shift+E", .contexts = Context::face});
  dragged("mesh.inset", "Inset", "Put a band of even width inside the rim of the selected faces.", width,
          {.faces = true}, insetting, {.keys = "I", .icon = icon::inset, .contexts = Context::face});
  dragged("mesh.bevel_edges", "Bevel edges", "Turn the selected edges into flat bands.", width,
          {.edges = true}, bevel_of_edges,
          {.keys = "Ctrl+B", .icon = icon::bevel, .contexts = Context::edge});
  dragged("mesh.bevel_vertices", "Bevel vertices", "Cut the selected corners off.", width, {.vertices = true},
          bevel_of_vertices, {.keys = "Ctrl+Shift+B", .icon = icon::bevel, .contexts = Context::vertex});
}

void add_cuts(CommandHost& host) {
  Editor& editor = host.editor;
  MenuRows rows(host.table, "Mesh");
  rows.add_edit("mesh.loop_cut", "Loop cut", "Cut a ring of four-sided faces from edge to edge.",
                [&host] { host.viewport.start_modal(make_loop_cut_tool()); }, needs_polyhedron(editor),
                {.keys = "Ctrl+R",
                 .icon = icon::loop_cut,
                 .separator_before = true,
                 .needs_window = true,
                 .contexts = Context::edge,
                 .script = {.arguments = {whole_argument("cuts", translatable("Cuts"), 1, 1, max_cuts),
                                          number_argument("slide", translatable("Slide"), 0, -1, 1)},
                            .run = [&editor](const Arguments& given) {
                              cut_ring(editor, {given.whole("cuts"), given.number("slide")});
                            }}});
  rows.add_edit("mesh.knife", "Knife", "Cut faces from point to point along a path.",
                [&host] { host.viewport.start_modal(make_knife_tool()); }, needs_polyhedron(editor),
                {.keys = "K", .icon = icon::knife, .needs_window = true, .contexts = any_element});
  rows.add_edit("mesh.connect", "Connect",
                "Split faces between the selected vertices, and between the middles of the selected edges.",
                [&editor] { connect_selected(editor); },
                needs_elements(editor, {.vertices = true, .edges = true}),
                {.keys = "J", .contexts = Context::vertex | Context::edge});
  rows.add_edit(
      "mesh.subdivide", "Subdivide",
      "Divide the selected faces into quads, or put a vertex on the middle of the selected edges.",
      [&editor] { subdivide_selected(editor, 1); }, needs_elements(editor, {.edges = true, .faces = true}),
      {.separator_before = true,
       .contexts = Context::edge | Context::face,
       .script = {
           .arguments = {whole_argument("points", translatable("Points"), 1, 1, max_cuts)},
           .run = [&editor](const Arguments& given) { subdivide_selected(editor, given.whole("points")); }}});
  rows.add_edit("mesh.poke", "Poke faces",
                "Put a vertex into the middle of each selected face, with triangles round it.",
                [&editor] { poke_selected(editor); }, needs_elements(editor, {.faces = true}),
                {.contexts = Context::face});
  rows.add_switch(
      "mesh.on_surface", "Refine on the surface",
      "Cuts and subdivisions put new points on the surface, which keeps its form; off: on straight edges.",
      editor.settings.refine_on_surface);
}

}  // namespace

void add_mesh_commands(CommandHost& host) {
  add_dragged(host);
  add_cuts(host);
}

}  // namespace hariko
