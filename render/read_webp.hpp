#pragma once

// Reader of WebP files, by libwebp where the program was built with it. Internal to render/.

#include <string_view>

#include "render/camera.hpp"
#include "render/image.hpp"

namespace hariko {

inline constexpr Code e_picture_webp{"E_PICTURE_WEBP"};

/// Whether the program was built with libwebp.
bool reads_webp();
/// Whether bytes begin like a WebP file.
bool looks_like_webp(std::string_view file);
/// Upright size of a WebP file, as the camera noted (EXIF). Errors: E_IMAGE_READ, also of animations;
/// E_PICTURE_WEBP unless `reads_webp`.
Result<PixelSize> webp_size(std::string_view file);
/// Upright pixels of a WebP file, lossy or lossless, with straight alpha. Errors: those of `webp_size`, and
/// E_IMAGE_READ above `most_pixels` and where parts are missing. Memory: up to 12 bytes a pixel.
Result<Image> read_webp(std::string_view file, std::uint64_t most_pixels);

}  // namespace hariko
