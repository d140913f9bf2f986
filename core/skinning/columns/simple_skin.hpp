#pragma once

// Skins to start from.

#include "core/base/result.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

/// Pleated skin of two arches across y at both ends of a straight path along x, centred at the origin:
/// `length` apart, `width` wide, `height` high at the first and half as high at the second; `points` control
/// points each (3 or more).
Skin arched_skin(double length, double width, double height, int points);

/// Pleated skin over two drawn sections: at the ends of an open path, at the beginning and the middle of a
/// closed one. Sections are reversed where needed so that both have the same direction. Errors: those of
/// `plan_skin`.
Result<Skin> skin_between(const SubdivisionCurve& path, const SubdivisionCurve& first,
                          const SubdivisionCurve& last);

}  // namespace hariko
