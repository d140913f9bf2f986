#pragma once

// CadModel: a surface as CAD programs want it: vertices, edges and faces with B-splines, every edge shared by
// the faces that meet there. What makes files of it is in core/cad/kernel.

#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/cad/cad_plan.hpp"
#include "core/cad/spline.hpp"

namespace hariko {

/// A curve over 0 .. length of its first use; runs from `begin` to `end`.
struct CadEdge {
  Index begin = no_index, end = no_index;
  SplineCurve curve;
  std::array<CadUse, 2> uses;  ///< pieces are faces here
  int use_count = 1;
  bool smooth = true;
  bool degenerate = false;  ///< a side that is shrunk to a point
  double deviation = 0;     ///< largest measured distance to the faces' own boundaries
};

struct CadFace {
  SplineSurface surface;  ///< over the breaks of its piece; the outside is on the left of ds, dt
  std::array<std::vector<Index>, 4> sides;  ///< edges, counter-clockwise
  bool exact = false;                       ///< the surface itself, to rounding
  bool reached = true;                      ///< the tolerance held at the places that the fit looked at
};

/// Positions are relative to `origin`.
struct CadModel {
  Vector3 origin = Vector3::Zero();
  double size = 0;  ///< diagonal of the box round the vertices and control points
  std::vector<Vector3> vertices;
  std::vector<CadEdge> edges;
  std::vector<CadFace> faces;
  std::vector<CadPiece> pieces;  ///< one a face: what it stands for

  /// The surface is meant to have continuous curvature across smooth edges.
  bool curvature = false;

  /// Every edge has two faces.
  bool closed() const;
};

inline constexpr double usual_cad_tolerance = 1e-4;  ///< of the diagonal
inline constexpr double usual_cad_angle = 0.1 * std::numbers::pi / 180;

struct CadModelOptions {
  /// Between the surface and faces that cannot be exact: a length, and a share of the size; the larger holds.
  double tolerance = 0, share = usual_cad_tolerance;
  double angle = usual_cad_angle;  ///< likewise between faces along smooth edges, radians
  bool exact =
      false;  ///< faces that are splines are exact, also where others of less weight keep the tolerance
  /// Triangles round the split point of a face of four sides are one face, also where more faces of them have
  /// less weight.
  bool whole_faces = false;
};
/// Of the diagonal: closer than this, a face is the surface.
inline constexpr double exact_face = 1e-12;

/// Why faces of a surface that are no splines of the degree in use are none, in a few words: "rational
/// triangles ...".
std::string_view why_not_exact(const Surface& surface);

/// Errors: E_CANCELLED. What is not a spline of the degree in use, or weighs more than a fit would, is fitted
/// by splines of degree 3 or 5, whichever has less control points. O(patches) for a fixed tolerance.
Result<CadModel> make_cad_model(const Surface& surface, const CadModelOptions& options = {},
                                const CancelToken& cancel = {}, const Progress& progress = {});

}  // namespace hariko
