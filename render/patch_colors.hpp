#pragma once

// Colours of single patches: the map of patches, and what is selected or under the pointer.

#include <cstdint>
#include <vector>

#include "render/scene.hpp"

namespace hariko {

/// Four bytes a patch of the object's mesh, which must be there: the colour in the map of patches, black in
/// others; then 0, 128 under the pointer, 255 selected. O(patches).
std::vector<std::uint8_t> patch_color_bytes(const SceneObject& object);

}  // namespace hariko
