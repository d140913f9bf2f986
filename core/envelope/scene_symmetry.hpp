#pragma once

// Scenes with a plane of symmetry: every solid has an image in it, and so has every vertex of the network
// (docs/envelope.md, spec 14).

#include <optional>
#include <vector>

#include "core/envelope/placed_solid.hpp"

namespace hariko {

using SolidVertex = std::pair<Index, Index>;  ///< placed solid, unit vertex

/// The plane goes through the zero of the coordinates, at right angles to `axis`.
struct SceneSymmetry {
  Eigen::Index axis = 0;
  std::vector<Index> solid;                ///< the image of each placed solid; itself where it is symmetric
  std::vector<std::vector<Index>> vertex;  ///< of the unit vertices of each: numbers within the image

  Vector3 reflected(Vector3 point) const {
    point[axis] = -point[axis];
    return point;
  }
  SolidVertex image(const SolidVertex& of) const { return {solid[of.first], vertex[of.first][of.second]}; }
};

/// What a surface goes round: the solids of the designer, and the images of those that have none among them.
struct EnvelopedScene {
  EnvelopeInput input;               ///< with the images after the designer's solids, under the same ids
  std::vector<Index> image_of;       ///< one a solid of `input`: number of what it is an image of, or its own
  std::vector<PlacedSolid> placed;   ///< relative to `origin`; parts of images are numbered from `image_part`
  Vector3 origin = Vector3::Zero();  ///< in the plane of symmetry
  std::optional<SceneSymmetry> symmetry;
};

/// Added to `PlacedSolid::part` of images.
inline constexpr std::uint32_t image_part = 2;

/// `input` passes `check_envelope`. Solids that are symmetric themselves, or come in pairs already, get no
/// image. O(solids^2).
EnvelopedScene enveloped_scene(const EnvelopeInput& input);

/// The solid beyond the plane through zero at right angles to an axis.
Solid reflected(const Solid& solid, Eigen::Index axis);

/// The images that `enveloped_scene` adds.
std::vector<Solid> images_of(const EnvelopeInput& input);

}  // namespace hariko
