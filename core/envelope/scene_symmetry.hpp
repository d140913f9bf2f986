#pragma once

// Scenes with a plane of symmetry: every solid has an image in it (docs/envelope.md).

#include <optional>
#include <vector>

#include "core/envelope/solid.hpp"

namespace hariko {

/// What a surface goes round: the solids of the designer, and the images of those that have none among them.
struct EnvelopedScene {
  EnvelopeInput input;               ///< with the images after the designer's solids, under the same ids
  std::vector<Index> image_of;       ///< one a solid of `input`: number of what it is an image of, or its own
  Vector3 origin = Vector3::Zero();  ///< about which to compute; in the plane of symmetry
  /// At right angles to the plane, which goes through the zero of the coordinates.
  std::optional<Eigen::Index> mirror = {};
};

/// `input` passes `check_envelope`. Solids that are symmetric themselves, or come in pairs already, get no
/// image. O(solids^2).
EnvelopedScene enveloped_scene(const EnvelopeInput& input);

/// The solid beyond the plane through zero at right angles to an axis.
Solid reflected(const Solid& solid, Eigen::Index axis);

/// The images that `enveloped_scene` adds.
std::vector<Solid> images_of(const EnvelopeInput& input);

}  // namespace hariko
