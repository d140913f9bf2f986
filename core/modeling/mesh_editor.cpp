#include "core/modeling/mesh_editor.hpp"

#include <algorithm>
#include <utility>

#include "core/modeling/shaping_cleanup.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {
namespace {

/// Error of a mesh that could not be built, in the designer's terms. Only elements of the source are named,
/// because the designer does not know new ones yet.
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

/// Removes attachments of edges that are gone or no longer on a border.
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

MeshEditor::MeshEditor(const PolyhedronSource& source)
    : source_(source), next_vertex_{0}, next_face_{0}, shaping_(*source.shaping) {
  const Polyhedron& polyhedron = source_.polyhedron;
  const HalfEdgeMesh& topology = polyhedron.topology();
  source_corners_.reserve(topology.half_edge_count());
  for (Index h = 0; h < topology.half_edge_count(); ++h)
    source_corners_.push_back(polyhedron.vertex_id(topology.origin(h)));
  if (const Index count = polyhedron.vertex_count(); count > 0)
    next_vertex_.value = polyhedron.vertex_id(count - 1).value + 1;
  if (const Index count = polyhedron.face_count(); count > 0)
    next_face_.value = polyhedron.face_id(count - 1).value + 1;
}

bool MeshEditor::contains(FaceId id) const {
  if (changed_faces_.contains(id)) return true;
  return source_.polyhedron.find(id) != no_index && !removed_faces_.contains(id);
}

const Vector3& MeshEditor::position(VertexId id) const {
  if (const auto found = changed_vertices_.find(id); found != changed_vertices_.end())
    return found->second.position;
  const Index v = source_.polyhedron.find(id);
  HARIKO_ASSERT(v != no_index, "the vertex must be in the draft");
  return source_.polyhedron.position(v);
}

std::vector<FaceId> MeshEditor::faces_at(VertexId id) const {
  if (const auto found = changed_vertices_.find(id); found != changed_vertices_.end())
    return found->second.faces;
  const Polyhedron& polyhedron = source_.polyhedron;
  const HalfEdgeMesh& topology = polyhedron.topology();
  const Index v = polyhedron.find(id);
  HARIKO_ASSERT(v != no_index, "the vertex must be in the draft");
  std::vector<FaceId> out;
  for (const Index h : topology.fan_corners(v)) out.push_back(polyhedron.face_id(topology.face(h)));
  std::sort(out.begin(), out.end());
  return out;
}

MeshEditor::Vertex& MeshEditor::edit(VertexId id) {
  const auto found = changed_vertices_.lower_bound(id);
  if (found != changed_vertices_.end() && found->first == id) return found->second;
  return changed_vertices_.emplace_hint(found, id, Vertex{position(id), faces_at(id)})->second;
}

std::span<const VertexId> MeshEditor::face(FaceId id) const {
  if (const auto found = changed_faces_.find(id); found != changed_faces_.end()) return found->second;
  const Index f = source_.polyhedron.find(id);
  HARIKO_ASSERT(f != no_index && !removed_faces_.contains(id), "the face must be in the draft");
  const HalfEdgeMesh& topology = source_.polyhedron.topology();
  return std::span(source_corners_).subspan(topology.face_begin(f), topology.side_count(f));
}

std::vector<Vector3> MeshEditor::corners(FaceId id) const {
  std::vector<Vector3> out;
  for (const VertexId v : face(id)) out.push_back(position(v));
  return out;
}

std::vector<VertexId> MeshEditor::vertices() const {
  const Polyhedron& polyhedron = source_.polyhedron;
  std::vector<VertexId> out;
  out.reserve(polyhedron.vertex_count() + changed_vertices_.size());
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) out.push_back(polyhedron.vertex_id(v));
  // New ids are greater than all of the source, except the id that means that they are used up.
  for (auto at = changed_vertices_.upper_bound(out.empty() ? VertexId{0} : out.back());
       at != changed_vertices_.end(); ++at)
    out.push_back(at->first);
  return out;
}

