#include "core/approximation/decimation/optimise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <queue>

#include "core/approximation/decimation/mesh_surgery.hpp"
#include "core/approximation/refinement/bisection.hpp"
#include "core/approximation/refinement/facet_error.hpp"
#include "core/approximation/refinement/fold_error.hpp"
#include "core/approximation/refinement/patch_grid_mesh.hpp"
#include "core/base/index_list.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// 35 degrees: largest turn of normals at the corners of a facet that a change may make
constexpr double most_normal_turn = 0.61;
constexpr int cycles = 6, sweeps_a_cycle = 3, flip_sweeps = 8;
/// Budget of facet errors at which the search ends in any case: about a minute.
constexpr std::size_t most_judgements = 12'000'000;
/// Approximate number of facet errors of the whole search per facet of the plain refinement.
constexpr std::size_t judgements_a_facet = 1200;
/// Factors of the tolerance. Decimation exceeds the tolerance on purpose, as the cuts of the repair are fewer
/// than the facets saved.
constexpr double beyond = 1.35, further = 0.1;  ///< in the first cycle, and the increase per cycle

MeshCriteria scaled(MeshCriteria criteria, double factor) {
  for (std::optional<double>* tolerance :
       {&criteria.distance, &criteria.normal_angle, &criteria.fold_angle, &criteria.luminance})
    if (*tolerance) **tolerance *= factor;
  return criteria;
}

class Optimiser {
 public:
  Optimiser(const SurfaceSampler& sampler, const MeshOptions& options, const CancelToken& cancel)
      : sampler_(sampler), options_(options), cancel_(cancel), errors_(sampler, options_.criteria) {}

  /// Removes vertices without any other change, for meshes that are too large to be searched.
  ParameterMesh thinned(ParameterMesh start) {
    most_facets_ = start.facets.size();
    take(start);
    decimate(1, true);
    return repair() ? mesh_ : start;
  }

  /// Smallest of `best`, which satisfies the criteria, and the meshes found from a start that need not.
  ParameterMesh run(ParameterMesh start, ParameterMesh best, const Progress& progress) {
    const auto keep_best = [&] {
      if (mesh_.facets.size() < best.facets.size()) best = mesh_;
    };
    // A larger mesh is of no use.
    most_facets_ = 2 * std::max(best.facets.size(), start.facets.size()) + 64;
    take(std::move(start));
    flips();
    decimate(0.6, false);
    relax(1, 0.2);
    flips();
    decimate(1, false);
    relax(2, 0.2);
    flips();
    if (!repair()) return best;
    keep_best();
    for (int cycle = 0; cycle < cycles && !over(); ++cycle) {
      progress.report((1.0 + cycle) / (1 + cycles));
      decimate(beyond + further * cycle, false);
      for (int sweep = 0; sweep < sweeps_a_cycle; ++sweep) {
        relax(2, 0.2);
        flips();
      }
      if (!repair()) return best;
      relax(2, 0.1);
      flips();
      if (!repair()) return best;
      decimate(1, true);
      if (!repair()) return best;
      keep_best();
    }
    return best;
  }

 private:
  void take(ParameterMesh mesh) {
    mesh_ = std::move(mesh);
    surgery_ = std::make_unique<MeshSurgery>(sampler_, mesh_);
    error_.resize(mesh_.facets.size());
    for (Index f = 0; f < mesh_.facets.size(); ++f) error_[f] = estimate(f);
  }
  bool over() const { return judgements_ > most_judgements || cancel_.cancelled(); }
  double estimate(Index facet) const {
    ++judgements_;
    double worst = errors_.sampled_error(mesh_, facet);
    if (options_.criteria.fold_angle) {
      const double crease = std::min(crease_angle, 0.5 * *options_.criteria.fold_angle);
      const double fold =
          std::max(errors_.normal_spread(mesh_, facet), facet_fold(sampler_, mesh_, facet, crease));
      worst = std::max(worst, fold / *options_.criteria.fold_angle);
    }
    if (options_.criteria.min_angle)
      worst = std::max(worst,
                       *options_.criteria.min_angle / std::max(smallest_angle(mesh_.corners(facet)), 1e-9));
    return worst;
  }

  struct Judged {
    double largest = 0, sum = 0;
  };
  /// Computes the errors of the facets of a change, into `fresh_`; stops above a limit.
  Judged judge(const MeshSurgery::Change& change, double limit) {
    Judged out;
    fresh_.clear();
    for (const Index f : change.facets) {
      fresh_.push_back(estimate(f));
      out.largest = std::max(out.largest, fresh_.back());
      out.sum += fresh_.back();
      if (out.largest > limit) break;
    }
    return out;
  }
  Judged before(const MeshSurgery::Change& change) const {
    Judged out;
    for (const Index f : change.facets) {
      out.largest = std::max(out.largest, error_[f]);
      out.sum += error_[f];
    }
    return out;
  }
  void keep(const MeshSurgery::Change& change) {
    surgery_->keep(change);
    for (std::size_t k = 0; k < change.facets.size(); ++k) error_[change.facets[k]] = fresh_[k];
  }
  bool turned_away(const MeshSurgery::Change& change) const {
    for (const Index f : change.facets) {
      const auto p = mesh_.corners(f);
      const Vector3 normal = facet_normal(p[0], p[1], p[2]);
      if (normal.isZero(0)) return true;
      std::array<Vector3, 3> at;
      sampler_.normals(mesh_.facets[f].patch, mesh_.facets[f].parameter, at);
      for (const Vector3& n : at)
        if (n.dot(normal) < std::cos(most_normal_turn)) return true;
    }
    return false;
  }

