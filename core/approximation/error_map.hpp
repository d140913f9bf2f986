#pragma once

// How far any triangle mesh is from a surface, point by point and facet by facet (section 3.3 of the paper),
// whatever made the mesh.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/approximation/fold_error.hpp"
#include "core/approximation/parameter_mesh.hpp"
#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

/// One kind of error. Lengths or radians, from samples.
struct ErrorField {
  std::vector<float> points;  ///< of each of the points that the field is measured at
  std::vector<float> facets;  ///< the largest of each facet
  double largest = 0, mean = 0;
  Index facet = no_index;           ///< that has the largest; no_index when all are 0
  Vector3 place = Vector3::Zero();  ///< where the largest is, relative to the surface's origin
};

/// A point of the surface, and the facet that it is compared with: the one that stands for it where that is
/// known, else the nearest.
struct SurfaceSample {
  Vector3 position = Vector3::Zero();  ///< relative to the surface's origin
  Index patch = 0;
  Vector2 parameter = Vector2::Zero();
  Index facet = no_index;
};

struct MeshErrorMap {
  std::vector<SurfaceSample> samples;
  std::vector<std::array<Index, 3>> sample_triangles;  ///< the surface through its samples, for pictures
  /// With parts: the first sample of each facet; those of one follow in the order of GridPattern. (A facet at
  /// a pole stands for two triangles: their samples follow each other.)
  std::vector<Index> facet_samples;
  /// Of the samples to the closed triangle that is nearest; `points` are the samples. Mean by area.
  ErrorField distance;
  /// Between the normals of the samples and of their facets; `points` are the samples. Mean by area.
  ErrorField normal_angle;
  /// Of the facets to the surface, at a grid on each; `points` are the mesh's vertices.
  ErrorField mesh_distance;
  /// Between neighbouring facets, creases of the surface apart; `points` are the vertices. Mean over edges.
  ErrorField fold_angle;
};

struct ErrorMapOptions {
  int density = 4;  ///< intervals a facet's side between samples, 1 to 16
  /// Where the surface's own normals differ by more than this along an edge there is no fold; radians.
  double crease = crease_angle;
};

/// `parts`, where the mesh has them, say which part of the surface each triangle stands for; else the nearest
/// facets are compared. The largest distance is looked for between samples too. The same on any number of
/// threads. O((facets + samples) log facets). Errors: E_MESH_NOTHING without triangles or patches,
/// E_CANCELLED.
Result<MeshErrorMap> mesh_error_map(const Surface& surface, const TriangleMesh& mesh,
                                    std::span<const ParameterFacet> parts = {},
                                    const ErrorMapOptions& options = {}, const CancelToken& cancel = {},
                                    const Progress& progress = {});

/// How many values lie in each of `bins` equal parts of 0 .. high; the last one also counts those above.
std::vector<std::size_t> error_histogram(std::span<const float> values, double high, int bins);

/// Lines of comma-separated values with a head: object, kind (facet, vertex or sample), number, facet, place
/// (absolute: the origins of mesh and surface are added), then the four errors, angles in degrees; empty
/// where a kind has none. `with_head` for the first of several objects.
std::string error_csv(const MeshErrorMap& map, const TriangleMesh& mesh, const Vector3& surface_origin,
                      std::string_view object, bool with_head);

}  // namespace hariko
