#pragma once

// Conversion of picture cameras to views of line drawings.

#include <optional>

#include "core/drawing/drawing_view.hpp"
#include "render/camera.hpp"
#include "render/scene.hpp"

namespace hariko {

/// View that shows, on a page of this size (> 0, in any unit), the same as the camera in a picture of this
/// shape. `shown`: bounding box of everything drawn, in the world.
DrawingView drawing_view(const Camera& camera, double width, double height, const Box3& shown,
                         const std::optional<SectionPlane>& section = {});

}  // namespace hariko
