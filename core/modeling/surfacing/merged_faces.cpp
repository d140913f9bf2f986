#include "core/modeling/surfacing/merged_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>

#include "core/geometry/polygon.hpp"
#include "core/modeling/mesh_editor.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "core/polyhedron/message_group.hpp"

namespace hariko {
namespace {

/// Largest angle between the normals of faces that count as coplanar, radians.
constexpr double coplanar_angle = 1e-6;
constexpr std::size_t most_warnings = 100;

Index most_sides(Mode mode) {
  return mode == Mode::fair || mode == Mode::g2 ? largest_fair_side_count : no_index;
}

/// Merges faces pair by pair, each time over all the sides that the pair has in common.
class FaceMerger {
 public:
  explicit FaceMerger(const PolyhedronSource& source)
      : polyhedron_(source.polyhedron),
        mesh_(polyhedron_.topology()),
        shaping_(*source.shaping),
        most_sides_(most_sides(source.mode)),
        place_(polyhedron_.vertex_count(), no_index) {
    for (Index f = 0; f < mesh_.face_count(); ++f) normals_.push_back(newell_normal(polyhedron_.corners(f)));
  }

  std::vector<MergedFaces::Group> run() {
    find_free_edges();
    std::vector<char> visited(mesh_.face_count(), 0);
    std::vector<MergedFaces::Group> out;
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      if (visited[f]) continue;
      const std::vector<Index> plane = faces_in_plane(f, visited);
      if (plane.size() > 1) merge_plane(plane, out);
    }
    std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.faces < b.faces; });
    return out;
  }

 private:
  bool is_triangle(Index h) const { return mesh_.side_count(mesh_.face(h)) == 3; }

  bool in_one_plane(const Vector3& a, const Vector3& b) const {
    return a.dot(b) > 0 && a.cross(b).norm() <= coplanar_angle * a.norm() * b.norm();
  }

  void find_free_edges() {
    free_.assign(mesh_.edge_count(), 0);
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      const Index h = mesh_.half_edge_of_edge(e), t = mesh_.twin(h);
      const EdgeId id = polyhedron_.edge_id(e);
      free_[e] = t != no_index && is_triangle(h) && is_triangle(t) && !shaping_.crease.contains(id) &&
                 !shaping_.beta.contains(id) &&
                 in_one_plane(normals_[mesh_.face(h)], normals_[mesh_.face(t)]);
    }
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (keeps_edges(v)) for_edges(v, [&](Index e) { free_[e] = 0; });
  }

  template <class Body>
  void for_edges(Index v, const Body& body) const {
    for (const Index h : mesh_.fan_corners(v)) {
      body(mesh_.edge(h));
      if (mesh_.rotate(h) == no_index) body(mesh_.edge(mesh_.previous(h)));
    }
  }

  bool keeps_edges(Index v) const {
    if (mesh_.outgoing(v) == no_index) return false;
    const VertexId id = polyhedron_.vertex_id(v);
    const Pin* pin = shaping_.pin.find(id);
    if (pin && pin->kind == Pin::Kind::tangents) return true;
    if (!pin && !shaping_.tag.contains(id) && !shaping_.alpha.contains(id) && !shaping_.form.contains(id))
      return false;
    bool all = true;
    for_edges(v, [&](Index e) { all = all && free_[e]; });
    return all;
  }

  /// Faces connected to a face through removable edges, in the order in which they are reached.
  std::vector<Index> faces_in_plane(Index start, std::vector<char>& visited) const {
    std::vector<Index> out{start};
    visited[start] = 1;
    for (std::size_t i = 0; i < out.size(); ++i)
      for (Index h = mesh_.face_begin(out[i]); h < mesh_.face_end(out[i]); ++h) {
        if (!free_[mesh_.edge(h)]) continue;
        const Index other = mesh_.face(mesh_.twin(h));
        if (visited[other] || !in_one_plane(normals_[start], normals_[other])) continue;
        visited[other] = 1;
        out.push_back(other);
      }
    return out;
  }

  /// Grows polygons from face to face; faces that cannot be added (a ring would close round a hole, too many
  /// sides) begin a polygon of their own.
  void merge_plane(std::vector<Index> faces, std::vector<MergedFaces::Group>& out) {
    while (!faces.empty()) {
      const auto corners = mesh_.face_vertices(faces.front());
      MergedFaces::Group group{{faces.front()}, {corners.begin(), corners.end()}};
      mark(group.corners, true);
      std::vector<Index> rest(faces.begin() + 1, faces.end());
      bool grown = true;
      while (grown) {
        grown = false;
        std::vector<Index> left;
        for (const Index f : rest) {
          if (take(group.corners, f)) {
            group.faces.push_back(f);
            grown = true;
          } else {
            left.push_back(f);
          }
        }
        rest = std::move(left);
      }
      mark(group.corners, false);
      if (group.faces.size() > 1) {
        std::sort(group.faces.begin(), group.faces.end());
        std::rotate(group.corners.begin(), std::min_element(group.corners.begin(), group.corners.end()),
                    group.corners.end());
        out.push_back(std::move(group));
      }
      faces = std::move(rest);
    }
  }

  /// Records where in the polygon each of its corners stands, or clears that.
  void mark(const std::vector<Index>& polygon, bool on) {
    for (std::size_t i = 0; i < polygon.size(); ++i) place_[polygon[i]] = on ? Index(i) : no_index;
  }

  /// Adds a face to a marked polygon where they meet along one chain of removable edges and nowhere else.
  bool take(std::vector<Index>& polygon, Index f) {
    const auto face = mesh_.face_vertices(f);
    const std::size_t n = face.size(), m = polygon.size();
    std::size_t shared = 0;
    for (const Index v : face) shared += place_[v] != no_index;
    if (shared < 2) return false;
    const auto common = [&](std::size_t i) {  // side i of the face occurs reversed in the polygon
      const Index a = place_[face[i]], b = place_[face[(i + 1) % n]];
      return a != no_index && b != no_index && (b + 1) % m == a;
    };
    std::size_t sides = 0, starts = 0, start = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const bool own = common(i);
      sides += own;
      if (own && !common((i + n - 1) % n)) {
        ++starts;
        start = i;
      }
      if (own && !free_[mesh_.edge(mesh_.face_begin(f) + Index(i))]) return false;
    }
    if (starts != 1 || shared != sides + 1) return false;
    if (m + n < 2 * sides + 3 || m + n - 2 * sides > most_sides_) return false;
    // The face's other corners are inserted between the ends of the chain, whose last point is first in the
    // polygon.
    std::vector<Index> merged;
    const std::size_t end = place_[face[start]];
    for (std::size_t i = 0; i < m - sides + 1; ++i) merged.push_back(polygon[(end + i) % m]);
    for (std::size_t i = sides + 1; i < n; ++i) merged.push_back(face[(start + i) % n]);
    mark(polygon, false);
    polygon = std::move(merged);
    mark(polygon, true);
    return true;
  }

  const Polyhedron& polyhedron_;
  const HalfEdgeMesh& mesh_;
  const Shaping& shaping_;
  std::size_t most_sides_;
  std::vector<Vector3> normals_;
  std::vector<char> free_;    ///< per edge: whether it may be removed
  std::vector<Index> place_;  ///< per vertex: its place in the growing polygon
};

