#pragma once

#include <filesystem>
#include <string>

namespace hariko {

/// File name extension with its ASCII letters in lower case: ".png" of "Picture.PNG".
std::string lower_ending(const std::filesystem::path& path);

}  // namespace hariko
