#pragma once

// Symmetric scenes: completion of solids by their mirror images (docs/envelope.md).

#include <optional>
#include <vector>

#include "core/envelope/solid.hpp"

namespace hariko {

/// Scene to be enveloped: the designer's solids, and the mirror images of those that have none among them.
struct EnvelopedScene {
  EnvelopeInput input;  ///< the images follow the designer's solids and have the same ids
  /// One per solid of `input`: index of the solid that it is an image of, or its own index.
  std::vector<Index> image_of;
  Vector3 origin = Vector3::Zero();  ///< origin for computations; in the plane of symmetry
  /// Axis perpendicular to the plane of symmetry, which passes through the origin of the coordinates.
  std::optional<Eigen::Index> mirror = {};
};

/// Makes the scene. `input` passes `check_envelope`. Solids that are symmetric themselves, or already come in
/// pairs, get no image. O(solids^2).
EnvelopedScene enveloped_scene(const EnvelopeInput& input);

/// Mirror image of a solid in the plane through the origin perpendicular to an axis.
Solid reflected(const Solid& solid, Eigen::Index axis);

/// Images that `enveloped_scene` adds.
std::vector<Solid> images_of(const EnvelopeInput& input);

}  // namespace hariko
