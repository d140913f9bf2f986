#pragma once

// JPEG files by libjpeg. Internal to render/.

#include <string_view>

#include "render/camera.hpp"
#include "render/image.hpp"

namespace hariko {

bool looks_like_jpeg(std::string_view file);
/// Upright, as the camera noted (EXIF, tag 0x0112). Errors: E_IMAGE_READ.
Result<PixelSize> jpeg_size(std::string_view file);
/// The whole picture, upright; grey, colours and those of print. What a damaged file lacks is grey. Errors:
/// E_IMAGE_READ, also above `most_pixels`.
Result<Image> read_jpeg(std::string_view file, std::uint64_t most_pixels);

}  // namespace hariko
