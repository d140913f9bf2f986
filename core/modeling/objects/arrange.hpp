#pragma once

// Arranging whole objects: copies in rows, around an axis and behind a plane; common faces and equal gaps.

#include <span>

#include "core/document/edits/edit_objects.hpp"
#include "core/document/object_box.hpp"
#include "core/geometry/mirror_plane.hpp"

namespace hariko {

inline constexpr Code e_no_objects{"E_NO_OBJECTS"};
inline constexpr Code e_few_objects{"E_FEW_OBJECTS"};
inline constexpr Code e_array_count{"E_ARRAY_COUNT"};
inline constexpr Code e_array_step{"E_ARRAY_STEP"};
inline constexpr Code e_array_axis{"E_ARRAY_AXIS"};
inline constexpr Code e_array_angle{"E_ARRAY_ANGLE"};
inline constexpr Code e_no_mirror_image{"E_NO_MIRROR_IMAGE"};
inline constexpr Code e_object_extent{"E_OBJECT_EXTENT"};

/// Least and largest number of places of a row or a ring, the originals' included.
inline constexpr int least_places = 2, most_places = 10000;

/// Copies objects so that there are `count` of each, the original at 0, copy k at k times `step` from it. The
/// copies are made as `duplicate_objects` makes them. Errors: E_NO_OBJECTS, E_ARRAY_COUNT (count outside
/// least_places .. most_places), E_ARRAY_STEP (zero or not finite), E_TRANSFORM_INVALID, and those of
/// `duplicate_objects`. O(n log n) in the objects and copies together.
Result<AddedObjects> array_in_row(const Document& document, std::span<const ObjectId> objects, int count,
                                  const Vector3& step);

/// Axis of a ring: a point on it and its direction, of any length.
struct RingAxis {
  Vector3 point = Vector3::Zero();
  Vector3 direction = Vector3::UnitZ();
};
/// Copies objects so that there are `count` of each, turned about the axis by equal angles, right-handed. A
/// full turn (`degrees` 360 or -360) spaces all of them evenly round; of a smaller angle the original and the
/// last copy stand at both ends. Errors: E_NO_OBJECTS, E_ARRAY_COUNT, E_ARRAY_AXIS (no direction, or not
/// finite), E_ARRAY_ANGLE (zero, beyond a full turn, or not finite), E_TRANSFORM_INVALID, and those of
/// `duplicate_objects`.
Result<AddedObjects> array_around_axis(const Document& document, std::span<const ObjectId> objects, int count,
                                       const RingAxis& axis, double degrees);

/// Makes one mirror image of each object in a plane of the document's space. Surfaces and facets of the
/// images are oriented outward. The source is reflected in a plane of its own space (`mirrored_source`), the
/// rest is taken up by the placement. Errors: E_NO_OBJECTS, E_NO_MIRROR_IMAGE (pictures and objects of an
/// unknown kind), E_TRANSFORM_INVALID, and those of `duplicate_objects`.
Result<AddedObjects> mirrored_copies(const Document& document, std::span<const ObjectId> objects,
                                     const MirrorPlane& plane);

/// An object and the box, along the document's axes, of what is seen of it.
struct SizedObject {
  ObjectId id;
  Eigen::AlignedBox3d box;
};

enum class BoxSide { minimum, centre, maximum };

/// Moves objects along an axis until this side of their boxes lies where that of the object `fixed`, which is
/// one of them (asserted), lies. Objects that lie there already stay untouched. Errors: E_FEW_OBJECTS (less
/// than two), E_OBJECT_EXTENT (an empty box), E_UNKNOWN_OBJECT, E_LOCKED, E_TRANSFORM_INVALID. O(n log n).
Result<Document> align_objects(const Document& document, std::span<const SizedObject> objects, ObjectId fixed,
                               Axis axis, BoxSide side);

/// Moves objects along an axis until the gaps between their boxes are equal. The order is that of the
/// centres of the boxes; the first and the last stay. Where there is no room the gaps are negative: equal
/// overlaps. Errors: E_FEW_OBJECTS (less than three), and as above. O(n log n).
Result<Document> distribute_objects(const Document& document, std::span<const SizedObject> objects,
                                    Axis axis);

}  // namespace hariko
