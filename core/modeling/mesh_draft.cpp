#include "core/modeling/mesh_draft.hpp"

#include <algorithm>
#include <utility>

#include "core/modeling/shaping_cleanup.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {
namespace {

/// The error of a mesh that could not be built, in the words of one who modelled it. New elements have no
/// names yet that a designer could know, so only elements of the source are named.
Message refusal(const Message& error, const Polyhedron& source) {
  if (error.code == e_nonfinite)
    return make_error(e_nonfinite, "A vertex would lie infinitely far away.", "Use a smaller amount.");
  if (error.code == e_no_faces)
    return make_error(e_no_faces, "No face would be left of the object.", "Delete the object instead.");
  bool known = false;
  switch (error.element.kind) {
    case Element::Kind::vertex:
      known = source.find(VertexId{static_cast<std::uint32_t>(error.element.id)}) != no_index;
      break;
    case Element::Kind::edge:
      known = source.find(EdgeId::from_packed(error.element.id)) != no_index;
      break;
    case Element::Kind::face:
      known = source.find(FaceId{static_cast<std::uint32_t>(error.element.id)}) != no_index;
      break;
    default:
      break;
  }
  const char* text =
      error.code == e_vertex_nonmanifold ? "Parts of the object would touch in a single vertex only."
      : error.code == e_edge_nonmanifold_or_flipped
          ? "An edge would belong to more than two faces, or its faces would face opposite ways."
          : "A face would pass through one of its vertices twice, or have fewer than three corners.";
  return make_error(e_would_be_nonmanifold, text, "Choose other elements, or split the parts first.",
                    known ? error.element : Element{});
}

/// An edge that is gone, or inside now, is attached no more.
void drop_attachments(PolyhedronSource& source) {
  if (source.attachments->empty()) return;
  Attachments kept;
  for (const auto& [edge, attachment] : *source.attachments)
    if (const Index e = source.polyhedron.find(edge);
        e != no_index && source.polyhedron.topology().is_border_edge(e))
      kept.set(edge, attachment);
  if (!(kept == *source.attachments)) source.attachments = std::move(kept);
}

}  // namespace

MeshDraft::MeshDraft(const PolyhedronSource& source)
    : source_(source), next_vertex_{0}, next_face_{0}, shaping_(*source.shaping) {
  const Polyhedron& polyhedron = source_.polyhedron;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v)
    vertices_.emplace_hint(vertices_.end(), polyhedron.vertex_id(v), Vertex{polyhedron.position(v), {}});
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    std::vector<VertexId> corners;
    for (const Index v : polyhedron.topology().face_vertices(f)) corners.push_back(polyhedron.vertex_id(v));
    link(polyhedron.face_id(f), corners);
    faces_.emplace_hint(faces_.end(), polyhedron.face_id(f), std::move(corners));
  }
  if (!vertices_.empty()) next_vertex_.value = vertices_.rbegin()->first.value + 1;
  if (!faces_.empty()) next_face_.value = faces_.rbegin()->first.value + 1;
}

const MeshDraft::Vertex& MeshDraft::at(VertexId id) const {
  const auto found = vertices_.find(id);
  HARIKO_ASSERT(found != vertices_.end(), "the vertex must be in the draft");
  return found->second;
}

MeshDraft::Vertex& MeshDraft::at(VertexId id) {
  return const_cast<Vertex&>(std::as_const(*this).at(id));
}

std::span<const VertexId> MeshDraft::face(FaceId id) const {
  const auto found = faces_.find(id);
  HARIKO_ASSERT(found != faces_.end(), "the face must be in the draft");
  return found->second;
}

std::vector<Vector3> MeshDraft::corners(FaceId id) const {
  std::vector<Vector3> out;
  for (const VertexId v : face(id)) out.push_back(position(v));
  return out;
}

std::vector<VertexId> MeshDraft::vertices() const {
  std::vector<VertexId> out;
  out.reserve(vertices_.size());
  for (const auto& entry : vertices_) out.push_back(entry.first);
  return out;
}

std::vector<FaceId> MeshDraft::faces() const {
  std::vector<FaceId> out;
  out.reserve(faces_.size());
  for (const auto& entry : faces_) out.push_back(entry.first);
  return out;
}

std::vector<FaceId> MeshDraft::faces_at(EdgeId id) const {
  if (!contains(id.low) || !contains(id.high)) return {};
  const auto &low = at(id.low).faces, &high = at(id.high).faces;
  std::vector<FaceId> out;
  for (const FaceId f : low.size() <= high.size() ? low : high) {
    const auto corners = face(f);
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (EdgeId::of(corners[i], corners[(i + 1) % corners.size()]) == id) {
        out.push_back(f);
        break;
      }
  }
  return out;
}

void MeshDraft::link(FaceId face, std::span<const VertexId> corners) {
  for (const VertexId v : corners) {
    std::vector<FaceId>& faces = at(v).faces;
    const auto place = std::lower_bound(faces.begin(), faces.end(), face);
    if (place == faces.end() || *place != face) faces.insert(place, face);
  }
}

void MeshDraft::unlink(FaceId face, std::span<const VertexId> corners) {
  for (const VertexId v : corners) {
    std::vector<FaceId>& faces = at(v).faces;
    const auto place = std::lower_bound(faces.begin(), faces.end(), face);
    if (place != faces.end() && *place == face) faces.erase(place);
  }
}

