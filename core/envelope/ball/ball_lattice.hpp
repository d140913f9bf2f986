#pragma once

// The closed distance on a lattice, smoothed (docs/envelope.md).

#include <optional>

#include "core/base/cancellation.hpp"
#include "core/envelope/ball/closing.hpp"
#include "core/envelope/ball/spline_field.hpp"

namespace hariko {

/// Passes of (1 2 1) / 4 before the B-spline: fewer on a coarser lattice give the same width.
inline constexpr int final_passes = 3, drag_passes = 2;

/// Between nodes, so that the passes and the cubic B-spline have the standard deviation `sigma` together.
double lattice_spacing(double sigma, int passes);

/// A ball of another radius between some solids.
struct OwnBall {
  double radius = 1;
  std::vector<char> between;  ///< one a solid: it may be touched; nothing else may
};

struct LatticeRequest {
  const GrownUnion& solids;  ///< relative to `origin`
  double radius = 1;         ///< of the rolling ball
  double sigma = 1;
  int passes = final_passes;
  /// Nodes lie at multiples of the spacing from the object's zero, whatever the scene is: nothing but the
  /// solids moves the surface.
  Vector3 origin = Vector3::Zero();
  std::optional<Eigen::Index> mirror = {};  ///< solids are images of each other across this axis's plane
  std::vector<OwnBall> own_balls = {};
};

struct LatticeReport {
  std::size_t nodes = 0, evaluated = 0, crease = 0;
};

/// The smoothed closed distance; its zero is the surface. Nodes that are farther from it than the kernel
/// reaches have a value between those of their neighbours. A quarter of the nodes of a scene are looked at.
SplineField smoothed_closing(const LatticeRequest& request, LatticeReport* report = nullptr,
                             const CancelToken& cancel = {});

}  // namespace hariko
