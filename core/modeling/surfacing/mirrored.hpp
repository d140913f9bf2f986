#pragma once

// Mirrored whole of a polyhedron with a live mirror: the half and its image, joined at the plane.

#include <memory>
#include <optional>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"
#include "core/polyhedron/element_aliases.hpp"

namespace hariko {

/// Error: the halves cannot be joined, because an edge in the plane would have more than two faces.
inline constexpr Code e_mirror_nonmanifold{"E_MIRROR_NONMANIFOLD"};

/// The half and its image as one polyhedron.
struct MirroredPolyhedron {
  Polyhedron polyhedron;  ///< the half's elements first, in order and with their ids; then the images
  Shaping shaping;
  /// Origin of the half, but zero along the axis, so that images are equal to the last bit.
  Vector3 origin = Vector3::Zero();
  std::shared_ptr<const ElementAliases> aliases;  ///< original element of each image
  PolyhedronSource half;                          ///< the source that the whole was made from
};

/// Makes the whole. `half` must have a mirror. Vertices of the seam (`mirror_seam`) lie in the plane exactly;
/// a pinned tangent plane at one of them is replaced by the nearest plane that is its own image. Where
/// `previous` was made from the same connectivity and the same seam, the result shares its topology, so that
/// the surface can be updated instead of made anew. Ids depend on the half alone. Errors:
/// E_MIRROR_NONMANIFOLD, E_TOO_MANY_ELEMENTS, E_NONFINITE. O(n log n).
Result<MirroredPolyhedron> mirrored(const PolyhedronSource& half,
                                    const MirroredPolyhedron* previous = nullptr);

/// Applies the live mirror: the images become elements of the designer's polyhedron, which has no mirror
/// then. A source without a mirror is returned as it is. Errors: those of `mirrored`.
Result<PolyhedronSource> baked(const PolyhedronSource& source);
/// `baked` as an operation; selects the images' faces. Errors: E_WRONG_SELECTION without a live mirror, and
/// those of `baked`.
Result<EditResult> apply_mirror(const PolyhedronSource& source);

/// Reflects the whole object in the plane through the origin of its space; ids stay, and faces stay oriented
/// outward. Frozen sides of attachments are reflected along, other attached edges released.
EditResult mirror_object(const PolyhedronSource& source, Axis axis);

}  // namespace hariko
