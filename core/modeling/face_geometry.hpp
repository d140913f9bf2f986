#pragma once

// The little geometry that operations share: directions in faces, and how far points can slide.

#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// The vector at length 1, or zero where it has no direction (zero, or not finite). No overflow.
Vector3 direction_of(const Vector3& vector);

/// Unit normal of the mean plane; zero for polygons without area.
Vector3 face_normal(const Polyhedron& polyhedron, Index face);

/// Mean of the faces' normals, each weighted with its area: the direction in which faces go together. Zero
/// where the faces have no area or cancel out.
Vector3 mean_normal(const Polyhedron& polyhedron, std::span<const Index> faces);

/// Unit vector in the mean plane of the half-edge's face, at right angles to the half-edge, into the face.
/// Zero where the face has no area or the edge no length.
Vector3 inward_direction(const Polyhedron& polyhedron, Index half_edge);

/// The shortest displacement of a corner that moves the lines through it by 1 along `a` and along `b` (unit
/// vectors, or zero for no demand). Sharp spikes are limited to ten times the width.
Vector3 miter(const Vector3& a, const Vector3& b);

/// The first face of `before` that `after` still has, but turned over; the id of no face when there is none.
/// Faces without area do not count. O(corners).
FaceId first_turned_face(const Polyhedron& before, const Polyhedron& after);

inline constexpr Code e_no_centre{"E_NO_CENTRE"};

/// A point from which all corners of the face are seen: the mean of the corners of convex faces, else the
/// centroid of all such points (the kernel of the polygon in its mean plane). Error: E_NO_CENTRE where there
/// is none. O(corners squared).
Result<Vector3> star_centre(const Polyhedron& polyhedron, Index face);

/// A point that slides with an amount: position + amount * rate.
struct Slide {
  Vector3 position;
  Vector3 rate;
};

/// The least amount at which the edge between two sliding points has no length left in its own direction;
/// infinity where it never shrinks that far or has no length to begin with.
double collapse_amount(const Slide& a, const Slide& b);

}  // namespace hariko
