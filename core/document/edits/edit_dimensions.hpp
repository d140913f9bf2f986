#pragma once

// Edits of dimensions, and which of them have lost what they measured.

#include <span>
#include <vector>

#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_unknown_dimension{"E_UNKNOWN_DIMENSION"};
inline constexpr Code e_dimension_invalid{"E_DIMENSION_INVALID"};
inline constexpr Code e_too_many_dimensions{"E_TOO_MANY_DIMENSIONS"};

/// A document and the dimension that the edit made.
struct AddedDimension {
  Document document;
  DimensionId id;
};

/// Appends a dimension under a new id (`next_dimension_id`). Locked and hidden objects can be measured.
/// Errors: E_DIMENSION_INVALID (see `Dimension`), E_UNKNOWN_OBJECT, E_UNKNOWN_ELEMENT (an anchor names what
/// is not there), E_TOO_MANY_DIMENSIONS. O(dimensions).
Result<AddedDimension> add_dimension(const Document& document, DimensionKind kind,
                                     std::vector<Anchor> anchors, const Vector3& label = Vector3::Zero());

/// Removes dimensions. Errors: E_UNKNOWN_DIMENSION.
Result<Document> remove_dimensions(const Document& document, std::span<const DimensionId> ids);

/// Moves the label of a dimension (`Dimension::label`). Errors: E_UNKNOWN_DIMENSION, E_DIMENSION_INVALID (not
/// finite).
Result<Document> move_dimension_label(const Document& document, DimensionId id, const Vector3& label);

/// Dimension with this id; null where there is none. O(dimensions).
const Dimension* find_dimension(const Document& document, DimensionId id);

/// Whether what an anchor names is there. Patches that are made anew with each surface count as there.
/// O(objects).
bool anchor_exists(const Document& document, const Anchor& anchor);

/// Dimensions with an anchor that does not exist any more, in their order. O(dimensions x objects).
std::vector<DimensionId> lost_dimensions(const Document& document);

/// Dimensions of `before` that are not in `after` because what they measured is gone. O(dimensions x
/// objects).
std::vector<DimensionId> dimensions_that_went(const Document& before, const Document& after);

/// Message E_TOO_MANY_DIMENSIONS.
Message too_many_dimensions();

/// Returns the document without the dimensions that name any of these objects.
Document without_dimensions_of(const Document& document, std::span<const ObjectId> objects);

}  // namespace hariko