std::vector<FaceId> MeshEditor::faces() const {
  const Polyhedron& polyhedron = source_.polyhedron;
  std::vector<FaceId> out;
  out.reserve(polyhedron.face_count() + changed_faces_.size());
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    if (const FaceId id = polyhedron.face_id(f); !removed_faces_.contains(id)) out.push_back(id);
  const FaceId last =
      polyhedron.face_count() > 0 ? polyhedron.face_id(polyhedron.face_count() - 1) : FaceId{0};
  for (auto at = changed_faces_.upper_bound(last); at != changed_faces_.end(); ++at) out.push_back(at->first);
  return out;
}

std::vector<FaceId> MeshEditor::faces_at(EdgeId id) const {
  if (!contains(id.low) || !contains(id.high)) return {};
  const std::vector<FaceId> low = faces_at(id.low), high = faces_at(id.high);
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

void MeshEditor::link(FaceId face, std::span<const VertexId> corners) {
  for (const VertexId v : corners) {
    std::vector<FaceId>& faces = edit(v).faces;
    const auto place = std::lower_bound(faces.begin(), faces.end(), face);
    if (place == faces.end() || *place != face) faces.insert(place, face);
  }
}

void MeshEditor::unlink(FaceId face, std::span<const VertexId> corners) {
  for (const VertexId v : corners) {
    std::vector<FaceId>& faces = edit(v).faces;
    const auto place = std::lower_bound(faces.begin(), faces.end(), face);
    if (place != faces.end() && *place == face) faces.erase(place);
  }
}

// The greatest id of all means "no element": a draft that runs into it is refused by Polyhedron::build, so
// counting simply stops there.
VertexId MeshEditor::add_vertex(const Vector3& position) {
  const VertexId id = next_vertex_;
  if (next_vertex_ != VertexId{}) ++next_vertex_.value;
  changed_vertices_.insert_or_assign(id, Vertex{position, {}});
  return id;
}

VertexId MeshEditor::add_vertex(const Vector3& position, const RefinedPoint& place) {
  const VertexId id = add_vertex(position);
  places_.insert_or_assign(id, place);
  return id;
}

FaceId MeshEditor::add_face(std::vector<VertexId> corners) {
  const FaceId id = next_face_;
  if (next_face_ != FaceId{}) ++next_face_.value;
  if (contains(id)) remove_face(id);
  link(id, corners);
  changed_faces_.emplace(id, std::move(corners));
  return id;
}

void MeshEditor::set_face(FaceId id, std::vector<VertexId> corners) {
  unlink(id, face(id));
  link(id, corners);
  changed_faces_.insert_or_assign(id, std::move(corners));
}

void MeshEditor::remove_face(FaceId id) {
  unlink(id, face(id));
  changed_faces_.erase(id);
  if (source_.polyhedron.find(id) != no_index) removed_faces_.insert(id);
}

void MeshEditor::split_edge(EdgeId edge, VertexId middle) {
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
    changed_faces_.insert_or_assign(f, std::move(corners));
    link(f, std::span<const VertexId>(&middle, 1));
  }
  inherit(edge, EdgeId::of(edge.low, middle));
  inherit(edge, EdgeId::of(middle, edge.high));
  shaping_.beta.erase(edge);
  shaping_.crease.erase(edge);
}

void MeshEditor::inherit(EdgeId from, EdgeId to) {
  if (const double* beta = shaping_.beta.find(from))
    shaping_.beta.set(to, double(*beta));
  else
    shaping_.beta.erase(to);
  if (shaping_.crease.contains(from))
    shaping_.crease.set(to, true);
  else
    shaping_.crease.erase(to);
}

void MeshEditor::inherit(VertexId from, VertexId to) {
  if (const double* alpha = shaping_.alpha.find(from))
    shaping_.alpha.set(to, double(*alpha));
  else
    shaping_.alpha.erase(to);
  if (const VertexTag* tag = shaping_.tag.find(from))
    shaping_.tag.set(to, VertexTag(*tag));
  else
    shaping_.tag.erase(to);
}

