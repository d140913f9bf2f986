#include "core/envelope/ball/closing_memory.hpp"

namespace hariko {

namespace {

/// Distance in sigma by which a solid must be out of a result's reach: more than distances, and sums of ways
/// between places, are off by rounding.
constexpr double reach_margin = 1e-4;
/// Largest shift of a lattice's box, in nodes, over which results are kept.
constexpr double farthest_shift = 1e6;

/// Numbers of every `step`th node along the axes.
std::array<int, 3> nodes_at_steps(const std::array<int, 3>& size, int step) {
  return {(size[0] - 1) / step + 1, (size[1] - 1) / step + 1, (size[2] - 1) / step + 1};
}

/// Values at the nodes of another box, with default values at nodes that are new. `shift`: from a node's
/// place in the old box to that in the new one.
template <class Value>
std::vector<Value> in_other_box(const std::vector<Value>& from, const std::array<int, 3>& old_size,
                                const std::array<int, 3>& size, const std::array<int, 3>& shift) {
  std::vector<Value> out(node_count(size));
  std::array<int, 3> first, last;
  for (std::size_t a = 0; a < 3; ++a) {
    first[a] = std::max(0, -shift[a]);
    last[a] = std::min(old_size[a], size[a] - shift[a]);
  }
  if (first[0] >= last[0]) return out;
  for (int k = first[2]; k < last[2]; ++k)
    for (int j = first[1]; j < last[1]; ++j)
      std::copy_n(from.data() + node_index(old_size, first[0], j, k), last[0] - first[0],
                  out.data() + node_index(size, first[0] + shift[0], j + shift[1], k + shift[2]));
  return out;
}

}  // namespace

const ClosingMemory::Trial* ClosingMemory::Sweep::before(std::size_t node) {
  const auto is_earlier = [&](std::size_t other) { return forward_ ? other < node : other > node; };
  while (next_ < before_.size() && is_earlier(before_[next_].node)) ++next_;
  return next_ < before_.size() && before_[next_].node == node ? &before_[next_] : nullptr;
}

bool ClosingMemory::goes_on_from_before(const GrownUnion& solids, const ClosingFrame& frame) const {
  if (!ended_ || before_->size() != solids.size() || frame.radius != frame_.radius ||
      frame.sigma != frame_.sigma || frame.spacing != frame_.spacing ||
      !equal_bits(frame.origin, frame_.origin))
    return false;
  return (frame.low - frame_.low).cwiseAbs().maxCoeff() <= farthest_shift;
}

void ClosingMemory::begin(const GrownUnion& solids, const ClosingFrame& frame) {
  moved_.clear();
  for (Sweep& sweep : sweeps_) {
    std::swap(sweep.before_, sweep.now_);
    sweep.now_.clear();
    sweep.next_ = 0;
    sweep.forward_ = (&sweep - sweeps_.data()) % 2 == 0;
  }
  was_plain_ = plain_;
  if (goes_on_from_before(solids, frame)) {
    for (Index i = 0; i < solids.size(); ++i)
      if (!equal_bits(solids[i].growth, (*before_)[i].growth) ||
          !solids[i].shape.is_same((*before_)[i].shape))
        moved_.push_back(i);
    move_to(frame);
  } else {
    before_.reset();
    frame_ = frame;
    nodes_.assign(node_count(frame.size), ClosedDistance{});
    first_.assign(nodes_.size(), First{});
    evaluated_.assign(nodes_.size(), 0);
    slots_.clear();
    was_plain_ = false;
    end_moved_ = {};
    for (Sweep& sweep : sweeps_) sweep.before_.clear();
  }
  ended_ = false;
  solids_ = &solids;
  changed_.assign(nodes_.size(), 0);
  searched_.assign(nodes_.size(), 0);
}

void ClosingMemory::end() {
  before_ = *solids_;
  solids_ = nullptr;
  ended_ = true;
}

void ClosingMemory::move_to(const ClosingFrame& frame) {
  const std::array<int, 3> old_size = frame_.size;
  std::array<int, 3> shift;
  for (std::size_t a = 0; a < 3; ++a) {
    shift[a] = int(std::lround(frame_.low[Eigen::Index(a)] - frame.low[Eigen::Index(a)]));
    end_moved_[a] = {shift[a] != 0, shift[a] + old_size[a] != frame.size[a]};
  }
  if (shift != std::array<int, 3>{} || old_size != frame.size) {
    nodes_ = in_other_box(nodes_, old_size, frame.size, shift);
    first_ = in_other_box(first_, old_size, frame.size, shift);
    evaluated_ = in_other_box(evaluated_, old_size, frame.size, shift);
    if (!slots_.empty()) {
      std::array<int, 3> steps = shift;
      for (int& step : steps) step /= slot_step;
      slots_ = in_other_box(slots_, nodes_at_steps(old_size, slot_step),
                            nodes_at_steps(frame.size, slot_step), steps);
    }
    for (Sweep& sweep : sweeps_) move_sweep(sweep, shift, frame);
  }
  frame_ = frame;
}

/// Numbers trials by the nodes of another box, whose order is the same.
void ClosingMemory::move_sweep(Sweep& sweep, const std::array<int, 3>& shift,
                               const ClosingFrame& frame) const {
  std::vector<Trial> kept;
  for (const Trial& trial : sweep.before_) {
    std::size_t rest = trial.node, node = 0, stride = 1;
    bool inside = true;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto old_size = std::size_t(frame_.size[a]);
      const int at = int(rest % old_size) + shift[a];
      rest /= old_size;
      inside = inside && at >= 0 && at < frame.size[a];
      node += stride * std::size_t(std::max(at, 0));
      stride *= std::size_t(frame.size[a]);
    }
    if (!inside) continue;
    kept.push_back(trial);
    kept.back().node = node;
  }
  sweep.before_ = std::move(kept);
}

