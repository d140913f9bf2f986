#pragma once

// Two rails for a skin that has one path.

#include "core/skinning/skin_edit.hpp"

namespace hariko {

/// Frames between two rails (`FrameMode::two_rail`). Where there is no second rail both come from the skin:
/// they are the curves along which the virtual surface takes the first and the last points of the sections,
/// with as many points as the path has, or a multiple where there are more sections. Ends of sections then
/// move onto the rails, by at most `deviation`. Errors: E_RAIL where sections are closed or are points, those
/// of `plan_skin`.
Result<SkinEdit> make_rails(const Skin& skin);

}  // namespace hariko
