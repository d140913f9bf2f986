#pragma once

// A bridge between two solids, for those who show it and change its waist.

#include "core/envelope/solid.hpp"

namespace hariko {

/// A curve of the network from one solid to another.
struct EnvelopeBridge {
  SolidPair solids;                    ///< ids; equal ones between a solid and its image
  Vector3 middle = Vector3::Zero();    ///< of the curve
  Vector3 outward = Vector3::UnitZ();  ///< unit, normal of the surface about there
  Vector3 way = Vector3::Zero();       ///< of the middle while the factor on the waist grows by one
};

}  // namespace hariko
