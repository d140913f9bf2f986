#pragma once

// Pleat skinning: the lines of the correspondences become edge lines of the control mesh.

#include "core/skinning/columns/skin_mesh.hpp"

namespace hariko {

/// Makes the control mesh of a pleated skin. Errors: E_SKIN_SIZE (too many vertices). O(vertices), and the
/// sparse solve of `SectionFit::fair`.
Result<SkinMesh> pleat_mesh(const Skin& skin, const SkinPlan& plan);

}  // namespace hariko
