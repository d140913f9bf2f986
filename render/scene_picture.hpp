#pragma once

// ScenePicture: a reference picture placed in a scene.

#include <array>
#include <memory>
#include <optional>

#include "core/document/picture_source.hpp"
#include "render/camera.hpp"
#include "render/reference_image.hpp"

namespace hariko {

/// Reference picture with its placement.
struct ScenePicture {
  std::shared_ptr<const ReferenceImage> image;  ///< null: not decoded yet, or not found; only the frame shows
  bool missing = false;                         ///< file not found: the frame is crossed out
  Matrix4 transform = Matrix4::Identity();      ///< object to world, a similarity
  Vector2 half = {0.5, 0.5};                    ///< half of its sides, in object lengths
  PictureLook look;
  bool selected = false, hovered = false;  ///< draws a frame

  /// Whether the picture is visible for a camera: those for one viewing direction vanish while the view
  /// turns.
  bool seen_by(const Camera& camera) const;
  /// Corners in the world, counter-clockwise from the lower left one.
  std::array<Vector3, 4> corners() const;
  Vector3 middle() const { return transform.topRightCorner<3, 1>(); }
  /// Ray parameter of the intersection with the picture, as a multiple of the ray's direction.
  std::optional<double> hit(const Ray& ray) const;

  friend bool operator==(const ScenePicture&, const ScenePicture&) = default;
};

}  // namespace hariko
