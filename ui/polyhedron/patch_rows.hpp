#pragma once

// The properties of an object of Bezier patches.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// How many patches there are, of which degree, and what makes them editable. Draws nothing for other
/// objects.
void patch_section(PanelContext& context, const Object& object);

}  // namespace hariko
