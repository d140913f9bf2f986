#pragma once

// CadModel: a surface as a boundary representation of vertices, edges and B-spline faces, every edge shared
// by the faces that meet there. core/cad/kernel makes files of it.

#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/cad/cad_plan.hpp"
#include "core/cad/fit/spline.hpp"

namespace hariko {

/// Edge curve over 0 .. length of its first use; runs from `begin` to `end`.
struct CadEdge {
  Index begin = no_index, end = no_index;
  SplineCurve curve;
  std::array<CadUse, 2> uses;  ///< the `piece` of a use is the number of a face here
  int use_count = 1;
  bool smooth = true;
  bool degenerate = false;  ///< a side collapsed to a point
  double deviation = 0;     ///< largest measured distance to the faces' own boundaries, a length
};

/// B-spline face of a CAD model.
struct CadFace {
  SplineSurface surface;  ///< over the breaks of its piece; the outside is on the left of ds, dt
  std::array<std::vector<Index>, 4> sides;  ///< edges along the four sides, counter-clockwise
  bool exact = false;                       ///< equals the surface, to rounding
  bool reached = true;                      ///< keeps the tolerance at the places where the fit was sampled
  bool folded = false;                      ///< turns its back to the surface at one of these places
};

/// Surface as vertices, edges and faces. Positions are relative to `origin`.
struct CadModel {
  Vector3 origin = Vector3::Zero();
  double size = 0;  ///< diagonal of the box round the vertices and control points
  std::vector<Vector3> vertices;
  std::vector<CadEdge> edges;
  std::vector<CadFace> faces;
  std::vector<CadPiece> pieces;  ///< source piece of each face; without cells in a reversed model

  /// Whether the surface is meant to have continuous curvature across smooth edges.
  bool curvature = false;

  /// Whether every edge has two faces.
  bool closed() const;
};

inline constexpr double usual_cad_tolerance = 1e-4;  ///< relative to the diagonal of the surface's box
/// Default angle between faces along smooth edges, radians.
inline constexpr double usual_cad_angle = 0.1 * std::numbers::pi / 180;

/// Tolerances and choices for `make_cad_model`.
struct CadModelOptions {
  /// Largest distance between the surface and faces that cannot be exact: a length, and a fraction of the
  /// size; the larger of both holds.
  double tolerance = 0, share = usual_cad_tolerance;
  double angle = usual_cad_angle;  ///< largest angle between faces along smooth edges, radians
  /// Faces that are splines stay exact, also where fitted ones of less weight would keep the tolerance.
  bool exact = false;
  /// Triangles round the split point of a face of four sides become one face, also where more faces would
  /// weigh less.
  bool whole_faces = false;
};
/// Distance, relative to the diagonal, below which a face counts as exact.
inline constexpr double exact_face = 1e-12;

/// Reason, in a few words ("rational triangles ..."), why faces of a surface that are no splines of the
/// degree in use are not exact. The surface has patches.
std::string_view why_not_exact(const Surface& surface);

/// CAD model of a surface. Patches that are not splines of the degree in use, or would weigh more exactly
/// than fitted, are fitted by splines of degree 3 or 5, whichever needs fewer control points. Errors:
/// E_CANCELLED. O(patches) for a fixed tolerance.
Result<CadModel> make_cad_model(const Surface& surface, const CadModelOptions& options = {},
                                const CancelToken& cancel = {}, const Progress& progress = {});

}  // namespace hariko
