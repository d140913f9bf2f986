#pragma once

// Scenes of glTF files: which nodes belong to them. Internal to core/exchange.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "core/exchange/gltf/gltf_fields.hpp"

namespace hariko {

/// Scene that is read.
struct GltfScene {
  std::optional<std::uint64_t> number;  ///< nothing: all nodes
  bool instead = false;                 ///< the default scene has no objects
};

/// The default scene, which is the one that the file names, else the first. Where no node with a mesh belongs
/// to it, the first scene with one; where no scene has one, or there is none, all nodes. Faulty scenes and
/// nodes count as empty. Errors are noted in `fields`. O(nodes log nodes).
GltfScene gltf_scene(const nlohmann::json& root, GltfFields& fields);

/// Nodes of a scene; of all nodes those that are not a child of another. Errors are noted in `fields`; the
/// result does not count then. O(nodes log nodes).
std::vector<std::uint64_t> gltf_roots(const nlohmann::json& root, const GltfScene& scene, GltfFields& fields);

/// Numbers of nodes with a mesh that a scene does not have.
struct GltfLeftOut {
  std::size_t in_others = 0;  ///< nodes that other scenes have
  std::size_t in_none = 0;    ///< nodes that no scene has
};
/// Counts the nodes that are left out where a scene is read. Faulty scenes and nodes count as empty. O(nodes
/// log nodes).
GltfLeftOut objects_left_out(const nlohmann::json& root, const GltfScene& scene);

}  // namespace hariko
