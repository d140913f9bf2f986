#pragma once

// Line drawings are seen by the cameras of pictures.

#include <optional>

#include "core/drawing/drawing_view.hpp"
#include "render/camera.hpp"
#include "render/scene.hpp"

namespace hariko {

/// What the camera sees, on a page of this size (> 0, in any unit): the same as in a picture of this shape.
/// `shown`: the box round all that is drawn, in the world.
DrawingView drawing_view(const Camera& camera, double width, double height, const Box3& shown,
                         const std::optional<SectionPlane>& section = {});

}  // namespace hariko
