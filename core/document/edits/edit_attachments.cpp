#include "core/document/edits/edit_attachments.hpp"

#include <algorithm>
#include <set>

#include "core/document/edits/edit_elements.hpp"
#include "core/document/edits/edit_support.hpp"

namespace hariko {

namespace {

/// Objects whose surfaces the surface of this object depends on.
std::vector<ObjectId> followed(const Document& document, const Object& object) {
  std::vector<ObjectId> out;
  const auto leads = [](const Attachment& attachment) {
    return attachment.continuity == Continuity::g0 || attachment.adapts == Adapts::surface;
  };
  if (const PolyhedronSource* source = object.polyhedron())
    for (const auto& [edge, attachment] : *source->attachments)
      if (!attachment.frozen && leads(attachment)) out.push_back(attachment.patch);
  if (!object.patches()) return out;
  for (const auto& other : document.objects)
    if (const PolyhedronSource* source = other->polyhedron())
      for (const auto& [edge, attachment] : *source->attachments)
        if (!attachment.frozen && attachment.patch == object.id && !leads(attachment))
          out.push_back(other->id);
  return out;
}

/// Whether `from` depends on `to`, directly or through others.
bool follows(const Document& document, ObjectId from, ObjectId to) {
  std::vector<ObjectId> waiting{from};
  std::set<ObjectId> seen;
  while (!waiting.empty()) {
    const ObjectId id = waiting.back();
    waiting.pop_back();
    if (!seen.insert(id).second) continue;
    const Object* object = document.find(id);
    if (!object) continue;
    for (const ObjectId next : followed(document, *object)) {
      if (next == to) return true;
      waiting.push_back(next);
    }
  }
  return false;
}

Result<Done> check(const Document& document, const Object& object, EdgeId edge,
                   const Attachment& attachment) {
  const PolyhedronSource& source = *object.polyhedron();
  const Index e = source.polyhedron.find(edge);
  if (e == no_index)
    return make_error(e_unknown_element, "The object has no such edge.", "Select it again.",
                      element_of(edge));
  if (!source.polyhedron.topology().is_border_edge(e))
    return make_error(e_not_a_border, "Edge " + to_string(edge) + " is not on the border.",
                      "Select a border edge: one that has a face on one side only.", element_of(edge));
  if (attachment.frozen) return Done{};
  const Object* patches = document.find(attachment.patch);
  if (!patches) return detail::unknown_object(attachment.patch);
  if (!patches->patches())
    return make_error(e_wrong_kind, "The object \"" + patches->name + "\" is not a patch object.",
                      "Choose a side of a patch object.", element_of(patches->id));
  if (!has_side(*patches->patches(), attachment.side))
    return make_error(e_no_side, "The object \"" + patches->name + "\" has no such side.",
                      "Choose another side.", element_of(patches->id));
  for (const auto& [other, taken] : *source.attachments)
    if (!(other == edge) && !taken.frozen && taken.patch == attachment.patch && taken.side == attachment.side)
      return make_error(
          e_side_taken,
          "Edge " + to_string(other) + " is attached to this side of \"" + patches->name + "\".",
          "Release it first: a side joins one edge.", element_of(other));
  return Done{};
}

}  // namespace

bool has_side(const PatchSource& patches, NetSide side) {
  return side.side < 4 && side.place < (side.side % 2 == 0 ? patches.columns : patches.rows);
}

std::optional<NetSide> side_of(const PatchSource& patches, EdgeId edge) {
  const BicubicNet shape{patches.columns, patches.rows, {}};
  const Index width = shape.width(), height = shape.height();
  const Index a = edge.low.value, b = edge.high.value;
  if (b >= width * height) return std::nullopt;
  const Index i = std::min(a % width, b % width), j = std::min(a / width, b / width);
  if (a / width == b / width) {
    if (j == 0) return NetSide{0, i / 3};
    if (j + 1 == height) return NetSide{2, patches.columns - 1 - i / 3};
  } else if (a % width == b % width) {
    if (i + 1 == width) return NetSide{1, j / 3};
    if (i == 0) return NetSide{3, patches.rows - 1 - j / 3};
  }
  return std::nullopt;
}

RelativePlace relative_place(const Object& from, const Object& to) {
  const Similarity &a = from.transform, &b = to.transform;
  RelativePlace out;
  // Equal parts cancel exactly, without rounding errors.
  if (a.rotation.coeffs() != b.rotation.coeffs() || a.scale != b.scale)
    out.linear = a.scale / b.scale * (b.rotation.conjugate() * a.rotation).toRotationMatrix();
  const Vector3 origin =
      out.linear == Matrix3::Identity() ? from.cage_origin() : Vector3(out.linear * from.cage_origin());
  out.offset =
      (b.rotation.conjugate() * (a.translation - b.translation)) / b.scale + (origin - to.cage_origin());
  return out;
}

FrozenSide side_seen_from(const Object& polyhedron, const Object& patches, const BicubicNet& net,
                          NetSide side, bool reversed) {
  const RelativePlace place = relative_place(patches, polyhedron);
  const SideRows rows = side_rows(net, side);
  FrozenSide out;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t from = reversed ? 3 - i : i;
    out.curve[i] = place.offset + place.linear * net.points[rows.curve[from]];
    out.row[i] = place.offset + place.linear * net.points[rows.row[from]];
  }
  return out;
}

