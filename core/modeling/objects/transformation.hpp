#pragma once

// Transformation: a translation, rotation or scaling of elements or of whole objects.

#include "core/base/result.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// Maps x to pivot + S R (x - pivot) + translation. A weight (0 .. 1) applies that fraction of the
/// translation, of the angle and of factor - 1.
struct Transformation {
  Vector3 translation = Vector3::Zero();
  Vector3 axis = Vector3::UnitZ();  ///< unit vector
  double degrees = 0;
  Matrix3 frame = Matrix3::Identity();  ///< orthonormal columns: the directions of the factors
  Vector3 factors = Vector3::Ones();

  /// Linear part S R. Quarter turns about coordinate axes are exact.
  Matrix3 linear(double weight = 1) const;
  Vector3 apply(const Vector3& point, const Vector3& pivot, double weight = 1) const;
  bool uniform() const { return factors.x() == factors.y() && factors.y() == factors.z(); }
  bool only_translates() const { return degrees == 0 && factors == Vector3::Ones(); }

  /// Returns the same change expressed in an object's space.
  Transformation in_space_of(const Similarity& object) const;
};

/// Transforms a whole object. Its placement takes up what a similarity can; factors that differ or mirror
/// change the source about the object's own axes, and mirrored polyhedra are reversed so that their faces
/// stay oriented outward; places of live copies go along (`mapped`). Errors: E_UNKNOWN_OBJECT, E_LOCKED,
/// E_TRANSFORM_INVALID, E_NONFINITE, E_WRONG_KIND (a source of unknown kind cannot be stretched).
Result<Document> transform_object(const Document& document, ObjectId object,
                                  const Transformation& transformation, const Vector3& pivot);

}  // namespace hariko
