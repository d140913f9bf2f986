#pragma once

// A skin to begin with.

#include "core/base/result.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

/// Two arches across y at both ends of a straight path along x, all centred about zero: `length` apart,
/// `width` wide, `height` high at the first and half as high at the second; `points` control points each (3
/// or more). Pleated.
Skin arched_skin(double length, double width, double height, int points);

/// A pleated skin over two drawn sections: at the ends of an open path, at the beginning and the middle of a
/// closed one. Sections are turned to run the same way round. Errors: those of `plan_skin`.
Result<Skin> skin_between(const SubdivisionCurve& path, const SubdivisionCurve& first,
                          const SubdivisionCurve& last);

}  // namespace hariko
