#pragma once

// Reader of Radiance pictures (.hdr, .pic): red, green and blue with a common exponent.

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "core/base/result.hpp"
#include "render/camera.hpp"
#include "render/image.hpp"
#include "render/radiance_image.hpp"

namespace hariko {

/// Most pixels, and the longest side, of a Radiance picture that is read.
inline constexpr std::uint64_t most_radiance_pixels = 150'000'000;
inline constexpr int most_radiance_side = 65536;

/// Receiver of the rows of a picture, called in their order from the top.
using RadianceRows = std::function<void(int row, std::span<const Radiance> pixels)>;

/// Whether bytes begin like a Radiance file.
bool looks_like_radiance(std::string_view file);
/// Size of a Radiance picture, from its header. Errors: E_IMAGE_READ where the header is damaged, the colours
/// are not RGBE, the rows do not run from the top and left, or the picture is above these limits.
Result<PixelSize> radiance_size(std::string_view file);
/// Rows of a Radiance picture: flat, or in either of the two run-length encodings. What EXPOSURE lines of the
/// header multiplied is divided out. Memory of one row. Errors: those of `radiance_size`, and E_IMAGE_READ
/// where rows are damaged or missing; those before were handed out. O(pixels).
Result<PixelSize> read_radiance(std::string_view file, const RadianceRows& take);

}  // namespace hariko
