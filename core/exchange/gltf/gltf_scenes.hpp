#pragma once

// Scenes of glTF files: which nodes belong to them. Internal to core/exchange.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "core/exchange/gltf/gltf_fields.hpp"

namespace hariko {

/// Number of the default scene: the one that the file names, else the first. Errors are noted in `fields`.
std::uint64_t gltf_default_scene(const nlohmann::json& root, GltfFields& fields);

/// Nodes of the default scene; without scenes, nodes that are not a child of another. Errors are noted in
/// `fields`; the result does not count then. O(nodes log nodes).
std::vector<std::uint64_t> gltf_roots(const nlohmann::json& root, GltfFields& fields);

/// Number of nodes with a mesh that other scenes have and the default one has not. Faulty scenes and nodes
/// count as empty. O(nodes log nodes).
std::size_t objects_of_other_scenes(const nlohmann::json& root, std::uint64_t default_scene);

}  // namespace hariko
