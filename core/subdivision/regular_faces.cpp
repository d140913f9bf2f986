#include "core/subdivision/regular_faces.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <unordered_map>

#include "core/geometry/edge_key.hpp"

namespace hariko {

namespace {

/// Traversal of quads: a corner is a face and a place in it.
class QuadWalk {
 public:
  explicit QuadWalk(const ControlMesh& control) : mesh_(control.mesh) {
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      const auto face = mesh_.face(f);
      for (std::size_t i = 0; i < face.size(); ++i)
        half_edge_[half_edge_key(face[i], face[(i + 1) % face.size()])] = {Index(f), int(i)};
    }
    const std::size_t n = mesh_.positions.size();
    struct Ring {
      int faces = 0, borders = 0;
      bool quads = true, sharp = false, corner = false;
    };
    std::vector<Ring> ring(n);
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      const auto face = mesh_.face(f);
      for (std::size_t i = 0; i < face.size(); ++i) {
        Ring& r = ring[face[i]];
        ++r.faces;
        r.quads = r.quads && face.size() == 4;
        const Index next = face[(i + 1) % face.size()];
        if (!half_edge_.contains(half_edge_key(next, face[i]))) ++r.borders, ++ring[next].borders;
      }
    }
    for (const auto& crease : control.creases) ring[crease.a].sharp = ring[crease.b].sharp = true;
    for (const auto& corner : control.corners) ring[corner.vertex].corner = true;
    regular_.resize(n);
    for (std::size_t v = 0; v < n; ++v) {
      const Ring& r = ring[v];
      const bool inside = r.borders == 0 && r.faces == 4 && !r.corner;
      const bool border = r.borders == 2 && (r.faces == 1 || (r.faces == 2 && !r.corner));
      regular_[v] = r.quads && !r.sharp && (inside || border);
    }
  }

  bool regular(Index face) const {
    const auto v = mesh_.face(face);
    return v.size() == 4 && std::all_of(v.begin(), v.end(), [&](Index i) { return regular_[i] != 0; });
  }

  /// Face beyond side `side` of a face, and the place at which the common side begins in it, in its own
  /// direction.
  std::optional<std::pair<Index, int>> beyond(Index face, int side) const {
    const auto v = mesh_.face(face);
    const auto found = half_edge_.find(half_edge_key(v[std::size_t((side + 1) % 4)], v[std::size_t(side)]));
    if (found == half_edge_.end()) return {};
    return found->second;
  }
  Index vertex(Index face, int place) const { return mesh_.face(face)[std::size_t(((place % 4) + 4) % 4)]; }
  const Vector3& position(Index v) const { return mesh_.positions[v]; }

 private:
  const PolygonMesh& mesh_;
  std::unordered_map<std::uint64_t, std::pair<Index, int>> half_edge_;
  std::vector<char> regular_;
};

/// The 4 x 4 points of a regular face, rotated so that its corner `turn` comes first.
std::array<Vector3, 16> piece(const QuadWalk& walk, Index face, int turn) {
  std::array<Vector3, 16> out;
  const auto at = [&](int i, int j) -> Vector3& { return out[std::size_t(4 * j + i)]; };
  // Grid places of the face's corners, and directions to the points beyond its sides, counter-clockwise.
  constexpr int corner[4][2] = {{1, 1}, {2, 1}, {2, 2}, {1, 2}};
  constexpr int outward[4][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  for (int c = 0; c < 4; ++c) at(corner[c][0], corner[c][1]) = walk.position(walk.vertex(face, turn + c));
  bool open[4];
  for (int side = 0; side < 4; ++side) {
    const int next = (side + 1) % 4;
    const int *a = corner[side], *b = corner[next], *o = outward[side];
    const auto other = walk.beyond(face, (turn + side) % 4);
    open[side] = !other;
    if (!other) continue;
    // The other face begins at b and continues b -> a -> beyond a -> beyond b.
    at(a[0] + o[0], a[1] + o[1]) = walk.position(walk.vertex(other->first, other->second + 2));
    at(b[0] + o[0], b[1] + o[1]) = walk.position(walk.vertex(other->first, other->second + 3));
  }
  for (int side = 0; side < 4; ++side) {
    if (!open[side]) continue;
    const int *a = corner[side], *b = corner[(side + 1) % 4], *o = outward[side];
    at(a[0] + o[0], a[1] + o[1]) = 2 * at(a[0], a[1]) - at(a[0] - o[0], a[1] - o[1]);
    at(b[0] + o[0], b[1] + o[1]) = 2 * at(b[0], b[1]) - at(b[0] - o[0], b[1] - o[1]);
  }
  // Corner points, diagonally across from each corner of the face.
  for (int c = 0; c < 4; ++c) {
    const int before = (c + 3) % 4;  // the side that ends at corner c; side c begins there
    const int *p = corner[c], *o = outward[c], *q = outward[before];
    Vector3& target = at(p[0] + o[0] + q[0], p[1] + o[1] + q[1]);
    if (!open[c]) {
      // Goes round the corner through the face beyond side c: its side that leaves from a.
      const auto other = walk.beyond(face, (turn + c) % 4);
      const auto far = walk.beyond(other->first, (other->second + 1) % 4);
      if (far) {
        target = walk.position(walk.vertex(far->first, far->second + 3));
        continue;
      }
      // Border on the side `before`: reflected across it.
      target = 2 * at(p[0] + o[0], p[1] + o[1]) - at(p[0] + o[0] - q[0], p[1] + o[1] - q[1]);
    } else {
      target = 2 * at(p[0] + q[0], p[1] + q[1]) - at(p[0] + q[0] - o[0], p[1] + q[1] - o[1]);
    }
  }
  return out;
}

}  // namespace

