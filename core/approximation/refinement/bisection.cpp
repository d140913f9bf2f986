#include "core/approximation/refinement/bisection.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/approximation/refinement/facet_queue.hpp"
#include "core/approximation/refinement/fold_error.hpp"
#include "core/base/parallel.hpp"

namespace hariko {

namespace {

constexpr double shortest_edge = 2e-4;  ///< relative to the patch
constexpr int longest_path = 200, most_detours = 200, most_detours_of_halving = 3;
constexpr std::size_t largest_batch = 512, facets_per_task = 32;
/// Levels of fallback for the paper's rule: 0, the rule itself; 1, where it does not lower a facet's error,
/// the Gauss image; 2, the middle of the longest edge, which always terminates. `patience`: cuts in a row
/// before the next level.
constexpr std::uint8_t patience = 3, last_level = 2;
/// Number of facets above which the nets of good facets are released, as they take far more memory than the
/// facets.
constexpr std::size_t most_kept_nets = 100'000;
/// Ratio to the error before the cut, below which an error counts as lowered.
constexpr double lowered = 0.9;
constexpr int most_failures = 1;  ///< in one patch, before the paper's rule is given up in all of it

class Bisection {
 public:
  Bisection(const SurfaceSampler& sampler, const FacetErrors& errors, const MeshOptions& options,
            ParameterMesh& mesh)
      : sampler_(sampler),
        errors_(errors),
        options_(options),
        criteria_(options.criteria),
        mesh_(mesh),
        nets_(std::make_shared<FacetNets>(sampler)),
        crease_(criteria_.fold_angle ? std::min(crease_angle, 0.5 * *criteria_.fold_angle) : crease_angle) {}

  BisectionResult run(const CancelToken& cancel, const Progress& progress) {
    measure_patches();
    grow();
    for (Index h = 0; h < mesh_.twin.size(); ++h) set_split(h);
    for (Index f = 0; f < mesh_.facets.size(); ++f) {
      make_net(f);
      touch(f);
    }
    evaluate_touched();
    while (!queue_.empty() && !result_.limit_reached) {
      if (cancel.cancelled()) {
        result_.cancelled = true;
        break;
      }
      const std::size_t batch = std::clamp<std::size_t>(queue_.size() / 8, 1, largest_batch);
      for (std::size_t i = 0; i < batch && !queue_.empty(); ++i) {
        const FacetQueue::Entry top = queue_.pop();
        if (state_[top.facet].version == top.version) cut(top.facet);
      }
      evaluate_touched();
      const auto count = static_cast<double>(mesh_.facets.size());
      progress.report(count / (count + std::max(pending_, 0.0)));
    }
    if (!sampled_.empty()) give_all_nets_back();
    result_.nets = nets_;
    result_.distance_bounds = std::move(bounds_);
    result_.sampled_distances = std::move(sampled_);
    return result_;
  }

 private:
  struct State {
    double error = 0;
    double pending = 0;  ///< its share of pending_
    std::uint32_t version = 0;
    double least = 0;         ///< least error of the facet and those it was cut from
    std::uint8_t futile = 0;  ///< cuts in a row that did not lower it, plus `patience` for each level
    bool touched = false, cut = false;
  };

  void measure_patches() {
    const Surface& surface = sampler_.surface();
    const std::vector<Vector2> parameters = GridPattern{surface.domain(), 3}.parameters();
    std::vector<Vector3> points(parameters.size());
    shortest_.resize(surface.patch_count());
    failures_.assign(surface.patch_count(), 0);
    for (Index p = 0; p < surface.patch_count(); ++p) {
      sampler_.positions(p, parameters, points);
      Eigen::AlignedBox3d box;
      for (const Vector3& q : points) box.extend(q);
      shortest_[p] = shortest_edge * box.diagonal().norm();
    }
  }

