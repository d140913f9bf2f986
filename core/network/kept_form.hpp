#pragma once

// Kept forms: between the offsets that a vertex keeps along its edges and those of its basis vectors
// (kuriyama.md section 12.7).

#include <span>
#include <vector>

#include "core/network/shaping.hpp"
#include "core/network/vertex_frames.hpp"

namespace hariko {

/// One edge of a vertex's fan: the end of a half-edge that describes it (VertexFrames), and what it leads to.
struct FanEnd {
  Index end = no_index;
  Index other = no_index;
};
/// Counter-clockwise, in the order of the fan.
std::vector<FanEnd> fan_ends(const HalfEdgeMesh& mesh, Index v);

/// The directions of the edges of a fan: along the edge and square to the mean normal of the corners, to the
/// left, and that normal. Zero where an edge has no such direction.
std::vector<Matrix3> edge_directions(const Polyhedron& polyhedron, Index v, std::span<const FanEnd> fan);

/// Image of an end's unit vector under basis vectors.
Vector3 image_of_unit(const VertexFrames& frames, Index end, std::span<const Vector3> basis);

/// Sets the vertex's basis vectors (part of those of all) to the ones whose images of the unit vectors of the
/// edges come nearest to `images`; those of `ends` only. Leaves them as they are and gives false where the
/// edges do not determine them.
bool fit_basis(const VertexFrames& frames, Index v, std::span<const Index> ends,
               std::span<const Vector3> images, std::span<Vector3> basis);

/// Sets the vertex's part of `offset` (one a basis vector of all vertices) to what the form says.
void add_form_offset(const Polyhedron& polyhedron, const VertexFrames& frames, Index v, const KeptForm& form,
                     std::span<Vector3> offset);

/// The form of the vertex's image in a mirror, with the same names.
KeptForm reflected_form(KeptForm form);

}  // namespace hariko
