#pragma once

// Joining several polyhedron objects into one.

#include <span>

#include "core/base/result.hpp"
#include "core/document/document.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {

/// Adds `added` as further parts to `base`. `to_base` takes points of `added`'s space to `base`'s. The added
/// elements get ids after all others, in order; pins are rotated and scaled with their vertices. Selects the
/// added faces. Errors: E_NONFINITE, E_TOO_MANY_ELEMENTS.
Result<EditResult> join(const PolyhedronSource& base, const PolyhedronSource& added,
                        const Similarity& to_base);

/// Joins all given objects into the first one. They stay where they are in the document's space, with their
/// live copies, which become parts; the others are removed. Live mirrors are applied first, because their
/// planes would not be those of the joined object. Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_WRONG_KIND,
/// E_WRONG_SELECTION (fewer than two objects), and those of `baked` and `join`.
Result<Document> join_objects(const Document& document, std::span<const ObjectId> objects);

}  // namespace hariko
