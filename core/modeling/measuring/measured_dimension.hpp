#pragma once

// Places of anchors and values of dimensions, from a document and the surfaces of its objects.

#include <functional>
#include <optional>
#include <vector>

#include "core/document/document.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Surface of an object that is measured on; null where it has none, or none yet.
using SurfaceOf = std::function<const Surface*(ObjectId)>;

/// Place of an anchor in the document's space. Nothing where what it names is gone, or its surface is not
/// there. O(objects + log elements), on surfaces O(patches).
std::optional<Vector3> anchor_place(const Document& document, const Anchor& anchor,
                                    const SurfaceOf& surface_of);

/// Value of a dimension and where it stands. Lengths are in the document's unit.
struct MeasuredDimension {
  std::vector<Vector3> points;  ///< places of the anchors
  /// Distance; angle in radians, 0 .. pi; radius: the smaller principal radius without its sign.
  double value = 0;
  /// Radius: principal radii, that of the greater curvature in absolute value first. Positive where the
  /// surface bends away from its outward normal, as a ball does; infinite where it is flat (a radius above
  /// 1e6 patch sizes).
  double first_radius = 0, second_radius = 0;
  Vector3 normal = Vector3::Zero();  ///< radius: unit outward normal of the surface
};

/// Measures a dimension. Nothing where an anchor has no place, where an arm of an angle has no length, and
/// where the surface has no curvature. Cost: that of `anchor_place` for each anchor.
std::optional<MeasuredDimension> measured(const Document& document, const Dimension& dimension,
                                          const SurfaceOf& surface_of);

}  // namespace hariko
