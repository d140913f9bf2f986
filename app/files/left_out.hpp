#pragma once

// Visible objects that cannot go into a file or a picture: said and counted, never left out in silence.

#include <vector>

#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code w_not_written{"W_NOT_WRITTEN"};

/// One warning W_NOT_WRITTEN each, which counts and names objects, or none. Of triangles and pictures:
/// objects of kinds that this version does not know.
std::vector<Message> left_out_of_triangles(const Document& document);

/// For STEP and IGES: also reference facets, which are no smooth faces.
std::vector<Message> left_out_of_cad(const Document& document);

/// For control meshes: all but skins.
std::vector<Message> left_out_of_control_meshes(const Document& document);

/// The visible objects of reference facets, which no CAD file holds.
std::size_t visible_reference_objects(const Document& document);

}  // namespace hariko
