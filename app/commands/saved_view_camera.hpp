#pragma once

// Cameras of pictures and line drawings: from a side, or a saved view of the document.

#include <string>

#include "core/document/document.hpp"
#include "render/camera.hpp"

namespace hariko {

/// Camera of the saved view, or, where `saved` is empty, from the side with the box framed. Errors:
/// E_UNKNOWN_VIEW.
Result<Camera> camera_for(const Document& document, const std::string& saved, StandardView side,
                          const Box3& box, PixelSize size);

}  // namespace hariko
