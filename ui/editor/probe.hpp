#pragma once

// Probe: what the surface is at one point: position, normal and curvature of the surface itself, not of the
// mesh that shows it.

#include <optional>
#include <string>

#include "core/analysis/curvature.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/scene_builder.hpp"

namespace hariko {

struct ProbeReading {
  Vector3 position = Vector3::Zero(), normal = Vector3::Zero();  ///< world
  std::optional<Curvature> curvature;  ///< in the document's unit; nothing where it is undefined
};

/// The front-most point of the surfaces under a pixel; nothing where a live copy is in front.
std::optional<SurfacePoint> surface_point(const SceneBuilder& scene, const Ray& ray);

/// The value of the shown map at a point with its unit, in the document's space: "12.5 mm", "undefined".
/// Drafts that cannot leave their mould are said to be undercuts, and what has no radius to be flat. Empty
/// for maps without values.
std::string map_value_text(const Editor& editor, const Language& tr, const SurfacePoint& point);

/// Reading at the point now; nothing when the object or the patch is gone.
std::optional<ProbeReading> read_probe(const Editor& editor, const SurfacePoint& point);

}  // namespace hariko
