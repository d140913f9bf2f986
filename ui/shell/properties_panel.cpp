// Properties: what can be set on the document, on the chosen objects and on the selected elements.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/document/angles.hpp"
#include "core/document/convert_unit.hpp"
#include "ui/analysis/display_panel.hpp"
#include "ui/editor/object_size.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/measure/dimension_rows.hpp"
#include "ui/outline/outline_rows.hpp"
#include "ui/paper/paper_properties.hpp"
#include "ui/pictures/picture_rows.hpp"
#include "ui/polyhedron/element_rows.hpp"
#include "ui/polyhedron/patch_rows.hpp"
#include "ui/shell/copies_rows.hpp"
#include "ui/shell/message_list.hpp"
#include "ui/skin/skin_properties.hpp"
#include "ui/solids/solids_properties.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/tips.hpp"
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

// The document.

void document_section(PanelContext& context) {
  Editor& editor = context.editor;
  heading(context, "Document");
  const Unit current = editor.document().unit;
  row_label(context, "Unit", "The unit of all lengths of the document");
  ImGui::SetNextItemWidth(-1);
  const bool open = ImGui::BeginCombo("##unit", context.tr(enum_choice(current).label));
  context.marks.item("combo.unit");
  if (!open) return;
  const auto offers = [&](const char* title, const char* id, const char* step, bool converts) {
    heading(context, title);
    for (const Unit unit : enum_values<Unit>()) {
      if (unit == current) continue;
      ImGui::PushID(2 * static_cast<int>(unit) + converts);
      if (ImGui::Selectable(context.tr(enum_choice(unit).label))) {
        const Document& document = editor.history.current();
        editor.commit(converts ? convert_unit(document, unit) : Result<Document>(set_unit(document, unit)),
                      step);
      }
      context.marks.item(std::string("unit.") + id + "." + std::string(to_string(unit)));
      ImGui::PopID();
    }
  };
  offers("Convert the numbers, keep the size", "convert", "Convert unit", true);
  offers("Keep the numbers, change the size", "keep", "Change unit", false);
  ImGui::EndCombo();
}

// Objects.

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

/// Changes the transforms of all objects, one after the other.
Result<Document> edit_transforms(const Document& document, const Objects& objects,
                                 const std::function<void(Similarity&)>& change) {
  Document result = document;
  for (const auto& object : objects) {
    const Object* found = result.find(object->id);
    if (!found) continue;
    Similarity transform = found->transform;
    change(transform);
    auto changed = set_transform(result, object->id, transform);
    if (!changed.ok()) return changed.error();
    result = std::move(changed).value();
  }
  return result;
}

template <class Get>
std::array<std::optional<double>, 3> common_axes(const Objects& objects, const Get& get) {
  std::array<std::optional<double>, 3> out;
  for (int axis = 0; axis < 3; ++axis)
    out[static_cast<std::size_t>(axis)] =
        common<double>(objects, [&](const auto& object) { return get(*object)[axis]; });
  return out;
}

void transform_rows(PanelContext& context, const Objects& objects) {
  Quantity length = length_quantity(context.editor.document().unit, model_size(context.editor));
  length.standard = 0;
  vector_row(context, "Location", "Where the object's own zero stands in the document",
             axis_specs({"location.x", "location.y", "location.z"}, "Place object", length),
             common_axes(objects, [](const Object& object) { return object.transform.translation; }),
             [objects, length](const Document& document, int axis, const ValueChange& change) {
               return edit_transforms(document, objects, [&](Similarity& transform) {
                 transform.translation[axis] = change.apply(length, transform.translation[axis]);
               });
             });
  const Quantity angle = angle_quantity();
  vector_row(context, "Rotation", "About the x axis first, then y, then z",
             axis_specs({"rotation.x", "rotation.y", "rotation.z"}, "Rotate object", angle),
             common_axes(objects, [](const Object& object) { return angles_of(object.transform.rotation); }),
             [objects, angle](const Document& document, int axis, const ValueChange& change) {
               return edit_transforms(document, objects, [&](Similarity& transform) {
                 Vector3 angles = angles_of(transform.rotation);
                 angles[axis] = change.apply(angle, angles[axis]);
                 transform.rotation = rotation_of(angles);
               });
             });
  Quantity scale = plain_quantity(4, 0.1);
  scale.multiplies = true;
  scale.low = Similarity::min_scale;
  scale.high = Similarity::max_scale;
  scale.standard = 1;
  value_row(context,
            {"scale", "Scale", "The same along all axes: surfaces keep their shape", "Scale object", scale},
            common<double>(objects, [](const auto& object) { return object->transform.scale; }),
            [objects, scale](const Document& document, const ValueChange& change) {
              return edit_transforms(document, objects, [&](Similarity& transform) {
                transform.scale = change.apply(scale, transform.scale);
              });
            });
}

