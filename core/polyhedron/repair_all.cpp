// make_manifold: the repairs, in an order in which each prepares the next.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/base/ids.hpp"
#include "core/polyhedron/edge_table.hpp"
#include "core/polyhedron/face_check.hpp"
#include "core/polyhedron/join_corners.hpp"
#include "core/polyhedron/repair.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {

namespace {

/// Appends the loops of a vertex cycle, which is cut wherever it returns to a vertex. O(n log n).
void add_rounds(std::span<const Index> face, PolygonMesh& out) {
  std::vector<Index> open(face.begin(), face.end());
  std::sort(open.begin(), open.end());
  if (std::adjacent_find(open.begin(), open.end()) == open.end()) {  // the usual case
    if (face.size() >= 3) out.add_face(face);
    return;
  }
  open.clear();
  std::map<Index, std::size_t> place;  // places of the vertices in `open`
  for (const Index v : face) {
    if (const auto before = place.find(v); before != place.end()) {
      const std::vector<Index> round(open.begin() + std::ptrdiff_t(before->second), open.end());
      open.resize(before->second);
      for (const Index w : round) place.erase(w);
      if (round.size() >= 3) out.add_face(round);
    }
    place.emplace(v, open.size());
    open.push_back(v);
  }
  if (open.size() >= 3) out.add_face(open);
}

struct SplitFaces {
  PolygonMesh mesh;
  std::size_t lost = 0;  ///< faces of which no loop has three corners
  std::size_t cut = 0;   ///< faces that became several, or lost corners
};

SplitFaces split_into_rounds(const PolygonMesh& mesh) {
  SplitFaces out;
  out.mesh.positions = mesh.positions;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::size_t before = out.mesh.face_count();
    add_rounds(mesh.face(f), out.mesh);
    const std::size_t rounds = out.mesh.face_count() - before;
    out.lost += rounds == 0;
    out.cut += rounds > 1 || (rounds == 1 && out.mesh.face(before).size() < mesh.face(f).size());
  }
  return out;
}

template <class Keep>
PolygonMesh with_faces(const PolygonMesh& mesh, Keep&& keep) {
  PolygonMesh out;
  out.positions = mesh.positions;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    if (keep(f)) out.add_face(mesh.face(f));
  return out;
}

/// Drops faces with the same vertices as an earlier one where one of their edges has more than two faces.
/// Elsewhere two faces back to back form a closed surface, which stays.
PolygonMesh without_doubles(const PolygonMesh& mesh) {
  std::vector<char> crowded(mesh.face_count(), 0);
  const std::vector<Index> face_of = faces_of_corners(mesh);
  EdgeTable(mesh, sound_faces(mesh)).for_each_edge([&](Index, Index, std::span<const EdgeUse> uses) {
    if (uses.size() <= 2) return;
    for (const EdgeUse& use : uses) crowded[face_of[use.corner]] = 1;
  });
  std::set<std::vector<Index>> seen;
  return with_faces(mesh, [&](std::size_t f) {
    if (!crowded[f]) return true;
    std::vector<Index> corners(mesh.face(f).begin(), mesh.face(f).end());
    std::sort(corners.begin(), corners.end());
    return seen.insert(std::move(corners)).second;
  });
}

bool same_face(const PolygonMesh& a, const PolygonMesh& b, std::size_t f) {
  return std::equal(a.face(f).begin(), a.face(f).end(), b.face(f).begin());
}

}  // namespace

PolygonMesh split_repeated_corners(const PolygonMesh& mesh) {
  return split_into_rounds(mesh).mesh;
}

Result<Repaired> make_manifold(const PolygonMesh& given) {
  Repaired out;
  RepairReport& report = out.report;
  PolygonMesh mesh = with_faces(given, [&](std::size_t f) {
    return std::all_of(given.face(f).begin(), given.face(f).end(),
                       [&](Index v) { return v < given.positions.size(); });
  });
  for (const Index v : mesh.face_vertices)
    if (!mesh.positions[v].allFinite())
      return make_error(e_nonfinite, "Vertex " + std::to_string(v) + " has a coordinate that is not finite.",
                        "Repair the file in the program that wrote it.", element_of(VertexId{v}));
  const std::size_t unused = mesh.positions.size();
  mesh = remove_isolated_vertices(mesh);
  report.removed_vertices = unused - mesh.positions.size();
  const std::size_t separate = mesh.positions.size();
  mesh = weld(mesh, joining_distance(mesh));
  report.merged_vertices = separate - mesh.positions.size();
  report.dropped_faces = given.face_count() - mesh.face_count();
  // Counted before and after the splitting, which makes several faces of one.
  const CutKeyholes whole = cut_keyholes(std::move(mesh));
  SplitFaces rounds = split_into_rounds(whole.mesh);
  report.cut_faces = whole.cut + rounds.cut;
  const std::size_t together = rounds.mesh.positions.size();
  if (auto bodies = separate_bodies(rounds.mesh)) rounds.mesh = std::move(bodies->mesh);
  mesh = without_doubles(rounds.mesh);
  report.dropped_faces += rounds.lost + (rounds.mesh.face_count() - mesh.face_count());
  if (mesh.face_count() == 0)
    return make_error(e_no_faces, "No face is left after the repair.",
                      "Repair the file in the program that wrote it.");
  const PolygonMesh oriented = orient_where_possible(mesh);
  const PolygonMesh split =
      split_nonmanifold_vertices(split_nonmanifold_edges(separate_at_edges(oriented).mesh));
  report.split_vertices = split.positions.size() - together;
  // Parts that were cut apart may have become closed: they are turned outward now.
  out.mesh = orient_where_possible(split);
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    report.turned_faces += same_face(mesh, oriented, f) != same_face(split, out.mesh, f);
  // Removes vertices that only dropped faces used.
  const std::size_t kept = out.mesh.positions.size();
  out.mesh = remove_isolated_vertices(out.mesh);
  report.removed_vertices += kept - out.mesh.positions.size();
  // Vertices of bodies that touch were merged and are two again. No report of a change is empty.
  RepairReport less = report;
  const std::size_t again = std::min(report.split_vertices, report.merged_vertices);
  less.split_vertices -= again;
  less.merged_vertices -= again;
  if (less != RepairReport{}) report = less;
  return out;
}

}  // namespace hariko
