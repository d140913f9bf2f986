#pragma once

// Glue tabs: trapezoids along cut edges that overlap nothing, as far as there is room.

#include <array>
#include <optional>
#include <vector>

#include "core/document/paper_settings.hpp"
#include "core/unfolding/cuts/facet_layout.hpp"
#include "core/unfolding/pages/sheet_overlaps.hpp"

namespace hariko {

/// Side of a cut edge that gets the tab. The first facet is the one with the lower number.
enum class TabChoice : std::uint8_t {
  automatic,
  first,
  second,
  strip  ///< no tab: a joint strip instead
};

/// Tab on a side of a facet.
struct GlueTab {
  Index facet = no_index, side = 0;
  double height = 0;               ///< mm
  std::array<Vector2, 4> corners;  ///< counter-clockwise; the first two lie on the facet's side
};

/// Cut edge between two facets, with the tab or strip that joins its sides.
struct Joint {
  Index edge = no_index;
  std::optional<GlueTab> tab;  ///< nothing: a joint strip
};

/// Joints of all cut edges with two facets, ascending by edge. Tabs are trapezoids with flanks of 45 degrees
/// and 1, 0.7, 0.45 or 0.25 of the set tab height, at most 0.4 of the edge: the highest that overlaps no
/// facet and no other tab of its piece, or none where that is below the least height. Longer edges have
/// priority. `choices` is empty or has one for each edge. O(facets) expected.
std::vector<Joint> find_joints(const FacetGraph& graph, const Folds& folds, const FlatLayout& layout,
                               const std::vector<TabChoice>& choices, const PaperSettings& settings);

}  // namespace hariko
