#include "core/envelope/ball/ball_cage.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/disjoint_sets.hpp"

namespace hariko {

namespace {

constexpr int first_steps = 6;
constexpr int even_rounds = 8;  ///< more of them make corners of quads blunt
constexpr double even_share = 0.6;
constexpr int spread_rounds = 8;
constexpr double least_ratio = 0.1;    ///< ratio of neighbouring sides of a quad
constexpr double least_corner = 0.2;   ///< sine of a quad's corner
constexpr double shortest_side = 0.3;  ///< in cube edges: shorter sides are collapsed

/// Collapses short sides, keeping the faces round each vertex.
class SideCollapse {
 public:
  SideCollapse(Contour& mesh, std::vector<double> sizes) : mesh_(mesh), sizes_(std::move(sizes)) {
    faces_.resize(mesh.vertices.size());
    for (Index f = 0; f < mesh.faces.size(); ++f)
      for (const Index v : mesh.faces[f])
        if (v != no_index) faces_[v].push_back(f);
  }

  /// Collapses short sides that are the shortest at both ends, with no other short one opposite in a face, so
  /// that the result does not depend on the order.
  void run() {
    std::vector<std::array<Index, 2>> chosen;
    for (const auto& face : mesh_.faces)
      for (std::size_t i = 0; i < 4 && face[3] != no_index; ++i)
        if (const Index a = face[i], b = face[(i + 1) % 4]; a < b && is_lonely(a, b))
          chosen.push_back({a, b});
    for (const auto& [a, b] : chosen) collapse(a, b);
    std::erase_if(mesh_.faces, [](const auto& face) { return face[0] == no_index; });
  }

 private:
  std::vector<Index> neighbours(Index v) const {
    std::vector<Index> out;
    for (const Index f : faces_[v]) {
      const auto& face = mesh_.faces[f];
      const std::size_t n = face[3] == no_index ? 3 : 4;
      const auto at = std::size_t(std::ranges::find(face, v) - face.begin());
      out.push_back(face[(at + 1) % n]);
    }
    return out;
  }

  double length(Index a, Index b) const {
    return (mesh_.vertices[a].position - mesh_.vertices[b].position).norm();
  }
  bool is_short(Index a, Index b) const {
    return length(a, b) < shortest_side * std::min(sizes_[a], sizes_[b]);
  }
  bool is_lonely(Index a, Index b) const {
    if (!is_short(a, b)) return false;
    constexpr double clearly = 1 + 1e-6;
    for (const auto& [v, other] : {std::pair{a, b}, {b, a}})
      for (const Index next : neighbours(v))
        if (next != other && length(v, next) < clearly * length(a, b)) return false;
    return std::ranges::all_of(faces_[a], [&](Index f) {
      const auto& face = mesh_.faces[f];
      for (std::size_t i = 0; i < 4 && face[3] != no_index; ++i) {
        const Index from = face[i], to = face[(i + 1) % 4];
        if (!((from == a && to == b) || (from == b && to == a))) continue;
        return !is_short(face[(i + 2) % 4], face[(i + 3) % 4]);
      }
      return true;
    });
  }

  /// Collapses a side: quads there become triangles, triangles are removed; does nothing where the mesh would
  /// not stay manifold.
  void collapse(Index a, Index b) {
    std::vector<Index> quads, triangles, tips;
    for (const Index f : faces_[a]) {
      const auto& face = mesh_.faces[f];
      if (std::ranges::find(face, b) == face.end()) continue;
      if (face[3] != no_index) {
        quads.push_back(f);
        continue;
      }
      triangles.push_back(f);
      for (const Index v : std::span(face).first(3))
        if (v != a && v != b) tips.push_back(v);
    }
    std::vector<Index> of_a = neighbours(a), of_b = neighbours(b), both;
    for (std::vector<Index>* some : {&of_a, &of_b, &tips}) std::ranges::sort(*some);
    std::ranges::set_intersection(of_a, of_b, std::back_inserter(both));
    const std::size_t left = of_a.size() + of_b.size() - 2 - triangles.size();
    if (quads.size() + triangles.size() != 2 || both != tips || left < 3 || left > 6) return;
    if (std::ranges::any_of(tips, [&](Index v) { return faces_[v].size() < 4; })) return;
    mesh_.vertices[a].position = 0.5 * (mesh_.vertices[a].position + mesh_.vertices[b].position);
    for (const Index f : triangles) {
      for (const Index v : std::span(mesh_.faces[f]).first(3)) std::erase(faces_[v], f);
      mesh_.faces[f].fill(no_index);
    }
    for (const Index f : quads) {
      auto& face = mesh_.faces[f];
      std::erase(faces_[b], f);
      const auto gone = std::ranges::find(face, b);
      std::rotate(gone, gone + 1, face.end());
      face[3] = no_index;
    }
    for (const Index f : faces_[b]) {
      std::ranges::replace(mesh_.faces[f], b, a);
      faces_[a].push_back(f);
    }
    faces_[b].clear();
  }

