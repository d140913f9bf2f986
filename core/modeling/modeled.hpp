#pragma once

// Modeled: what an operation on a polyhedron gives, and the codes that operations refuse with.

#include "core/base/message.hpp"
#include "core/document/source.hpp"
#include "core/modeling/element_set.hpp"

namespace hariko {

/// Nothing that the operation could work on was given.
inline constexpr Code e_nothing_selected{"E_NOTHING_SELECTED"};
/// The elements given do not fit the operation (an inner edge where a border is needed, ...).
inline constexpr Code e_wrong_selection{"E_WRONG_SELECTION"};
/// The result would have an edge of three faces, or parts that touch in one vertex only.
inline constexpr Code e_would_be_nonmanifold{"E_WOULD_BE_NONMANIFOLD"};
/// A number given is not finite or out of the range that the operation can use.
inline constexpr Code e_bad_amount{"E_BAD_AMOUNT"};
/// The result would have more elements than a polyhedron may get from one operation.
inline constexpr Code e_too_many_elements{"E_TOO_MANY_ELEMENTS"};

/// One operation may make this many new vertices or faces; more is a slip of the hand.
inline constexpr std::size_t max_new_elements = 4'000'000;

/// The polyhedron after an operation. What the operation does not name keeps its id, place and shaping.
struct Modeled {
  PolyhedronSource source;
  ElementSet selection;  ///< what the designer goes on with
};

}  // namespace hariko
