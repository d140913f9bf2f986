#pragma once

// NetworkSolid: a solid as corners about a centre of curvature, for the curve network (Ogasawara and Kobori;
// docs/envelope.md).

#include <vector>

#include "core/envelope/solid.hpp"

namespace hariko {

/// Corners about one centre of curvature; a capsule makes two of them. World points are centre + A u for
/// points u of the unit frame, in which the solid's centroid is 0 and its sizes are equal.
struct NetworkSolid {
  Index owner = 0;         ///< index of the authored solid
  double roundness = 0.5;  ///< roundness of its curves
  Vector3 centre = Vector3::Zero();
  Matrix3 to_world = Matrix3::Identity(), to_unit = Matrix3::Identity();
  std::vector<Vector3> unit_vertices;

  Vector3 world(const Vector3& unit) const { return centre + to_world * unit; }
};

/// Converts the solids, in their order, relative to `origin`, with the clearance. `input` passes
/// `check_envelope`.
std::vector<NetworkSolid> network_solids(const EnvelopeInput& input, const Vector3& origin);

/// Diagonal of the bounding box of all corners.
double network_size(const std::vector<NetworkSolid>& solids);

}  // namespace hariko
