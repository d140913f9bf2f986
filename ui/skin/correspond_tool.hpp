#pragma once

// CorrespondTool: strokes over the picture that say which points of neighbouring sections belong together.

#include <cstdint>
#include <set>

#include "core/skinning/edit/edit_correspondence.hpp"
#include "core/skinning/edit/stroke.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

/// What a stroke over a skin does, by what lies under it. Errors with a hint for a stroke that means nothing:
/// E_NO_GESTURE; else those of the edits. `hidden`: points that cannot be seen; lines neither begin nor end
/// there, and closed curves do not go round them.
Result<CorrespondenceEdit> gesture_edit(const Skin& skin, const SkinView& view, const Object& object,
                                        const Projector& projector, const Stroke& stroke, double pixel_scale,
                                        const std::set<std::uint32_t>& hidden = {});
inline constexpr Code e_no_gesture{"E_NO_GESTURE"};

/// Modal, for the active skin. Each stroke is one step.
std::unique_ptr<Tool> make_correspond_tool();

}  // namespace hariko