bool ClosingMemory::holds(const ClosingReach& reach) const {
  const double within = reach.reach + reach_margin * frame_.sigma;
  return std::ranges::none_of(moved_, [&](Index i) {
    return i == reach.blocker || !solids_->is_beyond(i, reach.about, within) ||
           !before_->is_beyond(i, reach.about, within);
  });
}

/// Part of space that a node's first value depends on, if it was searched for.
ClosingReach ClosingMemory::reach_of(std::size_t node) const {
  const ClosedDistance& at = nodes_[node];
  if (at.crease) return first_[node].reach;
  return {at.centre, std::max(at.value, frame_.radius), no_index};
}

bool ClosingMemory::is_changed_about(const std::array<int, 3>& n, int step) const {
  std::array<int, 3> low, high;
  for (std::size_t a = 0; a < 3; ++a) {
    low[a] = n[a] - step;
    high[a] = n[a] + step;
    if (low[a] < 0) {
      if (end_moved_[a][0]) return true;
      low[a] = n[a];
    }
    if (high[a] >= frame_.size[a]) {
      if (end_moved_[a][1]) return true;
      high[a] = n[a];
    }
  }
  for (int k = low[2]; k <= high[2]; k += step)
    for (int j = low[1]; j <= high[1]; j += step)
      for (int i = low[0]; i <= high[0]; i += step)
        if (is_changed_at(i, j, k)) return true;
  return false;
}

bool ClosingMemory::take_first(std::size_t node) {
  if (evaluated_[node] == 0 || !holds(reach_of(node))) return false;
  if (nodes_[node].crease) nodes_[node] = first_[node].value;
  return true;
}

void ClosingMemory::set_first(std::size_t node, const ClosedDistance& value, const ClosingReach& reach) {
  const ClosedDistance& before = nodes_[node].crease ? first_[node].value : nodes_[node];
  changed_[node] = evaluated_[node] == 0 || !equal_bits(before, value);
  evaluated_[node] = searched_[node] = 1;
  if (value.crease) first_[node] = {value, reach};
}

void ClosingMemory::set_mean(std::size_t node) {
  // Other nodes do not look at means.
  changed_[node] = evaluated_[node];
  evaluated_[node] = 0;
}

void ClosingMemory::find_steady_cells(bool plain) {
  plain_ = plain;
  const auto& size = frame_.size;
  for (std::size_t a = 0; a < 3; ++a) cells_[a] = (size[a] - 1) / 2;
  steady_.assign(node_count(cells_), 0);
  std::size_t at = 0;
  for (int k = 0; k + 2 < size[2]; k += 2)
    for (int j = 0; j + 2 < size[1]; j += 2)
      for (int i = 0; i + 2 < size[0]; i += 2) {
        bool same = true;
        for (int c = 0; c < 8 && same; ++c)
          same = !is_changed_at(i + 2 * (c & 1), j + (c & 2), k + (c >> 2) * 2);
        steady_[at++] = same;
      }
}

void ClosingMemory::begin_slots() {
  if (slots_.empty()) slots_.resize(node_count(nodes_at_steps(frame_.size, slot_step)));
}

SlotTest& ClosingMemory::slot_test(const std::array<int, 3>& n) {
  return slots_[node_index(nodes_at_steps(frame_.size, slot_step), n[0] / slot_step, n[1] / slot_step,
                           n[2] / slot_step)];
}

bool ClosingMemory::holds(const SlotTest& test) const {
  return test.known && holds(test.smaller) && holds(test.larger);
}

std::size_t ClosingMemory::searched() const {
  return std::size_t(std::ranges::count(searched_, char(1)));
}

}  // namespace hariko
