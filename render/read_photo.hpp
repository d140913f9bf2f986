#pragma once

// Readers of JPEG files, by libjpeg, and of WebP files, by libwebp where the program was built with it; and
// which side of a photograph is up, as its camera noted (EXIF). Internal to render/.

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

/// Orientation of EXIF notes (tag 0x0112), 1 .. 8: position of the file's first row and column; 1 where none
/// is noted or the notes are damaged. `notes`: from the header of TIFF on.
int exif_orientation(std::string_view notes);
/// Size of a picture of that orientation as it stands upright.
PixelSize upright_size(PixelSize file, int orientation);
/// The picture of that orientation upright.
Image upright_image(Image file, int orientation);

}  // namespace hariko
