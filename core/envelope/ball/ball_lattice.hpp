#pragma once

// Smoothed closing distance, sampled on a lattice (docs/envelope.md).

#include <optional>

#include "core/base/cancellation.hpp"
#include "core/envelope/ball/closing.hpp"
#include "core/envelope/ball/pulls.hpp"
#include "core/envelope/ball/spline_field.hpp"

namespace hariko {

/// Number of passes of the filter (1 2 1) / 4 before the B-spline: fewer passes on a coarser lattice give the
/// same width.
inline constexpr int final_passes = 3, drag_passes = 2;

/// Node spacing for which the passes and the cubic B-spline together have the standard deviation `sigma`.
double lattice_spacing(double sigma, int passes);

/// Ball of a different radius between certain solids.
struct OwnBall {
  double radius = 1;
  /// One per solid: whether the ball may touch it; it applies only where it touches no others.
  std::vector<char> between;
};

struct LatticeRequest {
  const GrownUnion& solids;  ///< positions relative to `origin`
  double radius = 1;         ///< radius of the rolling ball
  double sigma = 1;
  int passes = final_passes;
  /// Nodes lie at multiples of the spacing from the object's origin, whatever the scene is, so that only the
  /// solids determine the surface.
  Vector3 origin = Vector3::Zero();
  /// Axis of a symmetry plane: the solids are mirror images of each other.
  std::optional<Eigen::Index> mirror = {};
  std::vector<OwnBall> own_balls = {};
  std::vector<PulledPlace> pulls = {};  ///< relative to `origin`
};

/// Numbers of nodes: all, evaluated, and those where one solid alone does not determine the value.
struct LatticeReport {
  std::size_t nodes = 0, evaluated = 0, crease = 0;
};

/// Computes the smoothed closing distance, whose zero surface is the envelope. Nodes farther from it than the
/// kernel reaches get a value between those of their neighbours. About a quarter of the nodes are evaluated.
SplineField smoothed_closing(const LatticeRequest& request, LatticeReport* report = nullptr,
                             const CancelToken& cancel = {});

}  // namespace hariko
