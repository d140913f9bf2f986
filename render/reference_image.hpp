#pragma once

// ReferenceImage: pixels and mipmap levels of a reference picture, prepared for the GPU.

#include <string_view>

#include "core/base/cancellation.hpp"
#include "render/camera.hpp"
#include "render/image.hpp"

namespace hariko {

inline constexpr Code e_picture_kind{"E_PICTURE_KIND"};

/// File endings that can be read: ".png", ".jpg", ".jpeg", and ".webp" where the program was built with
/// libwebp.
std::span<const std::string_view> reference_endings();
/// Whether a name has one of these endings, or ".webp" in any case: the reader says what is missing.
bool is_reference_file(const std::filesystem::path& path);

/// Upright size of a PNG, JPEG or WebP file, from its header alone; photographs are turned as the camera
/// noted (EXIF). Errors: E_PICTURE_KIND where it is none of them, E_PICTURE_WEBP where the program was built
/// without libwebp, E_IMAGE_READ, also above 100 million pixels and of animations.
Result<PixelSize> reference_size(std::string_view file);

/// Reference picture with mipmap levels.
struct ReferenceImage {
  PixelSize size;  ///< upright size of the file
  /// Mipmap levels, with premultiplied alpha. Each has half the sides of the one before, rounded down; the
  /// last is one pixel. The first is the picture itself, reduced as far as `most_kept_pixels` and
  /// `longest_side` require.
  std::vector<Image> levels;

  static constexpr std::int64_t most_kept_pixels = 32'000'000;
  static constexpr int longest_side = 8192;

  /// Memory of all levels.
  std::size_t bytes() const;
};

/// Decodes a whole file. Errors: those of `reference_size`. After cancellation the result is of no use.
Result<ReferenceImage> decode_reference(std::string_view file, const CancelToken& cancel = {});

}  // namespace hariko
