#pragma once

// ReferenceImage: the pixels of a reference picture with those of its smaller versions, ready for the GPU.

#include <string_view>

#include "core/base/cancellation.hpp"
#include "render/camera.hpp"
#include "render/image.hpp"

namespace hariko {

inline constexpr Code e_picture_kind{"E_PICTURE_KIND"};

/// Endings of the files that are read: ".png", ".jpg", ".jpeg".
std::span<const std::string_view> reference_endings();
/// Whether the name ends like one of them.
bool is_reference_file(const std::filesystem::path& path);

/// Upright size of a PNG or JPEG file, from its beginning alone: a photograph is turned as its camera noted
/// (EXIF). Errors: E_PICTURE_KIND where it is neither, E_IMAGE_READ, also above 100 million pixels.
Result<PixelSize> reference_size(std::string_view file);

struct ReferenceImage {
  PixelSize size;  ///< of the file, upright
  /// Colours are multiplied by alpha. Each has half the sides of the one before, rounded down, the last one a
  /// pixel. The first is the picture itself, or as much smaller as `most_kept_pixels` asks for.
  std::vector<Image> levels;

  static constexpr std::int64_t most_kept_pixels = 32'000'000;
  static constexpr int longest_side = 8192;

  std::size_t bytes() const;
};

/// Decodes a whole file. Errors: those of `reference_size`; E_CANCELLED is none: what comes then is void.
Result<ReferenceImage> decode_reference(std::string_view file, const CancelToken& cancel = {});

}  // namespace hariko
