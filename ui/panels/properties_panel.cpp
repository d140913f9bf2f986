// Properties: what can be set on the active object and on its selected elements.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <vector>

#include "ui/icons.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/value_fields.hpp"

namespace hariko {

namespace {

/// The value that all elements have, or nothing when they differ.
template <class T, class Ids, class Get>
std::optional<T> common(const Ids& ids, const Get& get) {
  std::optional<T> value;
  for (const auto& id : ids) {
    const T own = get(id);
    if (value && !(*value == own)) return {};
    value = own;
  }
  return value;
}

std::string counted(const char* what, std::size_t count, const char* one, const char* many) {
  return std::string(what) + " of " + (count == 1 ? std::string(one) : std::to_string(count) + " " + many);
}

struct Choice {
  const char* label;
  const char* help;
};

/// A combo box; returns the new choice. `current` < 0 shows "mixed".
template <std::size_t N>
std::optional<int> choose(PanelContext& context, const char* id, const char* label, const char* help,
                          const std::array<Choice, N>& choices, int current) {
  row_label(context, label, help);
  std::optional<int> chosen;
  ImGui::SetNextItemWidth(-1);
  ImGui::PushID(id);
  const bool open =
      ImGui::BeginCombo("##combo", current < 0 ? "mixed" : choices[static_cast<std::size_t>(current)].label);
  context.marks.item(std::string("combo.") + id);
  if (open) {
    for (int i = 0; i < static_cast<int>(N); ++i) {
      const Choice& choice = choices[static_cast<std::size_t>(i)];
      if (ImGui::Selectable(choice.label, i == current)) chosen = i;
      context.marks.item("choice." + std::string(id) + "." + std::to_string(i));
      if (*choice.help && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", choice.help);
    }
    ImGui::EndCombo();
  }
  ImGui::PopID();
  return chosen;
}

constexpr std::array map_choices{
    Choice{"Shaded", "Studio light on clay"},
    Choice{"Patches", "One colour for each patch"},
    Choice{"Zebra", "Reflected stripes: a kink in a stripe shows a jump of curvature"},
    Choice{"Gaussian curvature", "Product of the principal curvatures: red dome, blue saddle"},
    Choice{"Mean curvature", "Mean of the principal curvatures"},
    Choice{"Greatest curvature", "The larger principal curvature k1"},
    Choice{"Least curvature", "The smaller principal curvature k2"},
    Choice{"Continuity", "How much curvature jumps across the edges"},
};
constexpr std::array mode_choices{
    Choice{"Fair", "Balances the curvature inside the faces: the smoothest result"},
    Choice{"Target", "Puts face centres where the boundary curves aim"},
    Choice{"Paper", "The construction as first published"},
};
constexpr std::array<Mode, 3> modes{Mode::fair, Mode::target, Mode::paper};
constexpr std::array tag_choices{
    Choice{"Automatic", "A corner where creases or the border demand it"},
    Choice{"Corner", "Every curve ends here with its own direction"},
    Choice{"Smooth", "Creases and the border run smoothly through"},
};

void object_name(PanelContext& context, const Object& object) {
  row_label(context, "Name", "");
  std::string name = object.name;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputText("##name", &name)) context.state.typed_text = name;
  if (ImGui::IsItemDeactivatedAfterEdit())
    context.editor.commit(
        rename_object(context.editor.history.current(), object.id, context.state.typed_text),
        "Rename object");
  context.marks.item("field.name");
}

void show_flag(PanelContext& context, const Object& object, const char* label, bool DisplaySettings::*flag) {
  bool on = object.display.*flag;
  if (ImGui::Checkbox(label, &on)) {
    DisplaySettings display = object.display;
    display.*flag = on;
    context.editor.commit(set_display(context.editor.history.current(), object.id, display),
                          std::string(on ? "Show " : "Hide ") + label);
  }
  context.marks.item(std::string("check.") + label);
}

void zebra_rows(PanelContext& context) {
  ZebraSettings& zebra = context.editor.view.zebra;
  row_label(context, "Stripes", "Number of dark stripes");
  ImGui::SetNextItemWidth(-1);
  ImGui::SliderInt("##stripes", &zebra.stripes, 2, 64);
  context.marks.item("slider.stripes");
  row_label(context, "Fixed", "Stripes stay on the object when the view turns");
  ImGui::Checkbox("##fixed", &zebra.fixed);
}

void object_section(PanelContext& context, const Object& object) {
  heading(context, "Object");
  object_name(context, object);
  if (!object.polyhedron()) {
    ImGui::TextDisabled("Reference mesh: shown as lines.");
    return;
  }
  Editor& editor = context.editor;
  const auto set = [&](const DisplaySettings& display, const std::string& step) {
    editor.commit(set_display(editor.history.current(), object.id, display), step);
  };
  DisplaySettings display = object.display;
  const int mode =
      static_cast<int>(std::find(modes.begin(), modes.end(), object.polyhedron()->mode) - modes.begin());
  if (const auto chosen =
          choose(context, "mode", "Surface", "How the surface spans the curves", mode_choices, mode))
    editor.commit(set_mode(editor.history.current(), object.id, modes[static_cast<std::size_t>(*chosen)]),
                  std::string("Surface ") + mode_choices[static_cast<std::size_t>(*chosen)].label);
  if (const auto chosen = choose(context, "map", "Map", "What colours the surface", map_choices,
                                 static_cast<int>(display.map))) {
    display.map = static_cast<SurfaceMap>(*chosen);
    set(display, std::string("Map ") + map_choices[static_cast<std::size_t>(*chosen)].label);
  }
  if (display.map == SurfaceMap::zebra) zebra_rows(context);
  const ObjectId id = object.id;
  value_slider(
      context,
      {"density", "Density", "Least intervals a patch side on the screen; small models are drawn finer",
       "Display density", DisplaySettings::min_density, DisplaySettings::max_density, false, true},
      display.density, [id](const Document& document, double value) -> Result<Document> {
        const Object* found = document.find(id);
        if (!found) return document;
        DisplaySettings changed = found->display;
        changed.density = static_cast<int>(value);
        return set_display(document, id, changed);
      });
  row_label(context, "Show", "");
  const float start = ImGui::GetCursorPosX();
  show_flag(context, object, "surface", &DisplaySettings::surface);
  ImGui::SetCursorPosX(start);
  show_flag(context, object, "network", &DisplaySettings::network);
  ImGui::SetCursorPosX(start);
  show_flag(context, object, "polyhedron", &DisplaySettings::polyhedron);
}

void position_row(PanelContext& context, const Object& object, VertexId vertex) {
  const PolyhedronSource& source = *object.polyhedron();
  const Vector3 position = source.origin + source.polyhedron.position(source.polyhedron.find(vertex));
  row_label(context, "Position", "Coordinates of the vertex, in the object's own axes");
  static constexpr std::array ids{"x", "y", "z"};
  const float spacing = context.metrics.px(4);
  const float width = (ImGui::GetContentRegionAvail().x - 2 * spacing) / 3;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) ImGui::SameLine(0, spacing);
    number_field(context, ids[static_cast<std::size_t>(axis)], position[axis], "%.4g", width, "Move vertex",
                 [&object, &source, vertex, axis, position](const Document& document, double value) {
                   Vector3 moved = position;
                   moved[axis] = value;
                   moved -= source.origin;
                   return move_vertices(document, object.id, {&vertex, 1}, {&moved, 1});
                 });
  }
}

