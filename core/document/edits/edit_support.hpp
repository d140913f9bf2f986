#pragma once

// Helpers of the edits: finding the object, checking it, and replacing it in a copy of the document.

#include <functional>
#include <string>

#include "core/document/document.hpp"
#include "core/document/edits/edit_objects.hpp"

namespace hariko::detail {

/// Errors E_UNKNOWN_OBJECT and E_LOCKED.
Message unknown_object(ObjectId id);
Message locked_object(const Object& object);

/// Name with a suffix, such as "Cup copy"; the name is cut at a character boundary where the result would be
/// too long.
std::string name_with(std::string name, std::string_view suffix);

/// Copy of the document in which `object` replaces the one with the same id.
Document with_object(const Document& document, Object object);

/// Calls `change` on a copy of the object; refuses locked objects if `unlocked_only`.
Result<Document> change_object(const Document& document, ObjectId id, bool unlocked_only,
                               const std::function<Result<Done>(Object&)>& change);

/// Checks of placement and display. Errors: E_TRANSFORM_INVALID, E_DISPLAY_INVALID.
Result<Similarity> checked_transform(const Similarity& transform);
Result<Done> check_display(const DisplaySettings& display);

}  // namespace hariko::detail
