#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "core/base/ids.hpp"
#include "core/polyhedron/edge_table.hpp"
#include "core/polyhedron/face_check.hpp"
#include "core/polyhedron/part_nesting.hpp"
#include "core/polyhedron/repair.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {

namespace {

/// Neighbour of a face across an edge, and whether the two agree in orientation as given.
struct Neighbour {
  Index face;
  bool agrees;
  Index low, high;  ///< the edge
};

/// Neighbours of every face, as ranges.
struct Neighbours {
  std::vector<Index> offsets;
  std::vector<Neighbour> list;
};

Message not_orientable(Index low, Index high, std::size_t faces) {
  const Element edge = element_of(EdgeId::of(VertexId{low}, VertexId{high}));
  if (faces > 2)
    return make_error(
        e_edge_nonmanifold_or_flipped,
        "The edge belongs to " + std::to_string(faces) + " faces; an edge may have at most two.",
        "Split the non-manifold edges first.", edge);
  return make_error(
      e_edge_nonmanifold_or_flipped,
      "The part with this edge has only one side, like a Moebius strip, and cannot be oriented.",
      "Split the non-manifold edges to cut it open.", edge);
}

/// Finds the neighbours of every face. `strict` refuses edges with more than two faces; otherwise they count
/// as boundary.
Result<Neighbours> find_neighbours(const PolygonMesh& mesh, const EdgeTable& edges, bool strict) {
  const std::vector<Index> face = faces_of_corners(mesh);
  Neighbours out;
  out.offsets.assign(mesh.face_count() + 2, 0);
  std::optional<Message> error;
  edges.for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
    if (strict && uses.size() > 2 && !error) error = not_orientable(low, high, uses.size());
    if (uses.size() != 2) return;
    for (const EdgeUse& use : uses) ++out.offsets[face[use.corner] + 2];
  });
  if (error) return *error;
  for (std::size_t i = 2; i < out.offsets.size(); ++i) out.offsets[i] += out.offsets[i - 1];
  out.list.resize(out.offsets.back());
  edges.for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
    if (uses.size() != 2) return;
    const bool agrees = is_manifold_edge(mesh, uses);
    const Index a = face[uses[0].corner], b = face[uses[1].corner];
    out.list[out.offsets[a + 1]++] = {b, agrees, low, high};
    out.list[out.offsets[b + 1]++] = {a, agrees, low, high};
  });
  out.offsets.pop_back();
  return out;
}

/// Connected part: its faces and, for each, whether it must be flipped to agree with the first.
struct Part {
  std::vector<Index> faces;
  bool closed = true;
};

/// Flood fill from `seed`; `flip` holds -1 for faces not reached yet. A one-sided part is an error when
/// `strict`; otherwise it does not count as closed.
Result<Part> flood(const PolygonMesh& mesh, const Neighbours& neighbours, Index seed, bool strict,
                   std::vector<signed char>& flip) {
  Part part;
  part.faces.push_back(seed);
  flip[seed] = 0;
  for (std::size_t next = 0; next < part.faces.size(); ++next) {
    const Index f = part.faces[next];
    const Index begin = neighbours.offsets[f], end = neighbours.offsets[f + 1];
    if (end - begin < mesh.face(f).size()) part.closed = false;
    for (Index i = begin; i < end; ++i) {
      const Neighbour& n = neighbours.list[i];
      const signed char wanted = n.agrees ? flip[f] : static_cast<signed char>(1 - flip[f]);
      if (flip[n.face] < 0) {
        flip[n.face] = wanted;
        part.faces.push_back(n.face);
      } else if (flip[n.face] != wanted) {
        if (strict) return not_orientable(n.low, n.high, 2);
        part.closed = false;
      }
    }
  }
  return part;
}

