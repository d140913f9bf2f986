#pragma once

// Distance of a surface from its sections, fast enough for display during a drag.

#include <vector>

#include "core/skinning/evaluate_skin.hpp"

namespace hariko {

/// Estimates `section_misses` of the skin that the surface was made from, at eight points per patch side
/// along the sections, and at fewer where there are more than 500 sides. With eight the root mean square is
/// within a fifth of that of `section_misses`, and the largest distance at most as large, because peaks lie
/// between samples. Where the vertices of a section's row are regular and have the limits of the section's
/// points, the curves are identical, and nothing else is measured. O(samples).
std::vector<SectionMiss> section_deviations(const SkinResult& result, const SubdivisionPatchSet& patches);

}  // namespace hariko