void vertex_section(PanelContext& context, const Object& object, const std::vector<VertexId>& ids) {
  const Shaping& shaping = *object.polyhedron()->shaping;
  heading(context, ids.size() == 1 ? "Vertex" : (std::to_string(ids.size()) + " vertices").c_str());
  const auto alpha = common<double>(ids, [&](VertexId id) { return shaping.alpha.get_or(id, 0); });
  value_slider(context,
               {"alpha", "Tension \u03b1", "Pulls the curves to the vertex: 0 is relaxed, 10 makes a point",
                counted("Tension", ids.size(), "vertex", "vertices"), 0, max_alpha, true},
               alpha, [&object, ids](const Document& document, double value) {
                 return set_alpha(document, object.id, ids, value);
               });
  const auto tag =
      common<VertexTag>(ids, [&](VertexId id) { return shaping.tag.get_or(id, VertexTag::automatic); });
  if (const auto chosen = choose(context, "tag", "Corner", "How creases and the border pass the vertex",
                                 tag_choices, tag ? static_cast<int>(*tag) : -1))
    context.editor.commit(
        set_vertex_tag(context.editor.history.current(), object.id, ids, static_cast<VertexTag>(*chosen)),
        counted("Tag", ids.size(), "vertex", "vertices"));
  if (ids.size() == 1) position_row(context, object, ids.front());
}

