#pragma once

#include <filesystem>
#include <string>

namespace hariko {

/// ".png" of "Picture.PNG": letters of ASCII are small.
std::string lower_ending(const std::filesystem::path& path);

}  // namespace hariko
