#pragma once

// How surfaces are written as STEP and IGES.

#include <numbers>

#include "core/document/document.hpp"

namespace hariko {

enum class CadQuality { light, balanced, fine };

/// Limits of a quality: the distance in millimetres, or as a share of an object's size where that is more,
/// and the angle between faces in radians.
struct CadGrade {
  double millimetres, share, angle;
};
inline constexpr CadGrade grade_of(CadQuality quality) {
  constexpr double degree = std::numbers::pi / 180;
  return quality == CadQuality::light  ? CadGrade{0.05, 5e-4, 0.2 * degree}
         : quality == CadQuality::fine ? CadGrade{0.001, 1e-5, 0.02 * degree}
                                       : CadGrade{0.01, 1e-4, 0.1 * degree};
}

struct CadChoices {
  /// Between surface and faces that cannot be exact, in the document's unit; 0: as the quality says.
  double tolerance = 0;
  double angle = 0;  ///< between faces along smooth edges, radians; 0: as the quality says
  CadQuality quality = CadQuality::balanced;
  bool exact = false;  ///< what is a spline stays it, also where a fit weighs less
  /// One CAD face for each face of a polyhedron that has four sides, also where several weigh less.
  bool whole_faces = false;
  Unit unit = Unit::millimetre;  ///< that the file is written in
  double scale = 1;              ///< of all lengths
  bool ap242 = false;            ///< the newer schema of STEP, instead of AP214

  friend bool operator==(const CadChoices&, const CadChoices&) = default;
};

}  // namespace hariko