// Keeps the corners of the border. An automatic border vertex is a corner exactly when it has two edges; new
// edges must not smooth corners, and new points must not make any.
void MeshEditor::keep_outline(const Polyhedron& after) {
  const auto edges_at = [&after](VertexId id) {
    const Index v = after.find(id);
    return v != no_index && after.topology().is_border_vertex(v) ? after.topology().valence(v) : 0;
  };
  for (const VertexId id : outline_points_)
    if (edges_at(id) == 2 && !shaping_.tag.contains(id)) shaping_.tag.set(id, VertexTag::smooth);
  const Polyhedron& before = source_.polyhedron;
  const HalfEdgeMesh& topology = before.topology();
  for (Index v = 0; v < before.vertex_count(); ++v) {
    if (!topology.is_border_vertex(v) || topology.valence(v) != 2) continue;
    const VertexId id = before.vertex_id(v);
    if (edges_at(id) > 2 && !shaping_.tag.contains(id) && !released_corners_.contains(id))
      shaping_.tag.set(id, VertexTag::corner);
  }
}

Result<Polyhedron> MeshEditor::build() const {
  const Polyhedron& source = source_.polyhedron;
  const HalfEdgeMesh& topology = source.topology();
  PolygonMesh mesh;
  std::vector<VertexId> vertex_ids;
  std::vector<FaceId> face_ids;
  mesh.positions.reserve(source.vertex_count() + changed_vertices_.size());
  vertex_ids.reserve(source.vertex_count() + changed_vertices_.size());
  // Dense numbers of the vertices that have faces: those of the source by their index there, new ones by id.
  std::vector<Index> number(source.vertex_count(), no_index);
  std::map<VertexId, Index> new_number;
  const auto put = [&](VertexId id, const Vector3& position) {
    mesh.positions.push_back(position);
    vertex_ids.push_back(id);
    return static_cast<Index>(vertex_ids.size() - 1);
  };
  auto changed = changed_vertices_.begin();
  for (Index v = 0; v < source.vertex_count(); ++v) {
    const VertexId id = source.vertex_id(v);
    if (changed == changed_vertices_.end() || changed->first != id) {
      if (topology.outgoing(v) != no_index) number[v] = put(id, source.position(v));
      continue;
    }
    if (!changed->second.faces.empty()) number[v] = put(id, changed->second.position);
    ++changed;
  }
  for (; changed != changed_vertices_.end(); ++changed)
    if (!changed->second.faces.empty())
      new_number.emplace_hint(new_number.end(), changed->first,
                              put(changed->first, changed->second.position));

  std::vector<Index> corners;
  const auto put_face = [&](FaceId id, std::span<const VertexId> ids) {
    corners.clear();
    for (const VertexId v : ids) {
      const Index known = source.find(v);
      corners.push_back(known != no_index ? number[known] : new_number.at(v));
    }
    mesh.add_face(corners);
    face_ids.push_back(id);
  };
  auto changed_face = changed_faces_.begin();
  for (Index f = 0; f < source.face_count(); ++f) {
    const FaceId id = source.face_id(f);
    if (changed_face != changed_faces_.end() && changed_face->first == id) {
      put_face(id, changed_face->second);
      ++changed_face;
    } else if (!removed_faces_.contains(id)) {
      corners.clear();
      for (const Index v : topology.face_vertices(f)) corners.push_back(number[v]);
      mesh.add_face(corners);
      face_ids.push_back(id);
    }
  }
  for (; changed_face != changed_faces_.end(); ++changed_face)
    put_face(changed_face->first, changed_face->second);
  return Polyhedron::build(mesh, std::move(vertex_ids), std::move(face_ids));
}

Result<PolyhedronSource> MeshEditor::finish() && {
  if (changed_vertices_.contains(VertexId{}) || changed_faces_.contains(FaceId{}))
    return make_error(e_too_many_elements, "The numbers for new vertices or faces are used up.",
                      "Export the object and import it again: that numbers its elements afresh.");
  Result<Polyhedron> built = build();
  if (!built) return refusal(built.error(), source_.polyhedron);
  keep_outline(*built);
  PolyhedronSource out = std::move(source_);
  Shaping shaping = detail::shaping_on(*built, shaping_, out.polyhedron, *out.shaping);
  out.polyhedron = *std::move(built);
  drop_attachments(out);
  if (!(shaping == *out.shaping)) out.shaping = std::move(shaping);
  return out;
}

Result<EditResult> MeshEditor::finish(ElementSet selection) && {
  Result<PolyhedronSource> source = std::move(*this).finish();
  if (!source) return source.error();
  return EditResult{std::move(source).value(), std::move(selection)};
}

}  // namespace hariko
