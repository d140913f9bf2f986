// Properties: what can be set on the document, on the chosen objects and on the selected elements.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <vector>

#include "core/document/angles.hpp"
#include "core/document/convert_unit.hpp"
#include "ui/panels/attachment_rows.hpp"
#include "ui/panels/choice.hpp"
#include "ui/panels/display_panel.hpp"
#include "ui/panels/message_list.hpp"
#include "ui/panels/outline_rows.hpp"
#include "ui/panels/paper_properties.hpp"
#include "ui/panels/patch_rows.hpp"
#include "ui/panels/selected_items.hpp"
#include "ui/panels/skin_properties.hpp"
#include "ui/panels/solids_properties.hpp"
#include "ui/panels/value_fields.hpp"

namespace hariko {

namespace {

constexpr std::array mode_choices{
    Choice{"Fair", "Balances the curvature inside the faces: the smoothest result"},
    Choice{"G2", "Curvature runs on without a break over edges and through vertices"},
    Choice{"Target", "Puts face centres where the boundary curves aim"},
    Choice{"Paper", "The construction as first published"},
};
constexpr std::array mode_steps{"Surface Fair", "Surface G2", "Surface Target", "Surface Paper"};
constexpr std::array<Mode, 4> modes{Mode::fair, Mode::g2, Mode::target, Mode::paper};
constexpr std::array tag_choices{
    Choice{"Automatic", "A corner where creases or the border demand it"},
    Choice{"Corner", "Every curve ends here with its own direction"},
    Choice{"Smooth", "Creases and the border run smoothly through"},
};
constexpr std::array mirror_choices{
    Choice{"None", "All of the object is modelled"},
    Choice{"Across X", "The plane x = 0 of the object"},
    Choice{"Across Y", "The plane y = 0 of the object"},
    Choice{"Across Z", "The plane z = 0 of the object"},
};
constexpr std::array unit_choices{
    Choice{"Millimetres", ""},
    Choice{"Centimetres", ""},
    Choice{"Metres", ""},
    Choice{"Inches", ""},
};
constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

/// "vertex" or "{0} vertices" filled.
std::string counted(const char* one, const char* many, std::size_t count) {
  return count == 1 ? one : fill(many, {std::to_string(count)});
}

/// The heading of a section about so many.
void counted_heading(const PanelContext& context, const char* one, const char* many, std::size_t count) {
  heading(context, count == 1 ? context.tr(one) : fill(context.tr(many), {std::to_string(count)}).c_str());
}

double model_size(const Editor& editor) {
  Box3 box;
  for (const auto& object : editor.document().objects) box.extend(world_box(*object));
  return box.isEmpty() ? 1 : box.sizes().maxCoeff();
}

Quantity tension_quantity(double low, double high, double standard) {
  Quantity quantity = plain_quantity(4, 0.1);
  quantity.low = low;
  quantity.high = high;
  quantity.standard = standard;
  return quantity;
}

// The document.

void document_section(PanelContext& context) {
  Editor& editor = context.editor;
  heading(context, "Document");
  const auto current = static_cast<int>(editor.document().unit);
  row_label(context, "Unit", "The unit of all lengths of the document");
  ImGui::SetNextItemWidth(-1);
  const bool open =
      ImGui::BeginCombo("##unit", context.tr(unit_choices[static_cast<std::size_t>(current)].label));
  context.marks.item("combo.unit");
  if (!open) return;
  const auto offers = [&](const char* title, const char* id, const char* step, bool converts) {
    heading(context, title);
    for (int i = 0; i < static_cast<int>(unit_choices.size()); ++i) {
      if (i == current) continue;
      const char* name = unit_choices[static_cast<std::size_t>(i)].label;
      ImGui::PushID(2 * i + converts);
      if (ImGui::Selectable(context.tr(name))) {
        const Document& document = editor.history.current();
        const auto unit = static_cast<Unit>(i);
        editor.commit(converts ? convert_unit(document, unit) : Result<Document>(set_unit(document, unit)),
                      step);
      }
      context.marks.item(std::string("unit.") + id + "." + std::string(to_string(static_cast<Unit>(i))));
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

using Objects = std::vector<std::shared_ptr<const Object>>;

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

std::array<FieldSpec, 3> axis_specs(const std::array<const char*, 3>& ids, const std::string& step,
                                    const Quantity& quantity) {
  return {FieldSpec{ids[0], "X", "", step, quantity}, FieldSpec{ids[1], "Y", "", step, quantity},
          FieldSpec{ids[2], "Z", "", step, quantity}};
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

void mode_row(PanelContext& context, const Objects& objects) {
  Objects polyhedra;
  for (const auto& object : objects)
    if (object->polyhedron()) polyhedra.push_back(object);
  if (polyhedra.empty()) return;
  const auto mode = common<Mode>(polyhedra, [](const auto& object) { return object->polyhedron()->mode; });
  const int current =
      mode ? static_cast<int>(std::find(modes.begin(), modes.end(), *mode) - modes.begin()) : -1;
  const auto chosen =
      choose(context, "mode", "Surface", "How the surface spans the curves", mode_choices, current);
  if (!chosen) return;
  Result<Document> result = context.editor.history.current();
  for (const auto& object : polyhedra)
    if (result.ok()) result = set_mode(*result, object->id, modes[static_cast<std::size_t>(*chosen)]);
  context.editor.commit(result, mode_steps[static_cast<std::size_t>(*chosen)]);
}

/// The live mirror of one object: its plane, and making the image the object's own.
void mirror_row(PanelContext& context, const Object& object) {
  const PolyhedronSource* source = object.polyhedron();
  if (!source || context.editor.selection.active != object.id) return;
  constexpr std::array commands{"mirror.live_x", "mirror.live_y", "mirror.live_z"};
  const int current = source->mirror ? static_cast<int>(source->mirror->axis) + 1 : 0;
  const auto chosen =
      choose(context, "mirror", "Mirror", "Model one half; its image completes the object at once.",
             mirror_choices, current);
  // The command of the present axis ends the mirror.
  if (chosen && *chosen != current)
    context.run(commands[static_cast<std::size_t>(*chosen == 0 ? current : *chosen) - 1]);
  if (current == 0) return;
  row_label(context, "", "");
  if (ImGui::Button((std::string(context.tr("Apply live mirror")) + "###apply_mirror").c_str(), {-1, 0}))
    context.run("mirror.apply");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", context.tr("Make both halves the object's own."));
  context.marks.item("button.apply_mirror");
}

/// Only mode G2 knows it.
void round_row(PanelContext& context, const Objects& objects) {
  Objects curved;
  for (const auto& object : objects)
    if (object->polyhedron() && object->polyhedron()->mode == Mode::g2) curved.push_back(object);
  if (curved.empty()) return;
  const auto round = common<bool>(curved, [](const auto& object) { return object->polyhedron()->round; });
  const auto on = check_row(context, "round", "Rounder",
                            "Measures bending over the surface itself: rounder, and slower to finish", round);
  if (!on) return;
  Result<Document> result = context.editor.history.current();
  for (const auto& object : curved)
    if (result.ok()) result = set_round(*result, object->id, *on);
  context.editor.commit(result, *on ? "Rounder surface" : "Plain surface");
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

/// Modes TARGET and FAIR know it.
void frames_row(PanelContext& context, const Objects& objects) {
  Objects shaped;
  for (const auto& object : objects)
    if (const PolyhedronSource* source = object->polyhedron())
      if (source->mode == Mode::fair || source->mode == Mode::target) shaped.push_back(object);
  if (shaped.empty()) return;
  const auto metric =
      common<bool>(shaped, [](const auto& object) { return object->polyhedron()->frames == Frames::metric; });
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
  if (const auto on = check_row(context, "split_concave", "Split concave",
                                "The surface is made as if concave faces were cut into convex ones", split))
    context.editor.commit(
        edit_preparations(context.editor.history.current(), polyhedra,
                          [&](Preparation& preparation) { preparation.split_concave = *on; }),
        *on ? "Split concave faces" : "Keep concave faces");
  const auto merge = common<bool>(
      polyhedra, [](const auto& object) { return object->polyhedron()->preparation.merge_coplanar; });
  if (const auto on = check_row(context, "merge_coplanar", "Merge triangles",
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
      {"automatic_tension", "Even tension",
       "Stretches short edges and relaxes long ones; at rest while you drag", "Even tension", power},
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
  if (std::any_of(objects.begin(), objects.end(), [](const auto& object) { return object->locked; }))
    hint_text(context, "Locked: unlock it in the list above to change it.");
  mode_row(context, objects);
  frames_row(context, objects);
  round_row(context, objects);
  if (objects.size() == 1) mirror_row(context, *objects.front());
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
  if (objects.size() == 1) draw_display(context, *objects.front());
}

// Elements.

Vector3 position_of(const PolyhedronSource& source, VertexId id) {
  return source.origin + source.polyhedron.position(source.polyhedron.find(id));
}

Result<Document> edit_positions(const Document& document, const SelectedIds<VertexId>& selected, int axis,
                                const Quantity& quantity, const ValueChange& change) {
  const Object* object = document.find(selected.object->id);
  if (!object || !object->polyhedron()) return document;
  const PolyhedronSource& source = *object->polyhedron();
  std::vector<Vector3> positions;
  for (const VertexId id : selected.ids) {
    Vector3 position = position_of(source, id);
    position[axis] = change.apply(quantity, position[axis]);
    positions.push_back(position - source.origin);
  }
  return move_vertices(document, object->id, selected.ids, positions);
}

void position_rows(PanelContext& context, const SelectedIds<VertexId>& selected) {
  const PolyhedronSource& source = *selected.object->polyhedron();
  const Quantity length = length_quantity(context.editor.document().unit, model_size(context.editor));
  std::array<std::optional<double>, 3> values;
  for (int axis = 0; axis < 3; ++axis)
    values[static_cast<std::size_t>(axis)] =
        common<double>(selected.ids, [&](VertexId id) { return position_of(source, id)[axis]; });
  vector_row(context, "Position", "Coordinates of the vertex, in the object's own axes",
             axis_specs(axis_names, counted("Move vertex", "Move {0} vertices", selected.ids.size()), length),
             values, [selected, length](const Document& document, int axis, const ValueChange& change) {
               return edit_positions(document, selected, axis, length, change);
             });
}

void pin_row(PanelContext& context, const SelectedIds<VertexId>& selected) {
  const auto& pins = selected.object->polyhedron()->shaping->pin;
  const auto pinned = static_cast<std::size_t>(std::count_if(selected.ids.begin(), selected.ids.end(),
                                                             [&](VertexId id) { return pins.contains(id); }));
  if (pinned == 0) return;
  row_label(context, "Pin", "The tangent plane is fixed here");
  const std::string label = pinned == 1 ? context.tr("Release pin")
                                        : fill(context.tr("Release {0} pins"), {std::to_string(pinned)});
  if (ImGui::Button((label + "###release").c_str(), {-1, 0}))
    context.editor.commit(clear_pins(context.editor.history.current(), selected.object->id, selected.ids),
                          counted("Release pin", "Release {0} pins", pinned));
  context.marks.item("button.release_pin");
}

/// Every tension of the selected elements changed, in one edit.
template <class Id, class Get, class Set>
Result<Document> edit_tensions(const Document& document, const SelectedIds<Id>& selected,
                               const Quantity& quantity, const ValueChange& change, const Get& get,
                               const Set& set) {
  const Object* object = document.find(selected.object->id);
  if (!object || !object->polyhedron()) return document;
  std::vector<double> values;
  for (const Id& id : selected.ids)
    values.push_back(change.apply(quantity, get(*object->polyhedron()->shaping, id)));
  return set(document, object->id, selected.ids, values);
}

void vertex_section(PanelContext& context, const SelectedIds<VertexId>& selected) {
  const Shaping& shaping = *selected.object->polyhedron()->shaping;
  const auto& ids = selected.ids;
  counted_heading(context, "Vertex", "{0} vertices", ids.size());
  const auto alpha_of = [](const Shaping& of, VertexId id) { return of.alpha.get_or(id, 0); };
  const Quantity quantity = tension_quantity(0, max_alpha, 0);
  slider_row(context,
             {"alpha", "Tension \u03b1", "Pulls the curves to the vertex: 0 is relaxed, 10 makes a point",
              counted("Tension of vertex", "Tension of {0} vertices", ids.size()), quantity},
             0, max_alpha, true, common<double>(ids, [&](VertexId id) { return alpha_of(shaping, id); }),
             [selected, quantity, alpha_of](const Document& document, const ValueChange& change) {
               return edit_tensions(document, selected, quantity, change, alpha_of, &set_alphas);
             });
  const auto tag =
      common<VertexTag>(ids, [&](VertexId id) { return shaping.tag.get_or(id, VertexTag::automatic); });
  if (const auto chosen = choose(context, "tag", "Corner", "How creases and the border pass the vertex",
                                 tag_choices, tag ? static_cast<int>(*tag) : -1))
    context.editor.commit(set_vertex_tag(context.editor.history.current(), selected.object->id, ids,
                                         static_cast<VertexTag>(*chosen)),
                          counted("Tag of vertex", "Tag of {0} vertices", ids.size()));
  pin_row(context, selected);
  position_rows(context, selected);
}

void edge_section(PanelContext& context, const SelectedIds<EdgeId>& selected) {
  const Shaping& shaping = *selected.object->polyhedron()->shaping;
  const auto& ids = selected.ids;
  counted_heading(context, "Edge", "{0} edges", ids.size());
  const auto beta_of = [](const Shaping& of, const EdgeId& id) { return of.beta.get_or(id, 1); };
  Quantity quantity = tension_quantity(min_beta, max_beta, 1);
  quantity.multiplies = true;
  slider_row(
      context,
      {"beta", "Tension \u03b2", "Stretches the curve along the edge: 1 is neutral, 10 is nearly straight",
       counted("Tension of edge", "Tension of {0} edges", ids.size()), quantity},
      min_beta, max_beta, true, common<double>(ids, [&](const EdgeId& id) { return beta_of(shaping, id); }),
      [selected, quantity, beta_of](const Document& document, const ValueChange& change) {
        return edit_tensions(document, selected, quantity, change, beta_of, &set_betas);
      });
  const auto crease = common<bool>(ids, [&](const EdgeId& id) { return shaping.crease.contains(id); });
  if (const auto on = check_row(context, "crease", "Crease", "The surface has a sharp edge here", crease))
    context.editor.commit(set_crease(context.editor.history.current(), selected.object->id, ids, *on),
                          *on ? counted("Crease of edge", "Crease of {0} edges", ids.size())
                              : counted("Smooth of edge", "Smooth of {0} edges", ids.size()));
  attachment_rows(context, selected);
}

void face_section(PanelContext& context, const SelectedIds<FaceId>& selected) {
  counted_heading(context, "Face", "{0} faces", selected.ids.size());
  hint_text(context, "Drag to move.");
}

}  // namespace

void draw_properties(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  if (begin_panel("Properties", rect, palette().panel, {m.px(12), m.px(8)})) {
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
      const auto vertices = selected_vertices(context.editor);
      const auto edges = selected_edges(context.editor);
      const auto faces = selected_faces(context.editor);
      if (!vertices.ids.empty()) vertex_section(context, vertices);
      if (!edges.ids.empty()) edge_section(context, edges);
      if (!faces.ids.empty()) face_section(context, faces);
      draw_skin_properties(context);
      if (objects.front()->solids()) draw_solids(context, *objects.front());
      outline_point_section(context);
      if (objects.size() == 1) outline_section(context, *objects.front());
      object_section(context, objects);
      if (vertices.ids.empty() && edges.ids.empty() && faces.ids.empty() && objects.front()->polyhedron()) {
        heading(context, "Selection");
        hint_text(context,
                  "Click a vertex or an edge to set its tension. Keys 1 2 3 choose what a click takes.");
      }
      draw_message_list(context, *objects.front());
    }
    document_section(context);
  }
  ImGui::End();
}

}  // namespace hariko
