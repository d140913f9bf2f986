#pragma once

// What a designer does to the path of a skin, and to where sections lie on it. Sections are carried along by
// the path's frames: offsets from the path stay what they are in them.

#include <cstdint>
#include <span>

#include "core/skinning/skin_edit.hpp"

namespace hariko {

/// Puts the section at another place of the path, strictly between its neighbours. E_SECTION_ORDER where it
/// would pass one of them, E_SECTION_RANGE for the ends of an open path.
Result<SkinEdit> slide_section(const Skin& skin, std::uint32_t section, double v);

enum class PathCurve : std::uint8_t { path, second_rail };

struct MovedPathPoint {
  PathCurve curve = PathCurve::path;
  int point = 0;
  Vector3 position = Vector3::Zero();
};
/// Sections stay at their places v and are carried.
Result<SkinEdit> move_path_points(const Skin& skin, std::span<const MovedPathPoint> points);

/// One more point in the middle of a span; rails get it both, and need as many points as each other (E_RAIL).
/// Sections stay where they are in space, with rails they are carried; the path changes by `deviation`.
Result<SkinEdit> insert_path_point(const Skin& skin, int span);
/// A point in the middle of every span. The path stays exactly what it is.
Result<SkinEdit> refine_path(const Skin& skin);
/// The path goes through the points that are left. A section at an end of the path stays at its end.
/// E_PATH_SHORT where too few would be left.
Result<SkinEdit> delete_path_point(const Skin& skin, int point);
/// A corner of the path.
Result<SkinEdit> set_path_sharp(const Skin& skin, PathCurve curve, int point, bool sharp);

/// Closes an open path or opens a closed one. Closing adds a span from the last point to the first, or, where
/// these lie in one place, makes one point (and section) of them; sections are carried. Opening keeps the
/// part from the first section to the last one; what is beyond goes, with its links and merges. E_PATH_SHORT
/// where fewer than three points would be left, E_FEW_SECTIONS where fewer than two sections would.
Result<SkinEdit> set_path_closed(const Skin& skin, bool closed);

/// Cuts an open path to the part between its first and last section, through points at about the same
/// distances. What E_SECTION_RANGE offers.
Result<SkinEdit> trim_path(const Skin& skin);

}  // namespace hariko
