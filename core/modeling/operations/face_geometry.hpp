#pragma once

// Geometry of faces that operations share: directions in faces, and limits of sliding points.

#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Returns the vector scaled to length 1, or zero where it has no direction (zero, or not finite). Does not
/// overflow.
Vector3 direction_of(const Vector3& vector);

/// Unit normal of the face's mean plane; zero for polygons without area.
Vector3 face_normal(const Polyhedron& polyhedron, Index face);

/// Area-weighted mean of the faces' normals, of unit length: the direction in which a group of faces is
/// moved. Zero where the faces have no area or their normals cancel out.
Vector3 mean_normal(const Polyhedron& polyhedron, std::span<const Index> faces);

/// Unit vector in the mean plane of the half-edge's face, at right angles to the half-edge, into the face.
/// Zero where the face has no area or the edge no length.
Vector3 inward_direction(const Polyhedron& polyhedron, Index half_edge);

/// Shortest displacement of a corner that moves the lines through it by 1 along `a` and along `b` (unit
/// vectors, or zero for a line without a constraint). At acute corners the length is limited to ten times the
/// width.
Vector3 miter(const Vector3& a, const Vector3& b);

/// First face of `before` that `after` still has with the normal reversed; an invalid id when there is none.
/// Faces without area do not count. O(corners).
FaceId first_turned_face(const Polyhedron& before, const Polyhedron& after);

inline constexpr Code e_no_centre{"E_NO_CENTRE"};

/// Point from which all corners of the face are visible: the mean of the corners of a convex face, else the
/// centroid of the kernel of the polygon in its mean plane. Error: E_NO_CENTRE where the kernel has less than
/// 1e-6 of the face's area. O(corners squared).
Result<Vector3> star_centre(const Polyhedron& polyhedron, Index face);

/// Point that slides linearly with an amount: position + amount * rate.
struct Slide {
  Vector3 position;
  Vector3 rate;
};

/// Smallest amount at which the length of the edge between two sliding points, measured along its original
/// direction, becomes zero; infinity where that never happens or the edge has no length to begin with.
double collapse_amount(const Slide& a, const Slide& b);

}  // namespace hariko
