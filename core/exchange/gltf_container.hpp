#pragma once

// The bytes of glTF files: chunks of the binary form, and addresses of buffers. Internal to core/exchange.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

/// Bytes before the first chunk of the binary form, and before the content of each.
inline constexpr std::size_t glb_header_size = 12, glb_chunk_header_size = 8;

struct GltfChunks {
  std::string_view json;
  std::optional<std::string_view> binary;  ///< of the binary form only, and not always there
};

/// The binary form begins with its magic number.
bool looks_like_glb(std::string_view bytes);

/// Takes the binary form apart; anything else is JSON as a whole. Borrows `bytes`. Errors: E_TRUNCATED,
/// E_PARSE, E_FORMAT_UNKNOWN for other versions than 2.
Result<GltfChunks> gltf_chunks(std::string_view bytes);

/// The content of a `data:` address in base64 (RFC 2397); nothing for other addresses. Errors: E_PARSE.
Result<std::optional<std::string>> data_of_uri(std::string_view uri);

/// Paths that a relative address may mean, likeliest first: percent signs resolved, and as it is written. All
/// stay inside the file's folder; there is at least one. Errors: E_FILE_OPEN for addresses of other machines,
/// absolute paths and those that leave the folder.
Result<std::vector<std::string>> buffer_paths(std::string_view uri);

}  // namespace hariko
