// separate_bodies: bodies that touch along edges or in points get vertices of their own.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <span>

#include "core/base/disjoint_sets.hpp"
#include "core/geometry/polygon.hpp"
#include "core/polyhedron/corner_fans.hpp"
#include "core/polyhedron/edge_table.hpp"
#include "core/polyhedron/face_check.hpp"
#include "core/polyhedron/mesh_errors.hpp"
#include "core/polyhedron/repair.hpp"

namespace hariko {

namespace {

constexpr double same_angle = 1e-7;  ///< radians within which two faces at an edge lie on each other

/// Pairs of sides at the edges with more than two faces: each pair belongs to one body.
class SidePairing {
 public:
  SidePairing(const PolygonMesh& mesh, const std::vector<char>& sound, const EdgeTable& edges)
      : mesh_(mesh),
        twin_(find_twins(mesh, edges)),
        face_(mesh.face_vertices.size()),
        bodies_(mesh.face_count()) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
      std::fill(face_.begin() + mesh.face_offsets[f], face_.begin() + mesh.face_offsets[f + 1],
                static_cast<Index>(f));
    for (Index h = 0; h < twin_.size(); ++h)
      if (twin_[h] != no_index) bodies_.join(face_[h], face_[twin_[h]]);
    std::vector<Index> by_angle;
    edges.for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
      if (uses.size() <= 2) return;
      std::vector<Index> rest;
      for (const EdgeUse& use : uses) rest.push_back(use.corner);
      pair_by_body(rest);
      pair_by_angle(low, high, rest, by_angle);
    });
    for (const Index h : by_angle) bodies_.join(face_[h], face_[twin_[h]]);
    undo_where_open(sound, by_angle);
    if (!by_angle.empty()) exchange_doubled(sound, edges);
  }
  const std::vector<Index>& twin() const { return twin_; }

 private:
  void pair(Index g, Index h) {
    twin_[g] = h;
    twin_[h] = g;
  }

  /// Pairs the two sides of bodies that pass the edge once; ordinary edges connect the faces of a body.
  void pair_by_body(std::vector<Index>& rest) {
    std::stable_sort(rest.begin(), rest.end(),
                     [&](Index g, Index h) { return bodies_.find(face_[g]) < bodies_.find(face_[h]); });
    std::vector<Index> left;
    for (std::size_t begin = 0, end = 0; begin < rest.size(); begin = end) {
      const Index body = bodies_.find(face_[rest[begin]]);
      for (end = begin + 1; end < rest.size() && bodies_.find(face_[rest[end]]) == body;) ++end;
      if (end == begin + 2 && mesh_.face_vertices[rest[begin]] != mesh_.face_vertices[rest[begin + 1]])
        pair(rest[begin], rest[begin + 1]);
      else
        left.insert(left.end(), rest.begin() + std::ptrdiff_t(begin), rest.begin() + std::ptrdiff_t(end));
    }
    rest = std::move(left);
  }

  /// Side at an edge: its angle about the edge, and whether its face runs from the low vertex to the high
  /// one.
  struct Side {
    Index corner;
    double angle;
    bool forward;
  };

  /// Sides round the edge low -> high by their angles; none where a face has no plane.
  std::vector<Side> sides_of(Index low, Index high, const std::vector<Index>& corners) {
    const Vector3 along = (mesh_.positions[high] - mesh_.positions[low]).normalized();
    Vector3 first = Vector3::Zero(), second = Vector3::Zero();
    std::vector<Side> out;
    for (const Index corner : corners) {
      const auto face = mesh_.face(face_[corner]);
      const Vector3 normal = newell_normal(
          face.size(), [&](std::size_t k) -> const Vector3& { return mesh_.positions[face[k]]; });
      const bool forward = mesh_.face_vertices[corner] == low;
      const Vector3 inwards = (forward ? 1.0 : -1.0) * normal.cross(along);
      if (!(inwards.norm() > 0)) return {};
      if (out.empty()) {
        first = inwards.normalized();
        second = along.cross(first);
      }
      double angle = std::atan2(inwards.dot(second), inwards.dot(first));
      if (angle < -same_angle) angle += 2 * std::numbers::pi;
      out.push_back({corner, angle, forward});
    }
    std::stable_sort(out.begin(), out.end(), [](const Side& a, const Side& b) { return a.angle < b.angle; });
    // Faces on each other: where one body ends the next one begins.
    for (std::size_t begin = 0, end = 0; begin < out.size(); begin = end) {
      for (end = begin + 1; end < out.size() && out[end].angle - out[begin].angle <= 2 * same_angle;) ++end;
      for (std::size_t k = begin; end - begin > 1 && k < end; ++k) on_others_.push_back(out[k].corner);
      std::stable_partition(out.begin() + std::ptrdiff_t(begin), out.begin() + std::ptrdiff_t(end),
                            [](const Side& side) { return side.forward; });
    }
    return out;
  }

  /// Pairs neighbours in angle with the inside between them: with growing angle a body begins at a face that
  /// runs backwards and ends at one that runs forwards. Pairs nothing where the two do not alternate.
  void pair_by_angle(Index low, Index high, const std::vector<Index>& corners, std::vector<Index>& paired) {
    if (corners.size() < 2 || corners.size() % 2 != 0) return;
    const std::vector<Side> sides = sides_of(low, high, corners);
    const std::size_t count = sides.size();
    for (std::size_t k = 0; k < count; ++k)
      if (sides[k].forward == sides[(k + 1) % count].forward) return;
    for (std::size_t k = 0; k < count; ++k) {
      if (sides[k].forward) continue;
      pair(sides[k].corner, sides[(k + 1) % count].corner);
      paired.push_back(sides[k].corner);
    }
  }

  /// Takes pairs by angle back where they leave a body open, or make one that is inside out of faces that lie
  /// on others: both sides of a sheet are no body. Cavities look inwards, too, and stay.
  void undo_where_open(const std::vector<char>& sound, const std::vector<Index>& paired) {
    if (paired.empty()) return;
    std::vector<char> open(mesh_.face_count(), 0), on_others(mesh_.face_count(), 0);
    for (const Index h : on_others_) on_others[bodies_.find(face_[h])] = 1;
    std::vector<double> volume(mesh_.face_count(), 0);
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      if (!sound[f]) continue;
      const Index body = bodies_.find(f);
      for (Index h = mesh_.face_offsets[f]; h < mesh_.face_offsets[f + 1]; ++h)
        if (twin_[h] == no_index) open[body] = 1;
      const auto corners = mesh_.face(f);
      const Vector3 reference = mesh_.positions[mesh_.face(body)[0]];
      const Vector3 p = mesh_.positions[corners[0]] - reference;
      for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        volume[body] += p.dot(
            (mesh_.positions[corners[k]] - reference).cross(mesh_.positions[corners[k + 1]] - reference));
    }
    for (const Index h : paired) {
      const Index body = bodies_.find(face_[h]);
      if (!open[body] && (volume[body] > 0 || (volume[body] < 0 && !on_others[body]))) continue;
      twin_[twin_[h]] = no_index;
      twin_[h] = no_index;
    }
  }

  Index next_corner(Index h) const {
    const Index begin = mesh_.face_offsets[face_[h]], end = mesh_.face_offsets[face_[h] + 1];
    return h + 1 == end ? begin : h + 1;
  }

  /// Two sides from `low` whose pairs the same fans hold at both ends, so that they would remain one edge;
  /// nothing where there are none.
  std::optional<std::array<Index, 2>> doubled_sides(const CornerFans& fans, Index low,
                                                    std::span<const EdgeUse> uses) const {
    std::map<std::array<Index, 2>, Index> first;  // side by its fans at both ends
    for (const EdgeUse& use : uses) {
      const Index h = use.corner;
      if (mesh_.face_vertices[h] != low || twin_[h] == no_index) continue;
      const auto [known, added] = first.try_emplace({fans.fan[h], fans.fan[next_corner(h)]}, h);
      if (!added) return std::array<Index, 2>{known->second, h};
    }
    return {};
  }

  /// Exchanges the partners of pairs that would remain one edge, where a body touches itself at an edge and
  /// hangs together round both of its ends. The faces close either way, the outside between them instead of
  /// the inside. An exchange parts a fan at each end and joins none, so no edge stays doubled.
  void exchange_doubled(const std::vector<char>& sound, const EdgeTable& edges) {
    for (bool changed = true; changed;) {
      changed = false;
      const CornerFans fans = find_corner_fans(mesh_, sound, edges, twin_);
      std::vector<char> other_fans(mesh_.positions.size(), 0);  // vertices where an exchange changed them
      edges.for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
        if (uses.size() <= 2 || other_fans[low] || other_fans[high]) return;
        const auto doubled = doubled_sides(fans, low, uses);
        if (!doubled) return;
        const auto [g, h] = *doubled;
        const Index of_g = twin_[g], of_h = twin_[h];
        pair(g, of_h);
        pair(h, of_g);
        changed = true;
        other_fans[low] = other_fans[high] = 1;
      });
    }
  }

  const PolygonMesh& mesh_;
  std::vector<Index> twin_;       ///< per corner
  std::vector<Index> face_;       ///< per corner
  DisjointSets bodies_;           ///< sets of faces
  std::vector<Index> on_others_;  ///< corners of sides whose faces lie on others at the edge
};

