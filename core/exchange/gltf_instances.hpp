#pragma once

// Many places of one mesh (the extension EXT_mesh_gpu_instancing of glTF). Internal to core/exchange.

#include <optional>
#include <string>
#include <vector>

#include "core/exchange/gltf_buffers.hpp"
#include "core/exchange/placement.hpp"

namespace hariko {

/// The places of the instances below their node, of the object `EXT_mesh_gpu_instancing`. Nothing, noted,
/// where it is faulty.
std::optional<std::vector<Placement>> gltf_instances(const nlohmann::json& instances,
                                                     const std::string& place, GltfBuffers& buffers,
                                                     GltfFields& fields, SceneCollector& collector);

}  // namespace hariko
