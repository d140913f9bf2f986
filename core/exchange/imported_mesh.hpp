#pragma once

// What every mesh reader returns, the codes of its messages, and the limits it keeps.

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/file_io.hpp"
#include "core/base/message.hpp"
#include "core/base/result.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {

inline constexpr Code e_truncated{"E_TRUNCATED"};  ///< the file ends before what it promises
inline constexpr Code e_format_unknown{
    "E_FORMAT_UNKNOWN"};                   ///< not a format, or a variant, that is read or written
inline constexpr Code e_empty{"E_EMPTY"};  ///< a well-formed file without a single face
inline constexpr Code w_unknown_statement{"W_UNKNOWN_STATEMENT"};
inline constexpr Code w_trailing_data{"W_TRAILING_DATA"};
inline constexpr Code w_degenerate_triangles{"W_DEGENERATE_TRIANGLES"};
// Indices out of range are E_INDEX_RANGE (validation.hpp), files above the limits E_LIMIT (file_io.hpp).

/// A mesh as a file describes it: positions finite, indices in range, nothing else checked (`validate` does
/// that).
struct ImportedMesh {
  PolygonMesh mesh;
  std::string name;  ///< printable UTF-8; empty when the file gives none
  std::vector<Message> warnings;
};

/// Sizes above which a reader gives E_LIMIT. Memory is bounded by them and by a small multiple of the file's
/// size.
struct ReadLimits {
  std::size_t vertices = 100'000'000;
  std::size_t corners = 400'000'000;  ///< also bounds the number of faces
};

}  // namespace hariko
