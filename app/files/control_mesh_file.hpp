#pragma once

// Export of the control meshes of skins, for programs that subdivide themselves.

#include <filesystem>

#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_no_skin{"E_NO_SKIN"};

/// Writes the control meshes of all visible skins to one OBJ file, with creases and corners (see
/// `write_control_obj`), in the document's space. Errors: those of skinning (with the object's name) and of
/// writing; E_NO_SKIN where there is nothing to write.
Result<Done> export_control_meshes(const Document& document, const std::filesystem::path& path);

}  // namespace hariko
