#pragma once

// Joint strips in a row: slits of many short edges get one long strip in the place of many snippets.

#include <vector>

#include "core/unfolding/glue_tabs.hpp"

namespace hariko {

/// Joints without a tab that follow each other along both of their sides, in the order along the strip, which
/// runs as the first facet of each joint has it on its left (of joint.edge, by `forward`).
struct StripRun {
  std::vector<Index> joints;
  double length = 0;  ///< mm
};

/// Every joint without a tab is in one run. A run goes on while the sides lie within an eighth of the strip's
/// width of the straight line between its ends, on both sides, and its length is at most `longest`, mm. Runs
/// ascend by their lowest joint. O(joints log joints) expected, times the joints of a run.
std::vector<StripRun> strip_runs(const FacetGraph& graph, const FlatLayout& layout,
                                 const std::vector<Joint>& joints, const PaperSettings& settings,
                                 double longest);

}  // namespace hariko
