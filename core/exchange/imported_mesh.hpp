#pragma once

// Result, message codes and limits shared by all mesh readers.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/files/file_io.hpp"
#include "core/base/message.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/polyhedron/validation.hpp"

namespace hariko {

inline constexpr Code e_truncated{"E_TRUNCATED"};  ///< the file ends before its content is complete
/// File of a format, or a variant of one, that is not read or written.
inline constexpr Code e_format_unknown{"E_FORMAT_UNKNOWN"};
inline constexpr Code e_empty{"E_EMPTY"};  ///< a well-formed file without a single face
inline constexpr Code w_unknown_statement{"W_UNKNOWN_STATEMENT"};
inline constexpr Code w_trailing_data{"W_TRAILING_DATA"};
inline constexpr Code w_degenerate_triangles{"W_DEGENERATE_TRIANGLES"};
inline constexpr Code w_count_missing{"W_COUNT_MISSING"};  ///< the header gives no count, but rows follow
inline constexpr Code w_end_missing{"W_END_MISSING"};      ///< the last word of a text is missing
// Indices out of range are E_INDEX_RANGE (validation.hpp), files above the limits E_LIMIT (file_io.hpp).

/// Mesh as a file describes it: positions finite, indices in range, all else unchecked (`validate` checks
/// it).
struct ImportedMesh {
  PolygonMesh mesh;
  std::string name;  ///< printable UTF-8; empty where the file gives none
  std::vector<Message> warnings;
};

/// Limits of a reader, which returns E_LIMIT above them, and its cancellation. Memory is bounded by them and
/// by a small multiple of the file's size. Cancelling `cancel` makes it return E_CANCELLED within a row of
/// the file.
struct ReadLimits {
  std::size_t vertices = 100'000'000;
  std::size_t corners = 400'000'000;  ///< also bounds the number of faces
  CancelToken cancel = {};
  Progress progress = {};

  /// Reports progress; to be called by readers once per row, with `left` of `size` bytes still to be read.
  /// Returns E_CANCELLED or nothing.
  std::optional<Message> row(std::size_t left, std::size_t size) const {
    progress.report(1 - static_cast<double>(left) / static_cast<double>(std::max<std::size_t>(size, 1)));
    if (!cancel.cancelled()) return {};
    return make_error(e_cancelled, "The import was cancelled.");
  }
};

}  // namespace hariko
