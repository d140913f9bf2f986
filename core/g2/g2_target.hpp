#pragma once

// G2Target: the contribution of target curvatures to the right-hand side (g2.md section 8).

#include <span>
#include <vector>

#include "core/g2/faces/face_elements.hpp"

namespace hariko {

/// Contribution of a face's target to the right-hand side, and to its centre's coefficients; in the order of
/// the chart's places.
struct FaceTarget {
  std::vector<Vector3> load, centre;
};
using G2Target = std::vector<FaceTarget>;  ///< per face

/// Target curvatures from a reference surface; for faces with a border or a crease from `at_sharp_edges`, if
/// given. Uses the elements in their present state. O(faces).
G2Target curvature_target(const G2Layout& layout, const FaceElements& elements,
                          const FaceReferences& references, std::span<const Vector3> positions,
                          const FaceReferences* at_sharp_edges);

}  // namespace hariko
