#pragma once

// Boundary data of joined sides for a surface of mode G2 (g2.md section 11).

#include <vector>

#include "core/g2/prescribed_ribbons.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/joins/join_plan.hpp"

namespace hariko {

/// Prescribed ribbons, per half-edge; empty where nothing is joined.
std::vector<PrescribedRibbon> given_ribbons(const JoinPlan& plan);

/// Boundary data of the sides: their curves and, with G1, the cross derivatives r1 = -lambda/f 3C(t) + l(t)
/// r0'(t), with l linear, by the plan's solution: lambda c + l d of kuriyama.md section 8.
std::vector<GivenSide> given_sides(const JoinPlan& plan, const JoinPlan::Solution& joined,
                                   const VertexFrames& frames, const PatchConstants& constants,
                                   const Network& network);

}  // namespace hariko
