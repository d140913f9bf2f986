#pragma once

// Points of a surface by patch and parameters: found by the names of patches, or as the nearest one to a
// point.

#include <optional>

#include "core/document/dimension.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Point of a surface.
struct SurfaceSpot {
  Index patch = no_index;
  Vector2 parameter = Vector2::Zero();
};

/// Point that an anchor names; nothing where the surface has no such patch. O(patches).
std::optional<SurfaceSpot> spot_of(const Surface& surface, const PatchAnchor& anchor);

/// Anchor at a point of a surface of an object. O(patches).
PatchAnchor patch_anchor(const Surface& surface, ObjectId object, const SurfaceSpot& spot);

/// Point of a surface nearest to a point that is relative to the surface's origin: the best of a grid on all
/// patches, then improved on the patches that come into question. Nothing for a surface without patches.
/// O(patches).
std::optional<SurfaceSpot> nearest_spot(const Surface& surface, const Vector3& point);

}  // namespace hariko