/// Gives every fan but the first a copy of its vertex; copies are appended at the end.
SeparatedBodies with_own_vertices(const PolygonMesh& mesh, const CornerFans& fans,
                                  const std::vector<char>& chosen) {
  SeparatedBodies out;
  out.mesh = mesh;
  out.original.resize(mesh.positions.size());
  for (Index v = 0; v < out.original.size(); ++v) out.original[v] = v;
  std::vector<Index> first_copy(mesh.positions.size(), no_index);  // copy for fan 1
  for (Index v = 0; v < first_copy.size(); ++v) {
    if (fans.fan_count[v] < 2 || !chosen[v]) continue;
    first_copy[v] = static_cast<Index>(out.original.size());
    out.original.insert(out.original.end(), fans.fan_count[v] - 1, v);
    out.mesh.positions.insert(out.mesh.positions.end(), fans.fan_count[v] - 1, mesh.positions[v]);
  }
  for (std::size_t h = 0; h < out.mesh.face_vertices.size(); ++h) {
    const Index v = mesh.face_vertices[h], fan = fans.fan[h];
    if (v < first_copy.size() && fan != no_index && fan > 0 && first_copy[v] != no_index)
      out.mesh.face_vertices[h] = first_copy[v] + fan - 1;
  }
  return out;
}

}  // namespace

