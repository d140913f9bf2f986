#pragma once

// ClosingMemory: the closing at a lattice's nodes, kept from one frame of a drag to the next
// (docs/envelope.md).

#include <array>
#include <optional>
#include <vector>

#include "core/envelope/ball/closing.hpp"
#include "core/envelope/ball/spline_field.hpp"

namespace hariko {

/// Nodes are tested for slots at every fourth one along each axis.
inline constexpr int slot_step = 4;

/// Ball and lattice of a frame. Nodes lie at multiples of the spacing from the object's origin; x runs
/// fastest.
struct ClosingFrame {
  double radius = 1, sigma = 1, spacing = 1;
  Vector3 origin = Vector3::Zero();
  Vector3 low = Vector3::Zero();  ///< first node, in spacings; `slot_step` divides these numbers
  std::array<int, 3> size{};      ///< numbers of nodes; one more than a multiple of it
};

/// Results of searches at nodes, with what they depend on. A result is taken from the frame before only where
/// a search would find it again bit for bit (docs/envelope.md): a frame does not depend on those before it.
///
/// In a frame the nodes of every step are reported in the order of the work: first values, sweeps over every
/// second node, slots, the other nodes, sweeps over all. Calls for different nodes may overlap where nodes
/// are visited in parallel.
class ClosingMemory {
 public:
  /// A node that a sweep tried to improve: its value from then on.
  struct Trial {
    std::size_t node = 0;
    ClosedDistance result;
    ClosingReach reach;
  };

  /// Trials of one sweep, in its order.
  class Sweep {
   public:
    /// Trial at a node in the frame before, or null; nodes come in the sweep's order.
    const Trial* before(std::size_t node);
    void add(const Trial& trial) { now_.push_back(trial); }

   private:
    friend class ClosingMemory;
    std::vector<Trial> before_, now_;
    std::size_t next_ = 0;  ///< the first trial of before that was not passed yet
    bool forward_ = true;
  };

  /// Begins a frame. What was kept is forgotten where the frame differs in more than its box, or solids came
  /// or went. `solids` must live until `end`.
  void begin(const GrownUnion& solids, const ClosingFrame& frame);
  /// Ends a frame; one that is not ended, as it was cancelled, leaves nothing to the next.
  void end();

  /// Values of the nodes: those of the frame before until this frame's are put there.
  std::vector<ClosedDistance>& nodes() { return nodes_; }

  /// Whether a result with this reach holds in this frame. O(changed solids).
  bool holds(const ClosingReach& reach) const;
  /// Whether a node's result is not the one of the frame before, as far as this frame has come.
  bool is_changed(std::size_t node) const { return changed_[node] != 0; }
  void set_changed(std::size_t node, bool changed) { changed_[node] = changed; }
  /// Whether one of a node's neighbours in the lattice of every `step`th node changed, came or went.
  bool is_changed_about(const std::array<int, 3>& n, int step) const;

  /// Puts a node's first value there where it holds; false where it has to be found.
  bool take_first(std::size_t node);
  /// Notes a first value that was searched for, before it is put there.
  void set_first(std::size_t node, const ClosedDistance& value, const ClosingReach& reach);
  /// Whether the node's value came without a search in the frame before.
  bool has_mean(std::size_t node) const { return evaluated_[node] == 0; }
  /// Notes that the node gets a value without a search.
  void set_mean(std::size_t node);

  /// Finds the cells between every second node whose corners all have the values of the frame before.
  /// `plain`: whether values alone tell which nodes are searched for.
  void find_steady_cells(bool plain);
  /// Whether the cell about a node is one of these.
  bool is_steady(const std::array<int, 3>& n) const {
    return steady_[node_index(cells_, std::min(n[0] / 2, cells_[0] - 1), std::min(n[1] / 2, cells_[1] - 1),
                              std::min(n[2] / 2, cells_[2] - 1))] != 0;
  }
  /// Whether values alone tell which nodes are searched for, and did in the frame before.
  bool is_plain() const { return plain_ && was_plain_; }

  /// Begins the tests for slots.
  void begin_slots();
  /// Test at a node of the lattice of every fourth one, from the frame before until it is replaced.
  SlotTest& slot_test(const std::array<int, 3>& n);
  bool holds(const SlotTest& test) const;
  void forget_slots() { slots_.clear(); }

  /// Trials of the sweep over every second node, or over all.
  Sweep& trials(bool over_all, bool forward) { return sweeps_[(over_all ? 2U : 0U) + (forward ? 0U : 1U)]; }
  /// Number of nodes whose first value was searched for in this frame.
  std::size_t searched() const;

 private:
  /// First value of a crease node. Sweeps change no others, whose value and centre tell the reach.
  struct First {
    ClosedDistance value;
    ClosingReach reach;
  };
  bool goes_on_from_before(const GrownUnion& solids, const ClosingFrame& frame) const;
  void move_to(const ClosingFrame& frame);
  void move_sweep(Sweep& sweep, const std::array<int, 3>& shift, const ClosingFrame& frame) const;
  ClosingReach reach_of(std::size_t node) const;
  bool is_changed_at(int i, int j, int k) const { return changed_[node_index(frame_.size, i, j, k)] != 0; }

  ClosingFrame frame_;
  const GrownUnion* solids_ = nullptr;  ///< this frame's; null between frames
  std::optional<GrownUnion> before_;    ///< solids of the frame before
  bool ended_ = false;                  ///< the frame before was
  std::vector<Index> moved_;            ///< solids that changed since
  /// Whether the box ends elsewhere than before: low and high end along each axis.
  std::array<std::array<bool, 2>, 3> end_moved_{};
  std::vector<ClosedDistance> nodes_;     ///< see `nodes`
  std::vector<First> first_;              ///< per node; without meaning at nodes that are not at a crease
  std::vector<char> evaluated_;           ///< per node: its value comes from a search, of any frame
  std::vector<char> changed_, searched_;  ///< per node: in this frame
  std::array<int, 3> cells_{};            ///< numbers of cells between every second node
  std::vector<char> steady_;              ///< per cell
  bool plain_ = false, was_plain_ = false;
  std::vector<SlotTest> slots_;  ///< tests at every fourth node; empty where none was tested
  std::array<Sweep, 4> sweeps_;
};

}  // namespace hariko
