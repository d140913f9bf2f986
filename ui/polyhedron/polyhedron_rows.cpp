#include "ui/polyhedron/polyhedron_rows.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/document/edits/edits.hpp"
#include "core/document/words.hpp"
#include "core/polyhedron/validation.hpp"
#include "ui/editor/outlines.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/script_edits.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

/// Modes as the list has them, with their steps.
constexpr std::array modes{std::pair(Mode::fair, "Surface Fair"), std::pair(Mode::g2, "Surface G2"),
                           std::pair(Mode::target, "Surface Local"),
                           std::pair(Mode::paper, "Surface as published")};
constexpr std::array mirror_choices{
    Choice{"None", "All of the object is modelled"},
    Choice{"Across X", "The plane x = 0 of the object"},
    Choice{"Across Y", "The plane y = 0 of the object"},
    Choice{"Across Z", "The plane z = 0 of the object"},
};

}  // namespace

void polyhedron_mode_row(PanelContext& context, const Objects& objects) {
  const Objects polyhedra = objects_where(objects, &Object::polyhedron);
  if (polyhedra.empty()) return;
  const auto mode = common<Mode>(polyhedra, [](const auto& object) { return object->polyhedron()->mode; });
  std::array<Choice, modes.size()> choices{};
  int current = -1;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    choices[i] = enum_choice(modes[i].first);
    if (mode == modes[i].first) current = static_cast<int>(i);
  }
  const auto chosen =
      choose(context, "mode", "Surface", "How the surface spans the curves", choices, current);
  if (!chosen) return;
  const auto& [wanted, step] = modes[static_cast<std::size_t>(*chosen)];
  Result<Document> result = context.editor.history.current();
  for (const auto& object : polyhedra)
    if (result.ok()) result = set_mode(*result, object->id, wanted);
  context.editor.commit(result, step);
}

void live_mirror_row(PanelContext& context, const Objects& objects) {
  const Objects polyhedra = objects_where(objects, &Object::polyhedron);
  if (polyhedra.empty()) return;
  Editor& editor = context.editor;
  const auto axis = common<int>(polyhedra, [](const auto& object) {
    const auto& mirror = object->polyhedron()->mirror;
    return mirror ? static_cast<int>(mirror->axis) + 1 : 0;
  });
  const auto chosen =
      choose(context, "mirror", "Mirror", "Model one half; its image completes the object at once.",
             mirror_choices, axis.value_or(-1));
  // Commands act on the active object: on each in its turn.
  const auto each = [&](const auto& run) {
    const ObjectId active = editor.selection.active;
    for (const auto& object : polyhedra) {
      editor.selection.active = object->id;
      run(*object);
    }
    editor.selection.active = active;
  };
  constexpr std::array commands{"mirror.live_x", "mirror.live_y", "mirror.live_z"};
  if (chosen && chosen != axis)
    each([&](const Object& object) {
      const auto& mirror = object.polyhedron()->mirror;
      const int current = mirror ? static_cast<int>(mirror->axis) + 1 : 0;
      // The command of the present axis ends the mirror.
      if (*chosen != current)
        context.run(commands[static_cast<std::size_t>(*chosen == 0 ? current : *chosen) - 1]);
    });
  if (std::ranges::none_of(polyhedra,
                           [](const auto& object) { return object->polyhedron()->mirror.has_value(); }))
    return;
  row_label(context, "", "");
  if (row_button(context, "apply_mirror", "Apply live mirror", "Make both halves the object's own."))
    each([&](const Object& object) {
      if (object.polyhedron()->mirror) context.run("mirror.apply");
    });
}

void tension_hint(PanelContext& context, const Object& object) {
  if (!object.polyhedron()) return;
  heading(context, "Selection");
  hint_text(context, "Click a vertex or an edge to set its tension. Keys 1 2 3 choose what a click takes.");
}

