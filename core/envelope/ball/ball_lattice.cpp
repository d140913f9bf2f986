#include "core/envelope/ball/ball_lattice.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>

#include "core/base/parallel.hpp"

namespace hariko {

namespace {

/// Range, in sigma, in which values are needed: farther from the surface the kernel has no weight that
/// matters.
constexpr double deepest = -2.8, highest = 3.2;
constexpr double margin = 5.5;       ///< width in sigma of the free space around the solids
constexpr double accuracy = 1e-3;    ///< accuracy of distances, in sigma
constexpr double noticeable = 1e-2;  ///< in sigma: a neighbour's centre that is better by this much is tried

/// Factors of the ball's radius. A single ball stops fitting between parallel walls at once and leaves the
/// whole slot; the mean of five values takes five smaller steps. The one in the middle is the ball itself.
constexpr std::array<double, 5> slot_factors{0.75, 0.87, 1, 1.15, 1.33};
constexpr std::size_t usual_ball = 2;

/// Fraction of the smaller radius: a ball that is this far from all other solids lies between its own solids
/// alone.
constexpr double own_reach = 0.5;

/// Balls of the request: five for slots, then those between certain solids.
std::vector<Closing> balls_of(const LatticeRequest& request) {
  std::vector<Closing> out;
  for (const double factor : slot_factors)
    out.emplace_back(request.solids, factor * request.radius, accuracy * request.sigma);
  for (const OwnBall& own : request.own_balls)
    out.emplace_back(request.solids, own.radius, accuracy * request.sigma);
  return out;
}

/// Values of balls between certain solids, and their weights at a node.
struct OwnValues {
  std::vector<double> sum, shares;
};

class Lattice {
 public:
  Lattice(const LatticeRequest& request, const CancelToken& cancel, ClosingMemory* memory)
      : request_(request),
        cancel_(cancel),
        memory_(request.own_balls.empty() ? memory : nullptr),
        spacing_(lattice_spacing(request.sigma, request.passes)),
        balls_(balls_of(request)),
        nodes_(memory_ ? memory_->nodes() : own_nodes_) {
    const Eigen::AlignedBox3d box = pulled_box(request.solids, request.pulls, request.sigma);
    for (Eigen::Index a = 0; a < 3; ++a) {
      double low = box.min()[a] + request.origin[a], high = box.max()[a] + request.origin[a];
      if (request.mirror == a) high = std::max(high, -low), low = -high;
      // Every second node from the ends belongs to the coarse lattice; every fourth one is tested for slots.
      low_[a] = slot_step * std::floor((low - margin * request.sigma) / spacing_ / slot_step);
      const double last = slot_step * std::ceil((high + margin * request.sigma) / spacing_ / slot_step);
      size_[std::size_t(a)] = int(last - low_[a]) + 1;
    }
    if (memory_)
      memory_->begin(request.solids, {request.radius, request.sigma, spacing_, request.origin, low_, size_});
    else
      nodes_.resize(node_count(size_));
    state_.assign(nodes_.size(), State::open);
  }

  SplineField make(LatticeReport& report) {
    visit(4, [&](std::size_t at, const std::array<int, 3>& n) {
      if (!take_first(at)) evaluate_first(at, n);
    });
    visit(2, [&](std::size_t at, const std::array<int, 3>& n) {
      if (state_[at] == State::open) evaluate_second(at, n);
    });
    improve(2, memory_);
    find_pulled();
    find_slots();
    look_at_own_balls();
    if (memory_) memory_->find_steady_cells(slots_.empty() && request_.pulls.empty());
    visit(1, [&](std::size_t at, const std::array<int, 3>& n) {
      if (state_[at] == State::open) refine(at, n);
    });
    improve(1, memory_);
    if (memory_ && !cancel_.cancelled()) memory_->end();
    std::vector<double> values(nodes_.size());
    parallel_for(values.size(), 8192, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) values[i] = nodes_[i].value;
    });
    report = counted();
    const OwnValues own = own_values();
    if (!slots_.empty()) average_slots(values);
    for (std::size_t i = 0; i < own.sum.size(); ++i)
      values[i] += (own.sum[i] - own.shares[i] * values[i]) / std::max(1.0, own.shares[i]);
    if (!request_.pulls.empty()) pull(values);
    // Both values of a node and its image are safe.
    if (request_.mirror) even_lattice(size_, std::size_t(*request_.mirror), values);
    return smoothed(std::move(values));
  }

