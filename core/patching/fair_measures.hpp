#pragma once

// Fair measures: what the energy of mode FAIR depends on, patch by patch and edge by edge (kuriyama.md
// sections 6 and 12.5).

#include <span>
#include <vector>

#include "core/network/network_system.hpp"
#include "core/patching/patch_constants.hpp"

namespace hariko {

/// Weights of the energy.
struct FairWeights {
  double curvature_jump = 10;  ///< mu
  double pair_distance = 10;   ///< lambda
  double tension = 2;          ///< kappa: membrane energy per unit of excess tension
};
/// The weights in use. In frames by measure they belong to another scale: 0.5 and 2.5 stand for 32 and 10 on
/// a cube.
FairWeights fair_weights(Frames frames);

/// The triangle (0, p, q) in the chart of a face by its scalar products p . p, p . q, q . q and its
/// determinant.
struct ChartTriangle {
  double pp = 0, pq = 0, qq = 0, determinant = 0;
};
ChartTriangle regular_triangle(Index sides);  ///< of the regular polygon with unit side

struct PatchMeasure {
  ChartTriangle triangle;
  double plate = 1, membrane = 0, pair = 0;           ///< factors of the patch's terms
  double split_jump = 0;                              ///< factor of the jump over its first split edge
  double c_centre = 0, c_split = 0, own_split = 0.5;  ///< of that split edge, as in PatchConstants
  Vector2 corner = Vector2::Zero();                   ///< Y = corner.y Ys + corner.x Yc
};
struct EdgeMeasure {
  double jump = -1;               ///< factor of the jump over the edge; negative on sharp edges
  double c_start = 0, c_end = 0;  ///< along the edge's half-edge
  double own = 0.5;               ///< weight of that half-edge's patch in the condition
};

struct FairMeasures {
  std::vector<PatchMeasure> patch;  ///< per half-edge
  std::vector<EdgeMeasure> edge;    ///< per edge; nothing at sharp ones
};
FairMeasures fair_measures(const HalfEdgeMesh& mesh, const NetworkSystem& network,
                           const PatchConstants& constants, const FairWeights& weights);

}  // namespace hariko
