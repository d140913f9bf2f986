#pragma once

// Colours of single patches, by the patch map and for highlights.

#include <cstdint>
#include <vector>

#include "render/scene.hpp"

namespace hariko {

/// Four bytes for each patch of the object's mesh, which must exist: the colour in the patch map, black in
/// other maps; then the highlight: 0, 128 hovered, 255 selected. O(patches).
std::vector<std::uint8_t> patch_color_bytes(const SceneObject& object);

}  // namespace hariko
