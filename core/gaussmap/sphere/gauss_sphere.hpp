#pragma once

// GaussSphere: the display of an outline on the Gauss sphere (figure 2 of Yoshida and Kunii 1991).

#include <optional>
#include <vector>

#include "core/gaussmap/control_points.hpp"
#include "core/gaussmap/outlines/outline_settings.hpp"
#include "core/gaussmap/sphere/spherical_delaunay.hpp"

namespace hariko {

/// Gauss image of the outline, and the sites inside it with their planes. Site i is the normal of control
/// point i, so the outline's points come first, by their numbers. Where the curvature is negative the image
/// lies on the right of its loops.
struct GaussSphere {
  std::vector<std::vector<Vector3>> loops;  ///< unit vectors
  std::optional<ControlPoints> points;      ///< empty with an error
  /// Triangles and cells on the sphere; nothing with an error or in mode position, which uses no Gauss map.
  std::optional<SphereMesh> mesh;
  Index inserted = 0;  ///< number of sites inserted in the full computation
  std::optional<Message> error;
};

/// Computes the display. `step`: number of sites inserted, without relaxation; if empty all sites, evenly
/// distributed (`relaxed`) as for the surface. Errors are in the result; `inserted` is 0 then. Cost: that of
/// `control_points`, twice with a step.
GaussSphere gauss_sphere(const Outline& outline, const OutlineSettings& settings, std::optional<Index> step,
                         const CancelToken& cancel = {});

/// Corners of the facet that the other tangent planes cut out of an inner site's plane, in order, in the
/// outline's space; empty where planes are nearly parallel or the site lies on the outline. With negative
/// curvature, and in coarse diagrams, it may intersect itself.
std::vector<Vector3> tangent_facet(const GaussSphere& sphere, Index site);

}  // namespace hariko
