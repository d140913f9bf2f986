#pragma once

// Marks over the picture of a mesh.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// A ring where the shown error is the largest, and, where four pictures are compared, what this one shows.
void draw_mesh_overlay(const PanelContext& context, const Camera& camera, PixelSize size,
                       const PanelRect& pane, std::size_t view);

}  // namespace hariko
