#pragma once

// Promises of readers of formats with several objects.

#include "core/exchange/imported_scene.hpp"
#include "tests/fuzz/check.hpp"

namespace hariko::fuzz {

/// So that copies of one mesh end before they take long.
inline ReadLimits small_limits() {
  ReadLimits limits{.vertices = 20'000, .corners = 60'000};
  return limits;
}

/// `triangles`: of formats that have no other faces.
inline void check(const Result<ImportedScene>& result, bool triangles = true) {
  if (!result.ok()) return check(result.error(), Severity::error);
  for (const Message& warning : result->warnings) check(warning, Severity::warning);
  require(
      !(result->parts.empty() && result->patches.empty()) && result->parts.size() <= ImportedScene::max_parts,
      "there are parts");
  std::size_t vertices = 0, corners = 0;
  for (const ImportedPart& part : result->parts) {
    const PolygonMesh& mesh = part.mesh;
    require(sanitized_utf8(part.name, 100'000) == part.name, "name is printable");
    require(mesh.face_count() > 0 && mesh.face_offsets.front() == 0, "there are faces");
    require(mesh.face_offsets.back() == mesh.face_vertices.size(), "offsets end at the corners");
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
      require((!triangles || mesh.face(f).size() == 3) && mesh.face_offsets[f] <= mesh.face_offsets[f + 1],
              "triangles");
    for (const Index v : mesh.face_vertices) require(v < mesh.positions.size(), "indices are in range");
    for (const Vector3& p : mesh.positions) require(p.allFinite(), "positions are finite");
    for (const auto& [a, b] : part.creases)
      require(std::max(a, b) < mesh.positions.size(), "creases are in range");
    for (const Index v : part.corners) require(v < mesh.positions.size(), "corners are in range");
    vertices += mesh.positions.size();
    corners += mesh.face_vertices.size();
  }
  require(vertices <= small_limits().vertices && corners <= small_limits().corners, "limits are kept");
}

}  // namespace hariko::fuzz
