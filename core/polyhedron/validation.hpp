#pragma once

// Validation of polygon meshes: every error and warning with its element named (kuriyama.md section 5).

#include <vector>

#include "core/base/ids.hpp"
#include "core/base/message.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

inline constexpr Code e_nonfinite{"E_NONFINITE"};
inline constexpr Code e_no_faces{"E_NO_FACES"};
inline constexpr Code e_index_range{"E_INDEX_RANGE"};
inline constexpr Code e_face_too_small{"E_FACE_TOO_SMALL"};
inline constexpr Code e_face_repeated_vertex{"E_FACE_REPEATED_VERTEX"};
inline constexpr Code e_edge_nonmanifold_or_flipped{"E_EDGE_NONMANIFOLD_OR_FLIPPED"};
inline constexpr Code e_vertex_nonmanifold{"E_VERTEX_NONMANIFOLD"};
inline constexpr Code w_isolated_vertex{"W_ISOLATED_VERTEX"};
inline constexpr Code w_inside_out{"W_INSIDE_OUT"};
inline constexpr Code w_duplicate_vertex{"W_DUPLICATE_VERTEX"};
inline constexpr Code w_zero_edge{"W_ZERO_EDGE"};
inline constexpr Code w_concave_face{"W_CONCAVE_FACE"};
inline constexpr Code w_self_crossing_face{"W_SELF_CROSSING_FACE"};
inline constexpr Code w_valence_2{"W_VALENCE_2"};

/// Errors and warnings of a mesh; elements are dense indices. At most `limit` messages of each code; the last
/// one then says how many more there are. Warnings need a mesh without errors. Typically O(corners log
/// corners).
///
/// Errors come first, in the order of the codes above, then warnings in theirs. The first error is the one
/// that Polyhedron::build returns. Lengths that count as zero (W_DUPLICATE_VERTEX, W_ZERO_EDGE) are up to
/// 1e-12 of the diagonal of the bounding box of all used vertices. W_DUPLICATE_VERTEX is about vertices on
/// borders, where a weld may close something. W_INSIDE_OUT names the first face of a closed part that looks
/// inwards and is no cavity of another one.
std::vector<Message> validate(const PolygonMesh& mesh, std::size_t limit = 100);

/// Warnings of a polyhedron, with its stable ids.
std::vector<Message> warnings_of(const Polyhedron& polyhedron, std::size_t limit = 100);
/// The warnings W_CONCAVE_FACE and W_SELF_CROSSING_FACE alone.
std::vector<Message> face_shape_warnings_of(const Polyhedron& polyhedron, std::size_t limit = 100);

}  // namespace hariko
