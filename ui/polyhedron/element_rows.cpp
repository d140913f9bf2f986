#include "ui/polyhedron/element_rows.hpp"

#include <algorithm>

#include "core/document/edits/edits.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

/// Selected elements of the active object.
template <class Id>
struct SelectedIds {
  std::shared_ptr<const Object> object;  ///< a polyhedron; null when there are no ids
  std::vector<Id> ids;                   ///< ascending
};

template <class Id>
SelectedIds<Id> ids_of_active(const Editor& editor, std::set<Id> ElementSelection::*member) {
  if (editor.mode == ElementMode::object) return {};
  const auto object = editor.document().find_shared(editor.selection.active);
  if (!object || !object->polyhedron()) return {};
  // A gesture's document may lack elements that are selected in the one it began with.
  const Polyhedron& polyhedron = object->polyhedron()->polyhedron;
  SelectedIds<Id> selected;
  for (const Id id : editor.selection.of(object->id).*member)
    if (polyhedron.find(id) != no_index) selected.ids.push_back(id);
  if (!selected.ids.empty()) selected.object = object;
  return selected;
}

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
  const auto values = common_axes(selected.ids, [&](VertexId id) { return position_of(source, id); });
  const VectorSpec spec{{"x", "y", "z"},
                        "Position",
                        "Coordinates of the vertex, in the object's own axes",
                        counted("Move vertex", "Move {0} vertices", selected.ids.size()),
                        length};
  vector_row(context, spec, values,
             [selected, length](const Document& document, int axis, const ValueChange& change) {
               return edit_positions(document, selected, axis, length, change);
             });
}

