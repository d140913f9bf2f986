#pragma once

// SurfacePoint: where on a surface something was pointed at.

#include "core/document/document.hpp"

namespace hariko {

/// A point of a surface by its patch: it stays on the surface when that moves.
struct SurfacePoint {
  ObjectId object;
  Index patch = no_index;
  Vector2 parameter = Vector2::Zero();
  double value = 0;  ///< of the map at the display mesh; NaN when undefined or without a map
};

}  // namespace hariko
