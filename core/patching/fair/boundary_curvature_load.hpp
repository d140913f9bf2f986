#pragma once

// Boundary bending of mode FAIR at rims where tangent planes are known (kuriyama.md section 6).

#include <span>
#include <vector>

#include "core/network/face_charts.hpp"
#include "core/network/network.hpp"
#include "core/network/shaping.hpp"
#include "core/patching/quartic/quartic_patch.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Clamped boundary edges: border half-edges, ascending, of triangles with both ends tagged smooth, where the
/// tangents at the ends are known and the tangent plane at the third vertex is: pins of kind tangents at all
/// three vertices, or pins of any kind with kept forms at both ends. These are the rims over outlines with
/// normals, with equal and with metric frames.
std::vector<Index> clamped_boundary_edges(const Polyhedron& polyhedron, const Shaping& shaping);

/// Load of a clamped rim: contribution of the bending across it to the right-hand side of mode FAIR, for z at
/// both ends of the half-edge. Length units.
struct BoundaryCurvatureLoad {
  Index half_edge = no_index;
  Vector3 at_origin = Vector3::Zero(), at_target = Vector3::Zero();
};

/// Height of a patch's chart over its rim, and the factor of the patch's term in the energy.
struct RimMeasure {
  double height = 0, factor = 1;
};
/// Measure of a clamped rim, from the chart of its face.
RimMeasure rim_measure(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index half_edge);

/// Computes the load of a rim. `base`: patches with all unknowns zero, whose split tangents give the
/// derivative across the rim.
BoundaryCurvatureLoad rim_bend(const HalfEdgeMesh& mesh, std::span<const Vector3> positions,
                               const Network& network, std::span<const QuarticPatch> base, Index half_edge,
                               const RimMeasure& measure);

}  // namespace hariko
