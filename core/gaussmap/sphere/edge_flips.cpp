#include "core/gaussmap/sphere/edge_flips.hpp"

#include <cstdint>
#include <unordered_map>

#include "core/geometry/edge_key.hpp"

namespace hariko {
namespace {

using Triangle = std::array<Index, 3>;

class Flipping {
 public:
  Flipping(std::vector<Triangle> triangles, Index vertex_count, Index fewest_edges,
           const BetterDiagonal& better)
      : better_(better),
        fewest_edges_(fewest_edges),
        triangles_(std::move(triangles)),
        edges_(vertex_count, 0) {
    left_of_.reserve(3 * triangles_.size());
    for (Index t = 0; t < triangles_.size(); ++t) enter(t);
    for (const auto& [edge, triangle] : left_of_) {
      const auto [from, to] = ends_of_key(edge);
      ++edges_[from];
      if (!left_of_.contains(half_edge_key(to, from))) ++edges_[to];
    }
  }

  std::vector<Triangle> run() {
    std::vector<Index> waiting;
    for (Index t = 0; t < triangles_.size(); ++t) waiting.push_back(t);
    std::size_t left = 15 * triangles_.size();
    while (!waiting.empty() && left > 0) {
      const Index t = waiting.back();
      waiting.pop_back();
      for (std::size_t k = 0; k < 3; ++k)
        if (const Index beyond = flip(t, k); beyond != no_index) {
          waiting.push_back(t);
          waiting.push_back(beyond);
          --left;
          break;
        }
    }
    return std::move(triangles_);
  }

 private:
  void enter(Index t) {
    for (std::size_t k = 0; k < 3; ++k)
      left_of_[half_edge_key(triangles_[t][k], triangles_[t][(k + 1) % 3])] = t;
  }

  /// Flips side k of triangle t; returns the other triangle of the old edge, or nothing when the edge stays.
  Index flip(Index t, std::size_t k) {
    const Index p = triangles_[t][k], q = triangles_[t][(k + 1) % 3], r = triangles_[t][(k + 2) % 3];
    const auto found = left_of_.find(half_edge_key(q, p));
    if (found == left_of_.end()) return no_index;
    const Index u = found->second;
    Index s = no_index;
    for (const Index corner : triangles_[u])
      if (corner != p && corner != q) s = corner;
    if (edges_[p] <= fewest_edges_ || edges_[q] <= fewest_edges_) return no_index;
    if (!better_(p, q, r, s)) return no_index;
    if (left_of_.contains(half_edge_key(r, s)) || left_of_.contains(half_edge_key(s, r))) return no_index;
    left_of_.erase(half_edge_key(p, q));
    left_of_.erase(half_edge_key(q, p));
    triangles_[t] = {p, s, r};
    triangles_[u] = {s, q, r};
    enter(t);
    enter(u);
    --edges_[p];
    --edges_[q];
    ++edges_[r];
    ++edges_[s];
    return u;
  }

  const BetterDiagonal& better_;
  Index fewest_edges_;
  std::vector<Triangle> triangles_;
  std::vector<Index> edges_;                          ///< number of edges at each vertex
  std::unordered_map<std::uint64_t, Index> left_of_;  ///< triangle on the left of each directed edge
};

}  // namespace

std::vector<Triangle> flip_edges(std::vector<Triangle> triangles, Index vertex_count, Index fewest_edges,
                                 const BetterDiagonal& better) {
  return Flipping(std::move(triangles), vertex_count, fewest_edges, better).run();
}

}  // namespace hariko
