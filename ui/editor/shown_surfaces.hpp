#pragma once

// The surfaces that the viewport shows, for what looks at them without drawing them.

#include <vector>

#include "render/scene.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// Meshes and transforms of all objects whose surface is shown and is that of the document.
std::vector<SceneObject> shown_surfaces(const Editor& editor);

}  // namespace hariko
