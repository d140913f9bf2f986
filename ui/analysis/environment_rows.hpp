#pragma once

// Rows of the properties about the environment that the view shows.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// Draws the rows of the environment: which one, its file, its turn about z and its exposure. They change the
/// settings, not the document.
void environment_rows(PanelContext& context);

}  // namespace hariko
