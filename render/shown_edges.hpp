#pragma once

// Surface curves of the polyhedron's edges: their direction, and as lines in space.

#include <optional>
#include <vector>

#include "render/scene.hpp"

namespace hariko {

/// Whether a curve runs from the first vertex of its edge to the second (true) or the other way; nothing
/// where it does not connect them, as for the image of an edge in a live mirror.
std::optional<bool> runs_forward(const SceneObject& object, Index edge, const EdgeCurves::Run& run);

/// Displayed curve of an edge, in world space from the edge's first vertex to its second, in equal steps of
/// its fraction; empty where the edge is not picked by a curve of its own.
std::vector<Vector3> shown_curve(const SceneObject& object, Index edge);

}  // namespace hariko
