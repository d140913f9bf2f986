#pragma once

// Probe: what the surface is at one point: position, normal and curvature of the surface itself, not of the
// mesh that shows it.

#include <optional>

#include "core/analysis/curvature.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/scene_builder.hpp"

namespace hariko {

struct ProbeReading {
  Vector3 position = Vector3::Zero(), normal = Vector3::Zero();  ///< world
  std::optional<Curvature> curvature;  ///< in the document's unit; nothing where it is undefined
};

/// The front-most point of the surfaces under a pixel.
std::optional<SurfacePoint> surface_point(const SceneBuilder& scene, const Ray& ray);

/// What is there now; nothing when the object or the patch is gone.
std::optional<ProbeReading> read_probe(const Editor& editor, const SurfacePoint& point);

}  // namespace hariko