void edge_section(PanelContext& context, const Object& object, const std::vector<EdgeId>& ids) {
  const Shaping& shaping = *object.polyhedron()->shaping;
  heading(context, ids.size() == 1 ? "Edge" : (std::to_string(ids.size()) + " edges").c_str());
  const auto beta = common<double>(ids, [&](const EdgeId& id) { return shaping.beta.get_or(id, 1); });
  value_slider(
      context,
      {"beta", "Tension \u03b2", "Stretches the curve along the edge: 1 is neutral, 10 is nearly straight",
       counted("Tension", ids.size(), "edge", "edges"), min_beta, max_beta, true},
      beta, [&object, ids](const Document& document, double value) {
        return set_beta(document, object.id, ids, value);
      });
  const auto crease = common<bool>(ids, [&](const EdgeId& id) { return shaping.crease.contains(id); });
  row_label(context, "Crease", "The surface has a sharp edge here");
  bool on = crease.value_or(false);
  if (ImGui::Checkbox(crease ? "##crease" : "mixed##crease", &on))
    context.editor.commit(set_crease(context.editor.history.current(), object.id, ids, on),
                          counted(on ? "Crease" : "Smooth", ids.size(), "edge", "edges"));
  context.marks.item("check.crease");
}

void message_list(PanelContext& context, const Object& object) {
  const SurfaceView* view = context.editor.view_of(object.id);
  if (!view) return;
  const auto line = [&](const Message& message) {
    const bool error = message.severity == Severity::error;
    {
      const TextColour colour(error ? palette().error : palette().warning);
      ImGui::TextUnformatted(error ? icon::error : icon::warning);
    }
    ImGui::SameLine();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(message.text.c_str());
    if (!message.remedy.empty()) ImGui::TextDisabled("%s", message.remedy.c_str());
    ImGui::PopTextWrapPos();
  };
  if (!view->error && view->warnings.empty()) return;
  heading(context, "Messages");
  if (view->error) line(*view->error);
  constexpr std::size_t most = 8;
  for (std::size_t i = 0; i < std::min(most, view->warnings.size()); ++i) line(view->warnings[i]);
  if (view->warnings.size() > most) ImGui::TextDisabled("and %zu more", view->warnings.size() - most);
}

}  // namespace

void draw_properties(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  if (begin_panel("Properties", rect, palette().panel, {m.px(12), m.px(8)})) {
    Editor& editor = context.editor;
    // Edits replace the document under the panel: what is drawn is this frame's value.
    const auto object = editor.document().find_shared(editor.selection.active);
    draw_last_operation(context);
    if (!object) {
      ImGui::TextDisabled("Nothing to set yet.");
    } else {
      object_section(context, *object);
      if (object->polyhedron()) {
        const ElementSelection selection = editor.selection.of(object->id);
        if (!selection.vertices.empty())
          vertex_section(context, *object, {selection.vertices.begin(), selection.vertices.end()});
        if (!selection.edges.empty())
          edge_section(context, *object, {selection.edges.begin(), selection.edges.end()});
        if (!selection.faces.empty()) {
          heading(context, selection.faces.size() == 1
                               ? "Face"
                               : (std::to_string(selection.faces.size()) + " faces").c_str());
          ImGui::TextDisabled("Drag to move.");
        }
        if (selection.empty()) {
          heading(context, "Selection");
          ImGui::PushTextWrapPos(0);
          ImGui::TextDisabled(
              "Click a vertex or an edge to set its tension. Keys 1 2 3 choose what a click takes.");
          ImGui::PopTextWrapPos();
        }
        message_list(context, *object);
      }
    }
  }
  ImGui::End();
}

}  // namespace hariko