Attachment attachment_to(const Object& polyhedron, EdgeId edge, const Object& patches, NetSide side) {
  const Polyhedron& own = polyhedron.polyhedron()->polyhedron;
  const Index h = own.topology().half_edge_of_edge(own.find(edge));
  const Vector3 &a = own.position(own.topology().origin(h)), &b = own.position(own.topology().target(h));
  const FrozenSide seen = side_seen_from(polyhedron, patches, patches.patches()->control_net(), side, true);
  const double against = (seen.curve[0] - a).squaredNorm() + (seen.curve[3] - b).squaredNorm();
  const double along = (seen.curve[3] - a).squaredNorm() + (seen.curve[0] - b).squaredNorm();
  Attachment out;
  out.patch = patches.id;
  out.side = side;
  out.reversed = against <= along;
  return out;
}

std::optional<Attachment> nearest_side(const Document& document, const Object& polyhedron, EdgeId edge) {
  const Polyhedron& own = polyhedron.polyhedron()->polyhedron;
  const Index e = own.find(edge);
  if (e == no_index) return std::nullopt;
  const Index h = own.topology().half_edge_of_edge(e);
  const Vector3 &a = own.position(own.topology().origin(h)), &b = own.position(own.topology().target(h));
  std::optional<Attachment> best;
  double least = 0;
  for (const auto& object : document.objects) {
    const PatchSource* patches = object->patches();
    if (!patches || !object->visible) continue;
    const BicubicNet net = patches->control_net();
    for (std::uint8_t side = 0; side < 4; ++side)
      for (Index place = 0; place < places_of(net, side); ++place) {
        const Attachment candidate = attachment_to(polyhedron, edge, *object, {side, place});
        const FrozenSide seen = side_seen_from(polyhedron, *object, net, {side, place}, candidate.reversed);
        const double distance = (seen.curve[0] - a).squaredNorm() + (seen.curve[3] - b).squaredNorm();
        if (best && !(distance < least)) continue;
        best = candidate;
        least = distance;
      }
  }
  return best;
}

Result<Document> attach_edge(const Document& document, ObjectId id, EdgeId edge,
                             const Attachment& attachment) {
  const Object* before = document.find(id);
  auto changed = detail::change_object(document, id, true, [&](Object& object) -> Result<Done> {
    auto* source = std::get_if<PolyhedronSource>(&object.source);
    if (!source)
      return make_error(e_wrong_kind, "The object \"" + object.name + "\" is not a polyhedron.",
                        "Select a border edge of a polyhedron.", element_of(id));
    if (const auto checked = check(document, object, edge, attachment); !checked) return checked.error();
    Attachments attachments = *source->attachments;
    attachments.set(edge, attachment);
    source->attachments = std::move(attachments);
    return Done{};
  });
  if (!changed || attachment.frozen) return changed;
  if (follows(*changed, id, id) || follows(*changed, attachment.patch, attachment.patch)) {
    const std::string own = "\"" + before->name + "\"",
                      other = "\"" + document.find(attachment.patch)->name + "\"";
    return make_error(e_attachment_cycle, own + " and " + other + " would each have to follow the other.",
                      "Let the same side adapt at all edges that join the two.", element_of(edge));
  }
  return changed;
}

Polyhedron attached_polyhedron(const Document& document, const Object& object) {
  const PolyhedronSource& source = *object.polyhedron();
  const HalfEdgeMesh& mesh = source.polyhedron.topology();
  std::vector<Index> moved;
  std::vector<Vector3> positions;
  for (const auto& [edge, attachment] : *source.attachments) {
    const Index e = source.polyhedron.find(edge);
    if (e == no_index || !mesh.is_border_edge(e)) continue;
    std::optional<FrozenSide> seen = attachment.frozen;
    const Object* patches = document.find(attachment.patch);
    if (!seen && patches && patches->patches() && has_side(*patches->patches(), attachment.side))
      seen = side_seen_from(object, *patches, patches->patches()->control_net(), attachment.side,
                            attachment.reversed);
    if (!seen) continue;
    const Index h = mesh.half_edge_of_edge(e);
    moved.insert(moved.end(), {mesh.origin(h), mesh.target(h)});
    positions.insert(positions.end(), {seen->curve[0], seen->curve[3]});
  }
  const auto placed = source.polyhedron.with_positions(moved, positions);
  return placed.ok() ? *placed : source.polyhedron;
}