std::vector<RegularFace> regular_faces(const ControlMesh& mesh) {
  const QuadWalk walk(mesh);
  std::vector<RegularFace> out;
  for (Index f = 0; f < mesh.mesh.face_count(); ++f)
    if (walk.regular(f)) out.push_back({f, piece(walk, f, 0)});
  return out;
}

Vector3 evaluate(const RegularFace& face, double s, double t) {
  const auto basis = [](double x) {
    const double y = 1 - x;
    return std::array<double, 4>{y * y * y / 6, (3 * x * x * x - 6 * x * x + 4) / 6,
                                 (-3 * x * x * x + 3 * x * x + 3 * x + 1) / 6, x * x * x / 6};
  };
  const auto a = basis(s), b = basis(t);
  Vector3 out = Vector3::Zero();
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 4; ++i) out += a[i] * b[j] * face.points[4 * j + i];
  return out;
}

namespace {

/// Face in a rectangle, with the corner that is the rectangle's lower left one.
struct Placed {
  Index face = no_index;
  int turn = 0;
};

class RectangleSearch {
 public:
  explicit RectangleSearch(const ControlMesh& mesh) : walk_(mesh), taken_(mesh.mesh.face_count(), 1) {
    for (Index f = 0; f < taken_.size(); ++f) taken_[f] = !walk_.regular(f);
  }

  std::vector<SplineRectangle> run() {
    std::vector<SplineRectangle> out;
    for (Index f = 0; f < taken_.size(); ++f)
      if (!taken_[f]) out.push_back(grow({f, 0}));
    return out;
  }

 private:
  /// Free neighbour over side 0 .. 3 (down, right, up, left) of a placed face.
  std::optional<Placed> step(Placed at, int side) const {
    const auto other = walk_.beyond(at.face, (at.turn + side) % 4);
    if (!other || taken_[other->first]) return {};
    // The common side is the opposite one in the neighbour: over the right side it is the neighbour's left
    // one, number 3, and so on.
    const int theirs = (side + 2) % 4;
    return Placed{other->first, ((other->second - theirs) % 4 + 4) % 4};
  }

  /// Row or column of free neighbours over one side of all faces given; nothing when one is missing.
  std::optional<std::vector<Placed>> line_beyond(const std::vector<Placed>& line, int side,
                                                 const std::set<Index>& own) const {
    std::vector<Placed> out;
    std::set<Index> seen = own;
    for (const Placed& at : line) {
      const auto next = step(at, side);
      if (!next || !seen.insert(next->face).second) return {};
      out.push_back(*next);
    }
    return out;
  }

  SplineRectangle grow(Placed start) {
    std::vector<std::vector<Placed>> grid{{start}};  // rows of columns
    std::set<Index> own{start.face};
    for (bool grown = true; grown;) {
      grown = false;
      for (int side = 0; side < 4; ++side) {
        std::vector<Placed> edge;
        if (side == 0) edge = grid.front();
        if (side == 2) edge = grid.back();
        if (side % 2 == 1)
          for (const auto& row : grid) edge.push_back(side == 1 ? row.back() : row.front());
        const auto line = line_beyond(edge, side, own);
        if (!line) continue;
        for (const Placed& p : *line) own.insert(p.face);
        if (side == 0) grid.insert(grid.begin(), *line);
        if (side == 2) grid.push_back(*line);
        for (std::size_t r = 0; r < grid.size() && side % 2 == 1; ++r)
          grid[r].insert(side == 1 ? grid[r].end() : grid[r].begin(), (*line)[r]);
        grown = true;
      }
    }
    SplineRectangle out;
    out.columns = Index(grid[0].size()), out.rows = Index(grid.size());
    out.points.resize(std::size_t(out.columns + 3) * (out.rows + 3));
    for (Index r = 0; r < out.rows; ++r)
      for (Index c = 0; c < out.columns; ++c) {
        const Placed& at = grid[r][c];
        taken_[at.face] = 1;
        out.faces.push_back(at.face);
        const auto points = piece(walk_, at.face, at.turn);
        for (Index j = 0; j < 4; ++j)
          for (Index i = 0; i < 4; ++i) out.points[(r + j) * (out.columns + 3) + c + i] = points[4 * j + i];
      }
    return out;
  }

  QuadWalk walk_;
  std::vector<char> taken_;
};

}  // namespace

std::vector<SplineRectangle> spline_rectangles(const ControlMesh& mesh) {
  return RectangleSearch(mesh).run();
}

}  // namespace hariko
