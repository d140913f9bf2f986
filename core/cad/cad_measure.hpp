#pragma once

// How near a CAD model is to the surface that it was made of.

#include <vector>

#include "core/base/cancellation.hpp"
#include "core/cad/cad_model.hpp"

namespace hariko {

struct CadMeasure {
  /// Distance of each face, from its points to the surface near equal parameters: never less than the
  /// distance; lengths.
  std::vector<double> distances;
  double largest = 0;
  double normal_jump = 0;  ///< largest across edges that are meant to be smooth, radians
  Index jump_edge = no_index;
  /// Largest across the same edges, of the normal curvature across them, relative to the largest curvature
  /// there or, where that is flatter, to a radius of the model's size. Models that are meant to have
  /// continuous curvature.
  double curvature_jump = 0;
  std::size_t exact = 0;  ///< faces closer than `exact_face` of the size
  std::size_t control_points = 0;
  double edge_deviation = 0;  ///< largest between edges and the boundaries of their faces
};

/// Looks at `samples` x `samples` places in each rectangle between knots, its sides included, and at as many
/// along each stretch of an edge. What is given after `cancel` is cancelled is of no use.
CadMeasure measure_cad(const Surface& surface, const CadModel& model, int samples = 4,
                       const CancelToken& cancel = {});

}  // namespace hariko
