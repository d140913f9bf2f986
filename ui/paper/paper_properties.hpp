#pragma once

// The settings of the paper model, while the paper view is shown.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// Rows of the properties panel: numbers, size, page, folds; what is wrong, with what can be done.
void draw_paper_properties(PanelContext& context);

}  // namespace hariko
