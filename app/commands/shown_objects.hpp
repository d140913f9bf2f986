#pragma once

// Objects that `hariko render` draws, as pictures or lines, and its camera. Internal to app/commands.

#include <optional>
#include <string>
#include <vector>

#include "app/commands/commands.hpp"
#include "core/document/document.hpp"
#include "render/camera.hpp"

namespace hariko {

/// Object of a picture, with its surface.
struct ShownObject {
  SceneObject part;
  Surface surface;
};

/// Visible surfaces and reference facets; reports errors and returns nothing where one cannot be made, or
/// there is none.
std::optional<std::vector<ShownObject>> shown_objects_or_report(const Document& document,
                                                                const RenderArguments& arguments);

/// Camera of the saved view, or, where `saved` is empty, from the side with the box framed. Errors:
/// E_UNKNOWN_VIEW.
Result<Camera> camera_for(const Document& document, const std::string& saved, StandardView side,
                          const Box3& box, PixelSize size);

}  // namespace hariko