  void flips() {
    for (int sweep = 0; sweep < flip_sweeps && !over(); ++sweep) {
      bool changed = false;
      for (Index h = 0; h < mesh_.twin.size() && !over(); ++h) {
        if (!surgery_->alive(facet_of(h)) || mesh_.twin[h] == no_index || mesh_.twin[h] < h) continue;
        const double old = std::max(error_[facet_of(h)], error_[facet_of(mesh_.twin[h])]);
        if (!surgery_->flip(h, change_)) continue;
        if (judge(change_, old).largest < old * (1 - 1e-9) && !turned_away(change_)) {
          keep(change_);
          changed = true;
        } else {
          surgery_->undo(change_);
        }
      }
      if (!changed) return;
    }
  }

  /// Best collapse of a vertex, with the largest error that it leaves.
  std::pair<double, Index> best_collapse(Index vertex, double limit) {
    std::pair<double, Index> best{infinite, no_index};
    if (surgery_->freedom(vertex) == MeshSurgery::Freedom::fixed) return best;
    std::vector<Index> edges;
    surgery_->star(vertex, edges);
    // In an open star the last border edge only arrives; its collapse belongs to the other facet's side.
    const double most = limit;
    for (const Index h : edges) {
      if (!surgery_->collapse(h, change_)) continue;
      const double cost = judge(change_, std::min(most, best.first)).largest;
      const bool good = cost <= most && cost < best.first && !turned_away(change_);
      surgery_->undo(change_);
      if (good) best = {cost, h};
    }
    return best;
  }
  bool certain(const MeshSurgery::Change& change) const {
    return std::all_of(change.facets.begin(), change.facets.end(), [&](Index f) {
      ++judgements_;
      return errors_.relative_error(mesh_, f) <= 1;
    });
  }

  void decimate(double limit, bool certified) {
    struct Entry {
      double cost;
      Index vertex, half_edge;
      std::uint32_t version;
      bool operator<(const Entry& other) const {
        return cost > other.cost || (cost == other.cost && vertex > other.vertex);
      }
    };
    std::priority_queue<Entry> queue;
    std::vector<std::uint32_t> version(surgery_->vertex_count(), 0);
    const auto push = [&](Index v) {
      const auto [cost, h] = best_collapse(v, limit);
      if (h != no_index) queue.push({cost, v, h, version[v]});
    };
    for (Index v = 0; v < version.size() && !over(); ++v)
      if (surgery_->vertex_alive(v)) push(v);
    std::vector<Index> round;
    while (!queue.empty() && !over()) {
      const Entry top = queue.top();
      queue.pop();
      if (top.version != version[top.vertex] || !surgery_->vertex_alive(top.vertex)) continue;
      const Index target = mesh_.to(top.half_edge);
      if (!surgery_->collapse(top.half_edge, change_)) continue;
      if (judge(change_, limit).largest > limit || (certified && !certain(change_))) {
        surgery_->undo(change_);
        continue;
      }
      keep(change_);
      surgery_->star(target, round);
      std::vector<Index> touched{target};
      for (const Index h : round) {
        touched.push_back(mesh_.to(h));
        touched.push_back(mesh_.from(previous_of(h)));
      }
      sort_unique(touched);
      for (const Index v : touched) {
        ++version[v];
        push(v);
      }
    }
    take(surgery_->compacted());
  }

