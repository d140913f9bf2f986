#pragma once

// Fair measures: the coefficients of mode FAIR's energy, per patch and per edge (kuriyama.md sections 6 and
// 12.5).

#include <span>
#include <vector>

#include "core/network/network_system.hpp"
#include "core/patching/quartic/patch_constants.hpp"

namespace hariko {

/// Weights of the energy.
struct FairWeights {
  double curvature_jump = 10;  ///< mu
  double pair_distance = 10;   ///< lambda
  double tension = 2;          ///< kappa: membrane energy per unit of excess tension
};
/// Weights in use. In metric frames they have another scale: 0.5 and 2.5 correspond to 32 and 10 on a cube.
FairWeights fair_weights(Frames frames);

/// Triangle (0, p, q) in the chart of a face, by its scalar products p . p, p . q, q . q and its determinant.
struct ChartTriangle {
  double pp = 0, pq = 0, qq = 0, determinant = 0;
};
ChartTriangle regular_triangle(Index sides);  ///< triangle of the regular polygon with unit side

/// Coefficients of a patch and of its first split edge.
struct PatchMeasure {
  ChartTriangle triangle;
  double plate = 1, membrane = 0, pair = 0;           ///< factors of the patch's terms
  double split_jump = 0;                              ///< factor of the jump over its first split edge
  double c_centre = 0, c_split = 0, own_split = 0.5;  ///< constants of that split edge, as in PatchConstants
  Vector2 corner = Vector2::Zero();                   ///< p of the corner: Y = corner.y Ys + corner.x Yc
};
/// Coefficients of an edge.
struct EdgeMeasure {
  double jump = -1;               ///< factor of the jump across the edge; negative on sharp edges
  double c_start = 0, c_end = 0;  ///< constants of the G1 condition along the edge's half-edge
  double own = 0.5;               ///< weight of that half-edge's patch in the condition
};

/// Coefficients of the energy for all patches and edges.
struct FairMeasures {
  std::vector<PatchMeasure> patch;  ///< per half-edge
  std::vector<EdgeMeasure> edge;    ///< per edge; jump < 0 on sharp edges
};
/// Computes the coefficients from the frames and the tensions. O(half-edges).
FairMeasures fair_measures(const HalfEdgeMesh& mesh, const NetworkSystem& network,
                           const PatchConstants& constants, const FairWeights& weights);

}  // namespace hariko
