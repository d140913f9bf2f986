#pragma once

// SceneCollector: placed meshes of a file, within limits. Internal to core/exchange.

#include <cstdint>
#include <optional>
#include <string>

#include "core/exchange/affine_map.hpp"
#include "core/exchange/imported_scene.hpp"

namespace hariko {

/// Reverses the orientation of all faces.
void turn_over(PolygonMesh& mesh);

/// Collects placed meshes. A file may place one mesh many times, so its content can be much larger than the
/// file. Besides the limits of all readers, vertices and corners together are at most 4 for each byte read
/// plus 20 million; a file without copies always stays below that.
class SceneCollector {
 public:
  explicit SceneCollector(const ReadLimits& limits) : limits_(limits) {}

  /// Counts bytes that were read, after unpacking.
  void add_bytes(std::uint64_t bytes) { bytes_ += bytes; }
  /// Counts vertices and corners before they are made. Errors: E_LIMIT, E_CANCELLED.
  std::optional<Message> reserve(std::uint64_t vertices, std::uint64_t corners);
  /// Adds a mesh that was counted; ignores one without faces. Mirrored meshes are turned over, so that their
  /// outside stays outside. More than `ImportedScene::max_parts` become one without a name. Errors: E_PARSE
  /// where a position overflows.
  std::optional<Message> add(PolygonMesh mesh, const AffineMap& placement, std::string_view name);

  /// Counts degenerate triangles that were left out, for one warning.
  void note_degenerate(std::size_t count) { degenerate_ += count; }
  void warn(Message warning) { scene_.warnings.push_back(std::move(warning)); }
  /// Collected scene; E_EMPTY where no triangle was added.
  Result<ImportedScene> finish();

 private:
  void join_all();

  const ReadLimits& limits_;
  ImportedScene scene_;
  std::uint64_t bytes_ = 0, vertices_ = 0, corners_ = 0;
  std::size_t degenerate_ = 0, flat_ = 0;
  std::size_t joined_ = 0;  ///< objects in the one part that all became; 0 while they are apart
};

}  // namespace hariko
