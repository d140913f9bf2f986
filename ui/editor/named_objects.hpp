#pragma once

// Objects by their names, as scripts call them.

#include <span>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_no_object_named{"E_NO_SUCH_OBJECT"};

/// Ids of all objects with these names: in the order of the names, those of one name in the order of the
/// document. Errors: E_NO_SUCH_OBJECT, with the nearest name. O(names * objects).
Result<std::vector<ObjectId>> objects_named(const Document& document, std::span<const std::string> names);

}  // namespace hariko
