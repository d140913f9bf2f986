// Commands that choose elements and objects.

#include "core/modeling/selection/edge_paths.hpp"
#include "core/modeling/selection/select_region.hpp"
#include "core/modeling/selection/select_similar.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/operations.hpp"
#include "ui/view/command_scripts.hpp"
#include "ui/view/region_tool.hpp"
#include "ui/view/viewport.hpp"

namespace hariko {

namespace {

constexpr double similar_tolerance = 0.01;

/// Something of the kinds asked for is selected, of an object whose elements the change can do something to,
/// and elements are what is being selected.
WhyNot needs_selected(const Editor& editor, NeededElements kinds, const ElementChange& change) {
  return [&editor, kinds, why_not = change.why_not]() -> Reason {
    if (auto reason = needs_document(editor)()) return reason;
    if (editor.mode == ElementMode::object)
      return translatable("Objects are being selected. Press 1, 2 or 3 for their elements.");
    const char* reason = kinds.missing();
    for (const auto& [id, elements] : editor.selection.elements()) {
      const Object* object = editor.document().find(id);
      if (!object || !kinds.among(elements)) continue;
      const char* fault = why_not(*object);
      if (!fault) return {};
      reason = fault;
    }
    return reason;
  };
}

constexpr NeededElements any_kind{.vertices = true, .edges = true, .faces = true};

/// The active object has elements of the mode, or objects are being selected.
WhyNot needs_elements_of_mode(const Editor& editor) {
  return only_if(
      needs_object(editor),
      [&editor] {
        return editor.mode == ElementMode::object ||
               object_kind(*editor.active_object()).has_elements(editor.mode);
      },
      translatable("The chosen object has nothing to select in this mode. Press 1 for points, 4 for "
                   "objects."));
}

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
    MenuRows(host.table, "Select")
        .add(id, label, "What a click takes.", [&editor, value] { change_mode(editor, value); }, {},
             {.keys = keys,
              .icon = symbol,
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
    MenuRows(host.table, submenu("Select", translatable("Convert")))
        .add(id, label, "Selects the elements of this kind that the selection consists of.",
             [&editor, value] { convert(editor, value); }, document, {.keys = keys});
  };
  conversion("select.to_vertices", "To vertices", "Ctrl+1", ElementMode::vertex);
  conversion("select.to_edges", "To edges", "Ctrl+2", ElementMode::edge);
  conversion("select.to_faces", "To faces", "Ctrl+3", ElementMode::face);
  conversion("select.to_objects", "To objects", "Ctrl+4", ElementMode::object);
}

/// Whether an object can be selected as a whole.
bool is_free(const Object& object) {
  return object.visible && !object.locked;
}

void select_all(Editor& editor) {
  if (editor.mode != ElementMode::object)
    return editor.selection.select_all(*editor.active_object(), editor.mode);
  for (const auto& object : editor.document().objects)
    if (is_free(*object)) editor.selection.select({object->id, element_of(object->id)}, Selection::How::add);
}

void invert_selection(Editor& editor) {
  Selection& selection = editor.selection;
  if (editor.mode == ElementMode::object) {
    for (const auto& object : editor.document().objects) {
      const ElementRef ref{object->id, element_of(object->id)};
      if (is_free(*object))
        selection.select(ref, selection.contains(ref) ? Selection::How::remove : Selection::How::add);
    }
    return;
  }
  invert_elements(editor);
}

void add_wholes(CommandHost& host) {
  Editor& editor = host.editor;
  MenuRows rows(host.table, "Select");
  rows.add("select.all", "All", "Select every element of the active object, or every object.",
           [&editor] { select_all(editor); }, needs_elements_of_mode(editor),
           {.keys = "Ctrl+A", .separator_before = true});
  rows.add(
      "select.none", "None", "Select nothing.",
      [&editor] {
        if (editor.mode == ElementMode::object) editor.selection.clear_objects();
        editor.selection.clear_elements();
      },
      only_if([&editor] { return !editor.selection.no_elements() || !editor.selection.objects().empty(); },
              translatable("Nothing is selected.")),
      {.keys = "Ctrl+Shift+A"});
  rows.add(
      "select.invert", "Invert", "Select what is not selected.", [&editor] { invert_selection(editor); },
      [&editor, all = needs_elements_of_mode(editor)] {
        return editor.selection.no_elements() ? all() : Reason();
      },
      {.keys = "Ctrl+Shift+I"});
}

/// All that hangs together with what is under the pointer, else with what is selected.
void select_linked(Editor& editor) {
  if (editor.hovered && editor.mode != ElementMode::object && select_linked_to(editor, *editor.hovered))
    return;
  change_elements(editor, by_links());
}

WhyNot needs_links(const Editor& editor) {
  return [&editor, selected = needs_selected(editor, any_kind, by_links())]() -> Reason {
    const bool elements = editor.hovered && editor.mode != ElementMode::object;
    const Object* under = elements ? editor.document().find(editor.hovered->object) : nullptr;
    const char* alone = under ? object_kind(*under).why_not_linked() : nullptr;
    if (under && !alone) return {};
    Reason reason = selected();
    if (reason && alone) reason = alone;
    return reason;
  };
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
  MenuRows rows(host.table, "Select");
  const auto change = [&](const char* id, const char* label, const char* help, const char* keys,
                          NeededElements kinds, const ElementChange& how) {
    rows.add(id, label, help, [&editor, how] { change_elements(editor, how); },
             needs_selected(editor, kinds, how), {.keys = keys});
  };
  rows.next_group();
  change("select.grow", "Grow", "Add the neighbours of the selection.", "Ctrl+Num + / Ctrl+=", any_kind,
         by_cage(grow));
  change("select.shrink", "Shrink", "Remove the rim of the selection.", "Ctrl+Num - / Ctrl+-", any_kind,
         by_cage(shrink));
  rows.add("select.linked", "Linked", "Add all that hangs together with what is under the pointer.",
           [&editor] { select_linked(editor); }, needs_links(editor), {.keys = "L"});
  change("select.all_linked", "Linked to the selection", "Add all that hangs together with the selection.",
         "Ctrl+L", any_kind, by_links());
  rows.next_group();
  change("select.loop", "Edge loop",
         "Add the edges in line with the selected ones. A double click does the same.", "Shift+L",
         {.edges = true},
         by_cage([](const auto& cage, const auto& elements) { return paths(cage, elements, edge_loop); }));
  change("select.ring", "Edge ring", "Add the edges side by side with the selected ones, from face to face.",
         "Ctrl+Shift+L", {.edges = true},
         by_cage([](const auto& cage, const auto& elements) { return paths(cage, elements, edge_ring); }));
  change("select.boundary", "Boundary of faces", "Select the edges round the selected faces.", "",
         {.faces = true}, by_cage(boundary_of_faces));
}

void add_similar(CommandHost& host) {
  Editor& editor = host.editor;
  const auto similar = [&](const char* id, const char* label, NeededElements kinds, auto alike) {
    const ElementChange how = by_polyhedron(std::move(alike));
    MenuRows(host.table, submenu("Select", translatable("Similar")))
        .add(
            id, label, "Add the elements that resemble the selected ones in this.",
            [&editor, how] { change_elements(editor, how); }, needs_selected(editor, kinds, how));
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
  MenuRows rows(host.table, "Select");
  rows.add("select.box", "Box", "Drag a box, also over elements.",
           [&viewport] { viewport.start_modal(make_region_tool(true)); }, needs_document(editor),
           {.keys = "B", .separator_before = true, .needs_window = true});
  rows.add_switch("select.lasso", "Lasso",
                  "Drags that begin beside elements draw a lasso; once more for boxes.",
                  editor.selecting.lasso, {.keys = "Q", .icon = icon::lasso});
  rows.add("select.through", "Select through",
           "Also select what is hidden. In parallel views boxes and lassos do so from the start.",
           [&editor] { select_through(editor); }, {},
           {.keys = "Shift+Q",
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
