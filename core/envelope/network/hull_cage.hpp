#pragma once

// NetworkCage: the coarse polygons whose edges become the curves of the network; vertices with the frames of
// their solids, and faces with their owners (Ogasawara and Kobori; docs/envelope.md).

#include <span>
#include <vector>

#include "core/envelope/solid.hpp"

namespace hariko {

/// Solid as corners about one centre of curvature; a capsule makes two of them. World points are centre + A u
/// for points u of the unit frame, in which the solid's centroid is 0 and its sizes are equal.
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

struct CageVertex {
  Index solid = 0;  ///< index of the network solid
  Vector3 position = Vector3::Zero();
  Vector3 unit = Vector3::Zero();     ///< position in the solid's unit frame
  Vector3 normal = Vector3::UnitZ();  ///< unit normal of the tangent plane
  Vector3 radial = Vector3::UnitZ();  ///< unit vector away from the centre of curvature
  bool guarded = false;               ///< the normal was changed and no longer equals the solid's

  /// Tangent of an edge that leaves along the chord: its radial projection to the tangent plane, unit. A
  /// chord through the centre has no radial projection and is projected along the normal. Zero if the chord
  /// is normal to the plane.
  Vector3 tangent(const Vector3& chord) const;
};

struct CageFace {
  std::vector<Index> loop;  ///< counter-clockwise seen from outside
  Index solid = no_index;   ///< solid of all corners (a primitive part); no_index: an inserted part
};

/// Closed polygon mesh of the network.
struct NetworkCage {
  std::vector<CageVertex> vertices;
  std::vector<CageFace> faces;
};

/// Makes the cage: the thinned hull of the solids' corners with pairs of triangles merged to quads. Closed,
/// of genus 0. No faces where all corners are coplanar. `size`: size of the scene, a length.
NetworkCage hull_cage(std::span<const NetworkSolid> solids, double size);

}  // namespace hariko
