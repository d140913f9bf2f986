#pragma once

#include "ui/widgets/panels.hpp"

namespace hariko {

/// A card about the crash of an earlier session with its report, below the cursor and `width` wide. Nothing
/// when there was none.
void draw_crash_offer(PanelContext& context, float width);

}  // namespace hariko
