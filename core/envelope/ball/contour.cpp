#include "core/envelope/ball/contour.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_map>

namespace hariko {

namespace {

using Node = std::array<int, 3>;  ///< in steps of the last level

Node moved(Node node, int axis, int by) {
  node[std::size_t(axis)] += by;
  return node;
}

/// Key of a node, or of the edge that begins there along an axis, or of the face perpendicular to it.
std::uint64_t key_of(const Node& node, int axis = 0) {
  std::uint64_t out = std::uint64_t(axis);
  for (const int x : node) out = out << 20 | std::uint64_t(x);
  return out;
}

/// Edge between nodes of different signs, without a node in between.
struct Crossing {
  Node node;  ///< the lower node
  int axis, length;
  bool rises;  ///< from inside to outside, in the direction of traversal
};

/// Crossings with the boundary of a face: at most one on each half of its sides.
struct Crossings {
  std::array<Crossing, 8> all;
  std::size_t count = 0;
};

/// Square between two cubes, not divided into smaller ones.
struct Face {
  Node node;  ///< the lowest node
  int axis, level;
};

class Contouring {
 public:
  Contouring(const CubeTree& cubes, const SplineField& field) : cubes_(cubes), field_(field) {}

  Contour make() {
    find_cubes();
    constexpr int most_rounds = 8;
    for (int round = 0; round < most_rounds; ++round) {
      do trace();
      while (add_missed());
      if (!flip_doubled()) break;
    }
    make_faces();
    return std::move(out_);
  }

 private:
  double value(const Node& node) {
    const auto [known, fresh] = values_.try_emplace(key_of(node), 0);
    if (fresh) known->second = field_.value(cubes_.point(node));
    return known->second;
  }
  bool inside(const Node& node) { return value(node) < 0; }

  /// Search radius in half edges: the distance of a corner, and a quarter more for the slope of fields
  /// between their nodes.
  static constexpr double reach = 1.25 * 1.7320508075688772;

  /// Finds unsplit cubes that the surface may cross.
  void find_cubes() {
    const auto& size = cubes_.size();
    for (int k = 0; k < size[2]; ++k)
      for (int j = 0; j < size[1]; ++j)
        for (int i = 0; i < size[0]; ++i) find_in({0, {i, j, k}});
  }
  void find_in(const Cube& cube) {
    const int steps = cubes_.steps(cube.level);
    const Node low{cube.at[0] * steps, cube.at[1] * steps, cube.at[2] * steps};
    const double half = 0.5 * cubes_.edge(cube.level);
    const Vector3 middle = cubes_.point(low) + Vector3::Constant(half);
    if (std::abs(field_.value(middle)) > reach * half) return;
    if (!cubes_.is_split(cube)) return leaves_.push_back(cube);
    for (int c = 0; c < 8; ++c)
      find_in({cube.level + 1,
               {2 * cube.at[0] + (c & 1), 2 * cube.at[1] + (c >> 1 & 1), 2 * cube.at[2] + (c >> 2)}});
  }

  /// Whether a cube of this level that touches the edge is split.
  bool is_halved(const Node& node, int axis, int level) const {
    const int steps = cubes_.steps(level);
    for (int c = 0; c < 4; ++c) {
      Node low = moved(moved(node, (axis + 1) % 3, c & 1 ? 0 : -1), (axis + 2) % 3, c & 2 ? 0 : -1);
      const auto at = [&](std::size_t a) { return low[a] < 0 ? -1 : low[a] / steps; };
      if (cubes_.is_split({level, {at(0), at(1), at(2)}})) return true;
    }
    return false;
  }

