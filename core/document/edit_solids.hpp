#pragma once

// Edits of the solids of an object and of the settings of the surface round them.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/document/document.hpp"

namespace hariko {

/// Settings of new solids: the borders of the patches round them, which no designer drew, are not shown.
DisplaySettings solids_display();

inline constexpr Code e_not_solids{"E_NOT_SOLIDS"};
inline constexpr Code e_last_solid{"E_LAST_SOLID"};

/// Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_NOT_SOLIDS, and those of `check_envelope` for the result.
Result<Document> change_envelope(const Document& document, ObjectId object,
                                 const std::function<void(EnvelopeInput&)>& change);

/// Changes each of the solids with these ids; ids that the object does not have are passed over. Errors as
/// above.
Result<Document> change_solids(const Document& document, ObjectId object, std::span<const std::uint32_t> ids,
                               const std::function<void(Solid&)>& change);

/// The id that a new solid gets: one more than the largest.
std::uint32_t next_solid_id(const EnvelopeInput& input);

/// Appends a solid under `next_solid_id`. Errors as above.
Result<Document> add_solid(const Document& document, ObjectId object, Solid solid);

/// Appends `copies` copies of each of the solids, each by `step` farther than the last (in the object's
/// axes). `added` gets the ids of the copies, copy by copy. A copied bridge is one between the copies of its
/// solids, where these are copied with it. Errors as above.
Result<Document> array_solids(const Document& document, ObjectId object, std::span<const std::uint32_t> ids,
                              int copies, const Vector3& step, std::vector<std::uint32_t>& added);

/// Errors as above; E_LAST_SOLID when none would be left.
Result<Document> remove_solids(const Document& document, ObjectId object, std::span<const std::uint32_t> ids);

/// The solid with this id, or null.
const Solid* find_solid(const Object& object, std::uint32_t id);

}  // namespace hariko
