#pragma once

// Separating faces: as a copy, as a part of their own, or as an object of their own.

#include <span>
#include <string>

#include "core/base/result.hpp"
#include "core/document/document.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {

// Copied vertices and edges have the tensions, creases and tags of their originals, copied vertices also the
// pinned normals. Errors of all three functions: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT,
// E_WOULD_BE_NONMANIFOLD (faces that touch in one vertex only).

/// Copies the faces as a new part at the same place. Selects the copy.
Result<EditResult> duplicate_faces(const PolyhedronSource& source, std::span<const FaceId> faces);

/// Cuts the faces loose, so that they become a part of their own in the same object, with a border where they
/// were cut. The faces keep their ids, the cut vertices get new ones. Selects the faces. Error:
/// E_WRONG_SELECTION when nothing has to be cut.
Result<EditResult> separate_faces(const PolyhedronSource& source, std::span<const FaceId> faces);

/// Document after `detach_faces`, and the new object.
struct Detached {
  Document document;
  ObjectId object;  ///< after its original in order, with the same transform and display
};
/// Moves the faces to an object of their own; all elements keep their ids. Further errors: E_UNKNOWN_OBJECT,
/// E_LOCKED, E_WRONG_KIND, E_NO_FACES (all faces are given), E_TOO_MANY_OBJECTS.
Result<Detached> detach_faces(const Document& document, ObjectId object, std::span<const FaceId> faces);

}  // namespace hariko