/// Aliases of removed sides and merged faces: the face that each now belongs to.
std::shared_ptr<const ElementAliases> aliases_of(const Polyhedron& polyhedron,
                                                 std::span<const MergedFaces::Group> groups) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  auto out = std::make_shared<ElementAliases>();
  for (const MergedFaces::Group& group : groups) {
    const FaceId own = polyhedron.face_id(group.faces.front());
    for (std::size_t i = 1; i < group.faces.size(); ++i)
      out->merged.set(polyhedron.face_id(group.faces[i]), own);
    for (std::size_t i = 0; i < group.corners.size(); ++i) {
      const Index a = group.corners[i], b = group.corners[(i + 1) % group.corners.size()];
      const Index h = mesh.find_half_edge(a, b);
      const FaceId from = polyhedron.face_id(mesh.face(h));
      if (from != own) out->sides.set({polyhedron.vertex_id(a), polyhedron.vertex_id(b)}, from);
    }
  }
  return out;
}

Result<MergedFaces> merge_groups(const PolyhedronSource& source, std::vector<MergedFaces::Group> groups) {
  const Polyhedron& polyhedron = source.polyhedron;
  MeshEditor draft(source);
  for (const MergedFaces::Group& group : groups) {
    for (std::size_t i = 1; i < group.faces.size(); ++i)
      draft.remove_face(polyhedron.face_id(group.faces[i]));
    std::vector<VertexId> corners;
    for (const Index v : group.corners) corners.push_back(polyhedron.vertex_id(v));
    draft.set_face(polyhedron.face_id(group.faces.front()), std::move(corners));
  }
  auto finished = std::move(draft).finish();
  if (!finished) return finished.error();
  if (!source.shaping->form.empty() || !source.shaping->kept_area.empty()) {
    Shaping shaping = *finished->shaping;
    shaping.form = source.shaping->form;
    shaping.kept_area = source.shaping->kept_area;
    finished.value().shaping = std::move(shaping);
  }
  MergedFaces out{source, std::move(groups), {}, std::move(finished).value(), nullptr};
  out.aliases = aliases_of(polyhedron, out.groups);
  for (Index v = 0; v < polyhedron.vertex_count(); ++v)
    if (polyhedron.topology().outgoing(v) != no_index &&
        out.source.polyhedron.find(polyhedron.vertex_id(v)) == no_index)
      out.lost.push_back(polyhedron.vertex_id(v));
  return out;
}

