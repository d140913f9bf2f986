#pragma once

// What is drawn along the curves of a surface: marks of continuity, curvature combs, and the cut of a
// section.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/analysis/combs.hpp"
#include "render/display_mesh.hpp"

namespace hariko {

/// Curves over source edges, sorted by their continuity.
struct EdgeMarks {
  struct Class {
    std::vector<CurveSegment> segments;  ///< vertices of the mesh that it was made for
    /// Length along the curve at both ends of each segment, for dashes.
    std::vector<std::array<float, 2>> lengths;
    std::size_t curves = 0;
  };
  std::array<Class, 3> classes;  ///< G0, G1, G2
};

/// `classes`: one for each seam of the surface that the mesh was built from. O(curves * density).
std::shared_ptr<const EdgeMarks> edge_marks(const DisplayMesh& mesh, std::span<const Continuity> classes);

/// Combs ready for the GPU.
struct CombLines {
  Vector3 origin = Vector3::Zero();
  std::vector<std::array<float, 6>> teeth;  ///< foot relative to the origin, and tooth
  int density = 0;
  double typical = 0;  ///< see `typical_curvature`; 0: nothing to draw
  double greatest = 0;
};
std::shared_ptr<const CombLines> comb_lines(const CurvatureCombs& combs, const Vector3& origin);

/// Edges of a triangle mesh, to be drawn over the surface that it stands for.
struct FacetLines {
  Vector3 origin = Vector3::Zero();
  std::vector<std::array<float, 3>> points;  ///< relative to the origin
  std::vector<std::array<Index, 2>> edges;
  double depth = 0;  ///< how far behind the surface an edge may lie, in the lengths of the points
};
/// `depth`: the largest distance between the triangles and what they are drawn over.
std::shared_ptr<const FacetLines> facet_lines(const Vector3& origin, std::span<const Vector3> positions,
                                              std::span<const std::array<Index, 3>> triangles, double depth);

/// A plane in coordinates relative to a mesh's origin: normal . x = offset.
struct LocalPlane {
  Vector3 normal;
  double offset = 0;
  friend bool operator==(const LocalPlane&, const LocalPlane&) = default;
};

/// Where a plane cuts the triangles of a mesh: one piece for each triangle that it crosses, relative to the
/// mesh's origin. Neighbouring pieces share their ends exactly. O(vertices of chunks that the plane meets).
std::vector<std::array<std::array<float, 3>, 2>> section_curve(const DisplayMesh& mesh,
                                                               const LocalPlane& plane);

}  // namespace hariko