// The greatest id of all means "no element": a draft that runs into it is refused by Polyhedron::build, so
// counting simply stops there.
VertexId MeshDraft::add_vertex(const Vector3& position) {
  const VertexId id = next_vertex_;
  if (next_vertex_ != VertexId{}) ++next_vertex_.value;
  vertices_.insert_or_assign(id, Vertex{position, {}});
  return id;
}

VertexId MeshDraft::add_vertex(const Vector3& position, const RefinedPoint& place) {
  const VertexId id = add_vertex(position);
  places_.insert_or_assign(id, place);
  return id;
}

FaceId MeshDraft::add_face(std::vector<VertexId> corners) {
  const FaceId id = next_face_;
  if (next_face_ != FaceId{}) ++next_face_.value;
  if (faces_.contains(id)) remove_face(id);
  link(id, corners);
  faces_.emplace(id, std::move(corners));
  return id;
}

void MeshDraft::set_face(FaceId id, std::vector<VertexId> corners) {
  unlink(id, face(id));
  link(id, corners);
  faces_.at(id) = std::move(corners);
}

void MeshDraft::remove_face(FaceId id) {
  unlink(id, face(id));
  faces_.erase(id);
}

void MeshDraft::split_edge(EdgeId edge, VertexId middle) {
  const std::vector<FaceId> sides = faces_at(edge);
  if (sides.size() == 1) outline_points_.insert(middle);
  for (const FaceId f : sides) {
    const auto old = face(f);
    std::vector<VertexId> corners;
    corners.reserve(old.size() + 1);
    for (std::size_t i = 0; i < old.size(); ++i) {
      corners.push_back(old[i]);
      if (EdgeId::of(old[i], old[(i + 1) % old.size()]) == edge) corners.push_back(middle);
    }
    faces_.at(f) = std::move(corners);
    link(f, std::span<const VertexId>(&middle, 1));
  }
  inherit(edge, EdgeId::of(edge.low, middle));
  inherit(edge, EdgeId::of(middle, edge.high));
  shaping_.beta.erase(edge);
  shaping_.crease.erase(edge);
}

void MeshDraft::inherit(EdgeId from, EdgeId to) {
  if (const double* beta = shaping_.beta.find(from))
    shaping_.beta.set(to, double(*beta));
  else
    shaping_.beta.erase(to);
  if (shaping_.crease.contains(from))
    shaping_.crease.set(to, true);
  else
    shaping_.crease.erase(to);
}

void MeshDraft::inherit(VertexId from, VertexId to) {
  if (const double* alpha = shaping_.alpha.find(from))
    shaping_.alpha.set(to, double(*alpha));
  else
    shaping_.alpha.erase(to);
  if (const VertexTag* tag = shaping_.tag.find(from))
    shaping_.tag.set(to, VertexTag(*tag));
  else
    shaping_.tag.erase(to);
}

// An automatic border vertex is a corner exactly when it has two edges: new edges must not round corners, nor
// new points make them.
void MeshDraft::keep_outline(const Polyhedron& after) {
  const auto edges_at = [](const Polyhedron& polyhedron, VertexId id) {
    const Index v = polyhedron.find(id);
    return v != no_index && polyhedron.topology().is_border_vertex(v) ? polyhedron.topology().valence(v) : 0;
  };
  for (const VertexId id : outline_points_)
    if (edges_at(after, id) == 2 && !shaping_.tag.contains(id)) shaping_.tag.set(id, VertexTag::smooth);
  const Polyhedron& before = source_.polyhedron;
  for (Index v = 0; v < before.vertex_count(); ++v) {
    const VertexId id = before.vertex_id(v);
    if (edges_at(before, id) == 2 && edges_at(after, id) > 2 && !shaping_.tag.contains(id) &&
        !released_corners_.contains(id))
      shaping_.tag.set(id, VertexTag::corner);
  }
}

Result<PolyhedronSource> MeshDraft::finish() && {
  PolygonMesh mesh;
  std::vector<VertexId> vertex_ids;
  std::vector<FaceId> face_ids;
  std::map<VertexId, Index> dense;
  for (const auto& [id, vertex] : vertices_) {
    if (vertex.faces.empty()) continue;
    dense.emplace_hint(dense.end(), id, static_cast<Index>(mesh.positions.size()));
    mesh.positions.push_back(vertex.position);
    vertex_ids.push_back(id);
  }
  std::vector<Index> face;
  for (const auto& [id, corners] : faces_) {
    face.clear();
    for (const VertexId v : corners) face.push_back(dense.at(v));
    mesh.add_face(face);
    face_ids.push_back(id);
  }
  if (vertices_.contains(VertexId{}) || faces_.contains(FaceId{}))
    return make_error(e_too_many_elements, "The numbers for new vertices or faces are used up.",
                      "Export the object and import it again: that numbers its elements afresh.");
  Result<Polyhedron> built = Polyhedron::build(mesh, std::move(vertex_ids), std::move(face_ids));
  if (!built) return refusal(built.error(), source_.polyhedron);
  keep_outline(*built);
  PolyhedronSource out = std::move(source_);
  Shaping shaping = detail::shaping_on(*built, shaping_, out.polyhedron, *out.shaping);
  out.polyhedron = *std::move(built);
  drop_attachments(out);
  if (!(shaping == *out.shaping)) out.shaping = std::move(shaping);
  return out;
}

Result<Modeled> MeshDraft::finish(ElementSet selection) && {
  Result<PolyhedronSource> source = std::move(*this).finish();
  if (!source) return source.error();
  return Modeled{std::move(source).value(), std::move(selection)};
}

}  // namespace hariko