  Contour& mesh_;
  std::vector<double> sizes_;
  std::vector<std::vector<Index>> faces_;
};

/// Contour without vertices of two faces: such a vertex means that its cube is too large for the surface in
/// it, and the cube is split.
Contour whole_contour(const SplineField& field, CubeTree& cubes) {
  for (;;) {
    Contour mesh = contour(cubes, field);
    bool whole = true;
    for (const ContourVertex& vertex : mesh.vertices)
      if (vertex.faces < 3 && vertex.cube.level < cubes.depth()) {
        whole = false;
        cubes.split(vertex.cube);
      }
    if (whole) return mesh;
  }
}

/// Removes the parts of the mesh that are oriented inwards and bound cavities.
void drop_hollows(Contour& mesh) {
  DisjointSets parts(mesh.vertices.size());
  for (const auto& face : mesh.faces)
    for (std::size_t i = 1; i < 4 && face[i] != no_index; ++i) parts.join(face[0], face[i]);
  std::vector<double> volume(mesh.vertices.size(), 0);
  const auto at = [&](Index v) -> const Vector3& { return mesh.vertices[v].position; };
  for (const auto& face : mesh.faces)
    for (std::size_t i = 2; i < 4 && face[i] != no_index; ++i)
      volume[parts.find(face[0])] += at(face[0]).dot(at(face[i - 1]).cross(at(face[i])));
  std::erase_if(mesh.faces, [&](const auto& face) { return volume[parts.find(face[0])] < 0; });
}

/// Cage with the faces unchanged, all quads; without the vertices of cavities.
BallCage as_it_is(const Contour& mesh, std::vector<double>& sizes) {
  BallCage out;
  std::vector<Index> number(mesh.vertices.size(), no_index);
  std::vector<double> kept;
  for (auto quad : mesh.faces) {
    out.cubes.push_back(mesh.vertices[quad[0]].cube);
    for (Index& v : quad) {
      if (number[v] == no_index) {
        number[v] = Index(out.positions.size());
        out.positions.push_back(mesh.vertices[v].position);
        kept.push_back(sizes[v]);
      }
      v = number[v];
    }
    out.quads.push_back(quad);
  }
  sizes = std::move(kept);
  return out;
}

/// Cage with every face divided into a star of quads about its centre.
BallCage starred(const SplineField& field, const CubeTree& cubes, const Contour& mesh,
                 std::vector<double>& sizes) {
  BallCage out;
  std::vector<Index> number(mesh.vertices.size(), no_index);
  const FaceSides all_sides = sides_of(mesh.faces, mesh.vertices.size());
  std::vector<Index> middles(all_sides.ends.size(), no_index);
  const auto add = [&](const Vector3& p, double size) {
    out.positions.push_back(projected(field, p, first_steps, 0.5 * size));
    sizes.push_back(size);
    return Index(out.positions.size() - 1);
  };
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    const std::size_t n = face[3] == no_index ? 3 : 4;
    std::array<Index, 4> corners{}, sides{};
    Vector3 sum = Vector3::Zero();
    double size = 1e300;
    for (std::size_t i = 0; i < n; ++i) {
      const ContourVertex &a = mesh.vertices[face[i]], &b = mesh.vertices[face[(i + 1) % n]];
      const double own = cubes.edge(a.cube.level), other = cubes.edge(b.cube.level);
      size = std::min(size, own);
      sum += a.position / double(n);
      if (number[face[i]] == no_index) number[face[i]] = add(a.position, own);
      corners[i] = number[face[i]];
      Index& amid = middles[all_sides.of_face[f][i]];
      if (amid == no_index) amid = add(0.5 * (a.position + b.position), std::min(own, other));
      sides[i] = amid;
    }
    const Index middle = add(sum, size);
    for (std::size_t i = 0; i < n; ++i) {
      out.quads.push_back({corners[i], sides[i], middle, sides[(i + n - 1) % n]});
      out.cubes.push_back(mesh.vertices[face[i]].cube);
    }
  }
  return out;
}

/// Moves vertices along the surface to make the quads even.
class Evening {
 public:
  Evening(const SplineField& field, std::span<const double> sizes, BallCage& cage)
      : field_(field),
        sizes_(sizes),
        cage_(cage),
        sum_(cage.positions.size()),
        count_(cage.positions.size()) {}

