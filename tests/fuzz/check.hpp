#pragma once

// Promises of every reader, whatever the bytes: checked by aborting, which libFuzzer reports.

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/write_mesh.hpp"

namespace hariko::fuzz {

inline void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

/// Messages are printable, carry a code and say something.
inline void check(const Message& message, Severity severity) {
  require(message.severity == severity, "severity");
  require(!message.code.name.empty() && !message.text.empty(), "message is empty");
  require(sanitized_utf8(message.text, 100'000) == message.text, "text is printable");
  require(sanitized_utf8(message.remedy, 100'000) == message.remedy, "remedy is printable");
}

/// A mesh has sound offsets, indices in range and finite positions, and its size is in proportion to the
/// file.
inline void check(const Result<ImportedMesh>& result, std::size_t bytes) {
  if (!result.ok()) return check(result.error(), Severity::error);
  const PolygonMesh& mesh = result->mesh;
  for (const Message& warning : result->warnings) check(warning, Severity::warning);
  require(sanitized_utf8(result->name, 100'000) == result->name, "name is printable");
  require(mesh.face_offsets.size() > 1 && mesh.face_offsets.front() == 0, "there are faces");
  require(mesh.face_offsets.back() == mesh.face_vertices.size(), "offsets end at the corners");
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    require(mesh.face_offsets[f] <= mesh.face_offsets[f + 1], "offsets ascend");
  for (const Index v : mesh.face_vertices) require(v < mesh.positions.size(), "indices are in range");
  for (const Vector3& p : mesh.positions) require(p.allFinite(), "positions are finite");
  // A byte of a strip is a triangle.
  require(mesh.positions.size() + mesh.face_vertices.size() + mesh.face_count() <= 4 * bytes,
          "size in proportion");
}

/// Reading back what is written gives the same mesh.
template <class Read, class Write>
void check_round_trip(const Result<ImportedMesh>& result, Read read, Write write) {
  if (!result.ok()) return;
  const NamedPolygons named[] = {{result->name, &result->mesh}};
  const Result<ImportedMesh> again = read(write(std::span<const NamedPolygons>(named)));
  require(again.ok(), "what is written can be read");
  require(again->mesh.positions == result->mesh.positions, "positions come back");
  require(again->mesh.face_offsets == result->mesh.face_offsets, "faces come back");
  require(again->mesh.face_vertices == result->mesh.face_vertices, "corners come back");
}

}  // namespace hariko::fuzz
