#pragma once

// Meanings of the endings of files, for lists of formats.

#include <string_view>

namespace hariko {

/// "Wavefront OBJ" of ".obj", in English, to be translated; the ending itself where it is not known.
const char* format_name(std::string_view ending);

}  // namespace hariko
