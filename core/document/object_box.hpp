#pragma once

// How large an object is, by what it is made from.

#include <Eigen/Geometry>

#include "core/document/document.hpp"

namespace hariko {

/// A box along the document's axes round what the object is made from, the image in a live mirror included.
/// Its surface may bulge out of it. Empty for kinds that are not known. O(points).
Eigen::AlignedBox3d world_box(const Object& object);

}  // namespace hariko
