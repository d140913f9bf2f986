#pragma once

// Edits of a skin's path and of the places of sections on it. Sections move with the path's frames: their
// offsets from the path, in the frames' coordinates, stay the same.

#include <cstdint>
#include <span>

#include "core/skinning/edit/skin_edit.hpp"

namespace hariko {

/// Moves the section to another place of the path, strictly between its neighbours. Errors: E_SECTION_ORDER
/// where it would pass one of them, E_SECTION_RANGE for the ends of an open path.
Result<SkinEdit> slide_section(const Skin& skin, std::uint32_t section, double v);

enum class PathCurve : std::uint8_t { path, second_rail };

/// Move of one control point of the path or of the second rail.
struct MovedPathPoint {
  PathCurve curve = PathCurve::path;
  int point = 0;
  Vector3 position = Vector3::Zero();
};
/// Moves control points. Sections keep their places v and move with the path.
Result<SkinEdit> move_path_points(const Skin& skin, std::span<const MovedPathPoint> points);

/// Inserts a control point in the middle of a span; with two rails in both, which need equal numbers of
/// points (E_RAIL). Sections stay where they are in space, or with two rails move with these; the path
/// changes by `deviation`.
Result<SkinEdit> insert_path_point(const Skin& skin, int span);
/// Inserts a control point in the middle of every span. The path stays exactly the same.
Result<SkinEdit> refine_path(const Skin& skin);
/// Deletes a control point; the path then passes through the remaining points. A section at an end of the
/// path stays at its end. Error: E_PATH_SHORT where too few would be left.
Result<SkinEdit> delete_path_point(const Skin& skin, int point);
/// Makes a control point of the path or rail a corner, or smooth again.
Result<SkinEdit> set_path_sharp(const Skin& skin, PathCurve curve, int point, bool sharp);

/// Closes an open path or opens a closed one. Closing adds a span from the last point to the first, or, where
/// these coincide, joins them (and the sections there); sections move with the path. Opening keeps the part
/// from the first section to the last one; the rest is removed with its links and merges. Errors:
/// E_PATH_SHORT where fewer than three points would be left, E_FEW_SECTIONS where fewer than two sections
/// would.
Result<SkinEdit> set_path_closed(const Skin& skin, bool closed);

/// Cuts an open path to the part between its first and last section, through points at about the same
/// distances. Remedy that E_SECTION_RANGE offers.
Result<SkinEdit> trim_path(const Skin& skin);

}  // namespace hariko
