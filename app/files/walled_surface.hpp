#pragma once

// Surfaces of objects as they are exported: themselves, at a distance, or as bodies with a thickness; and the
// triangles and flat patches of reference facets.

#include <optional>

#include "core/document/document.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "core/offset/offset_surface.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

inline constexpr Code e_offset_facets{"E_OFFSET_FACETS"};
inline constexpr Code e_offset_folds{"E_OFFSET_FOLDS"};

/// Treatment of walls that fold over themselves: along the edge of a fold no tolerance can be kept.
enum class FoldedWalls { refuse, tell };

/// Surface of an object at quality `final`, in its own space, with the wall, whose lengths are the
/// document's. Its warnings are those of the wall, with the object's name. Errors, with the object's name:
/// those of `object_surface` and `wall_surface`; E_OFFSET_FOLDS, with the largest distance that does not
/// fold, where folds are refused.
Result<ObjectSurface> walled_surface(const Document& document, const Object& object, const Wall& wall,
                                     FoldedWalls folds, const CancelToken& cancel = {});

/// E_OFFSET_FACETS where a wall is asked for and a visible object has reference facets, which have no normals
/// to go along.
std::optional<Message> why_no_wall(const Document& document, const Wall& wall);

/// Triangles in the object's space, without normals; polygons are triangulated.
TriangleMesh triangles_of(const MeshSource& source);

/// Flat patches in the object's space; their provenance is the faces.
Surface facets_of(const MeshSource& source);

/// Surface of an object, or the flat patches of its facets. Errors: those of `object_surface`.
Result<Surface> surface_or_facets(const Document& document, const Object& object,
                                  const CancelToken& cancel = {});

}  // namespace hariko
