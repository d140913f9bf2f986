#pragma once

// GltfSkin: the joints that bend a mesh of a glTF file. Internal to core/exchange.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/exchange/gltf_buffers.hpp"
#include "core/exchange/placement.hpp"

namespace hariko {

class GltfSkin {
 public:
  /// `joints`: from the space of the mesh to the document's, one a joint.
  explicit GltfSkin(std::vector<Placement> joints) : joints_(std::move(joints)) {}

  /// The mesh comes out with its inside outside.
  bool mirrors() const { return !joints_.empty() && joints_.front().mirrors(); }
  /// Moves the points of a primitive to where the joints carry them, by their weights, whose sum counts as
  /// 1. False, noted, where joints or weights are missing or name no joint. O(points).
  bool bend(const nlohmann::json& attributes, const std::string& place, GltfBuffers& buffers,
            GltfFields& fields, std::vector<Vector3>& points) const;

 private:
  std::vector<Placement> joints_;
};

/// The skin with its joints as their nodes stand; `places` has the nodes of the scene. Nothing, noted, where
/// it is faulty.
std::optional<GltfSkin> gltf_skin(const nlohmann::json& skin, const std::string& place,
                                  const std::map<std::uint64_t, Placement>& places, GltfBuffers& buffers,
                                  GltfFields& fields, SceneCollector& collector);

}  // namespace hariko
