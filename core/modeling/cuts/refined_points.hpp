#pragma once

// Points of a polyhedron where a refinement inserts new vertices.

#include <map>
#include <variant>

#include "core/base/ids.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// A point on an edge, at a fraction (0 .. 1, both excluded) of its length from its end with the smaller id.
struct EdgePoint {
  EdgeId edge;
  double share = 0.5;
};

/// A point of a face, relative to the polyhedron's origin.
struct FacePoint {
  FaceId face;
  Vector3 position = Vector3::Zero();
};

using RefinedPoint = std::variant<EdgePoint, FacePoint>;
using RefinedPoints = std::map<VertexId, RefinedPoint>;

}  // namespace hariko
