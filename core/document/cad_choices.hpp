#pragma once

// How surfaces are written as STEP and IGES.

#include "core/document/document.hpp"

namespace hariko {

struct CadChoices {
  /// Between surface and faces that cannot be exact, in the document's unit; 0: 1e-5 of each object's
  /// diagonal.
  double tolerance = 0;
  Unit unit = Unit::millimetre;  ///< that the file is written in
  double scale = 1;              ///< of all lengths
  bool ap242 = false;            ///< the newer schema of STEP, instead of AP214

  friend bool operator==(const CadChoices&, const CadChoices&) = default;
};

}  // namespace hariko
