#pragma once

// The whole of a polyhedron with a live mirror: the half and its image, joined at the plane.

#include <memory>
#include <optional>

#include "core/base/result.hpp"
#include "core/modeling/modeled.hpp"
#include "core/polyhedron/element_aliases.hpp"

namespace hariko {

/// The halves cannot be joined: an edge in the plane would have more than two faces.
inline constexpr Code e_mirror_nonmanifold{"E_MIRROR_NONMANIFOLD"};

struct MirroredPolyhedron {
  Polyhedron polyhedron;  ///< the half's elements first, in order and with their ids; then the images
  Shaping shaping;
  Vector3 origin =
      Vector3::Zero();  ///< the half's, but zero along the axis: images are equal to the last bit
  std::shared_ptr<const ElementAliases> aliases;  ///< which element each image is of
  PolyhedronSource half;                          ///< what it was made from
};

/// The whole. `half` must have a mirror. Vertices of the seam (`mirror_seam`) lie in the plane exactly; those
/// of them whose tangent plane is pinned get the nearest one that is its own image. Where `previous` was made
/// from the same connectivity and the same seam, the result shares its topology, so that the surface can be
/// updated instead of made anew. Ids follow from the half alone. Errors: E_MIRROR_NONMANIFOLD,
/// E_TOO_MANY_ELEMENTS. O(n log n).
Result<MirroredPolyhedron> mirrored(const PolyhedronSource& half,
                                    const MirroredPolyhedron* previous = nullptr);

/// The whole as the designer's own: the live mirror ends. An object without one comes back as it is.
Result<PolyhedronSource> baked(const PolyhedronSource& source);
/// `baked` as an operation; selects the images' faces. Errors: E_WRONG_SELECTION without a live mirror.
Result<Modeled> apply_mirror(const PolyhedronSource& source);

/// The image of the whole object in the plane through the zero of its space: same ids, faces still outward.
Modeled mirror_object(const PolyhedronSource& source, Axis axis);

}  // namespace hariko
