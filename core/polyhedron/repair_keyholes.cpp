// cut_keyholes: faces with a hole that is joined to the rim, as programs without holes in faces write them.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "core/base/index_list.hpp"
#include "core/geometry/polygon.hpp"
#include "core/polyhedron/face_decomposition.hpp"
#include "core/polyhedron/repair.hpp"

namespace hariko {

namespace {

using DirectedSides = std::set<std::pair<Index, Index>>;

std::vector<Vector3> positions_at(const PolygonMesh& mesh, std::span<const Index> face) {
  std::vector<Vector3> out;
  for (const Index v : face) out.push_back(mesh.positions[v]);
  return out;
}

/// Whether a face walks one of its sides in both directions, and no side twice in one direction.
bool has_bridge(const PolygonMesh& mesh, std::span<const Index> face) {
  std::vector<Index> sorted(face.begin(), face.end());
  std::sort(sorted.begin(), sorted.end());
  if (sorted.size() < 6 || sorted.back() >= mesh.positions.size()) return false;
  if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) return false;
  DirectedSides sides;
  bool bridge = false;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Index a = face[k], b = face[(k + 1) % face.size()];
    if (a == b || !sides.insert({a, b}).second) return false;
    bridge = bridge || sides.contains({b, a});
  }
  return bridge;
}

/// Whether one loop of the face runs round all of it and the others run against it, as holes do.
bool has_one_rim(const PolygonMesh& mesh, std::span<const Index> face, const Vector3& normal) {
  std::vector<Index> used(face.begin(), face.end()), own;
  sort_unique(used);
  for (const Index v : face)
    own.push_back(static_cast<Index>(std::lower_bound(used.begin(), used.end(), v) - used.begin()));
  PolygonMesh alone;
  alone.positions = positions_at(mesh, used);
  alone.add_face(own);
  const PolygonMesh loops = split_repeated_corners(alone);
  int rims = 0, holes = 0;
  for (std::size_t f = 0; f < loops.face_count(); ++f)
    ++(newell_normal(positions_at(loops, loops.face(f))).dot(normal) > 0 ? rims : holes);
  return rims == 1 && holes > 0;
}

/// Faces that a keyhole is cut into, by vertices; none where it cannot be cut exactly.
std::vector<std::vector<Index>> pieces_of_keyhole(const PolygonMesh& mesh, std::span<const Index> face,
                                                  const DirectedSides& taken) {
  const std::vector<Vector3> corners = positions_at(mesh, face);
  const Vector3 normal = newell_normal(corners);
  if (!has_one_rim(mesh, face, normal)) return {};
  const auto triangles = triangles_of(corners, [&](Index a, Index b) {
    return face[a] != face[b] && !taken.contains(std::minmax(face[a], face[b]));
  });
  if (!triangles) return {};
  // Triangles that all face outwards cover each place as often as the rim and the holes wind round it: once.
  DirectedSides sides;
  for (const auto& triangle : *triangles) {
    const auto at = [&](std::size_t k) -> const Vector3& { return corners[triangle[k % 3]]; };
    if (!((at(1) - at(0)).cross(at(2) - at(0)).dot(normal) > 0)) return {};
    for (std::size_t k = 0; k < 3; ++k)
      if (!sides.insert({face[triangle[k]], face[triangle[(k + 1) % 3]]}).second) return {};
  }
  std::vector<std::vector<Index>> out = joined_to_convex(corners, *triangles);
  const auto name = [&](std::vector<Index>& piece) {
    for (Index& corner : piece) corner = face[corner];
    std::vector<Index> sorted = piece;
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  };
  bool simple = true;
  for (std::vector<Index>& piece : out) simple = name(piece) && simple;
  if (simple) return out;
  out.clear();
  for (const auto& triangle : *triangles)
    out.push_back({face[triangle[0]], face[triangle[1]], face[triangle[2]]});
  return out;
}

}  // namespace

CutKeyholes cut_keyholes(PolygonMesh mesh) {
  CutKeyholes out;
  std::vector<char> bridged(mesh.face_count(), 0);
  bool any = false;
  for (std::size_t f = 0; f < bridged.size(); ++f)
    if (mesh.face(f).size() > 5 && has_bridge(mesh, mesh.face(f))) any = bridged[f] = 1;
  if (!any) {
    out.mesh = std::move(mesh);
    return out;
  }
  DirectedSides taken;  // the edges of the mesh, low vertex first: no diagonal may be one of them
  for (std::size_t f = 0; f < bridged.size(); ++f)
    for (std::size_t k = 0; k < mesh.face(f).size(); ++k)
      taken.insert(std::minmax(mesh.face(f)[k], mesh.face(f)[(k + 1) % mesh.face(f).size()]));
  out.mesh.positions = mesh.positions;
  for (std::size_t f = 0; f < bridged.size(); ++f) {
    const std::vector<std::vector<Index>> pieces =
        bridged[f] ? pieces_of_keyhole(mesh, mesh.face(f), taken) : std::vector<std::vector<Index>>();
    out.cut += !pieces.empty();
    if (pieces.empty()) out.mesh.add_face(mesh.face(f));
    for (const std::vector<Index>& piece : pieces) {
      out.mesh.add_face(piece);
      for (std::size_t k = 0; k < piece.size(); ++k)
        taken.insert(std::minmax(piece[k], piece[(k + 1) % piece.size()]));
    }
  }
  return out;
}

}  // namespace hariko
