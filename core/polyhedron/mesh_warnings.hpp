#pragma once

// Warnings of a manifold mesh, each with its element.

#include <span>
#include <vector>

#include "core/base/message.hpp"
#include "core/base/vector.hpp"
#include "core/polyhedron/element_names.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// All warnings of validation.hpp, in the order of the codes there. At most `limit` of each. Positions are
/// finite.
std::vector<Message> mesh_warnings(const HalfEdgeMesh& topology, std::span<const Vector3> positions,
                                   const ElementNames& names, std::size_t limit);

/// The warnings W_CONCAVE_FACE and W_SELF_CROSSING_FACE alone. O(corners log corners).
std::vector<Message> face_shape_warnings(const HalfEdgeMesh& topology, std::span<const Vector3> positions,
                                         const ElementNames& names, std::size_t limit);

/// Components (numbers of `HalfEdgeMesh::face_components`) that are closed and inside out: 1 for those, which
/// look inwards and are no cavities of others. O(faces), and O(n log n) where some look inwards and some
/// outwards.
std::vector<char> inside_out_components(const HalfEdgeMesh& topology, std::span<const Vector3> positions);

}  // namespace hariko
