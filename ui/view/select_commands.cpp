// Commands that choose elements and objects.

#include "core/modeling/selection/edge_paths.hpp"
#include "core/modeling/selection/select_region.hpp"
#include "core/modeling/selection/select_similar.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/view/region_tool.hpp"
#include "ui/view/select_scripts.hpp"
#include "ui/view/viewport.hpp"

namespace hariko {

namespace {

using Change = std::function<ElementSelection(const PolyhedronSource&, const ElementSelection&)>;

constexpr double similar_tolerance = 0.01;

/// Something of the kinds asked for is selected, of whatever object, and elements are what is being selected.
WhyNot needs_selected(const Editor& editor, NeededElements kinds) {
  return [&editor, kinds]() -> Reason {
    if (auto reason = needs_document(editor)()) return reason;
    if (editor.mode == ElementMode::object)
      return translatable("Objects are being selected. Press 1, 2 or 3 for their elements.");
    for (const auto& [id, elements] : editor.selection.elements())
      if ((kinds.vertices && !elements.vertices.empty()) || (kinds.edges && !elements.edges.empty()) ||
          (kinds.faces && !elements.faces.empty()))
        return {};
    if (kinds.vertices && kinds.edges && kinds.faces)
      return translatable("Nothing is selected. Click a vertex, an edge or a face.");
    if (kinds.vertices && kinds.edges) return translatable("Nothing is selected. Click a vertex or an edge.");
    if (kinds.vertices) return translatable("No vertices are selected. Press 1 and click one.");
    if (kinds.edges) return translatable("No edges are selected. Press 2 and click one.");
    return translatable("No faces are selected. Press 3 and click one.");
  };
}

constexpr NeededElements any_kind{.vertices = true, .edges = true, .faces = true};

void convert(Editor& editor, ElementMode mode) {
  editor.selection = converted(editor.selection, editor.document(), editor.mode, mode);
  editor.mode = mode;
}

void change_mode(Editor& editor, ElementMode mode) {
  // The object that was being worked on is the one that commands on objects then act on.
  if (mode == ElementMode::object && editor.selection.objects().empty() && editor.active_object())
    editor.selection.select({editor.selection.active, element_of(editor.selection.active)},
                            Selection::How::add);
  editor.mode = mode;
  editor.last_click.reset();
}

void add_modes(CommandHost& host) {
  Editor& editor = host.editor;
  const auto mode = [&](const char* id, const char* label, const char* keys, const char* symbol,
                        ElementMode value) {
    host.table.add({.id = id,
                    .menu = "Select",
                    .label = label,
                    .help = "What a click takes.",
                    .keys = keys,
                    .icon = symbol,
                    .run = [&editor, value] { change_mode(editor, value); },
                    .checked = [&editor, value] { return editor.mode == value; },
                    .script = {.arguments = arguments_to_select(value),
                               .run = [&editor, value](const Arguments& arguments) {
                                 change_mode(editor, value);
                                 select_as_written(editor, arguments);
                               }}});
  };
  mode("select.vertices", "Vertices", "1", icon::vertex, ElementMode::vertex);
  mode("select.edges", "Edges", "2", icon::edge, ElementMode::edge);
  mode("select.faces", "Faces", "3", icon::face, ElementMode::face);
  mode("select.objects", "Objects", "4", icon::object, ElementMode::object);
  const WhyNot document = needs_document(editor);
  const auto conversion = [&](const char* id, const char* label, const char* keys, ElementMode value) {
    host.table.add({.id = id,
                    .menu = submenu("Select", translatable("Convert")),
                    .label = label,
                    .help = "Selects the elements of this kind that the selection consists of.",
                    .keys = keys,
                    .run = [&editor, value] { convert(editor, value); },
                    .why_not = document});
  };
  conversion("select.to_vertices", "To vertices", "Ctrl+1", ElementMode::vertex);
  conversion("select.to_edges", "To edges", "Ctrl+2", ElementMode::edge);
  conversion("select.to_faces", "To faces", "Ctrl+3", ElementMode::face);
  conversion("select.to_objects", "To objects", "Ctrl+4", ElementMode::object);
}

void select_all(Editor& editor) {
  if (editor.mode != ElementMode::object)
    return editor.selection.select_all(*editor.active_object(), editor.mode);
  for (const auto& object : editor.document().objects)
    if (object->visible) editor.selection.select({object->id, element_of(object->id)}, Selection::How::add);
}

void invert_selection(Editor& editor) {
  Selection& selection = editor.selection;
  if (editor.mode == ElementMode::object) {
    for (const auto& object : editor.document().objects) {
      const ElementRef ref{object->id, element_of(object->id)};
      if (object->visible)
        selection.select(ref, selection.contains(ref) ? Selection::How::remove : Selection::How::add);
    }
    return;
  }
  const auto inverted = [&](const PolyhedronSource& source, const ElementSelection& elements) {
    return invert(source.polyhedron, elements, kind_of(editor.mode));
  };
  // An object without a selection is inverted when it is the active one.
  const Object* active = editor.active_object();
  const bool alone = selection.of_active().empty();
  change_elements(selection, editor.document(), inverted);
  if (alone && active && active->polyhedron())
    selection.set(active->id, select_all(active->polyhedron()->polyhedron, kind_of(editor.mode)));
}

void add_wholes(CommandHost& host) {
  Editor& editor = host.editor;
  host.table.add({.id = "select.all",
                  .menu = "Select",
                  .label = "All",
                  .help = "Select every element of the active object, or every object.",
                  .keys = "Ctrl+A",
                  .separator_before = true,
                  .run = [&editor] { select_all(editor); },
                  .why_not = needs_object(editor)});
  host.table.add(
      {.id = "select.none",
       .menu = "Select",
       .label = "None",
       .help = "Select nothing.",
       .keys = "Ctrl+Shift+A",
       .run =
           [&editor] {
             if (editor.mode == ElementMode::object) editor.selection.clear_objects();
             editor.selection.clear_elements();
           },
       .why_not = only_if(
           [&editor] { return !editor.selection.no_elements() || !editor.selection.objects().empty(); },
           translatable("Nothing is selected."))});
  host.table.add({.id = "select.invert",
                  .menu = "Select",
                  .label = "Invert",
                  .help = "Select what is not selected.",
                  .keys = "Ctrl+Shift+I",
                  .run = [&editor] { invert_selection(editor); },
                  .why_not = needs_object(editor)});
}

/// The connected part under the pointer, else those that the selection touches.
void select_linked(Editor& editor) {
  const auto& hovered = editor.hovered;
  const Object* object = hovered ? editor.document().find(hovered->object) : nullptr;
  if (object && object->polyhedron() && editor.mode != ElementMode::object) {
    Selection one;
    one.select(*hovered, Selection::How::replace);
    editor.selection.select(object->id, linked(object->polyhedron()->polyhedron, one.of(object->id)),
                            Selection::How::add);
    editor.selection.active = object->id;
    return;
  }
  change_elements(editor.selection, editor.document(),
                  [](const PolyhedronSource& source, const ElementSelection& elements) {
                    return linked(source.polyhedron, elements);
                  });
}

ElementSelection paths(const Polyhedron& polyhedron, const ElementSelection& elements,
                       std::vector<EdgeId> (*path)(const Polyhedron&, EdgeId)) {
  ElementSelection result = elements;
  for (const EdgeId& edge : elements.edges) {
    const auto more = path(polyhedron, edge);
    result.edges.insert(more.begin(), more.end());
  }
  return result;
}

void add_growth(CommandHost& host) {
  Editor& editor = host.editor;
  const auto change = [&](const char* id, const char* label, const char* help, const char* keys,
                          NeededElements kinds, bool first, Change how) {
    host.table.add({.id = id,
                    .menu = "Select",
                    .label = label,
                    .help = help,
                    .keys = keys,
                    .separator_before = first,
                    .run = [&editor, how = std::move(
                                         how)] { change_elements(editor.selection, editor.document(), how); },
                    .why_not = needs_selected(editor, kinds)});
  };
  change("select.grow", "Grow", "Add the neighbours of the selection.", "Ctrl+Num + / Ctrl+=", any_kind, true,
         [](const auto& source, const auto& elements) { return grow(source.polyhedron, elements); });
  change("select.shrink", "Shrink", "Remove the rim of the selection.", "Ctrl+Num - / Ctrl+-", any_kind,
         false, [](const auto& source, const auto& elements) { return shrink(source.polyhedron, elements); });
  host.table.add({.id = "select.linked",
                  .menu = "Select",
                  .label = "Linked",
                  .help = "Add all that hangs together with what is under the pointer.",
                  .keys = "L",
                  .run = [&editor] { select_linked(editor); },
                  .why_not = [&editor]() -> Reason {
                    if (editor.hovered && editor.mode != ElementMode::object) return {};
                    return needs_selected(editor, any_kind)();
                  }});
  change("select.all_linked", "Linked to the selection", "Add all that hangs together with the selection.",
         "Ctrl+L", any_kind, false,
         [](const auto& source, const auto& elements) { return linked(source.polyhedron, elements); });
  change("select.loop", "Edge loop",
         "Add the edges in line with the selected ones. A double click does the same.", "Shift+L",
         {.edges = true}, true, [](const auto& source, const auto& elements) {
           return paths(source.polyhedron, elements, edge_loop);
         });
  change("select.ring", "Edge ring", "Add the edges side by side with the selected ones, from face to face.",
         "Ctrl+Shift+L", {.edges = true}, false, [](const auto& source, const auto& elements) {
           return paths(source.polyhedron, elements, edge_ring);
         });
  change("select.boundary", "Boundary of faces", "Select the edges round the selected faces.", "",
         {.faces = true}, false, [](const auto& source, const auto& elements) {
           return boundary_of_faces(source.polyhedron, elements);
         });
}

void add_similar(CommandHost& host) {
  Editor& editor = host.editor;
  const auto similar = [&](const char* id, const char* label, NeededElements kinds, Change how) {
    host.table.add({.id = id,
                    .menu = submenu("Select", translatable("Similar")),
                    .label = label,
                    .help = "Add the elements that resemble the selected ones in this.",
                    .run = [&editor, how = std::move(
                                         how)] { change_elements(editor.selection, editor.document(), how); },
                    .why_not = needs_selected(editor, kinds)});
  };
  const auto vertices = [&](const char* id, const char* label, VertexLikeness likeness) {
    similar(id, label, {.vertices = true}, [likeness](const auto& source, const auto& elements) {
      ElementSelection result = elements;
      result.vertices = similar_vertices(source, elements.vertices, likeness, similar_tolerance);
      return result;
    });
  };
  const auto edges = [&](const char* id, const char* label, EdgeLikeness likeness) {
    similar(id, label, {.edges = true}, [likeness](const auto& source, const auto& elements) {
      ElementSelection result = elements;
      result.edges = similar_edges(source, elements.edges, likeness, similar_tolerance);
      return result;
    });
  };
  const auto faces = [&](const char* id, const char* label, FaceLikeness likeness) {
    similar(id, label, {.faces = true}, [likeness](const auto& source, const auto& elements) {
      ElementSelection result = elements;
      result.faces = similar_faces(source, elements.faces, likeness, similar_tolerance);
      return result;
    });
  };
  vertices("select.similar_valence", "Vertices: valence", VertexLikeness::valence);
  vertices("select.similar_alpha", "Vertices: tension", VertexLikeness::tension);
  vertices("select.similar_place", "Vertices: inner or border", VertexLikeness::place);
  edges("select.similar_length", "Edges: length", EdgeLikeness::length);
  edges("select.similar_beta", "Edges: tension", EdgeLikeness::tension);
  edges("select.similar_crease", "Edges: crease", EdgeLikeness::crease);
  faces("select.similar_sides", "Faces: side count", FaceLikeness::side_count);
  faces("select.similar_area", "Faces: area", FaceLikeness::area);
  faces("select.similar_normal", "Faces: direction", FaceLikeness::normal);
}

void select_through(Editor& editor) {
  SelectSettings& selecting = editor.selecting;
  bool& through = editor.camera().orthographic ? selecting.through_parallel : selecting.through;
  through = !through;
}

void add_pointing(CommandHost& host) {
  Editor& editor = host.editor;
  Viewport& viewport = host.viewport;
  host.table.add({.id = "select.box",
                  .menu = "Select",
                  .label = "Box",
                  .help = "Drag a box, also over elements.",
                  .keys = "B",
                  .separator_before = true,
                  .needs_window = true,
                  .run = [&viewport] { viewport.start_modal(make_region_tool(true)); },
                  .why_not = needs_document(editor)});
  host.table.add(switching({.id = "select.lasso",
                            .menu = "Select",
                            .label = "Lasso",
                            .help = "Drags that begin beside elements draw a lasso; once more for boxes.",
                            .keys = "Q",
                            .icon = icon::lasso},
                           editor.selecting.lasso));
  host.table.add(
      {.id = "select.through",
       .menu = "Select",
       .label = "Select through",
       .help = "Also select what is hidden. In parallel views boxes and lassos do so from the start.",
       .keys = "Shift+Q",
       .run = [&editor] { select_through(editor); },
       .checked = [&editor] { return editor.selecting.regions_through(editor.camera().orthographic); }});
}

}  // namespace

void add_select_commands(CommandHost& host) {
  add_modes(host);
  add_wholes(host);
  add_growth(host);
  add_similar(host);
  add_pointing(host);
}

}  // namespace hariko