namespace {

bool row_of_polyhedron(const Editor& editor) {
  return editor.active_object()->polyhedron() != nullptr;
}
bool row_of_modes(const Editor& editor) {
  return std::ranges::any_of(chosen_objects(editor),
                             [](const auto& object) { return object->polyhedron() != nullptr; });
}
bool row_of_frames(const Editor& editor) {
  return std::ranges::any_of(chosen_objects(editor),
                             [](const auto& object) { return surface_frames(object->source).has_value(); });
}
bool row_of_vertices(const Editor& editor) {
  return row_of_polyhedron(editor) && !editor.selection.of_active().vertices.empty();
}
bool row_of_edges(const Editor& editor) {
  return row_of_polyhedron(editor) && !editor.selection.of_active().edges.empty();
}
bool row_of_points(const Editor& editor) {
  const Object* outline = active_outline(editor);
  return outline && !selected_points(editor, *outline).empty();
}
bool row_of_position(const Editor& editor) {
  return row_of_vertices(editor) || row_of_points(editor);
}

/// Whether a selected edge is joined to a patch as is asked for.
template <class Test>
bool any_joined_edge(const Editor& editor, const Test& test) {
  const auto& selected = editor.selection.of_active().edges;
  if (!row_of_edges(editor)) return false;
  const Attachments& attachments = *editor.active_object()->polyhedron()->attachments;
  return std::ranges::any_of(attachments, [&](const auto& joined) {
    return selected.contains(joined.first) && test(joined.second);
  });
}
bool row_of_joined_edges(const Editor& editor) {
  return any_joined_edge(editor, [](const Attachment&) { return true; });
}
bool row_of_adapting_edges(const Editor& editor) {
  return any_joined_edge(
      editor, [](const Attachment& joined) { return !joined.frozen && joined.continuity == Continuity::g1; });
}

constexpr const char* no_vertices = translatable("No vertices are selected. Press 1 and click one.");
constexpr const char* no_edges = translatable("No edges are selected. Press 2 and click one.");
constexpr const char* no_joined_edges =
    translatable("No selected edge is joined to a patch. Join one: Shape > Attach to patch side.");
constexpr const char* no_positions = translatable("No points are selected. Press 1 and click one.");

constexpr std::array polyhedron_rows{
    PanelRow{"mode", "Surface", "How the surface spans the curves", "Polyhedron", row_of_modes},
    PanelRow{"frames", "By measure",
             "Angles and lengths of the polyhedron count: uneven cages give even surfaces", "Polyhedron",
             row_of_frames},
    PanelRow{"mirror", "Mirror", "Model one half; its image completes the object at once.", "Polyhedron",
             row_of_polyhedron},
    PanelRow{"alpha", "Tension \u03b1",
             "Pulls the curves to the vertex: 0 is relaxed, from 10 on it looks like a point", "Polyhedron",
             row_of_vertices, no_vertices},
    PanelRow{"tag", "Corner", "How creases and the border pass the vertex", "Polyhedron", row_of_vertices,
             no_vertices},
    PanelRow{"x", "Position", "Coordinates of the vertex, in the object's own axes", "Polyhedron",
             row_of_position, no_positions},
    PanelRow{"beta", "Tension \u03b2",
             "Stretches the curve along the edge: 1 is neutral, 10 is nearly straight", "Polyhedron",
             row_of_edges, no_edges},
    PanelRow{"crease", "Crease", "The surface has a sharp edge here", "Polyhedron", row_of_edges, no_edges},
    PanelRow{"join", "Joint", "How the edge meets the side of the patch that it is attached to", "Polyhedron",
             row_of_joined_edges, no_joined_edges},
    PanelRow{"adapts", "Adapts", "Who gives way where the two meet", "Polyhedron", row_of_adapting_edges,
             no_joined_edges},
};

SymmetryPlane plane_of(const std::optional<Mirror>& mirror) {
  return mirror ? static_cast<SymmetryPlane>(static_cast<int>(mirror->axis) + 1) : SymmetryPlane::none;
}

/// The mirror of the active polyhedron is a matter of commands, which cut it in half.
void add_mirror(CommandTable& table, Editor& editor) {
  ScriptUse use;
  use.arguments = {one_of<SymmetryPlane>()};
  use.read = [](const Object& object) {
    if (!object.polyhedron()) return WrittenArguments();
    const auto& mirror = object.polyhedron()->mirror;
    return word_now(plane_of(mirror));
  };
  use.run = [&table, &editor](const Arguments& given) {
    const auto& mirror = editor.active_object()->polyhedron()->mirror;
    const SymmetryPlane now = plane_of(mirror), wanted = chosen_of<SymmetryPlane>(given);
    // The command of the present axis ends the mirror.
    if (wanted != now)
      table.run("mirror.live_" + std::string(enum_word(wanted == SymmetryPlane::none ? now : wanted)));
  };
  table.use_in_scripts("property.mirror", std::move(use));
}

}  // namespace

std::vector<PanelRow> polyhedron_panel_rows() {
  return {polyhedron_rows.begin(), polyhedron_rows.end()};
}

void add_polyhedron_scripts(PropertyScripts& scripts, CommandTable& table, Editor& editor) {
  scripts.add(
      "mode", {one_of<Mode>()}, "Surface",
      [](const Document& document, const Object& object, const Arguments& given) -> Result<Document> {
        return object.polyhedron() ? set_mode(document, object.id, chosen_of<Mode>(given)) : document;
      },
      [](const Object& object) {
        return object.polyhedron() ? word_now(object.polyhedron()->mode) : WrittenArguments();
      });
  add_mirror(table, editor);
}

namespace {

const Preparation* preparation_of_object(const Object& object) {
  return object.polyhedron() ? &object.polyhedron()->preparation : nullptr;
}

constexpr std::array all_preparation_properties{
    member_property<&Preparation::split_concave>(switch_row(
        "split_concave", "Convex faces", "The surface is made as if concave faces were cut into convex ones",
        "Split concave faces", "Keep concave faces")),
    member_property<&Preparation::merge_coplanar>(switch_row(
        "merge_coplanar", "Merge flat", "The surface is made as if triangles in one plane were one face",
        "Merge flat triangles", "Keep flat triangles")),
    member_property<&Preparation::automatic_tension>(
        {"automatic_tension", "Auto tension",
         "Stretches short edges and relaxes long ones; at rest while you drag", "Automatic tension",
         linear_range(0, 1, 0, 2, 0.05)}),
};

}  // namespace

ObjectProperties<Preparation> preparation_properties() {
  return {whole_part<Preparation, &preparation_of_object, &set_preparation>(), all_preparation_properties};
}

void draw_concave_fix(PanelContext& context, const Object& object, const std::vector<Message>& warnings) {
  if (!object.polyhedron() || object.locked) return;
  if (std::ranges::find(warnings, w_concave_face, &Message::code) == warnings.end()) return;
  if (!row_button(context, "split_concave", "Split concave faces in the surface", "")) return;
  Preparation preparation = object.polyhedron()->preparation;
  preparation.split_concave = true;
  context.editor.commit(set_preparation(context.editor.history.current(), object.id, preparation),
                        "Split concave faces");
}

}  // namespace hariko
