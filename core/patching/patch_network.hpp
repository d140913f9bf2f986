#pragma once

// Complete curve network of a surface: the polyhedron's edges and the split edges of its faces, and from it
// the boundary points of every patch and the right-hand sides of the G1 conditions.

#include <span>
#include <vector>

#include "core/network/network.hpp"
#include "core/patching/quartic/patch_constants.hpp"
#include "core/patching/quartic/quartic_patch.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// Split tangents and split points of a surface.
struct PatchNetwork {
  std::vector<Vector3> split_tangent;  ///< per half-edge: tangent at its origin along the corner's split edge
  std::vector<Vector3> centre;         ///< per face: split point O
  std::vector<Vector3> centre_tangent;  ///< per half-edge: tangent at O towards the half-edge's origin
};

/// Builder of one patch from its half-edge; keeps references to arrays that must outlive it.
class PatchBuilder {
 public:
  PatchBuilder(const HalfEdgeMesh& mesh, const PatchConstants& constants, std::span<const Vector3> positions,
               const Network& network, const PatchNetwork& split)
      : mesh_(mesh), constants_(constants), positions_(positions), network_(network), split_(split) {}

  /// Base patch. Boundary points by degree elevation (9); inner points are set to the right-hand sides R of
  /// their edge ends: the G1 condition a1 G_left + a2 G_right = R holds with them, since a1 + a2 = 1. On
  /// sharp edges, across which nothing is required, the edge's cubic point beside the corner takes their
  /// place.
  QuarticPatch base_patch(Index h) const;

  /// Right-hand side R of the edge h at its origin and at its target, as seen from face(h) (kuriyama.md
  /// section 4.2).
  Vector3 right_side_at_origin(Index h) const;
  Vector3 right_side_at_target(Index h) const;
  /// Right-hand side R of the split edge of corner h at the vertex and at O.
  Vector3 right_side_at_vertex(Index h) const;
  Vector3 right_side_at_centre(Index h) const;

 private:
  const HalfEdgeMesh& mesh_;
  const PatchConstants& constants_;
  std::span<const Vector3> positions_;
  const Network& network_;
  const PatchNetwork& split_;
};

/// Computes split tangents Tsp from the network's tangents (item 6 of kuriyama.md section 1, and section 2.3
/// for half-turn corners), for the given faces.
void fill_split_tangents(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                         const PatchConstants& constants, std::span<const Vector3> positions,
                         const Network& network, std::span<const Index> faces, PatchNetwork& out);

/// Computes split points and their tangents from the split curves alone, which get the least bending: modes
/// PAPER and TARGET (equations (6), (7)).
void fill_split_points(const HalfEdgeMesh& mesh, const FaceCharts& charts, std::span<const Vector3> positions,
                       std::span<const Index> faces, PatchNetwork& out);

}  // namespace hariko
