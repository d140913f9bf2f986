#pragma once

// Construction of two rails for a skin with a single path.

#include "core/skinning/edit/skin_edit.hpp"

namespace hariko {

/// Makes the skin use frames between two rails (`FrameMode::two_rail`). Without a second rail, both rails are
/// made from the skin: they are the curves along which the virtual surface takes the first and the last
/// points of the sections, with as many points as the path has, or a multiple where there are more sections.
/// Ends of sections then move onto the rails, by at most `deviation`. Errors: E_RAIL where sections are
/// closed or are single points, those of `plan_skin`.
Result<SkinEdit> make_rails(const Skin& skin);

}  // namespace hariko
