#pragma once

// Objects that can appear in pictures, measurements and files.

#include "core/document/document.hpp"

namespace hariko {

/// Whether there is a shape to show, measure and export: a surface, or reference facets.
inline bool has_shape(const Object& object) {
  return object.has_surface() || object.mesh();
}

}  // namespace hariko
