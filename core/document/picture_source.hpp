#pragma once

// PictureSource: a picture of another program, a photograph or a drawing, as a plane to model by.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/document/kept_members.hpp"
#include "core/document/shared.hpp"

namespace hariko {

inline constexpr Code e_picture_invalid{"E_PICTURE_INVALID"};
inline constexpr Code e_pictures_too_large{"E_PICTURES_TOO_LARGE"};

/// Views along the axes, in the order of `StandardView` without the first.
enum class PictureSide : std::uint8_t { front, back, left, right, top, bottom };
/// Rotation of a picture that a view from this side sees upright and unturned.
Eigen::Quaterniond facing(PictureSide side);
/// The side whose view a picture with this rotation faces, to 1e-6 rad, whatever its turn in its own plane.
std::optional<PictureSide> faced_side(const Eigen::Quaterniond& rotation);

/// `space`: as its plane lies among the surfaces; `behind`, `front`: before or after all of them are drawn.
enum class PictureLayer : std::uint8_t { space, behind, front };

/// How a picture shows: nothing of it moves or changes the picture itself, so that locked ones have it, too.
struct PictureLook {
  double opacity = 0.6;  ///< 0 .. 1, times that of its own pixels
  PictureLayer layer = PictureLayer::space;
  std::optional<PictureSide> only_from;  ///< shown only in views from this side; nothing: in all
  friend bool operator==(const PictureLook&, const PictureLook&) = default;
};

/// A rectangle about the object's zero, x to the right, y upwards, seen from +z and from behind as well.
/// Invariants (`check_picture`): a path of valid UTF-8, at least one pixel, a width above zero.
struct PictureSource {
  /// Path of the file: absolute in memory, relative to the document's folder in its file, with "/". Where the
  /// bytes are packed, only the name that they came with.
  std::string path;
  Shared<std::string> bytes;            ///< of the file, packed into the document; empty where it is linked
  std::uint32_t columns = 1, rows = 1;  ///< pixels, upright
  double width = 1;                     ///< length along x
  PictureLook look;
  Shared<KeptMembers> kept;

  static constexpr std::uint32_t most_pixels = 1U << 20;  ///< a side
  static constexpr std::size_t longest_path = 4096;       ///< bytes

  bool packed() const { return !bytes->empty(); }
  double height() const { return width * rows / columns; }
  /// Counter-clockwise from the lower left one.
  std::array<Vector3, 4> corners() const {
    const double x = width / 2, y = height() / 2;
    return {Vector3(-x, -y, 0), Vector3(x, -y, 0), Vector3(x, y, 0), Vector3(-x, y, 0)};
  }
  friend bool operator==(const PictureSource&, const PictureSource&) = default;
};

/// Bytes of all pictures that one document may have packed.
inline constexpr std::size_t max_packed_pictures = std::size_t(100) << 20;

/// Bytes of a file that is read.
inline constexpr std::uint64_t largest_picture_file = std::uint64_t(1) << 29;

/// E_PICTURE_INVALID, E_PICTURES_TOO_LARGE.
Result<Done> check_picture(const PictureSource& picture);

}  // namespace hariko
