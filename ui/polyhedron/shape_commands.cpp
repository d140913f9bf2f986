// Commands that set what shapes the surface: tensions, creases, tags, pins.

#include <algorithm>
#include <memory>

#include "core/document/edits/edits.hpp"
#include "core/modeling/objects/edit_modeling.hpp"
#include "core/modeling/surfacing/local_edit.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/polyhedron/tension_tool.hpp"
#include "ui/view/viewport.hpp"

namespace hariko {

namespace {

std::vector<VertexId> vertices_of(const ElementSelection& elements) {
  return {elements.vertices.begin(), elements.vertices.end()};
}

std::vector<EdgeId> edges_of(const ElementSelection& elements) {
  return {elements.edges.begin(), elements.edges.end()};
}

using ShapeObject = std::function<Result<Document>(const Document&, const Object&, const ElementSelection&)>;

/// Applies an edit to every polyhedron with a selection, as one step.
void edit_selected(Editor& editor, const std::string& label, const ShapeObject& edit) {
  Result<Document> result = editor.history.current();
  for (const auto& [id, elements] : editor.selection.elements()) {
    const Object* object = result ? result->find(id) : nullptr;
    if (object && object->visible && object->polyhedron()) result = edit(*result, *object, elements);
  }
  editor.commit(result, label);
}

/// Whether all selected elements, of whatever object, have something.
template <class Has>
bool all_selected(const Editor& editor, Has&& has) {
  for (const auto& [id, elements] : editor.selection.elements()) {
    const Object* object = editor.document().find(id);
    if (object && object->polyhedron() && !has(*object->polyhedron()->shaping, elements)) return false;
  }
  return true;
}

WhyNot needs_shapeable(const Editor& editor, NeededElements kinds) {
  return [&editor, kinds]() -> Reason {
    if (auto reason = needs_document(editor)()) return reason;
    bool others = false;
    for (const auto& [id, elements] : editor.selection.elements()) {
      const Object* object = editor.document().find(id);
      if (!object ||
          !((kinds.vertices && !elements.vertices.empty()) || (kinds.edges && !elements.edges.empty())))
        continue;
      if (object->polyhedron()) return {};
      others = true;
    }
    if (others) return translatable("Only polyhedra have tensions, creases, corners and pins.");
    if (kinds.vertices && kinds.edges) return translatable("Nothing is selected. Click a vertex or an edge.");
    if (kinds.vertices) return translatable("No vertices are selected. Press 1 and click one.");
    return translatable("No edges are selected. Press 2 and click one.");
  };
}

/// The tensions of the active object's first selected vertex and edge.
struct CopiedTension {
  std::optional<double> alpha, beta;
};

constexpr CopiedTension neutral_tension{0, 1};

Result<Document> with_tension(const Document& document, const Object& object,
                              const ElementSelection& elements, const CopiedTension& tension) {
  Result<Document> result = document;
  if (tension.alpha && !elements.vertices.empty())
    result = set_alpha(*result, object.id, vertices_of(elements), *tension.alpha);
  if (result && tension.beta && !elements.edges.empty())
    result = set_beta(*result, object.id, edges_of(elements), *tension.beta);
  return result;
}

void give_tension(Editor& editor, const char* step, const CopiedTension& tension) {
  edit_selected(editor, step, [&](const auto& document, const auto& object, const auto& elements) {
    return with_tension(document, object, elements, tension);
  });
}

/// Numbers in the place of a drag; those that are missing stay as they are.
ScriptUse tension_in_scripts(Editor& editor) {
  return {.arguments = {optional(number_argument("alpha", translatable("Tension \u03b1"), {}, 0, max_alpha)),
                        optional(
                            number_argument("beta", translatable("Tension \u03b2"), {}, min_beta, max_beta))},
          .run = [&editor](const Arguments& given) {
            CopiedTension tension;
            if (given.has("alpha")) tension.alpha = given.number("alpha");
            if (given.has("beta")) tension.beta = given.number("beta");
            if (!tension.alpha && !tension.beta)
              return editor.notify(make_error(e_argument, "\"alpha\" or \"beta\" is needed.",
                                              "`hariko run --list` says what each command takes."));
            give_tension(editor, "Tension", tension);
          }};
}

CopiedTension tension_of_selection(const Editor& editor) {
  CopiedTension copied;
  const Object* object = editor.active_object();
  if (!object || !object->polyhedron()) return copied;
  const Shaping& shaping = *object->polyhedron()->shaping;
  const ElementSelection& elements = editor.selection.of_active();
  if (!elements.vertices.empty()) copied.alpha = shaping.alpha.get_or(*elements.vertices.begin(), 0);
  if (!elements.edges.empty()) copied.beta = shaping.beta.get_or(*elements.edges.begin(), 1);
  return copied;
}

void add_tensions(CommandHost& host) {
  Editor& editor = host.editor;
  Viewport& viewport = host.viewport;
  const WhyNot selected = needs_shapeable(editor, {.vertices = true, .edges = true});
  host.table.add({.id = "shape.tension",
                  .menu = "Shape",
                  .label = "Tension",
                  .help = "Drag to the side: more or less tension of the selected vertices and edges.",
                  .keys = "T",
                  .changes_document = true,
                  .needs_window = true,
                  .run = [&viewport] { viewport.start_modal(std::make_unique<TensionTool>()); },
                  .why_not = selected,
                  .script = tension_in_scripts(editor)});
  host.table.add({.id = "shape.reset_tension",
                  .menu = "Shape",
                  .label = "Reset tension",
                  .help = "Set \u03b1 of the selection to 0 and \u03b2 to 1.",
                  .keys = "Shift+T",
                  .changes_document = true,
                  .run = [&editor] { give_tension(editor, "Reset tension", neutral_tension); },
                  .why_not = selected});
  const auto preset = [&](const char* id, const char* label, const char* help, CopiedTension value) {
    host.table.add({.id = id,
                    .menu = submenu("Shape", translatable("Tension presets")),
                    .label = label,
                    .help = help,
                    .changes_document = true,
                    .run = [&editor, label, value] { give_tension(editor, label, value); },
                    .why_not = selected});
  };
  preset("shape.preset_relaxed", "Relaxed", "\u03b1 0, \u03b2 0.2: round.", {0, 0.2});
  preset("shape.preset_neutral", "Neutral", "\u03b1 0, \u03b2 1: the default.", neutral_tension);
  preset("shape.preset_soft", "Soft", "\u03b1 1, \u03b2 2: a little tighter.", {1, 2});
  preset("shape.preset_tight", "Tight", "\u03b1 10, \u03b2 10: close to the polyhedron.", {10, 10});
  preset("shape.preset_point", "Point", "\u03b1 100, \u03b2 100: almost sharp.", {100, 100});
}

void add_copied_tension(CommandHost& host) {
  Editor& editor = host.editor;
  const auto copied = std::make_shared<CopiedTension>();
  host.table.add({.id = "shape.copy_tension",
                  .menu = "Shape",
                  .label = "Copy tension",
                  .help = "Remember the tension of the selected vertex or edge.",
                  .keys = "Ctrl+Shift+C",
                  .run = [&editor, copied] { *copied = tension_of_selection(editor); },
                  .why_not = needs_elements(editor, {.vertices = true, .edges = true})});
  host.table.add(
      {.id = "shape.paste_tension",
       .menu = "Shape",
       .label = "Paste tension",
       .help = "Give the selection the tension that was copied.",
       .keys = "Ctrl+Shift+V",
       .changes_document = true,
       .run = [&editor, copied] { give_tension(editor, "Paste tension", *copied); },
       .why_not = only_if(
           needs_shapeable(editor, {.vertices = true, .edges = true}),
           [copied] { return copied->alpha || copied->beta; },
           translatable("No tension was copied. Select a vertex or an edge and copy its tension."))});
}

/// Visible objects whose surfaces know frames.
template <class Visit>
void for_framed(const Document& document, const Visit& visit) {
  for (const auto& object : document.objects) {
    const auto frames = surface_frames(object->source);
    if (frames && object->visible && !object->locked) visit(*object, *frames);
  }
}

void switch_frames(Editor& editor) {
  bool all = true;
  for_framed(editor.history.current(),
             [&](const Object&, Frames frames) { all = all && frames == Frames::metric; });
  Result<Document> result = editor.history.current();
  for_framed(editor.history.current(), [&](const Object& object, Frames) {
    if (result.ok()) result = set_frames(*result, object.id, all ? Frames::equal : Frames::metric);
  });
  editor.commit(result, all ? "Surfaces by equal angles" : "Surfaces by measure");
}

bool any_framed(const Document& document) {
  bool any = false;
  for_framed(document, [&](const Object&, Frames) { any = true; });
  return any;
}

void add_frames(CommandHost& host) {
  Editor& editor = host.editor;
  host.table.add(
      {.id = "shape.by_measure",
       .menu = "Shape",
       .label = "Surfaces by measure",
       .help =
           "All visible surfaces of polyhedra and outlines follow angles and lengths, or equal angles again.",
       .changes_document = true,
       .run = [&editor] { switch_frames(editor); },
       .why_not = only_if(
           needs_document(editor), [&editor] { return any_framed(editor.history.current()); },
           translatable("Nothing visible has a surface that angles and lengths could count for."))});
}

void crease_edges(Editor& editor, bool crease) {
  edit_selected(editor, crease ? "Crease edges" : "Smooth edges",
                [crease](const auto& document, const auto& object, const auto& elements) {
                  return set_crease(document, object.id, edges_of(elements), crease);
                });
}

void switch_crease(Editor& editor) {
  crease_edges(editor, !all_selected(editor, [](const Shaping& shaping, const ElementSelection& elements) {
                 return std::all_of(elements.edges.begin(), elements.edges.end(),
                                    [&](const EdgeId& id) { return shaping.crease.contains(id); });
               }));
}

void tag_vertices(Editor& editor, VertexTag tag, const char* step) {
  edit_selected(editor, tag == VertexTag::automatic ? "Automatic vertices" : step,
                [&](const auto& document, const auto& object, const auto& elements) {
                  return set_vertex_tag(document, object.id, vertices_of(elements), tag);
                });
}

void switch_tag(Editor& editor, VertexTag tag, const char* step) {
  const bool all = all_selected(editor, [&](const Shaping& shaping, const ElementSelection& elements) {
    return std::all_of(elements.vertices.begin(), elements.vertices.end(), [&](VertexId vertex) {
      return shaping.tag.get_or(vertex, VertexTag::automatic) == tag;
    });
  });
  tag_vertices(editor, all ? VertexTag::automatic : tag, step);
}

Result<Document> with_fixed_tangents(const Document& document, const Object& object,
                                     const ElementSelection& elements) {
  const auto fixed =
      edit_polyhedron(document, object.id, [&](const PolyhedronSource& source) -> Result<EditResult> {
        auto frozen = freeze_tangents(source, vertices_of(elements));
        if (!frozen) return frozen.error();
        return EditResult{std::move(frozen).value(), {}};
      });
  if (!fixed) return fixed.error();
  return fixed->document;
}

Result<Document> without_pins(const Document& document, const Object& object,
                              const ElementSelection& elements) {
  return clear_pins(document, object.id, vertices_of(elements));
}

bool any_pinned(const Editor& editor) {
  for (const auto& [id, elements] : editor.selection.elements()) {
    const Object* object = editor.document().find(id);
    if (!object || !object->polyhedron()) continue;
    const Shaping& shaping = *object->polyhedron()->shaping;
    for (const VertexId vertex : elements.vertices)
      if (shaping.pin.contains(vertex) || shaping.form.contains(vertex)) return true;
  }
  return false;
}

void add_tags(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot vertices = needs_shapeable(editor, {.vertices = true});
  table.add({.id = "shape.crease",
             .menu = "Shape",
             .label = "Crease edges",
             .help = "Make the selected edges sharp, or smooth again.",
             .keys = "C",
             .changes_document = true,
             .separator_before = true,
             .run = [&editor] { switch_crease(editor); },
             .why_not = needs_shapeable(editor, {.edges = true}),
             .script = {.arguments = {on_off_argument("on", translatable("Crease"), true)},
                        .run = [&editor](const Arguments& given) { crease_edges(editor, given.on("on")); }}});
  const auto tag = [&](const char* id, const char* label, const char* help, const char* keys,
                       VertexTag value) {
    table.add({.id = id,
               .menu = "Shape",
               .label = label,
               .help = help,
               .keys = keys,
               .changes_document = true,
               .run = [&editor, value, label] { switch_tag(editor, value, label); },
               .why_not = vertices,
               .script = {.arguments = {on_off_argument("on", label, true)},
                          .run = [&editor, value, label](const Arguments& given) {
                            tag_vertices(editor, given.on("on") ? value : VertexTag::automatic, label);
                          }}});
  };
  tag("shape.corner", "Corner vertices", "Tag the selected vertices as corners, or no longer.", "Shift+C",
      VertexTag::corner);
  tag("shape.smooth_ends", "Smooth ends",
      "Creases and borders run through the selected vertices smoothly, or no longer.", "Alt+Shift+C",
      VertexTag::smooth);
  table.add({.id = "shape.fix_tangents",
             .menu = "Shape",
             .label = "Fix tangents",
             .help = "Pin the tangents of the selected vertices as they are now.",
             .changes_document = true,
             .run = [&editor] { edit_selected(editor, "Fix tangents", with_fixed_tangents); },
             .why_not = vertices});
  table.add({.id = "shape.release_pins",
             .menu = "Shape",
             .label = "Release pins",
             .help = "Free the pinned tangents of the selected vertices.",
             .keys = "Shift+P",
             .changes_document = true,
             .run = [&editor] { edit_selected(editor, "Release pins", without_pins); },
             .why_not = only_if(
                 vertices, [&editor] { return any_pinned(editor); },
                 translatable("None of the selected vertices is pinned."))});
}

}  // namespace

void add_shape_commands(CommandHost& host) {
  add_tensions(host);
  add_copied_tension(host);
  add_tags(host);
  add_frames(host);
}

}  // namespace hariko
