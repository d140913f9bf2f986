#pragma once

// Fitting of a polyhedron, so that its surface is nearest to a reference, as a scan is.

#include <cstddef>
#include <span>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/document/source.hpp"
#include "core/modeling/surfacing/reference_facets.hpp"

namespace hariko {

inline constexpr int max_fit_steps = 50;

struct FitOptions {
  int steps = 8;  ///< at most, 1 .. max_fit_steps; less where a step brings no more than a hundredth
};

/// Distances of samples of a surface from a reference, in the space of the polyhedron: at the centres of the
/// 16 equal triangles that the domain of each patch is cut into. Samples count by the area that they stand
/// for; those beside the reference's border do not count (`ReferenceFoot::is_beyond`).
struct ReferenceDistance {
  double mean = 0, root_mean_square = 0, largest = 0;
  std::size_t counted = 0, beyond = 0;
};

struct ReferenceFit {
  PolyhedronSource source;
  ReferenceDistance before, after;
  int steps = 0;  ///< number of steps made
};

/// Moves vertices, unless they stay (`vertices_that_stay`), so that the surface round them is nearest to the
/// reference, which is seen from `source`. Each step is a linear least-squares problem over the displacements
/// of the vertices: the distances of the samples along the ways to their nearest points (point to plane),
/// where samples follow the vertices by their shares (`vertex_shares`, with the frames as they were at
/// first), and, much weaker, the differences between the displacements of neighbours, so that what the
/// reference leaves open follows. The surface is made anew after each step, which counts only as far as it
/// lowers the mean square of the distances; so that never rises. Distances are those over the faces in which
/// a moving vertex has shares. The seam of a live mirror stays in its plane, and both halves count.
/// Attachments to other objects are ignored. The same on any number of threads, and for polyhedron and
/// reference placed or scaled together up to rounding. Errors: those of `vertices_to_move` and of the
/// surface, E_BAD_AMOUNT (steps), E_WRONG_SELECTION (no part of the surface lies over the reference),
/// E_CANCELLED. Progress goes by the steps that may be made, so it may end early. O(samples log facets +
/// unknowns^1.5) per step.
Result<ReferenceFit> fit_to_reference(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                      const ReferenceFacets& reference, const FitOptions& options,
                                      const CancelToken& cancel = {}, const Progress& progress = {});

}  // namespace hariko
