#pragma once

// What a designer can take hold of on a surface round solids.

#include <vector>

#include "core/envelope/solid.hpp"

namespace hariko {

/// A curve of the network from one solid to another, or a place on the bar between them.
struct EnvelopeBridge {
  SolidPair solids;                    ///< ids; equal ones between a solid and its image
  Vector3 middle = Vector3::Zero();    ///< of the curve, or the place
  Vector3 outward = Vector3::UnitZ();  ///< unit, normal of the surface about there
  Vector3 way = Vector3::Zero();       ///< of the middle while the factor on the waist grows by one
};

/// A vertex of the network.
struct EnvelopeVertex {
  NetworkVertexKey vertex;  ///< whose offset moves it: its own, or that of its image
  Vector3 position = Vector3::Zero();
  Vector3 outward = Vector3::UnitZ();  ///< unit, normal of the surface
  Matrix3 axes =
      Matrix3::Identity();  ///< orthonormal; the vertex moves by `axes` times what its offset changes by
};

/// A curve of the network.
struct EnvelopeCurve {
  NetworkEdgeKey curve;
  Vector3 middle = Vector3::Zero();
  Vector3 outward = Vector3::UnitZ();  ///< unit, normal of the surface about there
  Vector3 way = Vector3::Zero();  ///< of the middle while the factor on the tangents begins to grow by one
};

struct EnvelopeHandles {
  std::vector<EnvelopeBridge> bridges;
  std::vector<EnvelopeVertex> vertices;
  std::vector<EnvelopeCurve> curves;

  void move(const Vector3& shift) {
    for (EnvelopeBridge& bridge : bridges) bridge.middle += shift;
    for (EnvelopeVertex& vertex : vertices) vertex.position += shift;
    for (EnvelopeCurve& curve : curves) curve.middle += shift;
  }
};

}  // namespace hariko