  /// Crossings of the surface with the boundary of a face, in order.
  Crossings crossings(const Face& face) {
    const int steps = cubes_.steps(face.level), u = (face.axis + 1) % 3, v = (face.axis + 2) % 3;
    const std::array<Node, 4> corners{face.node, moved(face.node, u, steps),
                                      moved(moved(face.node, u, steps), v, steps),
                                      moved(face.node, v, steps)};
    Crossings out;
    for (std::size_t side = 0; side < 4; ++side) {
      const Node &from = corners[side], &to = corners[(side + 1) % 4], low = std::min(from, to);
      const int axis = side % 2 == 0 ? u : v;
      const auto add = [&](const Node& a, const Node& b, int length) {
        if (const bool from_inside = inside(a); from_inside != inside(b))
          out.all[out.count++] = {std::min(a, b), axis, length, from_inside};
      };
      if (cubes_.any_split() && face.level < cubes_.depth() && is_halved(low, axis, face.level)) {
        const Node middle = moved(low, axis, steps / 2);
        add(from, middle, steps / 2);
        add(middle, to, steps / 2);
      } else {
        add(from, to, steps);
      }
    }
    return out;
  }

  /// Pairs of crossings of a face's boundary that are joined. If the face's centre is inside, outside corners
  /// are cut off.
  std::vector<std::array<Crossing, 2>> segments(const Face& face) {
    const Crossings found = crossings(face);
    const std::span all(found.all.data(), found.count);
    if (all.empty()) return {};
    bool cut_outside = true;
    if (all.size() > 2) {
      const auto [known, fresh] = decisions_.try_emplace(key_of(face.node, face.axis), face, false);
      if (fresh) {
        const int half = cubes_.steps(face.level);
        const Node far = moved(moved(face.node, (face.axis + 1) % 3, half), (face.axis + 2) % 3, half);
        known->second.second = field_.value(0.5 * (cubes_.point(face.node) + cubes_.point(far))) < 0;
      }
      cut_outside = known->second.second;
    }
    std::vector<std::array<Crossing, 2>> out;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].rises == cut_outside) out.push_back({all[i], all[(i + 1) % all.size()]});
    return out;
  }

