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
      if (!object || !kinds.among(elements)) continue;
      if (object->polyhedron()) return {};
      others = true;
    }
    if (others) return translatable("Only polyhedra have tensions, creases, corners and pins.");
    return kinds.missing();
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
  MenuRows rows(host.table, "Shape");
  rows.add_edit("shape.tension", "Tension",
                "Drag to the side: more or less tension of the selected vertices and edges.",
                [&viewport] { viewport.start_modal(std::make_unique<TensionTool>()); }, selected,
                {.keys = "T", .needs_window = true, .script = tension_in_scripts(editor)});
  rows.add_edit("shape.reset_tension", "Reset tension", "Set \u03b1 of the selection to 0 and \u03b2 to 1.",
                [&editor] { give_tension(editor, "Reset tension", neutral_tension); }, selected,
                {.keys = "Shift+T"});
  const auto preset = [&](const char* id, const char* label, const char* help, CopiedTension value) {
    MenuRows(host.table, submenu("Shape", translatable("Tension presets")))
        .add_edit(
            id, label, help, [&editor, label, value] { give_tension(editor, label, value); }, selected);
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
  MenuRows rows(host.table, "Shape");
  rows.add("shape.copy_tension", "Copy tension", "Remember the tension of the selected vertex or edge.",
           [&editor, copied] { *copied = tension_of_selection(editor); },
           needs_elements(editor, {.vertices = true, .edges = true}), {.keys = "Ctrl+Shift+C"});
  rows.add_edit("shape.paste_tension", "Paste tension", "Give the selection the tension that was copied.",
                [&editor, copied] { give_tension(editor, "Paste tension", *copied); },
                only_if(
                    needs_shapeable(editor, {.vertices = true, .edges = true}),
                    [copied] { return copied->alpha || copied->beta; },
                    translatable("No tension was copied. Select a vertex or an edge and copy its tension.")),
                {.keys = "Ctrl+Shift+V"});
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
  MenuRows(host.table, "Shape")
      .add_edit(
          "shape.by_measure", "Surfaces by measure",
          "All visible surfaces of polyhedra and outlines follow angles and lengths, or equal angles again.",
          [&editor] { switch_frames(editor); },
          only_if(
              needs_document(editor), [&editor] { return any_framed(editor.history.current()); },
              translatable("Nothing visible has a surface that angles and lengths could count for.")));
}

void crease_edges(Editor& editor, bool crease) {
  edit_selected(editor, crease ? "Crease edges" : "Smooth edges",
                [crease](const auto& document, const auto& object, const auto& elements) {
                  return set_crease(document, object.id, edges_of(elements), crease);
                });
}

void switch_crease(Editor& editor) {
  crease_edges(editor, !all_selected(editor, [](const Shaping& shaping, const ElementSelection& elements) {
                 return std::ranges::all_of(elements.edges,
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
    return std::ranges::all_of(elements.vertices, [&](VertexId vertex) {
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
  Editor& editor = host.editor;
  const WhyNot vertices = needs_shapeable(editor, {.vertices = true});
  MenuRows rows(host.table, "Shape");
  rows.add_edit(
      "shape.crease", "Crease edges", "Make the selected edges sharp, or smooth again.",
      [&editor] { switch_crease(editor); }, needs_shapeable(editor, {.edges = true}),
      {.keys = "C",
       .separator_before = true,
       .script = {.arguments = {on_off_argument("on", translatable("Crease"), true)},
                  .run = [&editor](const Arguments& given) { crease_edges(editor, given.on("on")); }}});
  const auto tag = [&](const char* id, const char* label, const char* help, const char* keys,
                       VertexTag value) {
    rows.add_edit(id, label, help, [&editor, value, label] { switch_tag(editor, value, label); }, vertices,
                  {.keys = keys,
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
  rows.add_edit(
      "shape.fix_tangents", "Fix tangents", "Pin the tangents of the selected vertices as they are now.",
      [&editor] { edit_selected(editor, "Fix tangents", with_fixed_tangents); }, vertices);
  rows.add_edit("shape.release_pins", "Release pins", "Free the pinned tangents of the selected vertices.",
                [&editor] { edit_selected(editor, "Release pins", without_pins); },
                only_if(
                    vertices, [&editor] { return any_pinned(editor); },
                    translatable("None of the selected vertices is pinned.")),
                {.keys = "Shift+P"});
}

}  // namespace

void add_shape_commands(CommandHost& host) {
  add_tensions(host);
  add_copied_tension(host);
  add_tags(host);
  add_frames(host);
}

// Commands that say when surfaces follow the polyhedra.

void add_recompute_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  MenuRows rows(host.table, "Shape");
  rows.add("surface.recompute", "Recompute now", "Bring every surface up to date.",
           [&editor] { editor.recompute.wants_now = true; },
           only_if(
               document, [&editor] { return !editor.recompute.outdated.empty(); },
               translatable("Every surface is up to date or on its way.")),
           {.keys = "F5", .separator_before = true});
  rows.add(
      "surface.cancel", "Cancel computing", "Stop computing; the last surfaces stay until the next change.",
      [&editor] { editor.recompute.wants_cancel = true; },
      only_if(
          document, [&editor] { return !editor.stale_since.empty(); },
          translatable("Nothing is being computed.")));
  rows.next_group();
  const auto policy = [&](const char* id, const char* label, const char* help, RecomputePolicy value) {
    rows.add(id, label, help, [&editor, value] { editor.recompute.policy = value; }, document,
             {.checked = [&editor, value] { return editor.recompute.policy == value; }});
  };
  policy("surface.live", "Live", "Surfaces follow every change, also while dragging.", RecomputePolicy::live);
  policy("surface.on_release", "When released", "Surfaces follow when a drag ends.",
         RecomputePolicy::on_release);
  policy("surface.manual", "By hand", "Surfaces follow when Recompute now is chosen.",
         RecomputePolicy::manual);
}

}  // namespace hariko