  void grow() {
    state_.resize(mesh_.facets.size());
    split_.resize(mesh_.twin.size());
  }
  void make_net(Index facet) {
    if (criteria_.distance) nets_->make(mesh_, facet);
  }
  int level(Index facet) const {
    const int own = state_[facet].futile / patience;
    return std::max(own, failures_[mesh_.facets[facet].patch] > most_failures ? 1 : 0);
  }
  void set_split(Index h) {
    const Index other = mesh_.twin[h];
    SplitRule rule = options_.split;
    if (rule == SplitRule::halving) {
      constexpr std::array rules{SplitRule::halving, SplitRule::gauss, SplitRule::midpoint};
      const int highest = std::max(level(facet_of(h)), other == no_index ? 0 : level(facet_of(other)));
      rule = rules[std::size_t(highest)];
    }
    split_[h] = edge_split(sampler_, mesh_, h, rule);
    // Among angles as priorities, a length counts relative to its patch.
    if (rule != options_.split && rule == SplitRule::midpoint)
      split_[h].priority *= shortest_edge / shortest_[mesh_.canonical_line(h).patch];
    if (other != no_index) split_[other] = split_[h];
  }
  void forget(State& state) {
    pending_ -= state.pending;
    state.pending = 0;
  }
  void touch(Index facet) {
    if (state_[facet].touched) return;
    state_[facet].touched = true;
    touched_.push_back(facet);
  }

  /// Whether edge a is cut before edge b.
  bool before(Index a, Index b) const {
    if (split_[a].priority != split_[b].priority) return split_[a].priority > split_[b].priority;
    const auto ends = [&](Index h) {
      const Index from = mesh_.from(h), to = mesh_.to(h);
      return std::pair{std::max(from, to), std::min(from, to)};
    };
    return ends(a) > ends(b);
  }
  Index best_edge(Index facet) const {
    Index best = 3 * facet;
    for (Index h = 3 * facet + 1; h < 3 * facet + 3; ++h)
      if (before(h, best)) best = h;
    return best;
  }

  /// End of the longest-edge path: the edge to cut first when this facet's best edge is to be cut.
  Index end_of_path(Index edge) const {
    for (int step = 0; step < longest_path; ++step) {
      const Index other = mesh_.twin[edge];
      if (other == no_index) break;
      const Index best = best_edge(facet_of(other));
      if (!(split_[best].priority > split_[edge].priority)) break;
      edge = best;
    }
    return edge;
  }

  /// Cuts edges until one of this facet's is cut. With priorities other than lengths the path may not end:
  /// then the facet's own edge is cut without regard to the neighbours.
  void cut(Index facet) {
    const std::uint32_t version = state_[facet].version;
    const int asked = options_.propagation == Propagation::direct ? 0
                      : options_.split == SplitRule::halving      ? most_detours_of_halving
                                                                  : most_detours;
    for (int round = 0; state_[facet].version == version; ++round) {
      if (options_.split == SplitRule::halving && round == asked && round > 0 && level(facet) == 0)
        give_up(facet);
      const Index own = best_edge(facet);
      const Index edge = round < asked ? end_of_path(own) : own;
      if (split_[edge].priority < 0 || mesh_.length(edge) <= shortest_[mesh_.facets[facet_of(edge)].patch]) {
        if (options_.split == SplitRule::halving && level(facet) < last_level) {
          give_up(facet);
          continue;
        }
        ++result_.unreached;
        return;
      }
      if (mesh_.facets.size() + 2 > options_.facet_limit) {
        result_.limit_reached = true;
        return;
      }
      split_edge(edge);
    }
  }
  /// Raises a facet to the next level: its edges and those made of them follow the next rule; after a few
  /// facets at which the paper's rule failed, all facets of the patch follow the Gauss image.
  void give_up(Index facet) {
    std::uint8_t& futile = state_[facet].futile;
    futile = std::uint8_t((futile / patience + 1) * patience);
    const Index patch = mesh_.facets[facet].patch;
    if (futile > patience || ++failures_[patch] <= most_failures) {
      for (Index h = 3 * facet; h < 3 * facet + 3; ++h) set_split(h);
    } else if (failures_[patch] == most_failures + 1) {
      for (Index h = 0; h < mesh_.twin.size(); ++h)
        if (mesh_.facets[facet_of(h)].patch == patch) set_split(h);
    }
  }

