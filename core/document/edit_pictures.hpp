#pragma once

// Edits of reference pictures: how they show, where they lie, what file they come from.

#include <filesystem>
#include <map>

#include "core/document/document.hpp"
#include "core/document/edit_objects.hpp"

namespace hariko {

/// Appends a picture. Errors: those of `add_object` and `check_picture`, E_PICTURES_TOO_LARGE.
Result<Added> add_picture(const Document& document, std::string name, PictureSource picture,
                          const Similarity& transform);

/// Locked pictures, too. Errors: E_UNKNOWN_OBJECT, E_WRONG_KIND, E_PICTURE_INVALID.
Result<Document> set_picture_look(const Document& document, ObjectId object, const PictureLook& look);

/// Turns a picture about its middle until a view from this side sees it upright; one that the view faces
/// already keeps its turn. A picture that is shown only from one side follows. Errors: E_UNKNOWN_OBJECT,
/// E_WRONG_KIND, E_LOCKED.
Result<Document> face_picture(const Document& document, ObjectId object, PictureSide side);

/// Scales a picture about `a` so that `b`, another point of the document's space, comes to be `length` away
/// from it. Errors: E_UNKNOWN_OBJECT, E_WRONG_KIND, E_LOCKED, E_PICTURE_INVALID where the points coincide or
/// the length is not above zero, E_TRANSFORM_INVALID.
Result<Document> scale_picture(const Document& document, ObjectId object, const Vector3& a, const Vector3& b,
                               double length);

/// The file that a picture comes from, or its bytes. Locked pictures, too, as nothing moves.
struct PictureFile {
  std::string path;
  Shared<std::string> bytes;  ///< empty: linked
  std::uint32_t columns = 1, rows = 1;
};
/// Keeps the width. Errors: E_UNKNOWN_OBJECT, E_WRONG_KIND, E_PICTURE_INVALID, E_PICTURES_TOO_LARGE.
Result<Document> set_picture_file(const Document& document, ObjectId object, const PictureFile& file);

/// Bytes of packed pictures, each counted as often as a file holds it.
std::size_t packed_picture_bytes(const Document& document);
/// E_PICTURES_TOO_LARGE above `max_packed_pictures`.
Result<Done> check_packed_pictures(const Document& document);

/// The document with paths of linked pictures as a file in this (absolute) folder has them, and back. Paths
/// that are relative (absolute) already stay. Documents without linked pictures come back as they are.
Document with_relative_pictures(const Document& document, const std::filesystem::path& folder);
Document with_absolute_pictures(const Document& document, const std::filesystem::path& folder);

}  // namespace hariko
