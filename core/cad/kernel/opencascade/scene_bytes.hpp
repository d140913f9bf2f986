#pragma once

// Serialisation of a CAD scene, to pass it from a child process to its parent. Private to this folder.

#include <string>
#include <string_view>

#include "core/cad/kernel/read_cad_file.hpp"

namespace hariko {

/// Bytes of a scene or of the error in its place. O(size).
std::string bytes_of(const Result<CadScene>& scene);
/// Inverse of `bytes_of` (asserted). O(size).
Result<CadScene> scene_of(std::string_view bytes);

}  // namespace hariko