  void split_edge(Index edge) {
    const Index other = mesh_.twin[edge];
    const ParameterLine line = mesh_.canonical_line(edge);
    const double t = split_[edge].parameter;
    // A cut facet's second side moves to the new facet, with its split.
    const EdgeSplit moved[2] = {split_[next_of(edge)],
                                other == no_index ? EdgeSplit{} : split_[next_of(other)]};
    const Vector2 at = line.at(t);
    Vector3 position;
    sampler_.positions(line.patch, {&at, 1}, {&position, 1});
    const Index sides[2] = {edge, other};
    double fraction[2] = {};
    for (int k = 0; k < 2 && sides[k] != no_index; ++k) {
      fraction[k] = mesh_.from(sides[k]) < mesh_.to(sides[k]) ? t : 1 - t;
      make_net(facet_of(sides[k]));
    }
    const ParameterMesh::Split made = mesh_.split(edge, t, position);
    grow();
    for (int k = 0; k < made.count; k += 2) {
      const Index f = made.facets[std::size_t(k)], g = made.facets[std::size_t(k + 1)];
      nets_->split(mesh_, f, g, int(sides[k / 2] % 3), fraction[k / 2]);
      // At poles the halves may have nets although the whole had none.
      make_net(f);
      make_net(g);
      split_[3 * g + next_of(k == 0 ? edge : other) % 3] = moved[k / 2];
      State& old = state_[f];
      forget(old);
      ++old.version;
      old.cut = true;
      state_[g] = State{.error = old.error, .least = old.least, .futile = old.futile, .cut = true};
      touch(f);
      touch(g);
    }
    for (int k = 0; k < made.edge_count; ++k) set_split(made.edges[std::size_t(k)]);
    // Folds change across the sides of the cut facets.
    if (!criteria_.fold_angle) return;
    for (int k = 0; k < made.count; ++k)
      for (Index h = 3 * made.facets[std::size_t(k)]; h < 3 * made.facets[std::size_t(k)] + 3; ++h)
        if (mesh_.twin[h] != no_index) touch_neighbour(facet_of(mesh_.twin[h]));
  }
  void touch_neighbour(Index facet) {
    if (state_[facet].touched) return;
    forget(state_[facet]);
    ++state_[facet].version;
    touch(facet);
  }

  double error_of(Index facet) {
    const double worst =
        errors_.relative_error(mesh_, facet, nets_->of(mesh_.facets[facet].patch, facet), &bounds_[facet]);
    if (!criteria_.fold_angle || worst > 1 || mesh_.facets[facet].degenerate()) return worst;
    const Index edge = best_edge(facet);
    const ParameterLine line = mesh_.canonical_line(edge);
    const Vector2 at = line.at(split_[edge].parameter);
    Vector3 m;
    sampler_.positions(line.patch, {&at, 1}, {&m, 1});
    double fold = facet_fold(sampler_, mesh_, facet, crease_);
    if (!is_crease(sampler_, mesh_, edge, crease_)) fold = std::max(fold, virtual_fold(mesh_, edge, m));
    // Without this test a midpoint that happens to lie in the facet's plane would end the refinement.
    fold = std::max(fold, errors_.normal_spread(mesh_, facet));
    return std::max(worst, fold / *criteria_.fold_angle);
  }

