#pragma once

// Container of glTF files: chunks of the binary form, and URIs of buffers. Internal to core/exchange.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

/// Kinds of chunks of the binary form.
inline constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

/// Sizes of the header of the binary form and of each chunk's header, bytes.
inline constexpr std::size_t glb_header_size = 12, glb_chunk_header_size = 8;

/// Chunks of a glTF file.
struct GltfChunks {
  std::string_view json;
  std::optional<std::string_view> binary;  ///< binary chunk; only the binary form has one, and not always
};

/// Whether the bytes begin with the magic number of the binary form.
bool looks_like_glb(std::string_view bytes);
/// Whether the bytes are a JSON object with an object "asset", which every description of glTF has. O(size).
bool looks_like_gltf_text(std::string_view bytes);

/// Splits the binary form into its chunks; other bytes are JSON as a whole. Borrows `bytes`. Errors:
/// E_TRUNCATED, E_PARSE, E_FORMAT_UNKNOWN for versions other than 2. O(chunks).
Result<GltfChunks> gltf_chunks(std::string_view bytes);

/// Content of a `data:` URI in base64 (RFC 2397), also with percent escapes; nothing for other URIs. Errors:
/// E_PARSE. O(size).
Result<std::optional<std::string>> data_of_uri(std::string_view uri);

/// Candidate paths for a relative URI, likeliest first: with percent signs decoded, as written, with slashes
/// for backslashes. At least one; all stay inside the file's folder. Errors: E_FILE_OPEN for URIs with a
/// scheme, absolute paths and those that leave the folder.
Result<std::vector<std::string>> buffer_paths(std::string_view uri);

}  // namespace hariko