  void run() {
    for (int round = 0; round < even_rounds; ++round) {
      add_up([&](const Corner& c) { return 0.5 * (c.middle + (c.before + c.after) - c.opposite); });
      move();
    }
    for (int round = 0; round < spread_rounds && find_crowded(); ++round) {
      add_up([](const Corner& c) { return c.middle; });
      move();
    }
  }

 private:
  struct Corner {
    Vector3 middle, before, after, opposite;
  };

  /// Averages the wanted position of each vertex over its quads. The first rounds aim at parallelograms,
  /// which extrapolate beyond the quads' corners and may put vertices with few quads on each other. The
  /// centres of quads, used later, lie between the corners.
  template <class Wanted>
  void add_up(const Wanted& wanted) {
    std::ranges::fill(sum_, Vector3::Zero());
    std::ranges::fill(count_, 0);
    for (const auto& quad : cage_.quads) {
      const auto at = [&](std::size_t i) -> const Vector3& { return cage_.positions[quad[i % 4]]; };
      const Vector3 middle = 0.25 * ((at(0) + at(2)) + (at(1) + at(3)));
      for (std::size_t i = 0; i < 4; ++i) {
        sum_[quad[i]] += wanted(Corner{middle, at(i + 3), at(i + 1), at(i + 2)});
        ++count_[quad[i]];
      }
    }
  }

  void move() {
    for (Index v = 0; v < cage_.positions.size(); ++v) {
      if (!crowded_.empty() && !crowded_[v]) continue;
      Vector3 way = sum_[v] / count_[v] - cage_.positions[v];
      const Vector3 normal = field_.at(cage_.positions[v]).gradient.stableNormalized();
      way -= way.dot(normal) * normal;
      cage_.positions[v] = projected(field_, cage_.positions[v] + even_share * way, 2, 0.25 * sizes_[v]);
    }
  }

  /// Finds vertices of quads with a corner that is nearly straight, nearly closed, or reversed.
  bool find_crowded() {
    crowded_.assign(cage_.positions.size(), 0);
    bool any = false;
    for (const auto& quad : cage_.quads) {
      bool bad = false;
      for (std::size_t i = 0; i < 4 && !bad; ++i) {
        const Vector3 &p = cage_.positions[quad[i]], a = cage_.positions[quad[(i + 1) % 4]] - p,
                      b = cage_.positions[quad[(i + 3) % 4]] - p;
        const double shorter = std::min(a.norm(), b.norm()), longer = std::max(a.norm(), b.norm());
        bad = shorter < least_ratio * longer ||
              a.cross(b).dot(field_.at(p).gradient.stableNormalized()) < least_corner * shorter * longer;
      }
      if (!bad) continue;
      any = true;
      for (const Index v : quad) crowded_[v] = 1;
    }
    return any;
  }

  const SplineField& field_;
  std::span<const double> sizes_;
  BallCage& cage_;
  std::vector<Vector3> sum_;
  std::vector<int> count_;
  std::vector<char> crowded_;  ///< per vertex; empty: all are moved
};

}  // namespace

BallCage ball_cage(const SplineField& field, CubeTree& cubes) {
  Contour mesh = whole_contour(field, cubes);
  std::vector<double> sizes;
  for (ContourVertex& vertex : mesh.vertices) {
    sizes.push_back(cubes.edge(vertex.cube.level));
    vertex.position = projected(field, vertex.position, first_steps, 0.5 * sizes.back());
  }
  drop_hollows(mesh);
  BallCage out;
  if (cubes.any_split()) {
    SideCollapse(mesh, std::move(sizes)).run();
    sizes.clear();
    out = starred(field, cubes, mesh, sizes);
  } else {
    out = as_it_is(mesh, sizes);
  }
  Evening(field, sizes, out).run();
  return out;
}

