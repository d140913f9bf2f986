#pragma once

// What joined sides give to a surface of mode G2 (g2.md section 11).

#include <vector>

#include "core/g2/given_sides.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/join_plan.hpp"

namespace hariko {

/// Per half-edge; empty where nothing is joined.
std::vector<GivenRibbon> given_ribbons(const JoinPlan& plan);

/// The sides' curves and, with G1, the cross derivatives r1 = -lambda/f 3C(t) + l(t) r0'(t), linear in l,
/// that the plan's solution makes of the network: lambda c + l d of kuriyama.md section 8.
std::vector<GivenSide> given_sides(const JoinPlan& plan, const JoinPlan::Solution& joined,
                                   const VertexFrames& frames, const PatchConstants& constants,
                                   const Network& network);

}  // namespace hariko
