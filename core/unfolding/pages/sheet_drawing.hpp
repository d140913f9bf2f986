#pragma once

// SheetDrawing: printed and cut content of pages, as lines and texts on layers. All writers and views draw
// it.

#include <string>
#include <string_view>
#include <vector>

#include "core/unfolding/unfolding.hpp"

namespace hariko {

/// Layers, one for each operation of a cutter or plotter.
enum class SheetLayer : std::uint8_t { cut, fold_mountain, fold_valley, tab, label, strip };
/// All layers.
inline constexpr SheetLayer sheet_layers[] = {SheetLayer::cut,         SheetLayer::fold_mountain,
                                              SheetLayer::fold_valley, SheetLayer::tab,
                                              SheetLayer::label,       SheetLayer::strip};
/// Name of a layer: "cut", "fold-mountain", "fold-valley", "tab", "label", "strip".
std::string_view to_string(SheetLayer layer);

/// Line on a layer.
struct DrawnLine {
  SheetLayer layer = SheetLayer::cut;
  Index page = 0;
  Vector2 from, to;
  bool inner_fold = false;  ///< fold between two facets, which is listed in `folds` too
};

/// Kinds of folds. Mountains are solid lines and fold away from the reader, valleys are dashed and fold
/// towards the reader.
enum class FoldKind : std::uint8_t { mountain, valley, flat };

/// Fold between two faces of a piece, or within a face that is not flat.
struct DrawnFold {
  FoldKind kind = FoldKind::flat;  ///< flat folds have no line
  Index page = 0;
  std::array<Index, 2> faces;  ///< faces of the mesh
  Vector2 from, to;
  double angle = 0;  ///< radians; > 0 mountain, < 0 valley
};

/// Facet on a page.
struct DrawnFacet {
  Index facet = 0, piece = 0, page = 0;
  FacetCorners corners;  ///< counter-clockwise; clockwise where the print is inside
};

/// Face of the mesh on a page, or a part of one that was divided.
struct DrawnFace {
  Index face = 0, piece = 0, page = 0;
  std::vector<Vector2> corners;  ///< in the mesh's order, with the orientation of facets
};

/// Text along direction `angle`, centred at `centre`. ASCII.
struct DrawnText {
  Index page = 0;
  Vector2 centre;
  double angle = 0, height = 0;  ///< height of capitals, mm
  std::string text;
};

/// Drawing of all pages, in mm, x to the right, y up from the lower left corner.
struct SheetDrawing {
  PaperSize page;
  Index page_count = 0;
  double scale = 1;  ///< mm per unit of the mesh
  std::vector<DrawnFacet> facets;
  std::vector<DrawnFace> faces;  ///< ascending
  std::vector<DrawnFold> folds;
  std::vector<DrawnLine> lines;  ///< visible folds included
  std::vector<DrawnText> texts;
};

/// Kind of a fold of this angle (radians).
FoldKind fold_kind(double angle, const PaperSettings& settings);

/// Drawing of a paper model: lines of cuts, folds, tabs and strips; the number of each joint on both sides of
/// the cut, on its tab and on both halves of its strip; names of pieces; page numbers, marks at the corners
/// of the printable area and a scale bar of 50 mm where the margin has room. Mirrored where the print is
/// inside. O(edges).
SheetDrawing draw_sheets(const Unfolding& unfolding);

}  // namespace hariko
