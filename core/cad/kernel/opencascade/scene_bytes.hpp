#pragma once

// What was read of a CAD file, as bytes from one process to its parent. Only for this folder.

#include <string>
#include <string_view>

#include "core/cad/kernel/read_cad_file.hpp"

namespace hariko {

std::string bytes_of(const Result<CadScene>& scene);
/// Of bytes that `bytes_of` made (asserted).
Result<CadScene> scene_of(std::string_view bytes);

}  // namespace hariko
