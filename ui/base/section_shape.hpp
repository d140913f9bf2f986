#pragma once

// Shapes to begin a section with.

#include "core/subdivision/subdivision_curve.hpp"

namespace hariko {

enum class SectionShape { circle, ellipse, rectangle };

/// Points that the closed curve of a shape goes through, and its corners, about the origin of a plane whose
/// axes are the first two columns of `axes`. `half`: half its width and height, both above zero; a circle has
/// the first one only.
struct ShapePoints {
  std::vector<Vector3> points;
  std::vector<char> sharp;
};
ShapePoints shape_points(SectionShape shape, const Vector3& middle, const Matrix3& axes, const Vector2& half);

}  // namespace hariko
