#pragma once

// Measured deviation of a CAD model from the surface that it was made of.

#include <vector>

#include "core/base/cancellation.hpp"
#include "core/cad/cad_model.hpp"

namespace hariko {

/// Deviations of a CAD model: distances, jumps across smooth edges, and size.
struct CadMeasure {
  /// Upper bound of the distance of each face from the surface: from sampled points of the face to the
  /// surface near equal parameters; lengths.
  std::vector<double> distances;
  /// Largest of `distances`.
  double largest = 0;
  /// Largest angle between normals across edges that are meant to be smooth, radians.
  double normal_jump = 0;
  /// Edge with the largest `normal_jump`.
  Index jump_edge = no_index;
  /// Largest jump, across the same edges, of the normal curvature across the edge, relative to the largest
  /// curvature there or, where that is flatter, to the curvature of a sphere with the model's size as radius.
  /// Measured only on models that are meant to have continuous curvature.
  double curvature_jump = 0;
  std::size_t exact = 0;  ///< faces closer to the surface than `exact_face` of the size
  std::size_t control_points = 0;
  double edge_deviation = 0;  ///< largest distance between edges and the boundaries of their faces
};

/// Measures a model at `samples` x `samples` places in each rectangle between knots, its sides included, and
/// at as many places along each stretch of an edge. The result is of no use once `cancel` is cancelled.
/// O(control points samples^2).
CadMeasure measure_cad(const Surface& surface, const CadModel& model, int samples = 4,
                       const CancelToken& cancel = {});

}  // namespace hariko
