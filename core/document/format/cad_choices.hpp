#pragma once

// Settings of the export of surfaces to STEP and IGES.

#include <numbers>

#include "core/base/text/enum_words.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// Accuracy of exported surfaces, see `grade_of`.
enum class CadQuality { light, balanced, fine };
template <>
inline constexpr auto enum_words<CadQuality> = all_words<CadQuality>({{CadQuality::light, "light"},
                                                                      {CadQuality::balanced, "balanced"},
                                                                      {CadQuality::fine, "fine"}});

/// Tolerances of a quality: the distance in millimetres, or as a fraction of the object's size where that is
/// larger, and the angle between faces in radians.
struct CadGrade {
  double millimetres, share, angle;
};
inline constexpr CadGrade grade_of(CadQuality quality) {
  constexpr double degree = std::numbers::pi / 180;
  return quality == CadQuality::light  ? CadGrade{0.05, 5e-4, 0.2 * degree}
         : quality == CadQuality::fine ? CadGrade{0.001, 1e-5, 0.02 * degree}
                                       : CadGrade{0.01, 1e-4, 0.1 * degree};
}

/// Export choices for STEP and IGES.
struct CadChoices {
  /// Largest distance between the surface and faces that cannot be exact, in the document's unit; 0: from the
  /// quality.
  double tolerance = 0;
  double angle = 0;  ///< between faces along smooth edges, radians; 0: from the quality
  CadQuality quality = CadQuality::balanced;
  bool exact = false;  ///< splines are written exactly even where a fit makes a smaller file
  /// Writes one CAD face for each four-sided face of a polyhedron, even where several make a smaller file.
  bool whole_faces = false;
  Unit unit = Unit::millimetre;  ///< unit of the file
  double scale = 1;              ///< factor of all lengths
  bool ap242 = false;            ///< newer STEP schema, AP242 instead of AP214
  bool to_zero = false;          ///< moves the middle of the box of all control points to zero

  friend bool operator==(const CadChoices&, const CadChoices&) = default;
};

}  // namespace hariko
