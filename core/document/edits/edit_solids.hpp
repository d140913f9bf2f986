#pragma once

// Edits of the solids of an object and of the settings of their envelope surface.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/document/document.hpp"

namespace hariko {

/// Display of new solids: the patch borders of the envelope are hidden, because no designer drew them.
DisplaySettings solids_display();

inline constexpr Code e_not_solids{"E_NOT_SOLIDS"};
inline constexpr Code e_last_solid{"E_LAST_SOLID"};

/// Changes solids and settings by `change`. Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_NOT_SOLIDS, and those of
/// `check_envelope` for the result.
Result<Document> change_envelope(const Document& document, ObjectId object,
                                 const std::function<void(EnvelopeInput&)>& change);

/// Changes each of the solids with these ids; ids that the object does not have are ignored. Errors as for
/// `change_envelope`.
Result<Document> change_solids(const Document& document, ObjectId object, std::span<const std::uint32_t> ids,
                               const std::function<void(Solid&)>& change);

/// Id of the next new solid: one more than the largest.
std::uint32_t next_solid_id(const EnvelopeInput& input);

/// Appends a solid under `next_solid_id`. Errors as for `change_envelope`.
Result<Document> add_solid(const Document& document, ObjectId object, Solid solid);

/// Appends `copies` copies of each of the solids, each displaced by `step` from the last (in the object's
/// axes). `added` gets the ids of the copies, copy by copy. A copied bridge joins the copies of its solids,
/// where these are copied too. Errors as for `change_envelope`.
Result<Document> array_solids(const Document& document, ObjectId object, std::span<const std::uint32_t> ids,
                              int copies, const Vector3& step, std::vector<std::uint32_t>& added);

/// Removes solids. Errors as for `change_envelope`; E_LAST_SOLID when none would be left.
Result<Document> remove_solids(const Document& document, ObjectId object, std::span<const std::uint32_t> ids);

/// Solid with this id, or null.
const Solid* find_solid(const Object& object, std::uint32_t id);

}  // namespace hariko
