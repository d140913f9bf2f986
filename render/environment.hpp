#pragma once

// Environment: a picture of all directions that surfaces reflect, with versions for rough surfaces.

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/text/enum_words.hpp"
#include "core/base/vector.hpp"
#include "render/radiance_image.hpp"

namespace hariko {

inline constexpr Code e_environment_shape{"E_ENVIRONMENT_SHAPE"};

/// Environments that the program makes by formula, and the user's own picture.
enum class EnvironmentKind : std::uint8_t { studio, tubes, horizon, overcast, file };
template <>
inline constexpr auto enum_words<EnvironmentKind> =
    all_words<EnvironmentKind>({{EnvironmentKind::studio, "studio"},
                                {EnvironmentKind::tubes, "tubes"},
                                {EnvironmentKind::horizon, "horizon"},
                                {EnvironmentKind::overcast, "overcast"},
                                {EnvironmentKind::file, "file"}});

/// Size of the picture that is kept of an environment: columns are equal steps round z, rows from z down. The
/// middle column shows +y, which one faces from the front; its right neighbours turn to +x.
inline constexpr int environment_width = 256, environment_height = 128;

/// World direction of a place in a picture of all directions; u and v run from 0 to 1, from the left and from
/// the top.
Vector3 environment_direction(double u, double v);

/// Mean over all directions, by solid angle, of a picture of all directions.
std::array<double, 3> mean_radiance(const RadianceImage& image);

/// Picture of an environment that is made by formula (asserted: not `file`), of the size that is kept. Its
/// mean luminance is 0.25 .. 0.60. The same bits on every call.
RadianceImage environment_picture(EnvironmentKind kind);

/// Environment, ready for the GPU: the picture, then versions of half the size each, averaged over lobes of
/// twice the width each. The last one stands for the light on a matt surface.
struct EnvironmentLevels {
  std::vector<RadianceImage> levels;
  std::size_t bytes() const;
};
inline constexpr int environment_level_count = 5;
/// Half the width of the lobe of a level, radians (the standard deviation); 0 for the picture itself.
double lobe_width(int level);

/// Prefilters a picture of the size that is kept (asserted). Averages over all directions stay as they are to
/// a few thousandths.
EnvironmentLevels environment_levels(RadianceImage picture);

/// Reads a Radiance, PNG or JPEG file in memory as a picture of all directions, reduced to the size that is
/// kept by the means of areas in linear light. Errors: E_PICTURE_KIND where it is none of them, E_IMAGE_READ,
/// E_ENVIRONMENT_SHAPE where it is not about twice as wide as high.
Result<RadianceImage> read_environment(std::string_view file);

/// File endings of environments that can be read.
std::span<const std::string_view> environment_endings();
/// Largest file of an environment that is read, bytes.
inline constexpr std::uint64_t largest_environment_file = std::uint64_t{1} << 29;

/// Environment as a scene shows it.
struct Environment {
  std::shared_ptr<const EnvironmentLevels> levels;  ///< null: materials stand in the light of their studio
  double turn = 0;                                  ///< degrees about z, anticlockwise from above
  double exposure = 0;                              ///< stops: each doubles the light

  static constexpr double most_exposure = 8;
  /// Axes of the environment's picture, as rows, in the world: whole turns leave the same bits.
  Matrix3 axes() const;
  friend bool operator==(const Environment&, const Environment&) = default;
};

}  // namespace hariko
