#pragma once

// Solids as they are drawn and picked inside of the surface round them.

#include <memory>
#include <set>

#include "core/document/source.hpp"
#include "render/display_polyhedron.hpp"

namespace hariko {

/// All solids of an object, and their images in its plane of symmetry, which have the ids of what they are
/// images of. Points carry the solid's id as that of a vertex, faces as that of a face; round
/// solids have faces to be picked by and few lines to be seen by.
std::shared_ptr<const DisplayPolyhedron> display_of(const SolidsSource& source);

/// The lines and faces of the solids with these ids, as elements of what `display_of` made.
Highlights highlights_of_solids(const DisplayPolyhedron& display, const std::set<VertexId>& ids);

}  // namespace hariko
