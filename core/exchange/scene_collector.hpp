#pragma once

// SceneCollector: the meshes of a file that places them, within limits. Internal to core/exchange.

#include <cstdint>
#include <optional>
#include <string>

#include "core/exchange/imported_scene.hpp"
#include "core/exchange/placement.hpp"

namespace hariko {

/// Makes the inside of the faces their outside.
void turn_over(PolygonMesh& mesh);

/// A file may place one mesh many times, so what it describes can be much larger than the file. Beside the
/// limits of all readers, vertices and corners together are at most 4 for each byte read and 20 million: a
/// file without copies is always below that.
class SceneCollector {
 public:
  explicit SceneCollector(const ReadLimits& limits) : limits_(limits) {}

  /// Counts bytes that were read, unpacked.
  void add_bytes(std::uint64_t bytes) { bytes_ += bytes; }
  /// Counts what is about to be made; E_LIMIT where that is too much, E_CANCELLED.
  std::optional<Message> reserve(std::uint64_t vertices, std::uint64_t corners);
  /// Adds a mesh that was counted; one without faces is forgotten. Mirrored meshes are turned, so that their
  /// outside stays outside. Errors: E_PARSE where a position leaves the range of numbers.
  std::optional<Message> add(PolygonMesh mesh, const Placement& placement, std::string_view name);

  void note_degenerate(std::size_t count) { degenerate_ += count; }
  void warn(Message warning) { scene_.warnings.push_back(std::move(warning)); }
  /// E_EMPTY where no triangle was added.
  Result<ImportedScene> finish();

 private:
  const ReadLimits& limits_;
  ImportedScene scene_;
  std::uint64_t bytes_ = 0, vertices_ = 0, corners_ = 0;
  std::size_t degenerate_ = 0, flat_ = 0;
};

}  // namespace hariko
