#pragma once

// Text encodings of STEP and IGES files.

#include <string>
#include <string_view>

#include "core/base/text/decoded_text.hpp"

namespace hariko {

/// Encodes UTF-8 beyond ASCII by the control directives of ISO 10303-21 (\X2\....\X0\, \X4\........\X0\).
/// O(size).
std::string with_step_directives(std::string_view text);

/// Name with each character beyond ASCII replaced by '_', for IGES. O(size).
std::string ascii_name(std::string_view text);

}  // namespace hariko
