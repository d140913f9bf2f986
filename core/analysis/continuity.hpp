#pragma once

// Continuity along seams: gaps, angles between normals, and jumps of curvature.

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Measurements along one seam. Positions and normals are compared at 33 points, x = k / 32, both ends
/// included; curvature tensors at 21 points, x = (k + 1/2) / 21.
struct SeamContinuity {
  double gap = 0;  ///< largest distance between the two sides, length
  /// Largest angle between the normals, radians, on seams of any intended continuity.
  double normal_jump = 0;
  /// Root mean squares over the 21 points, 1/length: of the Frobenius norm of the difference between the two
  /// curvature tensors, and of the mean of the two tensors' norms.
  double curvature_jump = 0, curvature = 0;
  double largest_curvature_jump = 0;    ///< largest jump at the 21 points, 1/length
  std::uint16_t curvature_samples = 0;  ///< number of the 21 points where both sides have a curvature
  std::uint16_t degenerate = 0;         ///< number of the 33 points that are degenerate, see ContinuityReport
  /// Number of the 33 points that are folded, see ContinuityReport.
  std::uint16_t folded = 0;
};

/// Measurements over all seams of a surface.
struct ContinuityReport {
  double largest_gap = 0;  ///< over all seams
  /// Largest normal jump over the seams intended to be smooth (G1 or G2), radians; nothing when there are
  /// none.
  std::optional<double> largest_normal_jump;
  /// Root mean square of the curvature jumps relative to that of the curvature, over the smooth seams;
  /// nothing when there are none, zero where the surface is flat along all of them.
  std::optional<double> rms_curvature_jump;
  /// Number of points of smooth seams that are left out of the normal jumps. At an end whose node gives no
  /// normal: |ds x dt| of a side is below 1e-9 of that patch's mean, or rounding of the control points alone
  /// turns the normal by more than 1e-11 radians. Between the ends: |ds x dt| is below that limit, or
  /// rounding turns the normal so far and the jump is not larger than the effect of rounding.
  std::size_t degenerate_samples = 0;
  /// Number of points of smooth seams where the normals of the two sides are opposite while the tangent
  /// planes agree to 1e-6 radians: the surface folds back. The jump is then the angle between the planes.
  std::size_t folded_samples = 0;
  std::vector<SeamContinuity> seams;  ///< one per seam of the surface; empty when cancelled
};

/// Measures the continuity along all seams. Angles are atan2(|n x m|, n . m). At the ends of a seam whose
/// node has a tangent plane, each side is compared with that plane, and a side that is degenerate there, or
/// whose derivatives are so short that rounding of the control points turns its normal by more than 1e-11
/// radians, takes the plane's normal. In parallel, with the same result on any number of threads. O(110
/// seams).
ContinuityReport continuity(const Surface& surface, const CancelToken& cancel = {});

/// Tolerances up to which a seam counts as smooth.
struct ContinuityTolerance {
  double angle = 0.1;      ///< angle between the normals, degrees
  double curvature = 0.1;  ///< jump of the curvature tensor relative to its size on both sides, 0 .. 2
  friend bool operator==(const ContinuityTolerance&, const ContinuityTolerance&) = default;
};

/// Measured continuity of each seam within the tolerance, whatever was intended: by its largest normal jump,
/// and by the root mean squares of jump and curvature. A seam where both sides are flat relative to the size
/// of the patch is G2. `report` must be of `surface` and not of a cancelled run. O(seams).
std::vector<Continuity> classify(const Surface& surface, const ContinuityReport& report,
                                 const ContinuityTolerance& tolerance);

}  // namespace hariko
