#pragma once

// Colours of tensions: orange where curves are pulled tighter than usual, blue where they are looser.

#include "render/color_map.hpp"

namespace hariko {

/// Place of a tension between -1 (loosest) and 1 (tightest); 0 is the default value. Logarithmic: alpha 20
/// and beta 20 reach the end, beta 1/20 the other one.
double alpha_place(double alpha);
double beta_place(double beta);
/// Where a place lies in the colours of ColorScale::diverging_safe: weak tensions keep away from its pale
/// middle, which means none.
double tension_fraction(double place);
Color tension_color(double place);

}  // namespace hariko
