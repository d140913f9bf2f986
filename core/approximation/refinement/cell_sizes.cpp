#include "core/approximation/refinement/cell_sizes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/approximation/refinement/patch_grid_mesh.hpp"
#include "core/base/disjoint_sets.hpp"
#include "core/surface/adjacency.hpp"

namespace hariko {

namespace {

constexpr double bend_places[] = {1.0 / 6, 0.5, 5.0 / 6};
constexpr double most_cells = 256;  ///< along a side
/// Factor by which cells are longer than the tolerance allows; bisection refines them where needed. Of 1, 2,
/// 4, 6 and 8 times the distance, 4, which is twice the length, leaves the fewest facets.
constexpr double coarse = 2;
/// Greatest ratio of largest to mean bend for which cells are used: a bend in one place only is better left
/// to bisection (measured: up to 1.53 cells leave fewer facets, at 1.96 and 3.4 more).
constexpr double most_uneven = 1.75;
/// Part of a cut below which a direction counts as straight.
constexpr double straight = 0.1;
constexpr double margin = 1.15;  ///< factor on the largest of a few samples

/// Bending of a patch along one direction of its parameters, from side to side.
struct ParameterBend {
  double mean = 0, most = 0;  ///< Lengths: normal component of the second derivative.
  double turn = 0;            ///< mean turn of the tangent, radians

  void add(const Vector3& first, const Vector3& second, const Vector3& normal) {
    constexpr double share = 1.0 / (std::size(bend_places) * std::size(bend_places));
    const double bend = std::abs(second.dot(normal)), speed = first.norm();
    mean += share * bend;
    most = std::max(most, bend);
    if (speed > 0) turn += share * bend / speed;
  }
  bool uneven() const { return most > most_uneven * mean; }
};

struct PatchBends {
  ParameterBend columns, rows;
};

PatchBends bends_of(const SurfaceSampler& sampler, Index patch) {
  PatchBends out;
  for (const double s : bend_places)
    for (const double t : bend_places) {
      const PatchPoint p = sampler.second_order(patch, {s, t});
      const Vector3 normal = p.ds.cross(p.dt).stableNormalized();
      out.columns.add(p.ds, p.dss, normal);
      out.rows.add(p.dt, p.dtt, normal);
    }
  return out;
}

/// Numbers of cells along the sides of a patch, not yet rounded.
struct WantedCells {
  double columns = 1, rows = 1;
};

/// Cells for a patch bent along one direction only: all cuts across it at once, as bisection would cut it
/// along the other direction, too.
WantedCells along_one(double columns, double rows) {
  return columns > rows ? WantedCells{std::ceil(columns), 1} : WantedCells{1, std::ceil(rows)};
}

/// Cells by distance: a cell of 1 / c x 1 / r keeps within (l / c^2 + n / r^2) / 8 of its surface, where l
/// and n are the bends; the fewest cells share that equally.
WantedCells by_distance(const PatchBends& bends, double tolerance) {
  const auto& [columns, rows] = bends;
  const double unit = 8 * tolerance;
  const double less = std::min(columns.most, rows.most);
  if (less < straight * unit) {
    const auto count = [&](const ParameterBend& b) { return std::sqrt(margin * b.most / (unit - less)); };
    return along_one(count(columns), count(rows));
  }
  if (columns.uneven() || rows.uneven()) return {};
  const auto count = [&](const ParameterBend& b) { return std::sqrt(2 * b.mean / unit) / coarse; };
  return {count(columns), count(rows)};
}

/// Cells by angle: normals turn by at most `turn` across a cell.
WantedCells by_turn(const PatchBends& bends, double turn) {
  const auto& [columns, rows] = bends;
  if (std::min(columns.turn, rows.turn) < straight * turn)
    return along_one(margin * columns.turn / turn, margin * rows.turn / turn);
  if (columns.uneven() || rows.uneven()) return {};
  return {columns.turn / turn / coarse, rows.turn / turn / coarse};
}

class StartCells {
 public:
  StartCells(const SurfaceSampler& sampler, const MeshCriteria& criteria)
      : sampler_(sampler), criteria_(criteria) {}

  std::vector<PatchCells> find() const {
    const Surface& surface = sampler_.surface();
    // Two pairs of opposite sides per patch, which have the same number of cells.
    DisjointSets pairs(2 * std::size_t(surface.patch_count()));
    const auto pair_of = [](const PatchSide& side) { return 2 * side.patch + side.side % 2; };
    for (const Seam& seam : surface.seams())
      if (is_full(seam)) pairs.join(pair_of(seam.first), pair_of(seam.second));
    std::vector<double> wanted(pairs.size(), 1.0);
    for (Index p = 0; p < surface.patch_count(); ++p) {
      const WantedCells cells = cells_of(p);
      for (const auto& [pair, count] : {std::pair(2 * p, cells.columns), std::pair(2 * p + 1, cells.rows)})
        wanted[pairs.find(pair)] = std::max(wanted[pairs.find(pair)], count);
    }
    const auto whole = [](double count) { return count > 1 ? int(std::min(count, most_cells)) : 1; };
    std::vector<PatchCells> out;
    for (Index p = 0; p < surface.patch_count(); ++p)
      out.push_back({whole(wanted[pairs.find(2 * p)]), whole(wanted[pairs.find(2 * p + 1)])});
    return out;
  }

 private:
  WantedCells cells_of(Index patch) const {
    const PatchBends bends = bends_of(sampler_, patch);
    WantedCells out;
    const auto take = [&](const WantedCells& w) {
      out.columns = std::max(out.columns, w.columns);
      out.rows = std::max(out.rows, w.rows);
    };
    if (criteria_.distance) take(by_distance(bends, *criteria_.distance));
    // A facet's normal is about that of its middle.
    if (criteria_.normal_angle) take(by_turn(bends, 2 * *criteria_.normal_angle));
    if (criteria_.fold_angle) take(by_turn(bends, *criteria_.fold_angle));
    return out;
  }

  const SurfaceSampler& sampler_;
  const MeshCriteria& criteria_;
};

}  // namespace

ParameterMesh start_mesh(const SurfaceSampler& sampler, const MeshOptions& options) {
  const Surface& surface = sampler.surface();
  if (options.start == MeshStart::patches || surface.domain() != Domain::square) return initial_mesh(surface);
  const std::vector<PatchCells> cells = StartCells(sampler, options.criteria).find();
  std::size_t facets = 0;
  for (const PatchCells& one : cells) facets += 2 * std::size_t(one.columns) * std::size_t(one.rows);
  if (facets > options.facet_limit) return initial_mesh(surface);
  return initial_mesh(surface, cells);
}

}  // namespace hariko
