#pragma once

// Taking faces apart from the rest: as a copy, as a part of their own, or as an object of their own.

#include <span>
#include <string>

#include "core/base/result.hpp"
#include "core/document/document.hpp"
#include "core/modeling/modeled.hpp"

namespace hariko {

// Copied vertices and edges have the tensions, creases and tags of their originals, copied vertices the
// pinned normals, too. Errors of all: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_WOULD_BE_NONMANIFOLD (faces
// that hang together in one vertex only).

/// A copy of the faces as a new part at the same place. Selects it.
Result<Modeled> duplicate_faces(const PolyhedronSource& source, std::span<const FaceId> faces);

/// Cuts the faces loose: a part of its own in the same object, its border where it was cut. The faces keep
/// their ids, the cut vertices get new ones. Selects the faces. E_WRONG_SELECTION when nothing has to be cut.
Result<Modeled> separate_faces(const PolyhedronSource& source, std::span<const FaceId> faces);

struct Detached {
  Document document;
  ObjectId object;  ///< the new one, after its original in order, with the same transform and display
};
/// Moves the faces to an object of their own; all elements keep their ids. Errors moreover: E_UNKNOWN_OBJECT,
/// E_LOCKED, E_WRONG_KIND, E_NO_FACES (all faces are given), E_TOO_MANY_OBJECTS.
Result<Detached> detach_faces(const Document& document, ObjectId object, std::span<const FaceId> faces);

}  // namespace hariko
