#pragma once

// What every mesh reader returns, the codes of its messages, and the limits it keeps.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/file_io.hpp"
#include "core/base/message.hpp"
#include "core/base/progress.hpp"
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
inline constexpr Code w_count_missing{"W_COUNT_MISSING"};  ///< the header promises nothing, but rows follow
inline constexpr Code w_end_missing{"W_END_MISSING"};      ///< the last word of a text is not there
// Indices out of range are E_INDEX_RANGE (validation.hpp), files above the limits E_LIMIT (file_io.hpp).

/// A mesh as a file describes it: positions finite, indices in range, nothing else checked (`validate` does
/// that).
struct ImportedMesh {
  PolygonMesh mesh;
  std::string name;  ///< printable UTF-8; empty when the file gives none
  std::vector<Message> warnings;
};

/// Sizes above which a reader gives E_LIMIT. Memory is bounded by them and by a small multiple of the file's
/// size. `cancel` makes it give E_CANCELLED within a row of the file.
struct ReadLimits {
  std::size_t vertices = 100'000'000;
  std::size_t corners = 400'000'000;  ///< also bounds the number of faces
  CancelToken cancel = {};
  Progress progress = {};

  /// For readers, once a row: `left` of `size` bytes are still to be read. E_CANCELLED, or nothing.
  std::optional<Message> row(std::size_t left, std::size_t size) const {
    progress.report(1 - static_cast<double>(left) / static_cast<double>(std::max<std::size_t>(size, 1)));
    if (!cancel.cancelled()) return {};
    return make_error(e_cancelled, "The import was cancelled.");
  }
};

}  // namespace hariko
