#include "core/unfolding/join_corners.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "core/base/disjoint_sets.hpp"
#include "core/base/index_list.hpp"
#include "core/polyhedron/edge_table.hpp"
#include "core/polyhedron/face_check.hpp"

namespace hariko {

namespace {

/// Number of each distinct position, for each vertex; numbered in the order of the positions.
std::vector<Index> place_numbers(const std::vector<Vector3>& positions) {
  std::vector<Index> order = ascending_indices(positions.size()), out(positions.size());
  const auto key = [&](Index v) {
    const Vector3& p = positions[v];
    return std::tuple(p.x() + 0.0, p.y() + 0.0, p.z() + 0.0);
  };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  Index number = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k > 0 && key(order[k - 1]) < key(order[k])) ++number;
    out[order[k]] = number;
  }
  return out;
}

/// Side without a second face, with the numbers of its end positions, lower first.
struct LooseSide {
  std::array<Index, 2> places, vertices;
  bool forward;  ///< its face runs from the first end to the second one
};

std::vector<LooseSide> loose_sides(const PolygonMesh& mesh, const std::vector<Index>& place) {
  std::vector<LooseSide> out;
  EdgeTable(mesh, sound_faces(mesh)).for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
    if (uses.size() != 1 || place[low] == place[high]) return;
    const bool rises = place[low] < place[high], from_low = mesh.face_vertices[uses[0].corner] == low;
    const Index a = rises ? low : high, b = rises ? high : low;
    out.push_back({{place[a], place[b]}, {a, b}, rises == from_low});
  });
  std::sort(out.begin(), out.end(),
            [](const LooseSide& a, const LooseSide& b) { return a.places < b.places; });
  return out;
}

}  // namespace

std::size_t join_equal_corners(PolygonMesh& mesh) {
  for (const Vector3& p : mesh.positions)
    if (!p.allFinite()) return 0;
  const std::vector<LooseSide> loose = loose_sides(mesh, place_numbers(mesh.positions));
  DisjointSets sets(mesh.positions.size());
  for (std::size_t begin = 0; begin < loose.size();) {
    std::size_t end = begin + 1;
    while (end < loose.size() && loose[end].places == loose[begin].places) ++end;
    if (end == begin + 2 && loose[begin].forward != loose[begin + 1].forward)
      for (std::size_t k = 0; k < 2; ++k) sets.join(loose[begin].vertices[k], loose[begin + 1].vertices[k]);
    begin = end;
  }
  std::size_t joined = 0;
  for (Index v = 0; v < mesh.positions.size(); ++v) joined += sets.find(v) != v ? 1 : 0;
  if (joined > 0)
    for (Index& v : mesh.face_vertices)
      if (v < mesh.positions.size()) v = sets.find(v);
  return joined;
}

}  // namespace hariko