SeparatedBodies separate_at_edges(const PolygonMesh& mesh) {
  const std::vector<char> sound = sound_faces(mesh);
  const EdgeTable edges(mesh, sound);
  const SidePairing pairing(mesh, sound, edges);
  std::vector<char> chosen(mesh.positions.size(), 0);
  edges.for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
    if (uses.size() > 2) chosen[low] = chosen[high] = 1;
  });
  return with_own_vertices(mesh, find_corner_fans(mesh, sound, edges, pairing.twin()), chosen);
}

std::optional<SeparatedBodies> separate_bodies(const PolygonMesh& mesh) {
  const std::vector<char> sound = sound_faces(mesh);
  if (std::find(sound.begin(), sound.end(), 0) != sound.end()) return {};
  const EdgeTable edges(mesh, sound);
  bool possible = true, touching = false;
  edges.for_each_edge([&](Index, Index, std::span<const EdgeUse> uses) {
    touching = touching || uses.size() > 2;
    possible = possible && (uses.size() > 2 ? uses.size() % 2 == 0 : is_manifold_edge(mesh, uses));
  });
  if (!possible) return {};
  std::vector<Index> twin;
  if (touching) {
    const SidePairing pairing(mesh, sound, edges);
    edges.for_each_edge([&](Index, Index, std::span<const EdgeUse> uses) {
      for (const EdgeUse& use : uses)
        possible = possible && (uses.size() <= 2 || pairing.twin()[use.corner] != no_index);
    });
    if (!possible) return {};
    twin = pairing.twin();
  } else {
    twin = find_twins(mesh, edges);
  }
  const CornerFans fans = find_corner_fans(mesh, sound, edges, twin);
  SeparatedBodies out = with_own_vertices(mesh, fans, std::vector<char>(mesh.positions.size(), 1));
  if (out.original.size() == mesh.positions.size() || !connectivity_errors(out.mesh, 1).empty()) return {};
  return out;
}

}  // namespace hariko