  /// Position along a space-filling curve (Morton order), patch by patch.
  std::uint64_t place_of(Index facet) const {
    const ParameterFacet& at = mesh_.facets[facet];
    const Vector2 centre = (at.parameter[0] + at.parameter[1] + at.parameter[2]) / 3;
    std::uint64_t place = at.patch;
    for (int bit = 15; bit >= 0; --bit)
      for (const double x : {centre.x(), centre.y()})
        place = 2 * place + ((std::uint32_t(std::clamp(x, 0.0, 1.0) * 65535) >> bit) & 1U);
    return place;
  }

  /// Records the data that the report needs of a net before its release.
  void note_sampled(Index facet) {
    if (options_.report == MeshReport::none) return;
    if (const FacetNet net = nets_->of(mesh_.facets[facet].patch, facet); net.shape)
      sampled_[facet] = float(errors_.net_sampled(mesh_, facet, net));
  }
  void give_all_nets_back() {
    sampled_.resize(mesh_.facets.size(), not_sampled);
    parallel_for(mesh_.facets.size(), facets_per_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) note_sampled(Index(f));
    });
    nets_ = std::make_shared<FacetNets>(sampler_);
  }

  void evaluate_touched() {
    const bool gives_nets_back = criteria_.distance && mesh_.facets.size() > most_kept_nets;
    fresh_.resize(touched_.size());
    bounds_.resize(mesh_.facets.size());
    if (gives_nets_back) sampled_.resize(mesh_.facets.size(), not_sampled);
    parallel_for(touched_.size(), facets_per_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        fresh_[i] = error_of(touched_[i]);
        if (gives_nets_back && !(fresh_[i] > 1)) note_sampled(touched_[i]);
      }
    });
    for (std::size_t i = 0; i < touched_.size(); ++i) {
      const Index facet = touched_[i];
      State& state = state_[facet];
      state.touched = false;
      if (options_.split == SplitRule::halving) take_stock(facet, fresh_[i]);
      state.error = fresh_[i];
      if (!(state.error > 1)) {
        if (gives_nets_back) nets_->release(facet);
        continue;
      }
      state.pending = std::min(state.error, most_pending);
      pending_ += state.pending;
      queue_.push({state.error, facet, state.version});
    }
    touched_.clear();
  }
  /// Counts the facet's cuts that did not lower its error, and raises its level when there are too many.
  void take_stock(Index facet, double error) {
    State& state = state_[facet];
    const int own = state.futile / patience;
    if (state.version == 0 && !state.cut) {
      state.least = error;
    } else if (error < lowered * state.least) {
      state.least = error;
      state.futile = std::uint8_t(own * patience);
    } else if (state.cut && error > 1 && own < last_level) {
      if (state.futile % patience + 1 < patience)
        ++state.futile;
      else
        give_up(facet);
    }
    state.cut = false;
  }

  static constexpr double most_pending = 1e4;
  static constexpr float not_sampled = -1;

  const SurfaceSampler& sampler_;
  const FacetErrors& errors_;
  const MeshOptions& options_;
  const MeshCriteria& criteria_;
  ParameterMesh& mesh_;
  std::shared_ptr<FacetNets> nets_;
  double crease_;
  std::vector<double> shortest_;  ///< per patch
  std::vector<int> failures_;     ///< per patch: number of facets at which halving was given up
  std::vector<State> state_;      ///< per facet
  std::vector<EdgeSplit> split_;  ///< per half-edge
  FacetQueue queue_{[this](Index facet) { return place_of(facet); }};
  std::vector<Index> touched_;
  std::vector<double> fresh_, bounds_;
  std::vector<float> sampled_;  ///< per facet; empty while all nets are kept
  double pending_ = 0;          ///< Estimate of the number of facets that those in the queue will become.
  BisectionResult result_;
};

}  // namespace

BisectionResult bisect(const SurfaceSampler& sampler, const FacetErrors& errors, const MeshOptions& options,
                       ParameterMesh& mesh, const CancelToken& cancel, const Progress& progress) {
  return Bisection(sampler, errors, options, mesh).run(cancel, progress);
}

}  // namespace hariko
