#pragma once

// Writers of sheets as the bytes of files: SVG, DXF, PDF, and the layout as JSON.

#include <string>

#include "core/unfolding/pages/sheet_drawing.hpp"

namespace hariko {

/// Gap between pages where a file has them side by side, mm.
inline constexpr double page_spacing = 20;
/// Height of capitals in Helvetica and similar fonts, at font size 1.
inline constexpr double helvetica_capital_height = 0.718;

/// Layout for other programs (unfolding.md, "Files"): every face of the mesh once with its corners in the
/// mesh's order (of divided faces each part), and all folds between them, also those without a line.
/// Coordinates are exact: they read back as the same doubles.
std::string write_layout_json(const SheetDrawing& drawing);

/// SVG of one page, in mm; a drawing without pages has an empty first one. Layers are groups with their
/// names; faces of the mesh are polygons of class `face` with data-face, data-piece and data-page; folds are
/// lines of class `fold mountain`, `fold valley` or `fold flat` (not visible) with data-faces and data-angle
/// in degrees.
std::string write_sheet_svg(const SheetDrawing& drawing, Index page);

/// DXF R12 (AC1009) in mm, with the pages side by side and a layer for each kind of line.
std::string write_sheet_dxf(const SheetDrawing& drawing);

/// PDF 1.4 with one page for each sheet, lines and Helvetica.
std::string write_sheet_pdf(const SheetDrawing& drawing);

}  // namespace hariko
