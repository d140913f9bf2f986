#pragma once

// Preparation of the designer's polyhedron for its surface: coplanar faces merged, concave faces cut, the
// mirrored half added, automatic tension applied.

#include <optional>

#include "core/base/result.hpp"
#include "core/modeling/surfacing/convex_faces.hpp"
#include "core/modeling/surfacing/merged_faces.hpp"
#include "core/modeling/surfacing/mirrored.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko {

/// Intermediate results kept beside a `PolyhedronSurfacer` from call to call. Results do not depend on them,
/// except for automatic tension during a drag.
struct SurfaceInputCache {
  std::optional<MergedFaces> merged;
  std::optional<ConvexFaces> convex;
  std::optional<MirroredPolyhedron> whole;
  /// Automatic tension of the last call: shaping before and after, for this connectivity and exponent.
  struct Tension {
    std::shared_ptr<const HalfEdgeMesh> topology;
    double exponent = 0;
    Shaping before, after;
  };
  std::optional<Tension> tension;
};

/// Returns the input of `PolyhedronSurfacer::rebuild`. At quality `drag` automatic tension is frozen as
/// `cache` has it, so that the factorised systems stay valid; at `final` it follows the lengths. Errors:
/// those of `mirrored`. O(corners).
Result<PolyhedronSurfaceInput> surface_input(const PolyhedronSource& source, Quality quality = Quality::final,
                                             SurfaceInputCache* cache = nullptr);

}  // namespace hariko
