#pragma once

// How far a surface is from its sections, quickly enough to be read while a point is dragged.

#include <vector>

#include "core/skinning/evaluate_skin.hpp"

namespace hariko {

/// As `section_misses`, of the skin that the surface was made from, at eight points a side of a patch along
/// the sections, and at fewer where there are more than 500 sides. With eight the root mean square is within
/// a fifth of that of `section_misses`, and the largest distance at most as large: peaks lie between samples.
/// Where the vertices of a section's row are regular and their limits are those of the section's points, the
/// curves are the same, and nothing else is measured. O(samples).
std::vector<SectionMiss> section_deviations(const SkinResult& result, const SubdivisionPatchSet& patches);

}  // namespace hariko
