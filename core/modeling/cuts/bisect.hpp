#pragma once

// Cutting an object in two at a plane and keeping one half: the first step of a live mirror.

#include "core/base/result.hpp"
#include "core/document/mirror.hpp"
#include "core/modeling/edit_result.hpp"
#include "core/modeling/surfacing/surface_form.hpp"

namespace hariko {

/// Returns the part of the object on the positive side of the mirror's plane, open where it was cut. Vertices
/// within the weld distance count as lying in the plane; faces that lie in it are removed, so that the half
/// can be joined to its image. An object without a vertex behind the plane keeps all its other faces. Given
/// `on`, the form of `source`, edges are cut where their curves cross the plane, and the half with its image
/// has the same surface as before. Selects nothing. Errors: E_MIRROR_INVALID, E_NO_FACES (nothing lies on the
/// positive side), E_WRONG_SELECTION (a face crosses the plane more than once; names it),
/// E_WOULD_BE_NONMANIFOLD.
Result<EditResult> halved(const PolyhedronSource& source, const Mirror& mirror,
                          const SurfaceForm* on = nullptr);

}  // namespace hariko
