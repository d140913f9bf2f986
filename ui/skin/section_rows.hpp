#pragma once

// How far the surface of a skin is from each of its sections.

#include "core/document/document.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// A row a section with its largest distance, from the surface that was made last, or one for all where the
/// surface goes through all; nothing where there is no surface. Marks: "skin.miss.<number>", "skin.miss.all".
void draw_section_rows(PanelContext& context, const Object& object);

}  // namespace hariko
