#pragma once

// From the designer's polyhedron to what its surface is made from: faces in one plane merged, concave faces
// cut, the mirrored half added, automatic tension.

#include <optional>

#include "core/base/result.hpp"
#include "core/modeling/convex_faces.hpp"
#include "core/modeling/merged_faces.hpp"
#include "core/modeling/mirrored.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko {

/// What is kept beside a `PolyhedronSurfacer` from call to call. The results do not depend on it, but for
/// automatic tension in a drag.
struct SurfaceInputCache {
  std::optional<MergedFaces> merged;
  std::optional<ConvexFaces> convex;
  std::optional<MirroredPolyhedron> whole;
  /// Automatic tension of the last call: of this shaping, on this connectivity, to this power.
  struct Tension {
    std::shared_ptr<const HalfEdgeMesh> topology;
    double exponent = 0;
    Shaping before, after;
  };
  std::optional<Tension> tension;
};

/// What `PolyhedronSurfacer::rebuild` takes. At quality `drag` automatic tension is frozen as `cache` has it,
/// so that the systems hold; at `final` it follows the lengths. Errors: those of `mirrored`. O(corners).
Result<PolyhedronSurfaceInput> surface_input(const PolyhedronSource& source, Quality quality = Quality::final,
                                             SurfaceInputCache* cache = nullptr);

}  // namespace hariko
