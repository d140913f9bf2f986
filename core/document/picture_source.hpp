#pragma once

// PictureSource: an imported photograph or drawing, as a reference plane to model by.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/document/format/kept_members.hpp"
#include "core/document/history/shared.hpp"

namespace hariko {

inline constexpr Code e_picture_invalid{"E_PICTURE_INVALID"};
inline constexpr Code e_pictures_too_large{"E_PICTURES_TOO_LARGE"};

/// Views along the axes, in the order of `StandardView` without the first.
enum class PictureSide : std::uint8_t { front, back, left, right, top, bottom };
/// Rotation of a picture that appears upright in the view from this side.
Eigen::Quaterniond facing(PictureSide side);
/// Side whose view a picture with this rotation faces, to 1e-6 rad, regardless of its rotation in its own
/// plane; nothing if there is none.
std::optional<PictureSide> faced_side(const Eigen::Quaterniond& rotation);

/// Depth order. `space`: at the depth of its plane; `behind`, `front`: drawn before or after all surfaces.
enum class PictureLayer : std::uint8_t { space, behind, front };

/// Look of a picture. It neither moves nor changes the picture itself, so that it can be set for locked ones.
struct PictureLook {
  double opacity = 0.6;  ///< 0 .. 1, multiplied by that of its own pixels
  PictureLayer layer = PictureLayer::space;
  std::optional<PictureSide> only_from;  ///< shown only in views from this side; nothing: in all views
  friend bool operator==(const PictureLook&, const PictureLook&) = default;
};

/// Picture as a rectangle centred at the object's origin, x to the right, y up, seen from +z; visible from
/// behind as well. Invariants (`check_picture`): a path of valid UTF-8, at least one pixel, a positive width.
struct PictureSource {
  static constexpr std::string_view kind = "picture";
  /// Path of the file: absolute in memory, relative to the document's folder in the document's file, with
  /// "/". If the bytes are packed, only the original file name.
  std::string path;
  Shared<std::string> bytes;  ///< bytes of the file, packed into the document; empty if it is linked
  std::uint32_t columns = 1, rows = 1;  ///< pixels, after the picture's orientation is applied
  double width = 1;                     ///< length along x
  PictureLook look;
  Shared<KeptMembers> kept;

  static constexpr std::uint32_t most_pixels = 1U << 20;  ///< per side
  static constexpr std::size_t longest_path = 4096;       ///< in bytes

  bool packed() const { return !bytes->empty(); }
  double height() const { return width * rows / columns; }
  /// Corners, counter-clockwise from the lower left one.
  std::array<Vector3, 4> corners() const {
    const double x = width / 2, y = height() / 2;
    return {Vector3(-x, -y, 0), Vector3(x, -y, 0), Vector3(x, y, 0), Vector3(-x, y, 0)};
  }
  friend bool operator==(const PictureSource&, const PictureSource&) = default;
};

/// Largest total size in bytes of the packed pictures of one document.
inline constexpr std::size_t max_packed_pictures = std::size_t(100) << 20;

/// Largest size in bytes of a picture file that is read.
inline constexpr std::uint64_t largest_picture_file = std::uint64_t(1) << 29;

/// Checks a picture. Errors: E_PICTURE_INVALID, E_PICTURES_TOO_LARGE.
Result<Done> check_picture(const PictureSource& picture);

}  // namespace hariko