/// `previous` with the present positions.
Result<MergedFaces> moved(const PolyhedronSource& source, const MergedFaces& previous) {
  const Polyhedron& whole = previous.source.polyhedron;
  std::vector<Index> vertices;
  std::vector<Vector3> positions;
  for (Index to = 0; to < whole.vertex_count(); ++to) {
    const Vector3& position = source.polyhedron.position(source.polyhedron.find(whole.vertex_id(to)));
    if (position == whole.position(to)) continue;
    vertices.push_back(to);
    positions.push_back(position);
  }
  auto polyhedron = whole.with_positions(vertices, positions);
  if (!polyhedron) return polyhedron.error();
  MergedFaces out = previous;
  out.before = source;
  out.source.polyhedron = std::move(polyhedron).value();
  return out;
}

}  // namespace

Result<MergedFaces> with_merged_faces(const PolyhedronSource& source, const MergedFaces* previous) {
  std::vector<MergedFaces::Group> groups = FaceMerger(source).run();
  if (groups.empty()) return MergedFaces{source, {}, {}, source, nullptr};
  const bool same = previous && previous->groups == groups &&
                    previous->before.polyhedron.shared_topology() == source.polyhedron.shared_topology() &&
                    previous->before.origin == source.origin && previous->before.shaping == source.shaping &&
                    previous->before.mirror == source.mirror && previous->before.mode == source.mode;
  return same ? moved(source, *previous) : merge_groups(source, std::move(groups));
}

std::vector<Message> merge_warnings_of(const PolyhedronSource& source) {
  std::vector<Message> out;
  if (!source.preparation.merge_coplanar) return out;
  const auto merged = with_merged_faces(source);
  if (!merged) return out;
  MessageGroup group(out, Severity::warning, w_vertex_merged,
                     "Move it out of the plane, or turn Merge flat off.", most_warnings);
  for (const VertexId id : merged->lost)
    group.add(element_of(id), [] {
      return std::string(
          "All triangles round the vertex lie in one plane and were merged: the surface does not pass "
          "through "
          "it.");
    });
  return out;
}

}  // namespace hariko
