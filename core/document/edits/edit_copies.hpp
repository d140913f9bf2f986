#pragma once

// Edits of live copies: one source at many places.

#include <span>

#include "core/document/edits/edit_objects.hpp"

namespace hariko {

inline constexpr Code e_no_live_copies{"E_NO_LIVE_COPIES"};

/// Whether an object can have live copies: pictures and objects of an unknown kind cannot.
bool can_have_copies(const Object& object);

/// Sets the live copies of an object; an empty list takes them away. Errors: E_UNKNOWN_OBJECT, E_LOCKED,
/// E_NO_LIVE_COPIES (the object cannot have any), E_COPIES_INVALID.
Result<Document> set_copies(const Document& document, ObjectId object, LiveCopies copies);

/// Repeats objects, with the live copies that they have, as one more array says, which is in the document's
/// space. An object that is given twice counts once. Errors: those of `set_copies`.
Result<Document> add_live_copies(const Document& document, std::span<const ObjectId> objects,
                                 const CopyArray& array);

}  // namespace hariko
