#pragma once

// Ejection search: removes pieces one at a time by placing their facets where these eject the least weight
// (unfolding.md, "The method that is used"). Internal to core/unfolding.

#include <cstdint>
#include <functional>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/unfolding/cuts/facet_forest.hpp"

namespace hariko {

/// Budget and seed of an ejection search.
struct EjectionOptions {
  std::uint64_t steps = 0;  ///< total budget; a step places one facet
  std::uint64_t seed = 1;
  /// Called after each piece that was removed.
  std::function<void(const FacetForest&)> improved = {};
};

/// Removes pieces one at a time while the budget lasts; leaves the forest with the fewest pieces found, also
/// when cancelled. Deterministic: steps are counted, not time. Returns the number of steps used.
std::uint64_t eject_pieces(FacetForest& forest, const EjectionOptions& options, const CancelToken& cancel,
                           const Progress& progress);

}  // namespace hariko
