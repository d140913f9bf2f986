#pragma once

// Polygons that are their own image in a plane through zero.

#include <optional>
#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// The plane is at right angles to `axis`.
struct CageMirror {
  Eigen::Index axis = 0;
  std::vector<Index> image;  ///< of each vertex; itself in the plane

  Vector3 reflected(Vector3 v) const {
    v[axis] = -v[axis];
    return v;
  }
  /// Both values of a vertex and its image, made images of each other to the last bit.
  Vector3 evened(const Vector3& own, const Vector3& of_image) const {
    return 0.5 * (own + reflected(of_image));
  }
};

/// Images of all vertices, each within `tolerance`, such that every loop has a loop as its image; nothing
/// where there are none. O(vertices^2).
std::optional<CageMirror> find_mirror(std::span<const Vector3> positions,
                                      std::span<const std::vector<Index>> loops, Eigen::Index axis,
                                      double tolerance);

/// Positions that are images of each other to the last bit.
void even(const CageMirror& mirror, std::span<Vector3> positions);

}  // namespace hariko
