#pragma once

// EditResult: the result of an operation on a polyhedron, and the error codes of such operations.

#include "core/base/message.hpp"
#include "core/document/source.hpp"
#include "core/modeling/selection/element_set.hpp"

namespace hariko {

/// Error: no element that the operation could work on was given.
inline constexpr Code e_nothing_selected{"E_NOTHING_SELECTED"};
/// Error: the elements given do not fit the operation (an inner edge where a border is needed, ...).
inline constexpr Code e_wrong_selection{"E_WRONG_SELECTION"};
/// Error: the result would have an edge of three faces, or parts that touch in one vertex only.
inline constexpr Code e_would_be_nonmanifold{"E_WOULD_BE_NONMANIFOLD"};
/// Error: a number is not finite or out of the range that the operation can use.
inline constexpr Code e_bad_amount{"E_BAD_AMOUNT"};
/// Error: the result would have more elements than one operation may make.
inline constexpr Code e_too_many_elements{"E_TOO_MANY_ELEMENTS"};

/// Largest number of vertices or faces that one operation may make; a larger number is taken for a typing
/// error.
inline constexpr std::size_t max_new_elements = 4'000'000;

/// Polyhedron after an operation. Elements that the operation does not name keep id, place and shaping.
struct EditResult {
  PolyhedronSource source;
  ElementSet selection;  ///< elements to be selected after the operation
};

}  // namespace hariko
