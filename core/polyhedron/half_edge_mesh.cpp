#include "core/polyhedron/half_edge_mesh.hpp"

#include <algorithm>

#include "core/polyhedron/edge_table.hpp"
#include "core/polyhedron/face_check.hpp"
#include "core/polyhedron/mesh_errors.hpp"

namespace hariko {

namespace {

bool faces_are_sound(const PolygonMesh& mesh) {
  FaceCheck check(mesh.positions.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    if (check(mesh.face(f)) != FaceFault::none) return false;
  return mesh.face_count() > 0;
}

Message first_error(const PolygonMesh& mesh) {
  std::vector<Message> errors = connectivity_errors(mesh, 1);
  HARIKO_ASSERT(!errors.empty(), "a mesh that cannot be built has an error");
  return std::move(errors.front());
}

}  // namespace

Result<HalfEdgeMesh> HalfEdgeMesh::build(const PolygonMesh& mesh) {
  HARIKO_ASSERT(!mesh.face_offsets.empty() && mesh.face_offsets.back() == mesh.face_vertices.size(),
                "face offsets must cover the corners");
  if (!faces_are_sound(mesh)) return first_error(mesh);
  HalfEdgeMesh out;
  out.face_offsets_ = mesh.face_offsets;
  out.origin_ = mesh.face_vertices;
  if (!out.link_twins(mesh)) return first_error(mesh);
  out.number_faces_and_edges();
  if (!out.find_fans(static_cast<Index>(mesh.positions.size()))) return first_error(mesh);
  return out;
}

bool HalfEdgeMesh::link_twins(const PolygonMesh& mesh) {
  twin_.assign(origin_.size(), no_index);
  bool manifold = true;
  EdgeTable(mesh).for_each_edge([&](Index, Index, std::span<const EdgeUse> uses) {
    if (!is_manifold_edge(mesh, uses)) {
      manifold = false;
    } else if (uses.size() == 2) {
      twin_[uses[0].corner] = uses[1].corner;
      twin_[uses[1].corner] = uses[0].corner;
    }
  });
  return manifold;
}

void HalfEdgeMesh::number_faces_and_edges() {
  face_.resize(origin_.size());
  for (Index f = 0; f < face_count(); ++f)
    std::fill(face_.begin() + face_offsets_[f], face_.begin() + face_offsets_[f + 1], f);
  edge_.resize(origin_.size());
  edge_half_edge_.reserve(origin_.size() / 2 + 1);
  for (Index h = 0; h < half_edge_count(); ++h) {
    if (twin_[h] < h) {
      edge_[h] = edge_[twin_[h]];
    } else {
      edge_[h] = edge_count();
      edge_half_edge_.push_back(h);
    }
  }
}

/// Chooses the first half-edge of every fan; false where the corners of a vertex form several fans.
bool HalfEdgeMesh::find_fans(Index vertex_count) {
  outgoing_.assign(vertex_count, no_index);
  corner_count_.assign(vertex_count, 0);
  for (Index h = 0; h < half_edge_count(); ++h) {
    const Index v = origin_[h];
    ++corner_count_[v];
    if (outgoing_[v] == no_index || (twin_[h] == no_index && twin_[outgoing_[v]] != no_index))
      outgoing_[v] = h;
  }
  // Rotation about a vertex is a partial injection on its half-edges, so every walk ends at the boundary or
  // at its start.
  for (Index v = 0; v < vertex_count; ++v) {
    const Index start = outgoing_[v];
    if (start == no_index) continue;
    Index count = 1;
    for (Index h = rotate(start); h != no_index && h != start; h = rotate(h)) ++count;
    if (count != corner_count_[v]) return false;
  }
  return true;
}

Index HalfEdgeMesh::find_half_edge(Index a, Index b) const {
  for (const Index h : fan_corners(a))
    if (target(h) == b) return h;
  return no_index;
}

std::vector<Index> HalfEdgeMesh::face_components() const {
  std::vector<Index> component(face_count(), no_index);
  std::vector<Index> stack;
  Index count = 0;
  for (Index seed = 0; seed < face_count(); ++seed) {
    if (component[seed] != no_index) continue;
    component[seed] = count;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index f = stack.back();
      stack.pop_back();
      for (Index h = face_begin(f); h < face_end(f); ++h) {
        if (twin(h) == no_index || component[face(twin(h))] != no_index) continue;
        component[face(twin(h))] = count;
        stack.push_back(face(twin(h)));
      }
    }
    ++count;
  }
  return component;
}

Index HalfEdgeMesh::border_loop_count() const {
  std::vector<char> visited(vertex_count(), 0);
  Index loops = 0;
  for (Index v = 0; v < vertex_count(); ++v) {
    if (visited[v] || !is_border_vertex(v)) continue;
    ++loops;
    // The first half-edge of a boundary vertex's fan leads along the boundary to the next boundary vertex.
    for (Index w = v; !visited[w]; w = target(outgoing(w))) visited[w] = 1;
  }
  return loops;
}

bool operator==(const HalfEdgeMesh& a, const HalfEdgeMesh& b) {
  return a.vertex_count() == b.vertex_count() && a.face_offsets_ == b.face_offsets_ && a.origin_ == b.origin_;
}

std::vector<FanEnd> fan_ends(const HalfEdgeMesh& mesh, Index v) {
  std::vector<FanEnd> out;
  for (const Index h : mesh.fan_corners(v)) {
    out.push_back({2 * h, mesh.target(h)});
    const Index last = mesh.previous(h);
    if (mesh.rotate(h) == no_index) out.push_back({2 * last + 1, mesh.origin(last)});
  }
  return out;
}

}  // namespace hariko
