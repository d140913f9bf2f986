#pragma once

// Adjacency of a polyhedron's surface: seams, nodes and provenance from connectivity alone.

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/network/vertex_frames.hpp"
#include "core/patching/quartic/quartic_patch.hpp"
#include "core/polyhedron/element_aliases.hpp"
#include "core/polyhedron/polyhedron.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Parts of a Surface other than geometry. Patch h is the one at half-edge h. Nodes: the vertices that have
/// faces, in order, then the split points of the faces. Sources are named by `aliases` where given; a
/// mirrored copy runs around its face in the opposite direction, from the same corner. `smooth`: intended
/// continuity across edges that are not sharp.
Surface::Parts polyhedron_surface_parts(const Polyhedron& polyhedron, const VertexFrames& frames,
                                        const ElementAliases* aliases = nullptr,
                                        Continuity smooth = Continuity::g1);

/// Unit normal of a patch at corner 0 (split point) or 1 (vertex), zero if there is none.
using CornerNormal = std::function<Vector3(Index patch, int corner)>;
/// Corner normals of quartic patches; keeps a reference to them.
CornerNormal corner_normals(const QuarticPatchArray& patches);

/// Normals of the nodes' tangent planes, from the corner tangents of one patch each, since all lie in one
/// plane. Zero where they do not (creases, corners with several sectors).
std::vector<Vector3> node_normals(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                                  const Surface::Parts& parts, const CornerNormal& normal);

/// Updates the normals at the nodes of some patches only; other entries of `normals` stay.
void update_node_normals(const HalfEdgeMesh& mesh, const VertexFrames& frames, const Surface::Parts& parts,
                         const CornerNormal& normal, std::span<const Index> changed,
                         std::vector<Vector3>& normals);

}  // namespace hariko