  /// Faces between a cube and its neighbours, which may be smaller.
  std::vector<Face> faces_of(const Cube& cube) const {
    const int steps = cubes_.steps(cube.level);
    const Node low{cube.at[0] * steps, cube.at[1] * steps, cube.at[2] * steps};
    std::vector<Face> out;
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        const Node node = moved(low, axis, side * steps);
        Cube beside = cube;
        beside.at[std::size_t(axis)] += side == 0 ? -1 : 1;
        if (!cubes_.is_split(beside)) {
          out.push_back({node, axis, cube.level});
          continue;
        }
        for (int c = 0; c < 4; ++c)
          out.push_back(
              {moved(moved(node, (axis + 1) % 3, (c & 1) * steps / 2), (axis + 2) % 3, (c >> 1) * steps / 2),
               axis, cube.level + 1});
      }
    return out;
  }

  void trace() {
    out_ = {};
    at_.clear();
    for (const Cube& cube : leaves_) trace_cube(cube);
  }

  Vector3 place(const Crossing& at) {
    const Node to = moved(at.node, at.axis, at.length);
    const double f = value(at.node), g = value(to);
    const Vector3 p = cubes_.point(at.node), q = cubes_.point(to);
    return p + f / (f - g) * (q - p);
  }

  /// Makes one vertex for every closed path round the cube from face to face.
  void trace_cube(const Cube& cube) {
    struct Link {
      std::array<Crossing, 2> ends;
      bool done = false;
    };
    std::vector<Link> links;
    for (const Face& face : faces_of(cube))
      for (const auto& segment : segments(face)) links.push_back({segment});
    const auto same = [](const Crossing& a, const Crossing& b) {
      return a.node == b.node && a.axis == b.axis;
    };
    for (Link& first : links) {
      if (first.done) continue;
      ContourVertex vertex{cube};
      const auto number = Index(out_.vertices.size());
      Crossing at = first.ends[0];
      Link* link = &first;
      while (link) {
        link->done = true;
        vertex.position += place(at);
        ++vertex.faces;
        at_[key_of(at.node, at.axis)].push_back({cube, at, number});
        at = same(link->ends[0], at) ? link->ends[1] : link->ends[0];
        link = nullptr;
        for (Link& next : links)
          if (!next.done && (same(next.ends[0], at) || same(next.ends[1], at))) link = &next;
      }
      vertex.position /= vertex.faces;
      out_.vertices.push_back(vertex);
    }
  }

  Index vertex_at(const Cube& cube, const Crossing& at) const {
    const auto found = at_.find(key_of(at.node, at.axis));
    if (found == at_.end()) return no_index;
    for (const Corner& corner : found->second)
      if (corner.cube.level == cube.level && corner.cube.at == cube.at) return corner.vertex;
    return no_index;
  }

  /// Cubes around an edge that the surface crosses, counter-clockwise seen from the end of the axis.
  std::array<Cube, 4> cubes_about(const Crossing& edge) const {
    const int u = (edge.axis + 1) % 3, v = (edge.axis + 2) % 3;
    const auto beside = [&](int by_u, int by_v) {
      return cubes_.leaf(moved(moved(edge.node, u, by_u), v, by_v));
    };
    return {beside(-1, -1), beside(0, -1), beside(0, 0), beside(-1, 0)};
  }

  /// Adds cubes that share a crossed edge and were skipped because the field is not 1-Lipschitz there. False
  /// where there are none.
  bool add_missed() {
    std::vector<Cube> missed;
    for (const auto& [key, corners] : at_)
      for (const Cube& cube : cubes_about(corners.front().crossing))
        if (vertex_at(cube, corners.front().crossing) == no_index) missed.push_back(cube);
    const auto same = [](const Cube& a, const Cube& b) { return a.level == b.level && a.at == b.at; };
    std::ranges::sort(missed, {}, [](const Cube& cube) { return std::pair(cube.level, cube.at); });
    missed.erase(std::unique(missed.begin(), missed.end(), same), missed.end());
    leaves_.insert(leaves_.end(), missed.begin(), missed.end());
    return !missed.empty();
  }

  /// Flips faces whose two segments belong to one vertex on both sides, because their quads would share two
  /// edges.
  bool flip_doubled() {
    bool flipped = false;
    for (auto& [key, decision] : decisions_) {
      const Face& face = decision.first;
      const auto cut = segments(face);
      const auto one_vertex = [&](int side) {
        const Cube cube = cubes_.leaf(moved(face.node, face.axis, side));
        const Index first = vertex_at(cube, cut[0][0]);
        return first != no_index && first == vertex_at(cube, cut[1][0]);
      };
      if (cut.size() != 2 || !one_vertex(0) || !one_vertex(-1)) continue;
      decision.second = !decision.second;
      flipped = true;
    }
    return flipped;
  }

  void make_faces() {
    std::vector<std::uint64_t> keys;
    for (const auto& [key, corners] : at_) keys.push_back(key);
    std::ranges::sort(keys);
    for (const std::uint64_t key : keys) {
      const Crossing& edge = at_.at(key).front().crossing;
      std::vector<Index> loop;
      for (const Cube& cube : cubes_about(edge)) {
        const Index vertex = vertex_at(cube, edge);
        if (loop.empty() || loop.back() != vertex) loop.push_back(vertex);
      }
      if (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
      if (!inside(edge.node)) std::ranges::reverse(loop);
      std::array<Index, 4> face{no_index, no_index, no_index, no_index};
      std::ranges::copy(loop, face.begin());
      out_.faces.push_back(face);
    }
  }

  struct Corner {
    Cube cube;
    Crossing crossing;
    Index vertex;
  };

  const CubeTree& cubes_;
  const SplineField& field_;
  std::unordered_map<std::uint64_t, double> values_;
  std::vector<Cube> leaves_;
  /// Whether a face's centre counts as inside.
  std::unordered_map<std::uint64_t, std::pair<Face, bool>> decisions_;
  std::unordered_map<std::uint64_t, std::vector<Corner>> at_;  ///< by crossed edge
  Contour out_;
};

}  // namespace

Contour contour(const CubeTree& cubes, const SplineField& field) {
  return Contouring(cubes, field).make();
}

}  // namespace hariko
