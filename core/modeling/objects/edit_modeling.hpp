#pragma once

// Application of operations on polyhedra as edits of the document.

#include <functional>

#include "core/base/result.hpp"
#include "core/document/document.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {

/// Edited document, and the elements selected after the edit.
struct ModeledDocument {
  Document document;
  ElementSet selection;  ///< elements of the object
};

/// Applies an operation to the polyhedron of one object. An operation that gives an equal polyhedron gives an
/// equal document. Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_WRONG_KIND, and those of the operation.
Result<ModeledDocument> edit_polyhedron(
    const Document& document, ObjectId object,
    const std::function<Result<EditResult>(const PolyhedronSource&)>& operation);

}  // namespace hariko
