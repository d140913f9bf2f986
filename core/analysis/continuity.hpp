#pragma once

// How well patches meet: gaps, angles between normals, and jumps of curvature along seams.

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// What was found along one seam. Positions and normals are compared at 33 points, x = k / 32, both ends
/// included; curvature tensors at 21 points, x = (k + 1/2) / 21.
struct SeamContinuity {
  double gap = 0;  ///< largest distance of the two sides, length
  double normal_jump =
      0;  ///< largest angle between the normals, radians, on seams of any intended continuity
  /// Root mean squares over the 21 points, 1/length: of the Frobenius norm of the difference of the two
  /// curvature tensors, and of the mean of the two tensors' norms.
  double curvature_jump = 0, curvature = 0;
  double largest_curvature_jump = 0;    ///< of the 21 points, 1/length
  std::uint16_t curvature_samples = 0;  ///< of the 21, those where both sides have a curvature
  std::uint16_t degenerate = 0;         ///< of the 33, see ContinuityReport
  std::uint16_t folded = 0;
};

struct ContinuityReport {
  double largest_gap = 0;  ///< over all seams
  /// Over the seams intended to be smooth (G1 or G2), radians; nothing when there are none.
  std::optional<double> largest_normal_jump;
  /// Root mean square of the curvature jumps relative to that of the curvature, over the smooth seams;
  /// nothing when there are none, zero where the surface is flat along all of them.
  std::optional<double> rms_curvature_jump;
  /// Points of smooth seams that are left out of the normal jumps: |ds x dt| of a side is below 1e-9 of that
  /// patch's mean, or, at an end, rounding of the control points alone turns the normal by more than 1e-11
  /// radians; and the node gives no normal either. Between the ends also points where it does so and the
  /// jump is not larger than that.
  std::size_t degenerate_samples = 0;
  /// Points of smooth seams where the normals of the sides are opposite while the tangent planes agree to
  /// 1e-6 radians: the surface folds back. The jump is then the angle between the planes.
  std::size_t folded_samples = 0;
  std::vector<SeamContinuity> seams;  ///< one for each seam of the surface; empty when cancelled
};

/// Angles are atan2(|n x m|, n . m). At the ends of a seam whose node has a tangent plane, each side is
/// compared with that plane, and a side that is degenerate there, or whose derivatives are so short
/// that rounding of the control points turns its normal by more than 1e-11 radians, takes the plane's normal.
/// In parallel, the same on any number of threads. O(110 seams).
ContinuityReport continuity(const Surface& surface, const CancelToken& cancel = {});

/// What still counts as smooth.
struct ContinuityTolerance {
  double angle = 0.1;      ///< between the normals, degrees
  double curvature = 0.1;  ///< jump of the curvature tensor relative to its size on both sides, 0 .. 2
  friend bool operator==(const ContinuityTolerance&, const ContinuityTolerance&) = default;
};

/// The continuity that each seam has within the tolerance, whatever was intended: by its largest normal jump,
/// and by the root mean squares of jump and curvature. Where both sides are flat against the size of the
/// patch it is G2. `report` must be of `surface` and not of a cancelled run. O(seams).
std::vector<Continuity> classify(const Surface& surface, const ContinuityReport& report,
                                 const ContinuityTolerance& tolerance);

}  // namespace hariko
