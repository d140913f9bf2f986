#pragma once

// G2Target: what the target curvature of faces adds to the right-hand side (g2.md section 8).

#include <span>
#include <vector>

#include "core/g2/face_elements.hpp"

namespace hariko {

/// Contribution of a face's target to the right-hand side, and to its centre's coefficients; in the order of
/// the chart's places.
struct FaceTarget {
  std::vector<Vector3> load, centre;
};
using G2Target = std::vector<FaceTarget>;  ///< per face

/// Curvature to come near to, from a reference; at faces with a border or a crease from `at_sharp_edges`, if
/// it is given. For the elements as they are. O(faces).
G2Target curvature_target(const G2Layout& layout, const FaceElements& elements,
                          const FaceReferences& references, std::span<const Vector3> positions,
                          const FaceReferences* at_sharp_edges);

}  // namespace hariko
