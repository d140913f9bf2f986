#pragma once

// TensionWeights: the weights of faces, curves and tangents in the energy of mode G2, from tensions and tags
// (g2.md section 5).

#include <vector>

#include "core/g2/faces/face_energy.hpp"
#include "core/network/network_system.hpp"

namespace hariko {

/// Weights of the energy's terms.
struct TensionWeights {
  std::vector<double> membrane;        ///< per face
  std::vector<double> over_reference;  ///< per face: share of bending measured over the reference
  std::vector<double> curve;           ///< per half-edge
  std::vector<double> tangent;         ///< per end (2 per half-edge)
};

/// Computes the weights from the tensions and tags of a network. O(half-edges).
TensionWeights tension_weights(const HalfEdgeMesh& mesh, const NetworkSystem& network,
                               const G2Weights& weights);

}  // namespace hariko