void pin_row(PanelContext& context, const SelectedIds<VertexId>& selected) {
  const auto& pins = selected.object->polyhedron()->shaping->pin;
  const auto pinned = static_cast<std::size_t>(
      std::ranges::count_if(selected.ids, [&](VertexId id) { return pins.contains(id); }));
  if (pinned == 0) return;
  row_label(context, "Pin", "The tangent plane is fixed here");
  const std::string label = pinned == 1 ? context.tr("Release pin")
                                        : fill(context.tr("Release {0} pins"), {std::to_string(pinned)});
  if (text_button(context.marks, "button.release_pin", label, -1))
    context.editor.commit(clear_pins(context.editor.history.current(), selected.object->id, selected.ids),
                          counted("Release pin", "Release {0} pins", pinned));
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
  value_row(context,
            {"alpha", "Tension \u03b1",
             "Pulls the curves to the vertex: 0 is relaxed, from 10 on it looks like a point",
             counted("Tension of vertex", "Tension of {0} vertices", ids.size()), quantity,
             SliderKind::logarithmic},
            common<double>(ids, [&](VertexId id) { return alpha_of(shaping, id); }),
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

/// The value that all attached edges share.
template <class Value>
std::optional<Value> common_value(const Attachments& attachments, const std::vector<EdgeId>& ids,
                                  Value Attachment::*member) {
  return common<Value>(ids, [&](const EdgeId& id) { return attachments.find(id)->*member; });
}

/// Joins of selected border edges to patches. Nothing where none of the edges is attached.
void attachment_rows(PanelContext& context, const SelectedIds<EdgeId>& selected) {
  const Attachments& attachments = *selected.object->polyhedron()->attachments;
  std::vector<EdgeId> ids;
  bool frozen = false;
  for (const EdgeId& id : selected.ids)
    if (const Attachment* attachment = attachments.find(id)) {
      ids.push_back(id);
      frozen = frozen || attachment->frozen.has_value();
    }
  if (ids.empty()) return;
  const auto change = [&](const std::string& step, const auto& edit) {
    Result<Document> result = context.editor.history.current();
    for (const EdgeId& id : ids) {
      Attachment changed = *attachments.find(id);
      edit(changed);
      if (result) result = attach_edge(*result, selected.object->id, id, changed);
    }
    context.editor.commit(result, step);
  };
  const auto continuity = common_value(attachments, ids, &Attachment::continuity);
  if (const auto chosen =
          choose(context, "join", "Joint", "How the edge meets the side of the patch that it is attached to",
                 continuity))
    change("Joint", [&](Attachment& attachment) { attachment.continuity = *chosen; });
  if (frozen) {
    hint_text(context, "The patch is gone; the edge keeps a copy of its side.");
  } else if (continuity == Continuity::g1) {
    const auto adapts = common_value(attachments, ids, &Attachment::adapts);
    if (const auto chosen = choose(context, "adapts", "Adapts", "Who gives way where the two meet", adapts))
      change("Adapts", [&](Attachment& attachment) { attachment.adapts = *chosen; });
  }
  if (row_button(context, "release_edges", "Release attached edges", "")) context.run("shape.release_edges");
}

void edge_section(PanelContext& context, const SelectedIds<EdgeId>& selected) {
  const Shaping& shaping = *selected.object->polyhedron()->shaping;
  const auto& ids = selected.ids;
  counted_heading(context, "Edge", "{0} edges", ids.size());
  const auto beta_of = [](const Shaping& of, const EdgeId& id) { return of.beta.get_or(id, 1); };
  Quantity quantity = tension_quantity(min_beta, max_beta, 1);
  quantity.multiplies = true;
  value_row(
      context,
      {"beta", "Tension \u03b2", "Stretches the curve along the edge: 1 is neutral, 10 is nearly straight",
       counted("Tension of edge", "Tension of {0} edges", ids.size()), quantity, SliderKind::logarithmic},
      common<double>(ids, [&](const EdgeId& id) { return beta_of(shaping, id); }),
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

double model_size(const Editor& editor) {
  Box3 box;
  for (const auto& object : editor.document().objects) box.extend(world_box(*object));
  return box.isEmpty() ? 1 : box.sizes().maxCoeff();
}

bool draw_elements(PanelContext& context) {
  const auto vertices = ids_of_active(context.editor, &ElementSelection::vertices);
  const auto edges = ids_of_active(context.editor, &ElementSelection::edges);
  const auto faces = ids_of_active(context.editor, &ElementSelection::faces);
  if (!vertices.ids.empty()) vertex_section(context, vertices);
  if (!edges.ids.empty()) edge_section(context, edges);
  if (!faces.ids.empty()) face_section(context, faces);
  return !vertices.ids.empty() || !edges.ids.empty() || !faces.ids.empty();
}

namespace {

/// "5 × 2", or "1 … 5" where patches differ.
std::string degree_text(const std::vector<BezierPatch>& patches) {
  const auto degrees = [](const BezierPatch& patch) { return std::pair(patch.degree_s, patch.degree_t); };
  const bool equal = std::ranges::all_of(
      patches, [&](const BezierPatch& patch) { return degrees(patch) == degrees(patches[0]); });
  if (equal) return std::to_string(patches[0].degree_s) + " \u00d7 " + std::to_string(patches[0].degree_t);
  int least = max_bezier_degree, most = 1;
  for (const BezierPatch& patch : patches) {
    least = std::min({least, patch.degree_s, patch.degree_t});
    most = std::max({most, patch.degree_s, patch.degree_t});
  }
  return std::to_string(least) + " \u2026 " + std::to_string(most);
}

}  // namespace

void patch_section(PanelContext& context, const Object& object) {
  const BezierSource* source = object.bezier();
  if (!source) return;
  const std::vector<BezierPatch>& patches = *source->patches;
  text_row(context, "patches.count", translatable("Patches"),
           translatable("One surface: sides that are equal are joined"), std::to_string(patches.size()));
  text_row(context, "patches.degree", translatable("Degree"),
           translatable("Of the polynomials along both sides"), degree_text(patches));
  const auto rational =
      std::ranges::count_if(patches, [](const BezierPatch& patch) { return patch.rational(); });
  if (rational > 0)
    text_row(context, "patches.weights", translatable("Weights"),
             translatable("Patches whose control points have weights"), std::to_string(rational));
  if (patches.size() < 2 || object.locked) return;
  row_label(context, "", "");
  if (row_button(context, "separate_patches", "Separate patches",
                 "Control points are edited patch by patch; welding joins them again."))
    context.run("shape.separate_patches");
}

}  // namespace hariko
