#pragma once

// Edits of skins.

#include "core/document/document.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

inline constexpr Code e_not_a_skin{"E_NOT_A_SKIN"};

/// Replaces an object's skin. Its points are in the object's space. Errors: E_UNKNOWN_OBJECT, E_LOCKED,
/// E_NOT_A_SKIN.
Result<Document> set_skin(const Document& document, ObjectId object, const Skin& skin);

}  // namespace hariko