Document with_seen_ends(const Document& document, ObjectId id) {
  const Object* object = document.find(id);
  if (!object || !object->polyhedron() || object->polyhedron()->attachments->empty()) return document;
  Object changed = *object;
  std::get<PolyhedronSource>(changed.source).polyhedron = attached_polyhedron(document, *object);
  return changed == *object ? document : detail::with_object(document, std::move(changed));
}

Result<Document> release_edges(const Document& document, ObjectId id, std::span<const EdgeId> edges) {
  return detail::change_object(document, id, true, [&](Object& object) -> Result<Done> {
    auto* source = std::get_if<PolyhedronSource>(&object.source);
    if (!source)
      return make_error(e_wrong_kind, "The object \"" + object.name + "\" is not a polyhedron.",
                        "Select a polyhedron.", element_of(id));
    const Polyhedron seen = attached_polyhedron(document, object);
    std::vector<Index> moved;
    std::vector<Vector3> positions;
    Attachments attachments = *source->attachments;
    for (const EdgeId edge : edges) {
      if (!attachments.contains(edge)) continue;
      attachments.erase(edge);
      for (const VertexId end : {edge.low, edge.high})
        if (const Index v = seen.find(end); v != no_index) {
          moved.push_back(v);
          positions.push_back(seen.position(v));
        }
    }
    auto placed = source->polyhedron.with_positions(moved, positions);
    if (!placed) return placed.error();
    source->polyhedron = std::move(placed).value();
    source->attachments = std::move(attachments);
    return Done{};
  });
}

Result<Document> let_patch_adapt(const Document& document, ObjectId id, VertexId vertex) {
  const Object* object = document.find(id);
  if (!object) return detail::unknown_object(id);
  const PolyhedronSource* source = object->polyhedron();
  std::optional<std::pair<EdgeId, Attachment>> last;
  if (source)
    for (const auto& [edge, attachment] : *source->attachments)
      if ((edge.low == vertex || edge.high == vertex) && !attachment.frozen &&
          attachment.continuity != Continuity::g0 && attachment.adapts == Adapts::surface)
        last = {edge, attachment};
  if (!last)
    return make_error(e_no_side, "No patch at vertex " + std::to_string(vertex.value) + " can adapt.",
                      "Join one of the edges by position only.", element_of(vertex));
  last->second.adapts = Adapts::patch;
  return attach_edge(document, id, last->first, last->second);
}

Source frozen_source(const Object& polyhedron, std::span<const std::shared_ptr<const Object>> gone) {
  PolyhedronSource out = *polyhedron.polyhedron();
  Attachments attachments = *out.attachments;
  for (const auto& [edge, attachment] : *out.attachments) {
    const auto found = std::find_if(gone.begin(), gone.end(),
                                    [id = attachment.patch](const auto& object) { return object->id == id; });
    if (attachment.frozen || found == gone.end() || !(*found)->patches() ||
        !has_side(*(*found)->patches(), attachment.side))
      continue;
    Attachment changed = attachment;
    changed.frozen = side_seen_from(polyhedron, **found, (*found)->patches()->control_net(), attachment.side,
                                    attachment.reversed);
    changed.patch = {};
    changed.side = {};
    changed.reversed = true;
    if (attachment.adapts == Adapts::patch) changed.continuity = Continuity::g0;
    changed.adapts = Adapts::surface;
    attachments.set(edge, changed);
  }
  if (!(attachments == *out.attachments)) out.attachments = std::move(attachments);
  return out;
}

std::size_t attached_to(const Document& document, std::span<const ObjectId> objects) {
  const auto among = [&](ObjectId id) {
    return std::find(objects.begin(), objects.end(), id) != objects.end();
  };
  std::size_t count = 0;
  for (const auto& object : document.objects) {
    if (!object->polyhedron() || among(object->id)) continue;
    for (const auto& [edge, attachment] : *object->polyhedron()->attachments)
      if (!attachment.frozen && among(attachment.patch)) ++count;
  }
  return count;
}

}  // namespace hariko
