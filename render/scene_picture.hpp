#pragma once

// ScenePicture: a reference picture as it stands among what is drawn.

#include <array>
#include <memory>
#include <optional>

#include "core/document/picture_source.hpp"
#include "render/camera.hpp"
#include "render/reference_image.hpp"

namespace hariko {

struct ScenePicture {
  std::shared_ptr<const ReferenceImage> image;  ///< null: still decoded, or not found: only its frame shows
  bool missing = false;                         ///< the frame is crossed out
  Matrix4 transform = Matrix4::Identity();      ///< object to world, a similarity
  Vector2 half = {0.5, 0.5};                    ///< half of its sides, in the object's lengths
  PictureLook look;
  bool selected = false, hovered = false;  ///< has a frame

  /// Whether a camera sees it: those that are shown from one side are gone while the view turns.
  bool seen_by(const Camera& camera) const;
  /// World points, counter-clockwise from the lower left one.
  std::array<Vector3, 4> corners() const;
  Vector3 middle() const { return transform.topRightCorner<3, 1>(); }
  /// Distance along a ray to where it meets the picture, as a multiple of the ray's direction.
  std::optional<double> hit(const Ray& ray) const;

  friend bool operator==(const ScenePicture&, const ScenePicture&) = default;
};

}  // namespace hariko
