#pragma once

// Error maps: deviation of any triangle mesh from a surface, by points and by facets, however the mesh was
// made (section 3.3 of the paper).

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/approximation/refinement/fold_error.hpp"
#include "core/approximation/refinement/parameter_mesh.hpp"
#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

/// Field of one kind of error, from samples: lengths or radians.
struct ErrorField {
  std::vector<float> points;  ///< error at each point of the field
  std::vector<float> facets;  ///< largest error of each facet
  double largest = 0, mean = 0;
  Index facet = no_index;           ///< the facet with the largest error; no_index when all are 0
  Vector3 place = Vector3::Zero();  ///< position of the largest error, relative to the surface's origin
};

/// Point of the surface, and the facet that it is compared with: the facet that approximates it where that is
/// known, otherwise the nearest one.
struct SurfaceSample {
  Vector3 position = Vector3::Zero();  ///< relative to the surface's origin
  Index patch = 0;
  Vector2 parameter = Vector2::Zero();
  Index facet = no_index;
};

/// Errors of a mesh against a surface, by points and by facets.
struct MeshErrorMap {
  std::vector<SurfaceSample> samples;
  /// First sample of each facet, for meshes with parts; the samples of a facet are in the order of
  /// GridPattern. (A facet at a pole covers two triangles, whose samples follow one another.)
  std::vector<Index> facet_samples;
  /// Distance of the samples to the nearest closed triangle; `points` are the samples. Mean by area.
  ErrorField distance;
  /// Angle between the normals of the samples and of their facets; `points` are the samples. Mean by area.
  ErrorField normal_angle;
  /// Distance of the facets to the surface, at a grid on each; `points` are the mesh's vertices.
  ErrorField mesh_distance;
  /// Angle between neighbouring facets, except at creases of the surface; `points` are the vertices. Mean
  /// over edges.
  ErrorField fold_angle;
};

/// Options of an error map.
struct ErrorMapOptions {
  int density = 4;  ///< intervals between samples per side of a facet, 1 to 16
  /// Angle between the surface's own normals along an edge above which it is a crease and no fold; radians.
  double crease = crease_angle;
};

/// Measures a mesh against a surface. `parts`, if the mesh has them, tell the part of the surface that each
/// triangle approximates; otherwise the nearest facets are compared. The largest distance is searched for
/// between samples too. The same result on any number of threads. O((facets + samples) log facets). Errors:
/// E_MESH_NOTHING without triangles or patches, E_CANCELLED.
Result<MeshErrorMap> mesh_error_map(const Surface& surface, const TriangleMesh& mesh,
                                    std::span<const ParameterFacet> parts = {},
                                    const ErrorMapOptions& options = {}, const CancelToken& cancel = {},
                                    const Progress& progress = {});

/// Comma-separated values with a header line: object, kind (facet, vertex or sample), number, facet, position
/// (absolute: the origins of mesh and surface are added), then the four errors, angles in degrees; empty
/// where a kind has none. `with_head` for the first of several objects.
std::string error_csv(const MeshErrorMap& map, const TriangleMesh& mesh, const Vector3& surface_origin,
                      std::string_view object, bool with_head);

}  // namespace hariko
