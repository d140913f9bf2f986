#pragma once

// Objects that can appear in pictures, measurements and files.

#include "core/document/document.hpp"

namespace hariko {

/// Whether the shape is facets, shown, measured and written as they are, without a smooth surface.
inline bool is_faceted(const Object& object) {
  return object.mesh() != nullptr;
}

/// Whether there is a shape to show, measure and export: a surface, or reference facets.
inline bool has_shape(const Object& object) {
  return object.has_surface() || is_faceted(object);
}

/// Whether its surface has a control mesh that can be written.
inline bool has_control_mesh(const Object& object) {
  return object.skin() != nullptr;
}

/// Whether this version of the program does not know its kind, and shows, measures and writes nothing of it.
inline bool is_unknown(const Object& object) {
  return std::holds_alternative<UnknownSource>(object.source);
}

}  // namespace hariko
