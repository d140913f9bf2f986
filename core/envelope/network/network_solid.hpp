#pragma once

// Solids as curves of the network see them: corners about a centre of curvature (Ogasawara and Kobori;
// docs/envelope.md).

#include <vector>

#include "core/envelope/solid.hpp"

namespace hariko {

/// One centre of curvature: a capsule makes two of them. World points are centre + A u for points u of the
/// unit frame, in which the solid's centroid is 0 and its sizes are equal.
struct NetworkSolid {
  Index owner = 0;         ///< number of the authored solid
  double roundness = 0.5;  ///< of the curves round it
  Vector3 centre = Vector3::Zero();
  Matrix3 to_world = Matrix3::Identity(), to_unit = Matrix3::Identity();
  std::vector<Vector3> unit_vertices;

  Vector3 world(const Vector3& unit) const { return centre + to_world * unit; }
};

/// In the order of the solids, relative to `origin`, with the clearance. `input` passes `check_envelope`.
std::vector<NetworkSolid> network_solids(const EnvelopeInput& input, const Vector3& origin);

/// Diagonal of the box of all corners.
double network_size(const std::vector<NetworkSolid>& solids);

}  // namespace hariko