/// How large the surfaces are along the objects' own axes.
void size_rows(PanelContext& context, const Objects& objects) {
  Editor& editor = context.editor;
  const Quantity length = length_quantity(editor.document().unit, model_size(editor));
  const auto sizes = [&](const Object& object) -> Vector3 {
    const Box3 box = own_box(editor, object);
    return box.isEmpty() ? Vector3(Vector3::Zero()) : Vector3(box.sizes() * object.transform.scale);
  };
  vector_row(context, "Size", "Of the surface, along the object's own axes",
             axis_specs({"size.x", "size.y", "size.z"}, "Size of object", length),
             common_axes(objects, sizes),
             [&editor, objects, length](const Document& document, int axis, const ValueChange& change) {
               Result<Document> result = document;
               for (const auto& object : objects) {
                 const Box3 box = own_box(editor, *object);
                 const double now = box.isEmpty() ? 0 : box.sizes()[axis] * object->transform.scale;
                 if (result)
                   result = with_size(*result, object->id, box, shown_density(editor, *object), axis,
                                      change.apply(length, now), editor.transform.proportional_size);
               }
               return result;
             });
  if (std::none_of(objects.begin(), objects.end(), [](const auto& object) { return stretches(*object); }))
    return;
  if (const auto on =
          check_row(context, "proportional", "Proportional",
                    "A typed size scales the object along all its axes", editor.transform.proportional_size))
    editor.transform.proportional_size = *on;
}

