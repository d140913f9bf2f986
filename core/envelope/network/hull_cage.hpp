#pragma once

// The coarse polygons whose edges become the curves of the network: vertices of solids with their frames, and
// faces with their owners (docs/envelope.md).

#include <span>
#include <vector>

#include "core/envelope/network/network_solid.hpp"

namespace hariko {

struct CageVertex {
  Index solid = 0;  ///< number of the network solid
  Vector3 position = Vector3::Zero();
  Vector3 unit = Vector3::Zero();     ///< place in the solid's unit frame
  Vector3 normal = Vector3::UnitZ();  ///< unit, of the tangent plane
  Vector3 radial = Vector3::UnitZ();  ///< unit, away from the centre of curvature
  bool guarded = false;               ///< the normal was turned and is not the solid's any more

  /// Tangent of an edge that leaves along the chord: radial projection to the tangent plane, unit.
  Vector3 tangent(const Vector3& chord) const;
};

struct CageFace {
  std::vector<Index> loop;  ///< counter-clockwise seen from outside
  Index solid = no_index;   ///< all corners are of this solid (a primitive part); none: an inserted part
};

struct NetworkCage {
  std::vector<CageVertex> vertices;
  std::vector<CageFace> faces;
};

/// Thinned hull of the solids' corners with pairs of triangles merged to quads. Closed, of genus 0. Faces
/// empty where all corners lie in a plane. `size`: that of the scene, a length.
NetworkCage hull_cage(std::span<const NetworkSolid> solids, double size);

}  // namespace hariko
