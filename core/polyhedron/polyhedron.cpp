#include "core/polyhedron/polyhedron.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/polyhedron/element_names.hpp"
#include "core/polyhedron/mesh_errors.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {

namespace {

template <class Id>
std::vector<Id> ascending_ids(std::size_t count) {
  std::vector<Id> ids(count);
  for (std::size_t i = 0; i < count; ++i) ids[i].value = static_cast<std::uint32_t>(i);
  return ids;
}

/// Whether ids ascend strictly and none is the "no element" value.
template <class Id>
bool are_valid(const std::vector<Id>& ids, std::size_t count) {
  if (ids.size() != count) return false;
  for (std::size_t i = 1; i < count; ++i)
    if (!(ids[i - 1] < ids[i])) return false;
  return ids.empty() || ids.back() != Id{};
}

template <class Id>
Index find_sorted(const std::vector<Id>& ids, Id id) {
  const auto it = std::lower_bound(ids.begin(), ids.end(), id);
  return it != ids.end() && *it == id ? static_cast<Index>(it - ids.begin()) : no_index;
}

}  // namespace

Result<Polyhedron> Polyhedron::build(const PolygonMesh& mesh) {
  return build(mesh, ascending_ids<VertexId>(mesh.positions.size()),
               ascending_ids<FaceId>(mesh.face_count()));
}

Result<Polyhedron> Polyhedron::build(const PolygonMesh& mesh, std::vector<VertexId> vertex_ids,
                                     std::vector<FaceId> face_ids) {
  if (!are_valid(vertex_ids, mesh.positions.size()) || !are_valid(face_ids, mesh.face_count()))
    return make_error(e_index_range, "The ids of the vertices or faces are not one each in ascending order.",
                      "Number vertices and faces in ascending order, each once.");
  const ElementNames names{vertex_ids, face_ids};
  const auto named = [&](Message message) {
    message.element = names.of_dense(message.element);
    return message;
  };
  for (const Vector3& position : mesh.positions)
    if (!position.allFinite()) return named(position_errors(mesh, 1).front());
  Result<HalfEdgeMesh> topology = HalfEdgeMesh::build(mesh);
  if (!topology) return named(topology.error());

  Polyhedron out;
  out.topology_ = std::make_shared<const HalfEdgeMesh>(std::move(topology).value());
  out.vertex_ids_ = std::make_shared<const std::vector<VertexId>>(std::move(vertex_ids));
  out.face_ids_ = std::make_shared<const std::vector<FaceId>>(std::move(face_ids));
  out.positions_ = ChunkedArray<Vector3, 128>(mesh.positions);
  return out;
}

EdgeId Polyhedron::edge_id(Index e) const {
  const Index h = topology_->half_edge_of_edge(e);
  return EdgeId::of(vertex_id(topology_->origin(h)), vertex_id(topology_->target(h)));
}

Index Polyhedron::find(VertexId id) const {
  return find_sorted(*vertex_ids_, id);
}

Index Polyhedron::find(FaceId id) const {
  return find_sorted(*face_ids_, id);
}

Index Polyhedron::find(EdgeId id) const {
  const Index a = find(id.low), b = find(id.high);
  if (a == no_index || b == no_index) return no_index;
  Index h = topology_->find_half_edge(a, b);
  if (h == no_index) h = topology_->find_half_edge(b, a);
  return h == no_index ? no_index : topology_->edge(h);
}

Result<Polyhedron> Polyhedron::with_positions(std::span<const Index> vertices,
                                              std::span<const Vector3> positions) const {
  HARIKO_ASSERT(vertices.size() == positions.size(), "one position a vertex");
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (!positions[i].allFinite())
      return make_error(e_nonfinite, "A coordinate of the vertex would be infinite or not a number.",
                        "Move the vertex less far.", element_of(vertex_id(vertices[i])));
  Polyhedron out = *this;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (out.positions_[vertices[i]] != positions[i]) out.positions_.edit(vertices[i]) = positions[i];
  return out;
}

PolygonMesh Polyhedron::to_mesh() const {
  PolygonMesh mesh;
  mesh.positions = positions_.to_vector();
  mesh.face_offsets.reserve(face_count() + 1);
  mesh.face_vertices.reserve(topology_->half_edge_count());
  for (Index f = 0; f < face_count(); ++f) mesh.add_face(topology_->face_vertices(f));
  return mesh;
}

std::vector<Vector3> Polyhedron::corners(Index face) const {
  std::vector<Vector3> out;
  for (const Index v : topology_->face_vertices(face)) out.push_back(position(v));
  return out;
}

bool operator==(const Polyhedron& a, const Polyhedron& b) {
  return (a.topology_ == b.topology_ || *a.topology_ == *b.topology_) &&
         (a.vertex_ids_ == b.vertex_ids_ || *a.vertex_ids_ == *b.vertex_ids_) &&
         (a.face_ids_ == b.face_ids_ || *a.face_ids_ == *b.face_ids_) && a.positions_ == b.positions_;
}

Vector3 origin_for(std::span<const Vector3> positions) {
  const double infinity = std::numeric_limits<double>::infinity();
  Vector3 low = Vector3::Constant(infinity), high = Vector3::Constant(-infinity);
  for (const Vector3& p : positions) {
    if (!p.allFinite()) continue;
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  if (!(low.array() <= high.array()).all()) return Vector3::Zero();
  // Halved before the subtraction, so that boxes of nearly the largest numbers do not overflow.
  Vector3 centre = low / 2 + high / 2;
  const double half_extent = (high / 2 - low / 2).maxCoeff();
  if (half_extent == 0) return centre;
  int exponent = 0;
  const double mantissa = std::frexp(half_extent, &exponent);  // in [0.5, 1)
  const double step = std::ldexp(1.0, mantissa == 0.5 ? exponent : exponent + 1);
  if (!std::isfinite(step)) return Vector3::Zero();
  // Beyond 2^53 steps a double is a multiple of the step already. Ties go to even, so that [0, 1] keeps
  // origin 0.
  return centre.unaryExpr(
      [step](double c) { return std::abs(c) / step < 0x1p53 ? std::nearbyint(c / step) * step + 0.0 : c; });
}

}  // namespace hariko
