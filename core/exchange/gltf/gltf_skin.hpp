#pragma once

// GltfSkin: skinning of a glTF mesh by joints. Internal to core/exchange.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/exchange/affine_map.hpp"
#include "core/exchange/gltf/gltf_buffers.hpp"

namespace hariko {

/// Joints of a skin, at rest; deforms the points of meshes by linear blend skinning.
class GltfSkin {
 public:
  /// `joints`: one map a joint, from the space of the mesh to the document's.
  explicit GltfSkin(std::vector<AffineMap> joints) : joints_(std::move(joints)) {}

  /// Whether the skin mirrors the mesh, so that its faces must be turned over.
  bool mirrors() const { return !joints_.empty() && joints_.front().mirrors(); }
  /// Moves the points of a primitive by the weighted mean of their joints' maps; weights are normalised to
  /// sum 1. False, with an error noted, where joints or weights are missing or a joint does not exist.
  /// O(points).
  bool bend(const nlohmann::json& attributes, const std::string& place, GltfBuffers& buffers,
            GltfFields& fields, std::vector<Vector3>& points) const;

 private:
  std::vector<AffineMap> joints_;
};

/// Skin with its joints in their nodes' rest positions; `places` has the placements of the scene's nodes.
/// Nothing, with an error noted, where it is faulty. O(joints).
std::optional<GltfSkin> gltf_skin(const nlohmann::json& skin, const std::string& place,
                                  const std::map<std::uint64_t, AffineMap>& places, GltfBuffers& buffers,
                                  GltfFields& fields, SceneCollector& collector);

}  // namespace hariko
