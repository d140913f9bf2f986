#include <unordered_map>

#include "core/base/index_list.hpp"
#include "core/envelope/ball/ball_cage.hpp"

namespace hariko {

namespace {

using Node = std::array<int, 3>;  ///< in steps of the last level

Node moved(Node node, int axis, int by) {
  node[std::size_t(axis)] += by;
  return node;
}

/// Edge between nodes of different signs, without a node in between.
struct Crossing {
  Node node;  ///< the lower node
  int axis, length;
  bool rises;  ///< from inside to outside, in the direction of traversal

  std::uint64_t key() const { return packed_key(axis, node); }
  bool is_same(const Crossing& other) const { return node == other.node && axis == other.axis; }
};

/// Crossings with the boundary of a face: at most one on each half of its sides.
struct Crossings {
  std::array<Crossing, 8> all;
  std::size_t count = 0;
};

/// Two crossings of a face's boundary that are joined.
using Segment = std::array<Crossing, 2>;
struct Segments {
  std::array<Segment, 4> all{};
  std::size_t count = 0;
  std::span<const Segment> found() const { return {all.data(), count}; }
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
    if (const double kept = cubes_.known_value(node); !std::isnan(kept)) return kept;
    const auto [known, fresh] = values_.try_emplace(packed_key(0, node), 0);
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
    if (cubes_.any_split()) values_.reserve(4 * leaves_.size());
  }
  void find_in(const Cube& cube) {
    if (is_far(cube)) return;
    if (!cubes_.is_split(cube)) return leaves_.push_back(cube);
    for (int c = 0; c < 8; ++c) find_in(cube.part(c));
  }

  /// Whether the surface lies beyond the search radius of a cube.
  bool is_far(const Cube& cube) const {
    const double half = 0.5 * cubes_.edge(cube.level), enough = reach * half;
    const Node low = cubes_.low_node(cube);
    if (cube.level == 0) {
      const int to = cubes_.steps(0) / 2;
      const double kept = std::abs(cubes_.known_value({low[0] + to, low[1] + to, low[2] + to}));
      // Its place is the middle but for rounding: near the limit it does not decide.
      constexpr double clearly = 1 + 1e-6;
      if (kept > clearly * enough) return true;
      if (clearly * kept < enough) return false;
    }
    const Vector3 middle = cubes_.point(low) + Vector3::Constant(half);
    return std::abs(field_.value(middle)) > enough;
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
  Segments segments(const Face& face) {
    const Crossings found = crossings(face);
    const std::span all(found.all.data(), found.count);
    Segments out;
    if (all.empty()) return out;
    bool cut_outside = true;
    if (all.size() > 2) {
      const auto [known, fresh] = decisions_.try_emplace(packed_key(face.axis, face.node), face, false);
      if (fresh) {
        const int half = cubes_.steps(face.level);
        const Node far = moved(moved(face.node, (face.axis + 1) % 3, half), (face.axis + 2) % 3, half);
        known->second.second = field_.value(0.5 * (cubes_.point(face.node) + cubes_.point(far))) < 0;
      }
      cut_outside = known->second.second;
    }
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].rises == cut_outside) out.all[out.count++] = {all[i], all[(i + 1) % all.size()]};
    return out;
  }

  /// Faces between a cube and its neighbours, which may be smaller; until the next call.
  const std::vector<Face>& faces_of(const Cube& cube) {
    const int steps = cubes_.steps(cube.level);
    const Node low = cubes_.low_node(cube);
    std::vector<Face>& out = faces_;
    out.clear();
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

  /// Whether all corners of a cube are on one side of the surface.
  bool is_on_one_side(const Cube& cube) {
    const int steps = cubes_.steps(cube.level);
    const Node low = cubes_.low_node(cube);
    const bool first = inside(low);
    for (int c = 1; c < 8; ++c) {
      const Node corner{low[0] + (c & 1) * steps, low[1] + (c >> 1 & 1) * steps, low[2] + (c >> 2) * steps};
      if (inside(corner) != first) return false;
    }
    return true;
  }

  /// Makes one vertex for every closed path round the cube from face to face.
  void trace_cube(const Cube& cube) {
    // Without smaller cubes beside it the surface crosses a cube's edges between its corners alone.
    if (!cubes_.any_split() && is_on_one_side(cube)) return;
    std::vector<Link>& links = links_;
    links.clear();
    for (const Face& face : faces_of(cube)) {
      const Segments cut = segments(face);
      for (const Segment& segment : cut.found()) links.push_back({segment});
    }
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
        at_[at.key()].push_back({cube, at, number});
        at = link->ends[0].is_same(at) ? link->ends[1] : link->ends[0];
        link = nullptr;
        for (Link& next : links)
          if (!next.done && (next.ends[0].is_same(at) || next.ends[1].is_same(at))) link = &next;
      }
      vertex.position /= vertex.faces;
      out_.vertices.push_back(vertex);
    }
  }

  Index vertex_at(const Cube& cube, const Crossing& at) const {
    const auto found = at_.find(at.key());
    if (found == at_.end()) return no_index;
    for (const Corner& corner : found->second)
      if (corner.cube == cube) return corner.vertex;
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
    sort_unique(missed);
    leaves_.insert(leaves_.end(), missed.begin(), missed.end());
    return !missed.empty();
  }

  /// Flips faces whose two segments belong to one vertex on both sides, because their quads would share two
  /// edges.
  bool flip_doubled() {
    bool flipped = false;
    for (auto& [key, decision] : decisions_) {
      const Face& face = decision.first;
      const Segments cut = segments(face);
      const auto one_vertex = [&](int side) {
        const Cube cube = cubes_.leaf(moved(face.node, face.axis, side));
        const Index first = vertex_at(cube, cut.all[0][0]);
        return first != no_index && first == vertex_at(cube, cut.all[1][0]);
      };
      if (cut.count != 2 || !one_vertex(0) || !one_vertex(-1)) continue;
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
      for (const Cube& cube : cubes_about(edge)) loop.push_back(vertex_at(cube, edge));
      remove_repeats(loop);
      if (!inside(edge.node)) std::ranges::reverse(loop);
      std::array<Index, 4> face{no_index, no_index, no_index, no_index};
      std::ranges::copy(loop, face.begin());
      out_.faces.push_back(face);
    }
  }

  struct Link {
    Segment ends;
    bool done = false;
  };
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
  std::vector<Link> links_;                                    ///< links in the cube being traced
  std::vector<Face> faces_;                                    ///< likewise
  Contour out_;
};

}  // namespace

Contour contour(const CubeTree& cubes, const SplineField& field) {
  return Contouring(cubes, field).make();
}

}  // namespace hariko
