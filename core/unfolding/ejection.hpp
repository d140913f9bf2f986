#pragma once

// Ejection search: fewer pieces by breaking one up and placing its facets where they push out the least
// (unfolding.md, "The method that is used"). Internal to core/unfolding.

#include <cstdint>
#include <functional>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/unfolding/facet_forest.hpp"

namespace hariko {

struct EjectionOptions {
  std::uint64_t steps = 0;  ///< of placing one facet; the whole budget
  std::uint64_t seed = 1;
  /// Called for every state with one piece less.
  std::function<void(const FacetForest&)> improved = {};
};

/// Removes pieces one by one while the budget lasts; the forest is left at the fewest pieces found. A
/// function of its arguments: steps are counted, never time. The last state is kept when cancelled. Gives the
/// steps that were used.
std::uint64_t eject_pieces(FacetForest& forest, const EjectionOptions& options, const CancelToken& cancel,
                           const Progress& progress);

}  // namespace hariko
