#pragma once

// Packing pieces on pages: bitmaps of what they cover, many turns, first free place from the lower left
// (unfolding.md, "Tabs, strips, pages").

#include <cstdint>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/document/paper_settings.hpp"
#include "core/unfolding/piece_placement.hpp"
#include "core/unfolding/sheet_overlaps.hpp"

namespace hariko {

/// Convex polygons that move together. Their `sheet` does not matter.
struct PackItem {
  std::vector<SheetPolygon> polygons;
  bool turns = true;  ///< otherwise two turns only, along the page and across
};

struct Packing {
  std::vector<PiecePlacement> placements;  ///< one for each item
  Index page_count = 0;
  std::vector<Index> too_large;  ///< items that no turn puts between the margins; each on a page of its own
};

struct PackOptions {
  PaperSize page;
  double margin = 0, gap = 0;  ///< mm
  int tries = 1;               ///< orders of the items; the fewest pages win
  /// What lies on the pages already; `sheet` is the page.
  std::vector<SheetPolygon> occupied = {};
};

/// Conservative: two items are never nearer than the gap, and nothing passes the margins. A function of the
/// arguments alone. Cells of about 1/180 of the page's longer side. Where cancelled the result means nothing.
Packing pack_pages(const std::vector<PackItem>& items, const PackOptions& options,
                   const CancelToken& cancel = {});

}  // namespace hariko
