#include "core/envelope/ball/ball_cage.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/disjoint_sets.hpp"
#include "core/envelope/ball/contour.hpp"

namespace hariko {

namespace {

constexpr int first_steps = 6;
constexpr int even_rounds = 8;  ///< more of them make corners of quads blunt
constexpr double even_share = 0.6;

/// Nodes outside that are not reached from the grid's rim become inside.
void fill_hollows(FlagGrid& grid) {
  const auto size = grid.size();
  std::vector<char> reached(grid.inside.size(), 0);
  std::vector<std::array<int, 3>> open{{0, 0, 0}};
  reached[0] = 1;
  while (!open.empty()) {
    const std::array<int, 3> n = open.back();
    open.pop_back();
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int by : {-1, 1}) {
        std::array<int, 3> m = n;
        m[axis] += by;
        if (m[axis] < 0 || m[axis] >= size[axis]) continue;
        const std::size_t at = grid.index(m[0], m[1], m[2]);
        if (reached[at] || grid.inside[at]) continue;
        reached[at] = 1;
        open.push_back(m);
      }
  }
  for (std::size_t i = 0; i < reached.size(); ++i) grid.inside[i] = !reached[i];
}

struct FlaggedField {
  FlagGrid grid;
  std::vector<double> values;
};

FlaggedField flagged(const SplineField& field, const Vector3& origin, double cell) {
  FlaggedField out;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = Eigen::Index(a);
    const double low = field.corner()[axis] + origin[axis] + field.spacing();
    const double high = low + (field.size()[a] - 3) * field.spacing();
    for (double k = std::ceil(low / cell); k <= std::floor(high / cell); ++k)
      out.grid.planes[a].push_back(k * cell - origin[axis]);
  }
  const auto size = out.grid.size();
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const double value = field.value(out.grid.point(i, j, k));
        const bool rim =
            i == 0 || j == 0 || k == 0 || i + 1 == size[0] || j + 1 == size[1] || k + 1 == size[2];
        out.values.push_back(value);
        out.grid.inside.push_back(value < 0 && !rim);
      }
  fill_hollows(out.grid);
  return out;
}

/// Moves vertices along the surface towards where the quads about them are parallelograms.
void make_even(const SplineField& field, BallCage& cage) {
  std::vector<Vector3> sum(cage.positions.size());
  std::vector<int> count(cage.positions.size());
  for (int round = 0; round < even_rounds; ++round) {
    std::ranges::fill(sum, Vector3::Zero());
    std::ranges::fill(count, 0);
    for (const auto& quad : cage.quads) {
      const auto at = [&](std::size_t i) -> const Vector3& { return cage.positions[quad[i % 4]]; };
      const Vector3 middle = 0.25 * ((at(0) + at(2)) + (at(1) + at(3)));
      for (std::size_t i = 0; i < 4; ++i) {
        sum[quad[i]] += 0.5 * (middle + (at(i + 1) + at(i + 3)) - at(i + 2));
        ++count[quad[i]];
      }
    }
    for (Index v = 0; v < cage.positions.size(); ++v) {
      Vector3 move = sum[v] / count[v] - cage.positions[v];
      const Vector3 normal = field.at(cage.positions[v]).gradient.stableNormalized();
      move -= move.dot(normal) * normal;
      cage.positions[v] = projected(field, cage.positions[v] + even_share * move, 2, 0.5 * cage.cell);
    }
  }
}

}  // namespace

BallCage ball_cage(const SplineField& field, const Vector3& origin, double cell) {
  const FlaggedField flags = flagged(field, origin, cell);
  const FlagGrid& grid = flags.grid;
  const Contour found = contour(grid, [&](const Vector3& p) { return field.value(p) < 0; });
  BallCage out;
  out.cell = cell;
  out.quads = found.quads;
  for (const ContourVertex& vertex : found.vertices) {
    Vector3 sum = Vector3::Zero();
    for (const auto& [i, j, k, axis] : vertex.crossings) {
      std::array<int, 3> m{i, j, k};
      ++m[std::size_t(axis)];
      const double f = flags.values[grid.index(i, j, k)], g = flags.values[grid.index(m[0], m[1], m[2])];
      const double share = f == g ? 0.5 : std::clamp(f / (f - g), 0.0, 1.0);
      sum += grid.point(i, j, k) + share * (grid.point(m[0], m[1], m[2]) - grid.point(i, j, k));
    }
    out.positions.push_back(projected(field, sum / double(vertex.crossings.size()), first_steps, 0.5 * cell));
  }
  make_even(field, out);
  return out;
}

BallCage cut_cage(const SplineField& field, const BallCage& cage, std::span<const HermitePatch> patches,
                  std::span<const QuadCuts> cuts) {
  // Sides are numbered; those that face each other across a quad are cut together.
  std::map<std::pair<Index, Index>, Index> sides;
  std::vector<std::array<Index, 4>> of_quad;
  for (const auto& quad : cage.quads) {
    std::array<Index, 4> mine;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto ends = std::minmax(quad[i], quad[(i + 1) % 4]);
      mine[i] = sides.try_emplace({ends.first, ends.second}, Index(sides.size())).first->second;
    }
    of_quad.push_back(mine);
  }
  DisjointSets chords(sides.size());
  for (const auto& mine : of_quad) chords.join(mine[0], mine[2]), chords.join(mine[1], mine[3]);
  std::vector<char> cut(sides.size(), 0);
  for (std::size_t q = 0; q < cuts.size(); ++q)
    for (std::size_t way = 0; way < 2; ++way)
      if (cuts[q][way]) cut[chords.find(of_quad[q][way])] = 1;
  const auto is_cut = [&](Index side) { return cut[chords.find(side)] != 0; };

  BallCage out = cage;
  out.quads.clear();
  std::vector<Index> middle(sides.size(), no_index);
  // New vertices lie on the patches, which are nearer to the surface than chords: those may cross thin parts.
  const auto add_vertex = [&](std::size_t q, double u, double v) {
    out.positions.push_back(
        projected(field, evaluate(patches[q], Vector2(u, v), Order::first).position, 3, 0.25 * cage.cell));
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
  }
  return out;
}

CageTopology topology_of(const BallCage& cage) {
  DisjointSets parts(cage.positions.size());
  for (const auto& quad : cage.quads)
    for (std::size_t k = 1; k < 4; ++k) parts.join(quad[0], quad[k]);
  CageTopology out;
  for (Index v = 0; v < cage.positions.size(); ++v) out.components += parts.find(v) == v;
  // Closed, of quads: twice as many edges as quads.
  const long euler = long(cage.positions.size()) - long(cage.quads.size());
  out.tunnels = out.components - int(euler / 2);
  return out;
}

}  // namespace hariko
