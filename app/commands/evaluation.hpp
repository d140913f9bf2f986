#pragma once

// Numbers of objects as JSON, for checks against other implementations, each kind in a file of its own;
// docs/cli.md describes the members.

#include <string>

#include "core/base/result.hpp"
#include "core/document/document.hpp"
#include "core/document/source.hpp"
#include "core/skinning/evaluate_skin.hpp"

namespace hariko {

/// JSON with network tangents, split points, control points, sampled points and normals, and metrics, in
/// absolute coordinates of the object; docs/cli.md describes the members. Errors: those of
/// `PolyhedronSurfacer::rebuild`.
Result<std::string> evaluation_json(const PolyhedronSource& source);

/// JSON with points, normals and curvatures of each patch at a few parameters, counted as in the file, and
/// with the continuity between patches, in coordinates of the object; docs/cli.md describes the members. The
/// object must consist of patches (asserted). Errors: those of `object_surface`.
Result<std::string> patch_evaluation_json(const Document& document, const Object& object);

/// JSON with control mesh, creases, lines, rows, figures and sampled points; docs/cli.md describes the
/// members. Errors: those of `SkinSurfacer::surface`.
Result<std::string> skin_evaluation_json(const Skin& skin);

/// JSON with points, normals, support values, curvature, triangles, boundary flags and messages, in absolute
/// coordinates of the object; docs/cli.md describes the members. Errors: those of `control_points`.
Result<std::string> outline_json(const OutlineSource& source);

/// JSON with vertices, edges with homogeneous control points, faces with owners, the number of patches, the
/// level of tightness, and whether the solids are enclosed. Surfaces made from a distance field have no edges
/// and faces. Errors: those of `EnvelopeSurfacer::rebuild`.
Result<std::string> solids_json(const SolidsSource& source);

}  // namespace hariko
