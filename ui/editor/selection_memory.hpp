#pragma once

// SelectionMemory: which selection belongs to which state of the history.

#include <cstdint>
#include <map>
#include <memory>

#include "ui/editor/selection.hpp"

namespace hariko {

struct ChosenElements {
  Selection selection;
  ElementMode mode = ElementMode::vertex;
  friend bool operator==(const ChosenElements&, const ChosenElements&) = default;
};

/// Keyed by History::serial(). Neighbouring states with equal selections share one. When all of them together
/// have more than `element_limit` elements, those of the oldest states are forgotten.
class SelectionMemory {
 public:
  static constexpr std::size_t default_element_limit = 2'000'000;
  explicit SelectionMemory(std::size_t element_limit = default_element_limit) : limit_(element_limit) {}

  /// A step led on from the state `left`: what could be redone is gone, as are states before `oldest`.
  void step(std::uint64_t left, ChosenElements chosen, std::uint64_t oldest);
  /// The state is left by undo or redo. What a step was made with stays.
  void leave(std::uint64_t state, ChosenElements chosen);
  /// nullptr when nothing is known of the state.
  const ChosenElements* find(std::uint64_t state) const;
  std::size_t size() const { return kept_.size(); }

 private:
  void keep(std::uint64_t state, ChosenElements chosen);
  std::map<std::uint64_t, std::shared_ptr<const ChosenElements>> kept_;
  std::size_t limit_;
};

}  // namespace hariko
