#pragma once

// Rows of the section curves in the panel of what is shown.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// The switch, and while it is on the planes and the combs.
void section_curve_rows(PanelContext& context);

}  // namespace hariko
