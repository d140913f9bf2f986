#pragma once

// Samples as cards with pictures, on the start page and in a dialog.

#include "ui/panels/panels.hpp"

namespace hariko {

/// Rows of `columns` cards below the cursor, from `left` (window coordinates) and `width` wide. True when one
/// was chosen, which then opens.
bool draw_samples(PanelContext& context, float left, float width, int columns);

}  // namespace hariko
