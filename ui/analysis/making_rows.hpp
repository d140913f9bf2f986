#pragma once

// Rows of the properties about how a part is going to be made: what the shown map of making checks.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// Draws the rows of a map of making: pull, limit, reference. They are of the document, for all objects.
void making_rows(PanelContext& context, SurfaceMap map);

/// A sentence where the active object should show a map of making and cannot.
void missing_map_row(PanelContext& context);

}  // namespace hariko
