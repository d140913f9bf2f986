#pragma once

// Writers of section curves and their combs, as SVG and DXF at full size.

#include <string>

#include "core/drawing/section_set.hpp"

namespace hariko {

/// SVG 1.1 in millimetres at full size, all planes over each other in the axes of `section_axes`, with a
/// layer for the curves of each plane (`section-1`, ...) and one for its comb (`comb-1`, ...). The page is as
/// large as what is drawn, with 5 mm at each side. `millimetres`: in a unit of the set's lengths, > 0.
/// Coordinates are rounded to a thousandth of a millimetre. O(points).
std::string write_sections_svg(const SectionSet& set, const SectionCombs& combs, double millimetres);

/// DXF R12 (AC1009) in millimetres with polylines in space: x and y in the axes of `section_axes`, z the
/// plane's distance along the direction; so the view from above shows the true shapes, and planes across z
/// are where they are in the model. Layers SECTION_1, ... and COMB_1, ... O(points).
std::string write_sections_dxf(const SectionSet& set, const SectionCombs& combs, double millimetres);

}  // namespace hariko
