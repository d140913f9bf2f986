#pragma once

// Instances of a mesh (the glTF extension EXT_mesh_gpu_instancing). Internal to core/exchange.

#include <optional>
#include <string>
#include <vector>

#include "core/exchange/affine_map.hpp"
#include "core/exchange/gltf/gltf_buffers.hpp"

namespace hariko {

/// Placements of the instances relative to their node, read from the object `EXT_mesh_gpu_instancing`.
/// Nothing, with an error noted, where it is faulty. O(instances).
std::optional<std::vector<AffineMap>> gltf_instances(const nlohmann::json& instances,
                                                     const std::string& place, GltfBuffers& buffers,
                                                     GltfFields& fields, SceneCollector& collector);

}  // namespace hariko
