#pragma once

// Warnings about what cannot go into a file, a picture or another document, so that nothing is omitted
// silently.

#include <optional>
#include <vector>

#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code w_not_written{"W_NOT_WRITTEN"};
inline constexpr Code w_not_imported{"W_NOT_IMPORTED"};

/// Warnings for triangle files and pictures about objects of kinds that this version does not know. Each
/// W_NOT_WRITTEN counts and names the objects of one kind; none where all are written.
std::vector<Message> left_out_of_triangles(const Document& document);

/// Warnings for STEP and IGES; these also omit reference facets, which are no smooth faces.
std::vector<Message> left_out_of_cad(const Document& document);

/// Warnings for control meshes, which only skins have.
std::vector<Message> left_out_of_control_meshes(const Document& document);

/// W_NOT_IMPORTED for a document that is imported into another one: its paper model stays behind.
std::optional<Message> left_out_of_import(const Document& document);

/// Number of visible objects of reference facets, which no CAD file holds.
std::size_t visible_reference_objects(const Document& document);

}  // namespace hariko
