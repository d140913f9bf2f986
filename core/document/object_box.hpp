#pragma once

// Size of an object, from its source.

#include <Eigen/Geometry>

#include "core/document/document.hpp"

namespace hariko {

/// Bounding box, along the document's axes, of the object's source including its image in a live mirror. The
/// surface may extend beyond it. Empty for unknown kinds. O(points).
Eigen::AlignedBox3d world_box(const Object& object);

}  // namespace hariko
