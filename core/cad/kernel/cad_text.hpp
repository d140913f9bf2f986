#pragma once

// What can be seen of STEP and IGES files before the kernel reads them: whether they are what they say they
// are, and whole. The kernel takes what is cut off for a smaller model.

#include <optional>
#include <string_view>

#include "core/base/message.hpp"

namespace hariko {

/// E_CAD_READ where the text is no STEP file (ISO 10303-21), ends early, or nests its lists deeper than 100.
std::optional<Message> check_step_text(std::string_view text);

/// E_CAD_READ where the text is no IGES file of fixed format, a line is not 80 columns with its section and
/// number, or sections do not have the lengths that the last line gives.
std::optional<Message> check_iges_text(std::string_view text);

}  // namespace hariko
