#include "core/document/edits/edit_dimensions.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "core/document/edits/edit_elements.hpp"
#include "core/document/edits/edit_support.hpp"
#include "core/document/object_shape.hpp"

namespace hariko {

namespace {

Message unknown_dimension() {
  return make_error(e_unknown_dimension, "The document has no such dimension.", "Choose one of the list.");
}

Message invalid_dimension() {
  return make_error(e_dimension_invalid, "These points make no dimension.",
                    "A distance takes two points, an angle three, a radius one on a surface.");
}

bool has_solid(const Object& object, std::uint32_t id) {
  const SolidsSource* source = object.solids();
  return source && std::any_of(source->input->solids.begin(), source->input->solids.end(),
                               [id](const Solid& solid) { return solid.id == id; });
}

bool has_section_point(const Skin& skin, std::uint32_t id) {
  return std::any_of(skin.sections.begin(), skin.sections.end(), [id](const SkinSection& section) {
    return std::any_of(section.points.begin(), section.points.end(),
                       [id](const SectionPoint& point) { return point.id == id; });
  });
}

bool has_vertex(const Object& object, const VertexAnchor& anchor) {
  if (anchor.image && !(object.polyhedron() && object.polyhedron()->mirror)) return false;
  if (const Polyhedron* cage = object.cage()) return cage->find(anchor.vertex) != no_index;
  if (const MeshSource* mesh = object.mesh()) return anchor.vertex.value < mesh->mesh->positions.size();
  if (const OutlineSource* outline = object.outline())
    return anchor.vertex.value < outline->outline->point_count();
  if (const SkinSource* skin = object.skin()) return has_section_point(*skin->skin, anchor.vertex.value);
  return has_solid(object, anchor.vertex.value);
}

bool has_patch(const Object& object, const PatchAnchor& anchor) {
  const auto number = static_cast<std::uint32_t>(anchor.element.id);
  if (anchor.element.kind != Element::Kind::face) return object.has_surface();
  if (const PolyhedronSource* source = object.polyhedron())
    return source->polyhedron.find(FaceId{number}) != no_index;
  if (const PatchSource* patches = object.patches())
    return number < std::uint64_t(patches->columns) * patches->rows;
  if (const BezierSource* bezier = object.bezier()) return number < bezier->patches->size();
  if (const MeshSource* mesh = object.mesh()) return number < mesh->mesh->face_count();
  return object.has_surface();
}

bool has_element(const Object& object, const Anchor& anchor) {
  if (const auto* placed = std::get_if<ObjectAnchor>(&anchor))
    return !placed->solid || has_solid(object, *placed->solid);
  if (const auto* vertex = std::get_if<VertexAnchor>(&anchor)) return has_vertex(object, *vertex);
  if (const auto* edge = std::get_if<EdgeAnchor>(&anchor))
    return object.cage() && object.cage()->find(edge->edge) != no_index;
  if (const auto* patch = std::get_if<PatchAnchor>(&anchor)) return has_patch(object, *patch);
  return has_shape(object);
}

/// Copy of the document with the dimensions that `stays` says; the same one where all do.
template <class Stays>
Document with_dimensions(const Document& document, Stays&& stays) {
  Dimensions left;
  std::copy_if(document.dimensions->begin(), document.dimensions->end(), std::back_inserter(left), stays);
  if (left.size() == document.dimensions->size()) return document;
  Document result = document;
  result.dimensions = std::move(left);
  return result;
}

}  // namespace

Message too_many_dimensions() {
  return make_error(e_too_many_dimensions, "The document has no room for more dimensions.",
                    "Delete dimensions first.");
}

Result<AddedDimension> add_dimension(const Document& document, DimensionKind kind,
                                     std::vector<Anchor> anchors, const Vector3& label) {
  const Dimensions& all = *document.dimensions;
  if (all.size() >= Document::max_dimensions) return too_many_dimensions();
  const DimensionId id = next_dimension_id(all);
  Dimension added{id, kind, std::move(anchors), label};
  if (!is_sound(added)) return invalid_dimension();
  for (const Anchor& anchor : added.anchors) {
    if (anchor_exists(document, anchor)) continue;
    const ObjectId object = *object_of(anchor);
    if (!document.find(object)) return detail::unknown_object(object);
    return make_error(e_unknown_element, "The object has no such element.", "Choose a point that it has.",
                      element_of(object));
  }
  AddedDimension result{document, id};
  Dimensions longer = all;
  longer.push_back(std::move(added));
  result.document.dimensions = std::move(longer);
  return result;
}

Result<Document> remove_dimensions(const Document& document, std::span<const DimensionId> ids) {
  for (const DimensionId id : ids)
    if (!find_dimension(document, id)) return unknown_dimension();
  const std::set<DimensionId> chosen(ids.begin(), ids.end());
  return with_dimensions(document,
                         [&](const Dimension& dimension) { return !chosen.contains(dimension.id); });
}

Result<Document> move_dimension_label(const Document& document, DimensionId id, const Vector3& label) {
  const Dimension* found = find_dimension(document, id);
  if (!found) return unknown_dimension();
  if (!label.allFinite()) return invalid_dimension();
  if (found->label == label) return document;
  Dimensions moved = *document.dimensions;
  moved[static_cast<std::size_t>(found - document.dimensions->data())].label = label;
  Document result = document;
  result.dimensions = std::move(moved);
  return result;
}

const Dimension* find_dimension(const Document& document, DimensionId id) {
  const Dimensions& all = *document.dimensions;
  const auto found =
      std::find_if(all.begin(), all.end(), [id](const Dimension& other) { return other.id == id; });
  return found == all.end() ? nullptr : &*found;
}

bool anchor_exists(const Document& document, const Anchor& anchor) {
  const ObjectId* id = object_of(anchor);
  if (!id) return true;
  const Object* object = document.find(*id);
  return object && has_element(*object, anchor);
}

std::vector<DimensionId> lost_dimensions(const Document& document) {
  std::vector<DimensionId> out;
  for (const Dimension& dimension : *document.dimensions)
    if (!std::all_of(dimension.anchors.begin(), dimension.anchors.end(),
                     [&](const Anchor& anchor) { return anchor_exists(document, anchor); }))
      out.push_back(dimension.id);
  return out;
}

std::vector<DimensionId> dimensions_that_went(const Document& before, const Document& after) {
  std::vector<DimensionId> out;
  for (const Dimension& dimension : *before.dimensions)
    if (!find_dimension(after, dimension.id) &&
        !std::all_of(dimension.anchors.begin(), dimension.anchors.end(),
                     [&](const Anchor& anchor) { return anchor_exists(after, anchor); }))
      out.push_back(dimension.id);
  return out;
}

Document without_dimensions_of(const Document& document, std::span<const ObjectId> objects) {
  if (document.dimensions->empty()) return document;
  const std::set<ObjectId> chosen(objects.begin(), objects.end());
  return with_dimensions(document, [&](const Dimension& dimension) {
    return std::none_of(dimension.anchors.begin(), dimension.anchors.end(), [&](const Anchor& anchor) {
      const ObjectId* object = object_of(anchor);
      return object && chosen.contains(*object);
    });
  });
}

}  // namespace hariko