 private:
  enum class State : char { open, known, between };

  std::size_t index(const std::array<int, 3>& n) const { return node_index(size_, n[0], n[1], n[2]); }
  Vector3 point(const std::array<int, 3>& n) const {
    return spacing_ * (low_ + Vector3(n[0], n[1], n[2])) - request_.origin;
  }

  std::size_t slices(int step) const { return std::size_t((size_[2] - 1) / step + 1); }

  /// Visits every `step`th node, slices in parallel.
  template <class Each>
  void visit(int step, const Each& each) const {
    parallel_for(slices(step), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t slice = begin; slice < end && !cancel_.cancelled(); ++slice)
        for (int j = 0; j < size_[1]; j += step)
          for (int i = 0; i < size_[0]; i += step) {
            const std::array<int, 3> n{i, j, int(slice) * step};
            each(index(n), n);
          }
    });
  }

  LatticeReport counted() const {
    LatticeReport out;
    out.nodes = nodes_.size();
    out.evaluated = std::size_t(std::ranges::count(state_, State::known));
    out.crease = creases_;
    out.searched = memory_ ? memory_->searched() : out.evaluated;
    return out;
  }

  /// Evaluates a node for another ball than the usual one, whose centre leads to that of the other.
  void evaluate(std::size_t at, const std::array<int, 3>& n, const ClosedDistance& usual) {
    const Closing& ball = balls_[ball_];
    const Vector3 x = point(n), start = x + ball.radius() / request_.radius * (usual.centre - x);
    nodes_[at] = ball.at(x, &start, nullptr, true);
    state_[at] = State::known;
  }

  /// Evaluates a node for the first time.
  void evaluate_first(std::size_t at, const std::array<int, 3>& n, const Vector3* start = nullptr,
                      bool thorough = false) {
    ClosingReach reach;
    const ClosedDistance found = balls_[ball_].at(point(n), start, memory_ ? &reach : nullptr, thorough);
    if (memory_) memory_->set_first(at, found, reach);
    nodes_[at] = found;
    state_[at] = State::known;
  }

  /// Takes a node's first value from the frame before; false where it may be another one. Where there is a
  /// start, it must be that of the frame before.
  bool take_first(std::size_t at) {
    if (!memory_ || !memory_->take_first(at)) return false;
    state_[at] = State::known;
    return true;
  }

  /// Numbers of the eight nodes around a node in the lattice of every `step`th; they need not be different.
  /// Their order is that of the corners of a cell. `step` is a power of two.
  std::array<std::size_t, 8> around(std::size_t at, const std::array<int, 3>& n, int step) const {
    std::array<std::size_t, 8> out;
    out.fill(at);
    std::size_t stride = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      const int past = n[a] & (step - 1);
      const std::size_t back = std::size_t(past) * stride,
                        on = past > 0 ? std::size_t(step) * stride - back : 0;
      for (std::size_t c = 0; c < 8; ++c) out[c] += c >> a & 1 ? on : -back;
      stride *= std::size_t(size_[a]);
    }
    return out;
  }

  /// Estimate of the value at x from another node's centre: the room for the ball there less the way to it.
  double value_from(const ClosedDistance& beside, const Vector3& x) const {
    return std::max(balls_[ball_].radius(), beside.value) - (beside.centre - x).norm();
  }

  /// Finds every second node that is not one of every fourth, from those around it.
  void evaluate_second(std::size_t at, const std::array<int, 3>& n) {
    const std::array<std::size_t, 8> coarse = around(at, n, 4);
    const bool steady =
        memory_ && std::ranges::none_of(coarse, [&](std::size_t m) { return memory_->is_changed(m); });
    if (!(steady && take_first(at))) evaluate_first(at, n, nearest_centre(point(n), coarse), true);
  }

  /// Finds a node from those around it in the lattice of every second one.
  void refine(std::size_t at, const std::array<int, 3>& n) {
    const bool steady = memory_ && memory_->is_steady(n), known_band = steady && memory_->is_plain();
    if (known_band && memory_->has_mean(at)) {
      state_[at] = State::between;  // its value is there
      return;
    }
    const std::array<std::size_t, 8> coarse = around(at, n, 2);
    if (const auto mean = known_band ? std::nullopt : mean_outside_band(at, n, coarse)) {
      nodes_[at].value = *mean;
      state_[at] = State::between;
      if (memory_) memory_->set_mean(at);
      return;
    }
    if (steady && take_first(at)) return;
    evaluate_first(at, n, nearest_centre(point(n), coarse));
  }

  /// Mean of the coarse nodes around a node where these, which bound its value, exclude that it is needed.
  std::optional<double> mean_outside_band(std::size_t at, const std::array<int, 3>& n,
                                          const std::array<std::size_t, 8>& coarse) const {
    double sum = 0, least = 1e300, most = -1e300;
    for (const std::size_t m : coarse) {
      const double value = nodes_[m].value;
      sum += value / 8;
      most = std::max(most, least_.empty() ? value : least_[m]);
      least = std::min(least, most_.empty() ? value : most_[m]);
    }
    const bool in_slot = !slots_.empty() && slots_[at] > 0;
    const double way = spacing_ * std::sqrt(double((n[0] & 1) + (n[1] & 1) + (n[2] & 1)));
    const auto [inwards, outwards] = pulled_by(n);
    if (in_slot || (least + way + inwards > deepest * request_.sigma &&
                    most - way - outwards < highest * request_.sigma))
      return {};
    return sum;
  }

  /// Best centre for a place among those of coarse nodes around it.
  const Vector3* nearest_centre(const Vector3& x, const std::array<std::size_t, 8>& coarse) const {
    double best = -1e300;
    const Vector3* out = nullptr;
    for (const std::size_t m : coarse)
      if (const double value = value_from(nodes_[m], x); value > best) best = value, out = &nodes_[m].centre;
    return out;
  }

  /// Tries the centres of neighbours, because a search may end in a centre that is not the nearest one.
  /// `memory`, if not null: keeps the trials, and has those of the frame before.
  void improve(int step, ClosingMemory* memory = nullptr) {
    std::vector<std::array<int, 3>> creases = crease_nodes(step);
    creases_ = creases.size();
    worth_trying_.assign(nodes_.size(), 1);
    for (const bool forward : {true, false}) {
      if (cancel_.cancelled()) return;
      ClosingMemory::Sweep* const sweep = memory ? &memory->trials(step == 1, forward) : nullptr;
      for (const std::array<int, 3>& n : creases)
        if (sweep)
          improve_kept(index(n), n, step, *sweep);
        else
          improve_node(index(n), n, step);
      std::ranges::reverse(creases);
    }
  }

  /// Every `step`th node whose value one solid alone does not determine, in order. Sweeps change no node's
  /// kind.
  std::vector<std::array<int, 3>> crease_nodes(int step) const {
    std::vector<std::vector<std::array<int, 3>>> of_slice(slices(step));
    visit(step, [&](std::size_t at, const std::array<int, 3>& n) {
      if (state_[at] == State::known && nodes_[at].crease) of_slice[std::size_t(n[2] / step)].push_back(n);
    });
    std::vector<std::array<int, 3>> out;
    for (const auto& some : of_slice) out.insert(out.end(), some.begin(), some.end());
    return out;
  }

  /// Improves a node where what the frame before found does not hold.
  void improve_kept(std::size_t at, const std::array<int, 3>& n, int step, ClosingMemory::Sweep& sweep) {
    const ClosingMemory::Trial* before = sweep.before(at);
    const bool same_value = !memory_->is_changed(at);
    if (worth_trying_[at] && same_value && !memory_->is_changed_about(n, step) &&
        (!before || memory_->holds(before->reach))) {
      worth_trying_[at] = 0;
      if (!before) return;
      put(at, n, step, before->result);
      sweep.add(*before);
      return;
    }
    const ClosedDistance wanted = before ? before->result : nodes_[at];
    ClosingReach reach;
    if (improve_node(at, n, step, &reach)) sweep.add({at, nodes_[at], reach});
    if (same_value) memory_->set_changed(at, !equal_bits(nodes_[at], wanted));
  }

  /// Calls each(number) for a node and those about it in the lattice of every `step`th.
  template <class Each>
  void for_all_about(const std::array<int, 3>& n, int step, const Each& each) const {
    for (int k = std::max(n[2] - step, 0); k <= std::min(n[2] + step, size_[2] - 1); k += step)
      for (int j = std::max(n[1] - step, 0); j <= std::min(n[1] + step, size_[1] - 1); j += step)
        for (int i = std::max(n[0] - step, 0); i <= std::min(n[0] + step, size_[0] - 1); i += step)
          each(node_index(size_, i, j, k));
  }

  /// Replaces a node's value in a sweep; where it is another one, it is worth trying there, and at the
  /// neighbours.
  void put(std::size_t at, const std::array<int, 3>& n, int step, const ClosedDistance& value) {
    if (equal_bits(nodes_[at], value)) return;
    nodes_[at] = value;
    for_all_about(n, step, [&](std::size_t other) { worth_trying_[other] = 1; });
  }

  /// Tries the best centre of a node's neighbours, if any of these changed since it was tried; false if none
  /// is better. `reach`: see `Closing`.
  bool improve_node(std::size_t at, const std::array<int, 3>& n, int step, ClosingReach* reach = nullptr) {
    if (!worth_trying_[at]) return false;
    worth_trying_[at] = 0;
    const Vector3 x = point(n);
    double best = nodes_[at].value + noticeable * request_.sigma;
    const Vector3* start = nullptr;
    for_all_about(n, step, [&](std::size_t other) {
      if (state_[other] != State::known || other == at) return;
      // The squared way alone excludes most neighbours.
      const ClosedDistance& beside = nodes_[other];
      const double left = std::max(balls_[ball_].radius(), beside.value) - best;
      if (left < 0 || (beside.centre - x).squaredNorm() >= left * left) return;
      best = value_from(beside, x);
      start = &beside.centre;
    });
    if (start) put(at, n, step, balls_[ball_].improved(x, nodes_[at], *start, reach));
    return start != nullptr;
  }

  /// Finds how far nodes lie in a slot, from 0 to 1, tested at every fourth one.
  void find_slots() {
    if (no_slot * request_.radius > request_.solids.box().diagonal().norm()) {
      if (memory_) memory_->forget_slots();
      return;
    }
    if (memory_) memory_->begin_slots();
    std::vector<double> asked(nodes_.size(), 0);
    std::atomic<bool> any = false;
    visit(slot_step, [&](std::size_t at, const std::array<int, 3>& n) {
      SlotTest own;
      SlotTest& test = memory_ ? memory_->slot_test(n) : own;
      if (!memory_ || memory_->is_changed(at) || !memory_->holds(test))
        test =
            slot_test(balls_.front(), balls_[slot_factors.size() - 1], request_.radius, point(n), nodes_[at]);
      asked[at] = test.share;
      if (test.share > 0) any = true;
    });
    if (!any) return;
    slots_.assign(nodes_.size(), 0);
    visit(1, [&](std::size_t at, const std::array<int, 3>& n) {
      const std::array<std::size_t, 8> tested = around(at, n, slot_step);
      for (std::size_t c = 0; c < 8; ++c) {
        double weight = 1;
        for (std::size_t a = 0; a < 3; ++a) {
          const double along = n[a] % slot_step / double(slot_step);
          weight *= c >> a & 1 ? along : 1 - along;
        }
        slots_[at] += weight * asked[tested[c]];
      }
    });
  }

  /// Moves values towards the mean over all five balls, weighted by how far a node lies in a slot. No value
  /// becomes larger than the solids' distances, because none of the five is.
  void average_slots(std::vector<double>& values) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) state_[i] = slots_[i] > 0 ? State::known : State::between;
    const std::vector<double> own = values;
    const std::vector<ClosedDistance> usual = nodes_;
    for (ball_ = 0; ball_ < slot_factors.size(); ++ball_) {
      if (ball_ == usual_ball) continue;
      visit(1, [&](std::size_t at, const std::array<int, 3>& n) {
        if (slots_[at] > 0) evaluate(at, n, usual[at]);
      });
      improve(1);
      for (std::size_t i = 0; i < values.size(); ++i)
        if (slots_[i] > 0) values[i] += slots_[i] / double(slot_factors.size()) * (nodes_[i].value - own[i]);
    }
    nodes_ = usual;
  }

  /// Finds the range of all balls' values at every second node; the result at the nodes between is a mean of
  /// them.
  void look_at_own_balls() {
    if (request_.own_balls.empty()) return;
    const std::vector<ClosedDistance> usual = nodes_;
    for (const ClosedDistance& node : usual) least_.push_back(node.value), most_.push_back(node.value);
    for (ball_ = slot_factors.size(); ball_ < balls_.size(); ++ball_) {
      visit(2, [&](std::size_t at, const std::array<int, 3>& n) { evaluate(at, n, usual[at]); });
      improve(2);
      for (std::size_t i = 0; i < usual.size(); ++i) {
        least_[i] = std::min(least_[i], nodes_[i].value);
        most_[i] = std::max(most_[i], nodes_[i].value);
      }
    }
    ball_ = usual_ball;
    nodes_ = usual;
  }

  /// Weight of an own ball at a node, from 0 to 1: depends on the distance of the larger of both balls, which
  /// touches several solids there, from all other solids. Where it touches only one solid, both balls have
  /// the same value.
  double share_of(const OwnBall& own, const ClosedDistance& larger) const {
    if (!larger.crease) return 0;
    const double reach = own_reach * std::min(own.radius, request_.radius);
    double gap = reach;
    const double radius = std::max(own.radius, request_.radius);
    for (Index i = 0; i < request_.solids.size(); ++i)
      if (!own.between[i] && request_.solids.bound(i, larger.centre) - radius < gap)
        gap = std::min(gap, request_.solids.distance(i, larger.centre) - radius);
    const double t = std::clamp(gap / reach, 0.0, 1.0);
    return t * t * (3 - 2 * t);
  }

  /// Weighted sums of the values of own balls. A mean of several balls' values, none of which is larger than
  /// the solids' distances, is not larger either.
  OwnValues own_values() {
    OwnValues out;
    if (request_.own_balls.empty()) return out;
    out.sum.assign(nodes_.size(), 0);
    out.shares.assign(nodes_.size(), 0);
    const std::vector<ClosedDistance> usual = nodes_;
    const std::vector<State> known = state_;
    std::vector<double> shares(nodes_.size());
    for (std::size_t k = 0; k < request_.own_balls.size(); ++k) {
      const OwnBall& own = request_.own_balls[k];
      const bool larger = own.radius > request_.radius;
      ball_ = slot_factors.size() + k;
      state_ = known;
      const auto find_shares = [&](const std::vector<ClosedDistance>& nodes) {
        for (std::size_t i = 0; i < nodes.size(); ++i)
          shares[i] = known[i] == State::known ? share_of(own, nodes[i]) : 0;
      };
      if (!larger) {
        find_shares(usual);
        for (std::size_t i = 0; i < shares.size(); ++i)
          if (!(shares[i] > 0)) state_[i] = State::between;
      }
      visit(1, [&](std::size_t at, const std::array<int, 3>& n) {
        if (state_[at] == State::known) evaluate(at, n, usual[at]);
      });
      improve(1);
      if (larger) find_shares(nodes_);
      for (std::size_t i = 0; i < shares.size(); ++i) {
        out.sum[i] += shares[i] * nodes_[i].value;
        out.shares[i] += shares[i];
      }
    }
    ball_ = usual_ball;
    return out;
  }

  SplineField smoothed(std::vector<double> values) const {
    for (int pass = 0; pass < request_.passes; ++pass) smooth_lattice(size_, values);
    return SplineField(point({0, 0, 0}), spacing_, size_, std::move(values));
  }

  /// Finds how far pulls move the surface, from the values at every second node.
  void find_pulled() {
    for (const PulledPlace& pull : request_.pulls) {
      const Vector3 at = (pull.at + request_.origin) / spacing_ - low_;
      std::array<int, 3> n;
      for (std::size_t a = 0; a < 3; ++a) n[a] = 2 * int(std::round(0.5 * at[Eigen::Index(a)]));
      const double value = nodes_[index(n)].value;
      ways_.push_back(value + std::copysign(2 * spacing_, value));
    }
  }

  /// Largest changes of a node's value by pulls, inwards and outwards.
  std::pair<double, double> pulled_by(const std::array<int, 3>& n) const {
    double inwards = 0, outwards = 0;
    for (std::size_t k = 0; k < ways_.size(); ++k) {
      const PulledPlace& pull = request_.pulls[k];
      double& most = ways_[k] < 0 ? inwards : outwards;
      most = std::max(most, pull_bound(ways_[k], pull_reach(pull.radius, ways_[k], request_.sigma),
                                       (point(n) - pull.at).norm()));
    }
    return {inwards, outwards};
  }

  /// Moves the surface to the pulled places. Values become no larger than the solids' distances.
  void pull(std::vector<double>& values) {
    const std::vector<double> offsets =
        pull_offsets(smoothed(values), request_.passes, request_.pulls, request_.sigma);
    visit(1, [&](std::size_t at, const std::array<int, 3>& n) {
      values[at] -= offsets[at];
      if (offsets[at] < 0) values[at] = std::min(values[at], request_.solids.nearest(point(n)).distance);
    });
  }

  const LatticeRequest& request_;
  const CancelToken& cancel_;
  ClosingMemory* memory_;  ///< null: nothing is kept
  double spacing_;
  std::vector<Closing> balls_;
  std::size_t ball_ = usual_ball;  ///< the ball being rolled
  Vector3 low_;                    ///< position of the first node, in spacings from the object's origin
  std::array<int, 3> size_{};
  std::vector<ClosedDistance> own_nodes_;
  std::vector<ClosedDistance>& nodes_;  ///< the memory's, or our own where nothing is kept
  std::vector<State> state_;
  std::size_t creases_ = 0;  ///< number of crease nodes at the last sweep
  /// Per node: whether its value, or a neighbour's, changed since the sweeps tried it last.
  std::vector<char> worth_trying_;
  /// Range of all balls' values at coarse nodes; empty if there is only one ball.
  std::vector<double> least_, most_;
  std::vector<double> slots_;  ///< depth of nodes in a slot; empty without slots
  std::vector<double> ways_;   ///< shifts by pulls, negative inwards, from the nodes nearest to them
};

}  // namespace

double lattice_spacing(double sigma, int passes) {
  return sigma / std::sqrt(0.5 * passes + 1.0 / 3);
}

SplineField smoothed_closing(const LatticeRequest& request, LatticeReport& report, const CancelToken& cancel,
                             ClosingMemory* memory) {
  return Lattice(request, cancel, memory).make(report);
}

}  // namespace hariko
