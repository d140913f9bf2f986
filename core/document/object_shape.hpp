#pragma once

// Objects that go into pictures, measures and files.

#include "core/document/document.hpp"

namespace hariko {

/// There is something to show, measure and export: a surface, or reference facets.
inline bool has_shape(const Object& object) {
  return object.has_surface() || object.mesh();
}

}  // namespace hariko
