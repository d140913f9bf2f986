#pragma once

// Lines on a surface: continuity marks, curvature combs and section curves.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/analysis/combs.hpp"
#include "render/display_mesh.hpp"

namespace hariko {

/// Curves over source edges, sorted by continuity.
struct EdgeMarks {
  struct Class {
    std::vector<CurveSegment> segments;  ///< vertices of the source mesh
    /// Arc length along the curve at both ends of each segment, for dashes.
    std::vector<std::array<float, 2>> lengths;
    std::size_t curves = 0;
  };
  std::array<Class, 3> classes;  ///< G0, G1, G2
};

/// Continuity marks. `classes`: one for each seam of the surface that the mesh was built from. O(curves *
/// density).
std::shared_ptr<const EdgeMarks> edge_marks(const DisplayMesh& mesh, std::span<const Continuity> classes);

/// Curvature combs prepared for the GPU.
struct CombLines {
  Vector3 origin = Vector3::Zero();
  std::vector<std::array<float, 6>> teeth;  ///< foot relative to the origin, and vector of the tooth
  int density = 0;
  double typical = 0;  ///< see `typical_curvature`; 0: nothing to draw
  double greatest = 0;
};
/// Combs relative to an origin. O(teeth).
std::shared_ptr<const CombLines> comb_lines(const CurvatureCombs& combs, const Vector3& origin);

/// Edges of a triangle mesh, drawn over the surface that it approximates.
struct FacetLines {
  Vector3 origin = Vector3::Zero();
  std::vector<std::array<float, 3>> points;  ///< relative to the origin
  std::vector<std::array<Index, 2>> edges;
  double depth = 0;  ///< largest distance of an edge behind the surface, in the lengths of the points
};
/// Edges of triangles, each once. `depth`: largest distance between the triangles and the surface under them.
/// O(triangles log triangles).
std::shared_ptr<const FacetLines> facet_lines(const Vector3& origin, std::span<const Vector3> positions,
                                              std::span<const std::array<Index, 3>> triangles, double depth);

/// Plane relative to a mesh's origin: normal . x = offset.
struct LocalPlane {
  Vector3 normal;
  double offset = 0;
  friend bool operator==(const LocalPlane&, const LocalPlane&) = default;
};

/// Intersection of a plane with the triangles of a mesh: one segment for each triangle that it crosses,
/// relative to the mesh's origin. Neighbouring segments share their ends exactly. O(vertices of chunks that
/// the plane meets).
std::vector<std::array<std::array<float, 3>, 2>> section_curve(const DisplayMesh& mesh,
                                                               const LocalPlane& plane);

}  // namespace hariko
