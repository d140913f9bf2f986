#pragma once

// Size of an object, from its source.

#include <Eigen/Geometry>
#include <functional>

#include "core/document/document.hpp"

namespace hariko {

/// Bounding box, along the document's axes, of the object's source including its image in a live mirror, at
/// all its places. The surface may extend beyond it. Empty for unknown kinds. O(points * places).
Eigen::AlignedBox3d world_box(const Object& object);
/// Box round all places of an object; `box_at` gives that of one place. Places that are moved and not turned
/// against each other are measured once.
Eigen::AlignedBox3d box_of_places(const Object& object,
                                  const std::function<Eigen::AlignedBox3d(const Similarity&)>& box_at);
/// The same as `world_box` at the object's own place alone, without live copies: what lengths are in
/// proportion to that are chosen for the shape. O(points).
Eigen::AlignedBox3d box_at_own_place(const Object& object);

}  // namespace hariko
