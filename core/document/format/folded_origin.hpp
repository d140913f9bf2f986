#pragma once

// Origins of solids, skins and outlines, which the place of their object carries: their positions stay near
// zero and keep their digits, wherever the object is.

#include "core/document/similarity.hpp"
#include "core/document/source.hpp"

namespace hariko {

/// Whether the object's place carries the origin of such a source: solids, skins and outlines.
bool origin_is_folded(const Source& source);

/// Place of an object whose positions are relative to `origin`: maps x to transform(origin + x).
Similarity with_origin(const Similarity& transform, const Vector3& origin);

/// Makes positions that are far from zero relative to a near origin, and returns it. Each coordinate of the
/// origin is zero unless it is more than 1024 times as large as the box round the positions, so that a model
/// that is not far away stays as it is, and no subtraction rounds. The axis of a plane of symmetry of solids
/// keeps zero; a skin's mirror plane moves along. Zero for all other kinds. O(positions).
Vector3 take_far_origin(Source& source);

}  // namespace hariko
