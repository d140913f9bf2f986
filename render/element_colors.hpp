#pragma once

// Colours of tensions: orange where curves are tighter than by default, blue where they are looser; and
// colours of single patches, by the patch map and for highlights.

#include <cstdint>
#include <vector>

#include "render/color_map.hpp"
#include "render/scene.hpp"

namespace hariko {

/// Position of a tension between -1 (loosest) and 1 (tightest); 0 is the default value. Logarithmic: alpha 20
/// and beta 20 reach 1, beta 1/20 reaches -1.
double alpha_place(double alpha);
double beta_place(double beta);
/// Position on ColorScale::diverging_safe; weak tensions avoid its pale middle, which means none.
double tension_fraction(double place);
/// Colour of a position.
Color tension_color(double place);

/// Four bytes for each patch of the object's mesh, which must exist: the colour in the patch map, black in
/// other maps; then the highlight: 0, 128 hovered, 255 selected. O(patches).
std::vector<std::uint8_t> patch_color_bytes(const SceneObject& object);

}  // namespace hariko
