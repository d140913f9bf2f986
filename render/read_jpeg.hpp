#pragma once

// Reader of JPEG files, by libjpeg. Internal to render/.

#include <string_view>

#include "render/camera.hpp"
#include "render/image.hpp"

namespace hariko {

/// Whether bytes begin like a JPEG file.
bool looks_like_jpeg(std::string_view file);
/// Upright size of a JPEG file, as the camera noted (EXIF, tag 0x0112). Errors: E_IMAGE_READ.
Result<PixelSize> jpeg_size(std::string_view file);
/// Upright pixels of a JPEG file, in grey, RGB or CMYK. Missing parts of a damaged file are grey. Errors:
/// E_IMAGE_READ, also above `most_pixels`.
Result<Image> read_jpeg(std::string_view file, std::uint64_t most_pixels);

}  // namespace hariko