FaceSides sides_of(std::span<const std::array<Index, 4>> faces, std::size_t vertices) {
  FaceSides out;
  // Lists of the sides at their lower ends.
  std::vector<Index> first(vertices, no_index), next;
  for (const auto& face : faces) {
    std::array<Index, 4>& mine = out.of_face.emplace_back();
    const std::size_t n = face[3] == no_index ? 3 : 4;
    for (std::size_t i = 0; i < n; ++i) {
      const auto [low, high] = std::minmax(face[i], face[(i + 1) % n]);
      Index at = first[low];
      while (at != no_index && out.ends[at][1] != high) at = next[at];
      if (at == no_index) {
        at = Index(out.ends.size());
        out.ends.push_back({low, high});
        next.push_back(std::exchange(first[low], at));
      }
      mine[i] = at;
    }
  }
  return out;
}

BallCage cut_cage(const SplineField& field, const BallCage& cage, const HermitePatchSet& patches,
                  std::span<const QuadCuts> cuts, double longest) {
  const FaceSides sides = sides_of(cage.quads, cage.positions.size());
  const std::size_t count = sides.ends.size();
  const std::vector<std::array<Index, 4>>& of_quad = sides.of_face;
  // Opposite sides of a quad are cut together.
  DisjointSets chords(count);
  for (const auto& mine : of_quad) chords.join(mine[0], mine[2]), chords.join(mine[1], mine[3]);
  std::vector<char> cut(count, 0);
  for (std::size_t q = 0; q < cuts.size(); ++q)
    for (std::size_t way = 0; way < 2; ++way)
      if (cuts[q][way]) cut[chords.find(of_quad[q][way])] = 1;
  const auto is_cut = [&](Index side) { return cut[chords.find(side)] != 0; };

  BallCage out = cage;
  out.quads.clear();
  out.cubes.clear();
  std::vector<Index> middle(count, no_index);
  // New vertices start on the patches, which are nearer to the surface than chords; chords may cross thin
  // parts.
  const auto add_vertex = [&](std::size_t q, double u, double v) {
    out.positions.push_back(
        projected(field, patches.evaluate(Index(q), Vector2(u, v), Order::first).position, 3, longest));
    return Index(out.positions.size() - 1);
  };
  for (std::size_t q = 0; q < cage.quads.size(); ++q)
    for (std::size_t i = 0; i < 4; ++i)
      if (Index& at = middle[of_quad[q][i]]; at == no_index && is_cut(of_quad[q][i])) {
        const Vector2 place = side_parameter(Domain::square, int(i), 0.5);
        at = add_vertex(q, place.x(), place.y());
      }
  for (std::size_t q = 0; q < cage.quads.size(); ++q) {
    const auto& [a, b, c, d] = cage.quads[q];
    const auto& mine = of_quad[q];
    const bool first = is_cut(mine[0]), second = is_cut(mine[1]);
    const Index ab = middle[mine[0]], bc = middle[mine[1]], cd = middle[mine[2]], da = middle[mine[3]];
    if (first && second) {
      const Index centre = add_vertex(q, 0.5, 0.5);
      out.quads.insert(out.quads.end(),
                       {{a, ab, centre, da}, {ab, b, bc, centre}, {centre, bc, c, cd}, {da, centre, cd, d}});
    } else if (first) {
      out.quads.insert(out.quads.end(), {{a, ab, cd, d}, {ab, b, c, cd}});
    } else if (second) {
      out.quads.insert(out.quads.end(), {{a, b, bc, da}, {da, bc, c, d}});
    } else {
      out.quads.push_back(cage.quads[q]);
    }
    out.cubes.resize(out.quads.size(), cage.cubes[q]);
  }
  return out;
}

CageTopology topology_of(const BallCage& cage) {
  DisjointSets parts(cage.positions.size());
  for (const auto& quad : cage.quads)
    for (std::size_t k = 1; k < 4; ++k) parts.join(quad[0], quad[k]);
  CageTopology out;
  for (Index v = 0; v < cage.positions.size(); ++v) out.components += parts.find(v) == v;
  // A closed mesh of quads has twice as many edges as quads.
  const long euler = long(cage.positions.size()) - long(cage.quads.size());
  out.tunnels = out.components - int(euler / 2);
  return out;
}

}  // namespace hariko
