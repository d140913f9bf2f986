#pragma once

// Packing of pieces on pages: bitmaps of covered cells, many rotations, first free place from the lower left
// (unfolding.md, "Tabs, strips, pages").

#include <cstdint>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/document/paper_settings.hpp"
#include "core/unfolding/pages/piece_placement.hpp"
#include "core/unfolding/pages/sheet_overlaps.hpp"

namespace hariko {

/// Convex polygons that move together. Their `sheet` is ignored.
struct PackItem {
  std::vector<SheetPolygon> polygons;
  bool turns = true;  ///< false: only two rotations, along the page and across
};

/// Result of packing.
struct Packing {
  std::vector<PiecePlacement> placements;  ///< one for each item
  Index page_count = 0;
  /// Items that fit between the margins in no rotation; each is on a page of its own.
  std::vector<Index> too_large;
};

/// Page and effort of packing.
struct PackOptions {
  PaperSize page;
  double margin = 0, gap = 0;  ///< mm
  int tries = 1;               ///< number of orders of the items that are tried; the fewest pages win
  /// Polygons that are on the pages already; `sheet` is the page.
  std::vector<SheetPolygon> occupied = {};
};

/// Packs items on pages. Conservative: two items are never nearer than the gap, and nothing extends beyond
/// the margins. Deterministic: depends on the arguments alone. Cells are about 1/180 of the page's longer
/// side. The result is of no use where cancelled.
Packing pack_pages(const std::vector<PackItem>& items, const PackOptions& options,
                   const CancelToken& cancel = {});

}  // namespace hariko
