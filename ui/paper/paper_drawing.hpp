#pragma once

// Drawing the pages of a paper model with ImGui, and where they are on the screen.

#include <imgui.h>

#include "ui/editor/paper_state.hpp"
#include "ui/view/view_layer.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// Pages in rows, and how they are looked at. Lengths in mm on the paper, y up on each page.
struct PageTable {
  static constexpr double gap = 12;  ///< between pages, mm
  PaperSize page;
  Index columns = 1;
  double zoom = 1;                   ///< screen pixels for 1 mm
  Vector2 corner = Vector2::Zero();  ///< corner of the first page, screen pixels

  /// As many columns as give a table of about this shape (width over height).
  static Index columns_for(const PaperSize& page, Index pages, double aspect);
  Vector2 upper_left(Index number) const;  ///< corner of a page, screen pixels
  ImVec2 to_screen(Index number, const Vector2& p) const;
  Vector2 to_page(Index number, const Vector2& pixel) const;
  /// The page under a pixel, or the nearest of `pages`.
  Index page_near(const Vector2& pixel, Index pages) const;
  /// Size of the whole table at zoom 1, mm.
  Vector2 size(Index pages) const;
};

/// Pages, pieces with what is pointed at and what is wrong, lines, words. `pages` may be one more than there
/// are, to put pieces on. Only what is within `clip`.
void draw_paper(ImDrawList& list, const Metrics& metrics, const PaperLayout& layout, const PaperState& state,
                const PageTable& table, Index pages, const PanelRect& clip);

/// A point of a page as it is drawn: mirrored where the print is inside.
Vector2 as_drawn(const PaperLayout& layout, const Vector2& p);

/// Corners of the tab or the strip of a joint as drawn, and its page.
std::array<Vector2, 4> joint_corners(const PaperLayout& layout, Index joint);
Index joint_page(const PaperLayout& layout, Index joint);

/// Box of a piece with its tabs, as drawn on its page.
struct PieceBox {
  Index page = 0;
  Vector2 low, high;
};
PieceBox box_of(const PaperLayout& layout, Index piece);

std::unique_ptr<ViewLayer> make_paper_layer();

}  // namespace hariko
