#include "core/envelope/ball/contour.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace hariko {

namespace {

using Node = std::array<int, 3>;
using Edge = std::array<int, 4>;  ///< lower node, axis
using Face = std::array<int, 4>;  ///< lower node, axis of the normal

class Contouring {
 public:
  Contouring(const FlagGrid& grid, const std::function<bool(const Vector3&)>& inside)
      : grid_(grid), inside_(inside) {}

  Contour make() {
    for (int round = 0; round < 8; ++round) {
      trace();
      if (!flip_doubled()) break;
    }
    make_quads();
    return std::move(out_);
  }

 private:
  bool flag(const Node& n) const { return grid_.inside[grid_.index(n[0], n[1], n[2])] != 0; }
  static Node moved(Node n, int axis, int by = 1) {
    n[std::size_t(axis)] += by;
    return n;
  }
  bool crossed(const Edge& e) const {
    const Node n{e[0], e[1], e[2]};
    return flag(n) != flag(moved(n, e[3]));
  }

  /// Pairs of crossed edges of a cell's face that are joined.
  std::vector<std::pair<Edge, Edge>> segments(const Face& face) {
    const Node n{face[0], face[1], face[2]};
    const int u = (face[3] + 1) % 3, v = (face[3] + 2) % 3;
    // Round the face: u low, v high, u high, v low.
    const Node nu = moved(n, u), nv = moved(n, v);
    const std::array<Edge, 4> edges{Edge{n[0], n[1], n[2], u}, Edge{nu[0], nu[1], nu[2], v},
                                    Edge{nv[0], nv[1], nv[2], u}, Edge{n[0], n[1], n[2], v}};
    std::vector<Edge> crossings;
    for (const Edge& e : edges)
      if (crossed(e)) crossings.push_back(e);
    if (crossings.size() == 2) return {{crossings[0], crossings[1]}};
    if (crossings.size() != 4) return {};
    // Corner n lies between edges 3 and 0. If the centre is inside, outside corners are cut off.
    const bool cut_off_n = flag(n) != centre_inside(face);
    if (cut_off_n) return {{edges[3], edges[0]}, {edges[1], edges[2]}};
    return {{edges[0], edges[1]}, {edges[2], edges[3]}};
  }
  bool centre_inside(const Face& face) {
    const auto [known, fresh] = decisions_.try_emplace(face, false);
    if (fresh) {
      const int u = (face[3] + 1) % 3, v = (face[3] + 2) % 3;
      const Node n{face[0], face[1], face[2]}, m = moved(moved(n, u), v);
      known->second = inside_(0.5 * (grid_.point(n[0], n[1], n[2]) + grid_.point(m[0], m[1], m[2])));
    }
    return known->second;
  }

  void trace() {
    out_ = {};
    at_.clear();
    const auto [nx, ny, nz] = grid_.size();
    for (int k = 0; k + 1 < nz; ++k)
      for (int j = 0; j + 1 < ny; ++j)
        for (int i = 0; i + 1 < nx; ++i) trace_cell({i, j, k});
  }

  void trace_cell(const Node& cell) {
    int count = 0;
    for (int c = 0; c < 8; ++c)
      count += flag({cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2)});
    if (count == 0 || count == 8) return;
    std::map<Edge, std::vector<Edge>> beside;
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        const Node n = moved(cell, axis, side);
        for (const auto& [a, b] : segments({n[0], n[1], n[2], axis})) {
          beside[a].push_back(b);
          beside[b].push_back(a);
        }
      }
    std::set<Edge> done;
    for (const auto& [first, others] : beside) {
      if (done.contains(first)) continue;
      ContourVertex vertex;
      vertex.cell = cell;
      Edge at = first, before = first;
      do {
        done.insert(at);
        vertex.crossings.push_back(at);
        at_[{cell, at}] = Index(out_.vertices.size());
        const auto& next = beside.at(at);
        const Edge to =
            next[0] == before && next.size() > 1 && !(vertex.crossings.size() == 1) ? next[1] : next[0];
        before = at;
        at = to;
      } while (!done.contains(at));
      out_.vertices.push_back(std::move(vertex));
    }
  }

  /// Where both segments of a face belong to one vertex on both sides, two quads would share two edges.
  bool flip_doubled() {
    bool flipped = false;
    for (auto& [face, decision] : decisions_) {
      const auto cut = segments(face);
      if (cut.size() != 2) continue;
      const Node here{face[0], face[1], face[2]}, before = moved(here, face[3], -1);
      const auto one_vertex = [&](const Node& cell) {
        const auto a = at_.find({cell, cut[0].first}), b = at_.find({cell, cut[1].first});
        return a != at_.end() && b != at_.end() && a->second == b->second;
      };
      if (!one_vertex(here) || !one_vertex(before)) continue;
      decision = !decision;
      flipped = true;
    }
    return flipped;
  }

  void make_quads() {
    const auto size = grid_.size();
    for (int axis = 0; axis < 3; ++axis)
      for (int k = 0; k < size[2]; ++k)
        for (int j = 0; j < size[1]; ++j)
          for (int i = 0; i < size[0]; ++i) {
            const Node n{i, j, k};
            if (n[std::size_t(axis)] + 1 >= size[std::size_t(axis)] || !crossed({i, j, k, axis})) continue;
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const Edge edge{i, j, k, axis};
            // Counter-clockwise seen from the end of the axis.
            const std::array<Node, 4> cells{moved(moved(n, u, -1), v, -1), moved(n, v, -1), n,
                                            moved(n, u, -1)};
            std::array<Index, 4> quad;
            for (std::size_t c = 0; c < 4; ++c) quad[c] = at_.at({cells[c], edge});
            if (!flag(n)) std::reverse(quad.begin(), quad.end());
            out_.quads.push_back(quad);
          }
  }

  const FlagGrid& grid_;
  const std::function<bool(const Vector3&)>& inside_;
  std::map<Face, bool> decisions_;
  std::map<std::pair<Node, Edge>, Index> at_;
  Contour out_;
};

}  // namespace

Contour contour(const FlagGrid& grid, const std::function<bool(const Vector3&)>& inside) {
  return Contouring(grid, inside).make();
}

}  // namespace hariko
