#pragma once

// Curves on the surface as the places of the polyhedron's edges: from which end they run, and as lines in
// space.

#include <optional>
#include <vector>

#include "render/scene.hpp"

namespace hariko {

/// Whether a curve runs from the first vertex of its edge to the second (true) or the other way; nothing
/// where it does not join them, as the image of an edge in a live mirror does.
std::optional<bool> runs_forward(const SceneObject& object, Index edge, const EdgeCurves::Run& run);

/// The curve that is shown for an edge, in world space from the edge's first vertex to its second, in equal
/// steps of its share; empty where pointing does not find the edge by a curve of its own.
std::vector<Vector3> shown_curve(const SceneObject& object, Index edge);

}  // namespace hariko
