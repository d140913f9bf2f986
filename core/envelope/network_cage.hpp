#pragma once

// The coarse polygons whose edges become the curves of the network: vertices of solids with their frames, and
// faces with their owners (docs/envelope.md, spec 3.1, 3.2).

#include <set>
#include <span>
#include <vector>

#include "core/envelope/cage_mirror.hpp"
#include "core/envelope/scene_symmetry.hpp"

namespace hariko {

struct CageVertex {
  Index solid = no_index;  ///< placed solid; none: in a valley between solids
  Index vertex = 0;  ///< of its unit vertices, none of a point on it that is none of them; in a valley a
                     ///< number that stays while the solids move
  NetworkVertexKey name = {};  ///< of what is none of a solid's unit vertices
  Vector3 position = Vector3::Zero();
  Vector3 unit = Vector3::Zero();     ///< place in the solid's unit frame, growth included
  Vector3 normal = Vector3::UnitZ();  ///< unit, of the tangent plane
  Vector3 radial = Vector3::UnitZ();  ///< unit, away from the centre of curvature
  bool guarded = false;               ///< the normal was turned and is not the solid's any more
  Vector3 outward = Vector3::Zero();  ///< unit, out of the valley; zero on solids

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
  std::optional<CageMirror> mirror = {};  ///< of a symmetric scene, where the cage is its own image
};

struct HullCageInput {
  std::span<const PlacedSolid> solids;
  std::span<const double> growth;  ///< sigma, one a solid
  double diagonal = 1;             ///< of the scene
  double detail = 0.09;
  double merge_angle = 40;                        ///< degrees
  const std::set<SolidVertex>* pinned = nullptr;  ///< never thinned
  const std::set<SolidVertex>* kept = nullptr;    ///< vertices of the last frame, preferred while dragging
  /// Added to places of vertices, in the solids' own axes; such vertices are never thinned. May be null.
  const FlatMap<NetworkVertexKey, Vector3>* offsets = nullptr;
  const SceneSymmetry* symmetry = nullptr;  ///< the cage is its own image then
};

/// Makes a cage of a symmetric scene its own image to the last bit, where its faces allow that.
void make_symmetric(NetworkCage& cage, const SceneSymmetry& symmetry, std::span<const PlacedSolid> solids,
                    double diagonal);

/// Thinned hull of the solids' vertices with pairs of triangles merged to quads. Closed, of genus 0. Faces
/// empty where all vertices lie in a plane.
NetworkCage hull_cage(const HullCageInput& input);

/// Name of a vertex that stays while solids move.
NetworkVertexKey key_of(const SolidVertex& vertex, std::span<const PlacedSolid> solids);
NetworkVertexKey key_of(const CageVertex& vertex, std::span<const PlacedSolid> solids);
/// The name that settings have for it: those of images go by the names of what they are images of.
NetworkVertexKey settings_key(NetworkVertexKey key);

/// Diagonal of the box of all vertices of the solids.
double scene_diagonal(std::span<const PlacedSolid> solids);

/// Normal of a loop by Newell's formula: unit, zero for a degenerate loop.
Vector3 newell_normal(std::span<const Index> loop, std::span<const CageVertex> vertices);

}  // namespace hariko
