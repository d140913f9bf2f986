#pragma once

// The dimensions of the document in the properties.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// A row for each dimension: its kind, its value, and buttons that copy the value and delete it. A click on
/// the value chooses the dimension. Draws nothing where there are none.
void dimension_section(PanelContext& context);

}  // namespace hariko