/// Volume of a closed part after its flips.
double volume_of(const PolygonMesh& mesh, const Part& part, const std::vector<signed char>& flip) {
  const Vector3 reference = mesh.positions[mesh.face(part.faces[0])[0]];
  double volume = 0;
  for (Index f : part.faces) {
    const std::span<const Index> corners = mesh.face(f);
    const Vector3 p = mesh.positions[corners[0]] - reference;
    double sum = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      sum +=
          p.dot((mesh.positions[corners[i]] - reference).cross(mesh.positions[corners[i + 1]] - reference));
    volume += flip[f] ? -sum : sum;
  }
  return volume;
}

/// Closed part with its orientation after its flips.
struct ClosedPart {
  Part part;
  bool inwards = false;          ///< its faces look inwards
  bool given_inwards = false;    ///< most of them did before the flips
  PartNesting::Triangles faces;  ///< after the flips
};

ClosedPart closed_part(const PolygonMesh& mesh, Part part, bool mostly_flipped,
                       const std::vector<signed char>& flip) {
  ClosedPart out;
  out.inwards = volume_of(mesh, part, flip) < 0;
  out.given_inwards = out.inwards != mostly_flipped;
  for (const Index f : part.faces) {
    const std::span<const Index> corners = mesh.face(f);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      out.faces.push_back(flip[f] ? std::array{corners[0], corners[i + 1], corners[i]}
                                  : std::array{corners[0], corners[i], corners[i + 1]});
  }
  out.part = std::move(part);
  return out;
}

/// Turns closed parts outwards; a part inside another one that looks the other way is a cavity, and does so
/// afterwards, too.
void turn_outwards(const PolygonMesh& mesh, std::vector<ClosedPart> closed, std::vector<signed char>& flip) {
  std::vector<PartNesting::Triangles> faces(closed.size());
  if (closed.size() > 1)
    for (std::size_t k = 0; k < closed.size(); ++k) faces[k] = std::move(closed[k].faces);
  PartNesting nesting(mesh.positions, std::move(faces));
  for (std::size_t k = 0; k < closed.size(); ++k) {
    const std::vector<Index> around = nesting.around(static_cast<Index>(k));
    const bool cavity = !around.empty() && closed[around[0]].given_inwards != closed[k].given_inwards;
    if (closed[k].inwards == cavity) continue;
    for (const Index f : closed[k].part.faces) flip[f] = static_cast<signed char>(1 - flip[f]);
  }
}

Result<PolygonMesh> orient(const PolygonMesh& mesh, bool strict) {
  const std::vector<char> sound = sound_faces(mesh);
  const Result<Neighbours> neighbours = find_neighbours(mesh, EdgeTable(mesh, sound), strict);
  if (!neighbours) return neighbours.error();

  std::vector<signed char> flip(mesh.face_count(), -1);
  std::vector<ClosedPart> closed;
  for (Index seed = 0; seed < mesh.face_count(); ++seed) {
    if (!sound[seed] || flip[seed] >= 0) continue;
    Result<Part> part = flood(mesh, *neighbours, seed, strict, flip);
    if (!part) return part.error();
    const auto flipped =
        std::count_if(part->faces.begin(), part->faces.end(), [&](Index f) { return flip[f] == 1; });
    const bool mostly_flipped = static_cast<std::size_t>(flipped) * 2 > part->faces.size();
    // Open parts keep the orientation of most of their faces.
    if (part->closed)
      closed.push_back(closed_part(mesh, std::move(part).value(), mostly_flipped, flip));
    else if (mostly_flipped)
      for (Index f : part->faces) flip[f] = static_cast<signed char>(1 - flip[f]);
  }
  turn_outwards(mesh, std::move(closed), flip);

  PolygonMesh out = mesh;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)  // the first corner stays first
    if (flip[f] == 1)
      std::reverse(out.face_vertices.begin() + mesh.face_offsets[f] + 1,
                   out.face_vertices.begin() + mesh.face_offsets[f + 1]);
  return out;
}

}  // namespace

Result<PolygonMesh> repair_orientation(const PolygonMesh& mesh) {
  return orient(mesh, true);
}

PolygonMesh orient_where_possible(const PolygonMesh& mesh) {
  return orient(mesh, false).value();
}

}  // namespace hariko
