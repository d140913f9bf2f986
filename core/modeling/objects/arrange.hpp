#pragma once

// Arranging whole objects: copies in rows, around an axis, along a curve and behind a plane; common faces and
// equal gaps.

#include <optional>
#include <span>
#include <vector>

#include "core/document/edits/edit_copies.hpp"
#include "core/document/object_box.hpp"
#include "core/geometry/arc_length_curve.hpp"
#include "core/geometry/mirror_plane.hpp"

namespace hariko {

inline constexpr Code e_no_objects{"E_NO_OBJECTS"};
inline constexpr Code e_few_objects{"E_FEW_OBJECTS"};
inline constexpr Code e_array_count{"E_ARRAY_COUNT"};
inline constexpr Code e_array_step{"E_ARRAY_STEP"};
inline constexpr Code e_array_axis{"E_ARRAY_AXIS"};
inline constexpr Code e_array_angle{"E_ARRAY_ANGLE"};
inline constexpr Code e_array_spacing{"E_ARRAY_SPACING"};
inline constexpr Code e_array_offset{"E_ARRAY_OFFSET"};
inline constexpr Code e_curve_short{"E_CURVE_SHORT"};
inline constexpr Code e_no_mirror_image{"E_NO_MIRROR_IMAGE"};
inline constexpr Code e_object_extent{"E_OBJECT_EXTENT"};

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

/// The same rows and rings as arrays of live copies in the document's space (`add_live_copies`). Errors:
/// E_ARRAY_COUNT, E_ARRAY_STEP; E_ARRAY_COUNT, E_ARRAY_AXIS, E_ARRAY_ANGLE.
Result<CopyArray> row_of_copies(int count, const Vector3& step);
Result<CopyArray> ring_of_copies(int count, const RingAxis& axis, double degrees);

/// Turning of what stands along a curve: with the rotation-minimising frame, about the vertical with the
/// direction of the curve seen from above, or not at all.
enum class CurveTurning { with_curve, upright, none };

/// Places along a curve. The first is at the arc length `offset`, the others at equal arc lengths behind it:
/// as far as the curve's end, which is the last, or round a closed curve, on which the last is as far from
/// the first as the others are from each other.
struct CurveLayout {
  int count = least_places;            ///< number of places, where there is no spacing
  std::optional<double> spacing = {};  ///< arc length between places; as many as there is room for
  double offset = 0;                   ///< on closed curves any, on open ones 0 .. length
  CurveTurning turning = CurveTurning::with_curve;
  /// Point of the objects that comes to lie on the curve: the originals are moved by its way to the first
  /// place. Without it they stay where they are, and the copies stand to the curve as they do.
  std::optional<Vector3> carried = {};
};

/// Arc lengths of the places of a layout on a curve, ascending; on closed curves they may go beyond its
/// length. Errors: E_ARRAY_COUNT, E_ARRAY_SPACING (not above zero, not finite, or more than most_places fit),
/// E_ARRAY_OFFSET (below zero on an open curve, or not finite), E_CURVE_SHORT (no room for two places).
Result<std::vector<double>> ways_along(const ArcLengthCurve& curve, const CurveLayout& layout);

/// Copies objects so that there is one of each at every place, the original at the first. Copies are turned
/// against the original about its place as the curve is there against the first place. Where the curve is
/// vertical, upright ones have the direction of the place before. Errors: E_NO_OBJECTS, those of
/// `ways_along`, E_LOCKED (an original is to be moved), E_TRANSFORM_INVALID, and those of
/// `duplicate_objects`.
Result<AddedObjects> array_along_curve(const Document& document, std::span<const ObjectId> objects,
                                       const ArcLengthCurve& curve, const CurveLayout& layout);

/// The same places as live copies of the objects. Errors: E_NO_OBJECTS, those of `ways_along`, E_LOCKED,
/// E_TRANSFORM_INVALID, and those of `add_live_copies`.
Result<Document> live_copies_along_curve(const Document& document, std::span<const ObjectId> objects,
                                         const ArcLengthCurve& curve, const CurveLayout& layout);

/// The mirror image in a plane of the document's space as an array of live copies (`add_live_copies`).
CopyArray mirror_of_copies(const MirrorPlane& plane);

/// Makes objects of the live copies of objects, as `duplicate_objects` makes them, at the same places; the
/// originals stay at their own. Sources of mirror images are reflected as `mirrored_copies` reflects them.
/// The ids are those of the new objects. Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_NO_LIVE_COPIES (none of the
/// objects has any), E_TRANSFORM_INVALID, E_TOO_MANY_OBJECTS, and those of `mirrored_source`.
Result<AddedObjects> copies_to_objects(const Document& document, std::span<const ObjectId> objects);

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