  /// Moves each vertex to a place where the largest error around it is smaller.
  void relax(int sweeps, double radius) {
    std::vector<Index> edges;
    for (int sweep = 0; sweep < sweeps && !over(); ++sweep)
      for (Index v = 0; v < surgery_->vertex_count() && !over(); ++v) {
        if (!surgery_->vertex_alive(v)) continue;
        const MeshSurgery::Freedom freedom = surgery_->freedom(v);
        if (freedom == MeshSurgery::Freedom::fixed) continue;
        surgery_->star(v, edges);
        if (freedom == MeshSurgery::Freedom::inside)
          relax_inside(v, edges, radius);
        else
          relax_border(edges, radius);
      }
  }
  void relax_inside(Index v, const std::vector<Index>& edges, double radius) {
    double size = 0;
    for (const Index h : edges) {
      const ParameterFacet& facet = mesh_.facets[facet_of(h)];
      size = std::max(size, (facet.arriving(next_of(h) % 3) - facet.parameter[h % 3]).norm());
    }
    for (const double step : {radius, 0.35 * radius})
      for (int way = 0; way < 8; ++way) {
        const double angle = way * 0.78539816339744831;
        if (surgery_->move(v, step * size * Vector2(std::cos(angle), std::sin(angle)), change_))
          keep_if_better();
      }
  }
  void relax_border(const std::vector<Index>& edges, double radius) {
    for (const Index h : edges) {
      if (!surgery_->is_border_edge(h)) continue;
      for (const double step : {radius, 0.35 * radius})
        for (const double sign : {1.0, -1.0})
          // Backwards runs along the other border edge, which continues this one in the domain.
          if (surgery_->slide(h, sign * step, change_)) keep_if_better();
    }
  }
  void keep_if_better() {
    const Judged old = before(change_);
    const double bar = old.largest + 0.001 * old.sum / double(change_.facets.size());
    const Judged now = judge(change_, bar);
    if (now.largest + 0.001 * now.sum / double(change_.facets.size()) < bar * (1 - 1e-9) &&
        !turned_away(change_))
      keep(change_);
    else
      surgery_->undo(change_);
  }

  /// Cuts facets above the tolerance, by certain bounds. False where that does not terminate: splitting by
  /// the square root of curvature makes needles, between which folds remain.
  bool repair() {
    MeshOptions options = options_;
    if (!options_.criteria.fold_angle) {
      options.split = SplitRule::curvature;
      options.propagation = Propagation::direct;
    }
    options.facet_limit = std::min(options_.facet_limit, most_facets_);
    ParameterMesh mesh = mesh_;
    const BisectionResult result = bisect(sampler_, errors_, options, mesh, cancel_);
    if (result.limit_reached || result.cancelled) return false;
    take(std::move(mesh));
    return true;
  }

  const SurfaceSampler& sampler_;
  MeshOptions options_;
  const CancelToken& cancel_;
  FacetErrors errors_;
  ParameterMesh mesh_;
  std::unique_ptr<MeshSurgery> surgery_;
  std::vector<double> error_, fresh_;
  MeshSurgery::Change change_;
  std::size_t most_facets_ = 0;
  mutable std::size_t judgements_ = 0;
};

MeshOptions start_options_of(MeshOptions options) {
  options.split = SplitRule::midpoint;
  return options;
}

/// Best uniform grid: the one with the fewest cells, fewer than `most` facets, whose facets are all good.
std::optional<ParameterMesh> best_grid(const SurfaceSampler& sampler, const MeshOptions& options,
                                       std::size_t most, const CancelToken& cancel) {
  const FacetErrors errors(sampler, options.criteria);
  std::optional<ParameterMesh> best;
  const auto grid = [&](int columns, int rows) {
    const PatchCells cells{columns, rows};
    return grid_mesh(sampler.surface(), {&cells, 1});
  };
  const auto good = [&](const ParameterMesh& mesh) {
    for (Index f = 0; f < mesh.facets.size(); ++f)
      if (errors.relative_error(mesh, f) > 1) return false;
    return true;
  };
  for (int columns = 1; 2 * std::size_t(columns) < most && !cancel.cancelled(); ++columns) {
    // Finer rows hardly ever hurt, so their number is found by bisection.
    int low = 0, high = int((most - 1) / (2 * std::size_t(columns)));
    if (high < 1 || !good(grid(columns, high))) continue;
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      (good(grid(columns, middle)) ? high : low) = middle;
    }
    best = grid(columns, high);
    most = best->facets.size();
  }
  return best;
}

}  // namespace

ParameterMesh optimised_mesh(const SurfaceSampler& sampler, const MeshOptions& options,
                             const CancelToken& cancel, const Progress& progress) {
  // Near poles and where many small patches meet, refinement alone may be better.
  ParameterMesh plain = initial_mesh(sampler.surface());
  MeshOptions start_options = start_options_of(options);
  bisect(sampler, FacetErrors(sampler, options.criteria), start_options, plain, cancel,
         progress.part(0, 0.05));
  Optimiser optimiser(sampler, options, cancel);
  if (plain.facets.size() > most_judgements / judgements_a_facet) return optimiser.thinned(std::move(plain));
  start_options.criteria = scaled(options.criteria, 0.5);
  ParameterMesh start = initial_mesh(sampler.surface());
  bisect(sampler, FacetErrors(sampler, start_options.criteria), start_options, start, cancel,
         progress.part(0.05, 0.1));
  ParameterMesh best = optimiser.run(std::move(start), std::move(plain), progress.part(0.1, 0.6));
  const Surface& surface = sampler.surface();
  if (surface.patch_count() != 1 || surface.domain() != Domain::square || cancel.cancelled()) return best;
  if (auto grid = best_grid(sampler, options, 3 * best.facets.size() / 2, cancel)) {
    best = optimiser.run(std::move(*grid), std::move(best), progress.part(0.6, 1));
  }
  return best;
}

}  // namespace hariko
