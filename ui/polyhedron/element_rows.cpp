#include "ui/polyhedron/element_rows.hpp"

#include <algorithm>

#include "core/document/edits/edits.hpp"
#include "ui/polyhedron/attachment_rows.hpp"
#include "ui/widgets/enum_labels.hpp"

namespace hariko {

namespace {

constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

/// "vertex" or "{0} vertices" filled.
std::string counted(const char* one, const char* many, std::size_t count) {
  return count == 1 ? one : fill(many, {std::to_string(count)});
}

Quantity tension_quantity(double low, double high, double standard) {
  Quantity quantity = plain_quantity(4, 0.1);
  quantity.low = low;
  quantity.high = high;
  quantity.standard = standard;
  return quantity;
}

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
             {"alpha", "Tension \u03b1",
              "Pulls the curves to the vertex: 0 is relaxed, from 10 on it looks like a point",
              counted("Tension of vertex", "Tension of {0} vertices", ids.size()), quantity},
             0, max_alpha, true, common<double>(ids, [&](VertexId id) { return alpha_of(shaping, id); }),
             [selected, quantity, alpha_of](const Document& document, const ValueChange& change) {
               return edit_tensions(document, selected, quantity, change, alpha_of, &set_alphas);
             });
  const auto tag =
      common<VertexTag>(ids, [&](VertexId id) { return shaping.tag.get_or(id, VertexTag::automatic); });
  if (const auto chosen = choose(context, "tag", "Corner", "How creases and the border pass the vertex", tag))
    context.editor.commit(set_vertex_tag(context.editor.history.current(), selected.object->id, ids, *chosen),
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

/// The heading of a section about so many.
void counted_heading(const PanelContext& context, const char* one, const char* many, std::size_t count) {
  heading(context, count == 1 ? context.tr(one) : fill(context.tr(many), {std::to_string(count)}).c_str());
}

std::array<FieldSpec, 3> axis_specs(const std::array<const char*, 3>& ids, const std::string& step,
                                    const Quantity& quantity) {
  return {FieldSpec{ids[0], "X", "", step, quantity}, FieldSpec{ids[1], "Y", "", step, quantity},
          FieldSpec{ids[2], "Z", "", step, quantity}};
}

double model_size(const Editor& editor) {
  Box3 box;
  for (const auto& object : editor.document().objects) box.extend(world_box(*object));
  return box.isEmpty() ? 1 : box.sizes().maxCoeff();
}

bool draw_elements(PanelContext& context) {
  const auto vertices = selected_vertices(context.editor);
  const auto edges = selected_edges(context.editor);
  const auto faces = selected_faces(context.editor);
  if (!vertices.ids.empty()) vertex_section(context, vertices);
  if (!edges.ids.empty()) edge_section(context, edges);
  if (!faces.ids.empty()) face_section(context, faces);
  return !vertices.ids.empty() || !edges.ids.empty() || !faces.ids.empty();
}

}  // namespace hariko
