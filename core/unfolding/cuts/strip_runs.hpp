#pragma once

// Runs of joint strips: slits with many short edges get one long strip instead of many short ones.

#include <vector>

#include "core/unfolding/glue_tabs.hpp"

namespace hariko {

/// Consecutive joints without a tab, along both of their sides, in the order along the strip. The strip runs
/// so that the first facet of each joint has it on its left.
struct StripRun {
  std::vector<Index> joints;
  double length = 0;  ///< mm
};

/// Runs of all joints without a tab, each in exactly one run. A run continues while the sides on both sides
/// of the slit lie within an eighth of the strip's width of the straight line between its ends, up to the
/// length `longest`, mm. Runs ascend by their lowest joint. O(joints log joints) expected, times the joints
/// of a run.
std::vector<StripRun> strip_runs(const FacetGraph& graph, const FlatLayout& layout,
                                 const std::vector<Joint>& joints, const PaperSettings& settings,
                                 double longest);

}  // namespace hariko