void mode_row(PanelContext& context, const Objects& objects) {
  Objects polyhedra;
  for (const auto& object : objects)
    if (object->polyhedron()) polyhedra.push_back(object);
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

/// The live mirror: its plane, and making the image the object's own.
void mirror_row(PanelContext& context, const Objects& objects) {
  Objects polyhedra;
  for (const auto& object : objects)
    if (object->polyhedron()) polyhedra.push_back(object);
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
  if (std::none_of(polyhedra.begin(), polyhedra.end(),
                   [](const auto& object) { return object->polyhedron()->mirror.has_value(); }))
    return;
  row_label(context, "", "");
  if (ImGui::Button((std::string(context.tr("Apply live mirror")) + "###apply_mirror").c_str(), {-1, 0}))
    each([&](const Object& object) {
      if (object.polyhedron()->mirror) context.run("mirror.apply");
    });
  if (ImGui::IsItemHovered()) show_tip(context.tr("Make both halves the object's own."));
  context.marks.item("button.apply_mirror");
}

Result<Document> edit_preparations(const Document& document, const Objects& objects,
                                   const std::function<void(Preparation&)>& change) {
  Result<Document> result = document;
  for (const auto& object : objects) {
    const Object* found = result.ok() ? result->find(object->id) : nullptr;
    if (!found || !found->polyhedron()) continue;
    Preparation preparation = found->polyhedron()->preparation;
    change(preparation);
    result = set_preparation(*result, object->id, preparation);
  }
  return result;
}

void frames_row(PanelContext& context, const Objects& objects) {
  Objects shaped;
  for (const auto& object : objects)
    if (surface_frames(object->source)) shaped.push_back(object);
  if (shaped.empty()) return;
  const auto metric = common<bool>(
      shaped, [](const auto& object) { return surface_frames(object->source) == Frames::metric; });
  const auto on =
      check_row(context, "frames", "By measure",
                "Angles and lengths of the polyhedron count: uneven cages give even surfaces", metric);
  if (!on) return;
  Result<Document> result = context.editor.history.current();
  for (const auto& object : shaped)
    if (result.ok()) result = set_frames(*result, object->id, *on ? Frames::metric : Frames::equal);
  context.editor.commit(result, *on ? "Surface by measure" : "Surface by equal angles");
}

void preparation_rows(PanelContext& context, const Objects& objects) {
  Objects polyhedra;
  for (const auto& object : objects)
    if (object->polyhedron()) polyhedra.push_back(object);
  if (polyhedra.empty()) return;
  const auto split = common<bool>(
      polyhedra, [](const auto& object) { return object->polyhedron()->preparation.split_concave; });
  if (const auto on = check_row(context, "split_concave", "Convex faces",
                                "The surface is made as if concave faces were cut into convex ones", split))
    context.editor.commit(
        edit_preparations(context.editor.history.current(), polyhedra,
                          [&](Preparation& preparation) { preparation.split_concave = *on; }),
        *on ? "Split concave faces" : "Keep concave faces");
  const auto merge = common<bool>(
      polyhedra, [](const auto& object) { return object->polyhedron()->preparation.merge_coplanar; });
  if (const auto on = check_row(context, "merge_coplanar", "Merge flat",
                                "The surface is made as if triangles in one plane were one face", merge))
    context.editor.commit(
        edit_preparations(context.editor.history.current(), polyhedra,
                          [&](Preparation& preparation) { preparation.merge_coplanar = *on; }),
        *on ? "Merge flat triangles" : "Keep flat triangles");
  Quantity power = plain_quantity(2, 0.05);
  power.low = 0;
  power.high = 1;
  power.standard = 0;
  slider_row(
      context,
      {"automatic_tension", "Auto tension",
       "Stretches short edges and relaxes long ones; at rest while you drag", "Automatic tension", power},
      0, 1, false,
      common<double>(polyhedra,
                     [](const auto& object) { return object->polyhedron()->preparation.automatic_tension; }),
      [polyhedra, power](const Document& document, const ValueChange& change) {
        return edit_preparations(document, polyhedra, [&](Preparation& preparation) {
          preparation.automatic_tension = change.apply(power, preparation.automatic_tension);
        });
      });
}

void object_section(PanelContext& context, const Objects& objects) {
  counted_heading(context, "Object", "{0} objects", objects.size());
  if (objects.size() == 1) object_name(context, *objects.front());
  size_rows(context, objects);
  if (std::any_of(objects.begin(), objects.end(), [](const auto& object) { return object->locked; }))
    hint_text(context, "Locked: unlock it in the list above to change it.");
  copies_rows(context, objects);
  mode_row(context, objects);
  frames_row(context, objects);
  mirror_row(context, objects);
  preparation_rows(context, objects);
  if (objects.size() == 1) patch_section(context, *objects.front());
  if (ImGui::TreeNodeEx("##place",
                        ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen |
                            (objects.size() > 1 ? ImGuiTreeNodeFlags_DefaultOpen : 0),
                        "%s", context.tr("Placement"))) {
    context.marks.item("section.placement");
    transform_rows(context, objects);
  } else {
    context.marks.item("section.placement");
  }
  // Nothing of how surfaces show is about pictures.
  if (std::any_of(objects.begin(), objects.end(), [](const auto& object) { return !object->picture(); }))
    draw_display(context, objects);
}

}  // namespace

void draw_properties(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  if (begin_panel("Properties", rect, palette().panel, {m.px(12), m.px(8)})) {
    PanelState& state = context.state;
    state.typing_row.clear();
    state.steady.begin();
    // Edits replace the document under the panel: what is drawn is this frame's value.
    draw_last_operation(context);
    if (context.editor.paper.shown) draw_paper_properties(context);
    const auto objects = chosen_objects(context.editor);
    if (objects.empty()) {
      hint_text(context,
                context.editor.document().objects.empty()
                    ? translatable("The document is empty. Add a shape, or drop a mesh on the window.")
                    : translatable("Nothing is selected. Click an object here or in the view."));
    } else {
      // Elements first: they are what the hand is on.
      const bool elements = draw_elements(context);
      draw_skin_properties(context);
      if (objects.front()->solids()) draw_solids(context, *objects.front());
      outline_point_section(context);
      if (objects.size() == 1) outline_section(context, *objects.front());
      picture_section(context, objects);
      object_section(context, objects);
      if (!elements && objects.front()->polyhedron()) {
        heading(context, "Selection");
        hint_text(context,
                  "Click a vertex or an edge to set its tension. Keys 1 2 3 choose what a click takes.");
      }
      draw_message_list(context, *objects.front());
    }
    dimension_section(context);
    document_section(context);
    state.steady.end(context.marks, state.typing_row);
  }
  ImGui::End();
}

}  // namespace hariko
