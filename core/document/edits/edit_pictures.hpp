#pragma once

// Edits of reference pictures: their look, placement and file.

#include <filesystem>
#include <map>

#include "core/document/document.hpp"
#include "core/document/edits/edit_objects.hpp"

namespace hariko {

/// Appends a picture. Errors: those of `add_object` and `check_picture`, E_PICTURES_TOO_LARGE.
Result<Added> add_picture(const Document& document, std::string name, PictureSource picture,
                          const Similarity& transform);

/// Sets the look of a picture, even of a locked one. Errors: E_UNKNOWN_OBJECT, E_WRONG_KIND,
/// E_PICTURE_INVALID.
Result<Document> set_picture_look(const Document& document, ObjectId object, const PictureLook& look);

/// Rotates a picture about its centre until a view from this side sees it upright; one that faces the view
/// already keeps its rotation. The restriction of a picture to views from one side changes with it. Errors:
/// E_UNKNOWN_OBJECT, E_WRONG_KIND, E_LOCKED.
Result<Document> face_picture(const Document& document, ObjectId object, PictureSide side);

/// Scales a picture about `a` so that the distance of `b`, another point of the document's space, from `a`
/// becomes `length`. Errors: E_UNKNOWN_OBJECT, E_WRONG_KIND, E_LOCKED, E_PICTURE_INVALID where the points
/// coincide or the length is not greater than zero, E_TRANSFORM_INVALID.
Result<Document> scale_picture(const Document& document, ObjectId object, const Vector3& a, const Vector3& b,
                               double length);

/// File of a picture: its path, its bytes if packed, and its size in pixels.
struct PictureFile {
  std::string path;
  Shared<std::string> bytes;  ///< empty: linked
  std::uint32_t columns = 1, rows = 1;
};
/// Sets the file of a picture, even of a locked one, and keeps the width. Errors: E_UNKNOWN_OBJECT,
/// E_WRONG_KIND, E_PICTURE_INVALID, E_PICTURES_TOO_LARGE.
Result<Document> set_picture_file(const Document& document, ObjectId object, const PictureFile& file);

/// Total bytes of packed pictures, each counted as often as a file contains it.
std::size_t packed_picture_bytes(const Document& document);
/// Checks the total size of packed pictures: E_PICTURES_TOO_LARGE above `max_packed_pictures`.
Result<Done> check_packed_pictures(const Document& document);

/// Converts the paths of linked pictures to relative ones for a file in this (absolute) folder, or back to
/// absolute ones. Paths that are relative (absolute) already stay. Documents without linked pictures are
/// returned unchanged. Of a relative path that no file can hold, as a folder's name is no UTF-8, the
/// picture's name is left.
Document with_relative_pictures(const Document& document, const std::filesystem::path& folder);
Document with_absolute_pictures(const Document& document, const std::filesystem::path& folder);
/// Converts paths that no file can hold to relative ones for this folder, and leaves all others.
Document with_storable_pictures(const Document& document, const std::filesystem::path& folder);

}  // namespace hariko
