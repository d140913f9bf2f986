#pragma once

// Glue tabs: for each pair of cut sides a trapezoid that overlaps nothing, where there is room for one.

#include <array>
#include <optional>
#include <vector>

#include "core/document/paper_settings.hpp"
#include "core/unfolding/facet_layout.hpp"
#include "core/unfolding/sheet_overlaps.hpp"

namespace hariko {

/// Which side of a cut edge has the tab. The first facet is that with the lower number.
enum class TabChoice : std::uint8_t {
  automatic,
  first,
  second,
  strip  ///< none: a joint strip instead
};

struct GlueTab {
  Index facet = no_index, side = 0;
  double height = 0;               ///< mm
  std::array<Vector2, 4> corners;  ///< counter-clockwise; the first two lie on the facet's side
};

/// The two sides of a cut edge between two facets, and what they are glued with.
struct Joint {
  Index edge = no_index;
  std::optional<GlueTab> tab;  ///< nothing: a joint strip
};

/// One joint for each cut edge with two facets, ascending by edge. Tabs are trapezoids with flanks of 45
/// degrees and 1, 0.7, 0.45 or 0.25 of the height of tabs, but at most 0.4 of the edge: the highest that
/// overlaps no facet and no other tab of its piece, or none where that is below the least height. Longest
/// edges choose first. `choices` is empty or has one for each edge. O(facets) expected.
std::vector<Joint> find_joints(const FacetGraph& graph, const Folds& folds, const FlatLayout& layout,
                               const std::vector<TabChoice>& choices, const PaperSettings& settings);

}  // namespace hariko
