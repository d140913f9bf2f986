#pragma once

// Smoothed closing distance, sampled on a lattice; pulls, places chosen by hand through which the surface
// passes (docs/envelope.md).

#include "core/base/cancellation.hpp"
#include "core/envelope/ball/closing_memory.hpp"

namespace hariko {

/// Pull relative to a field's origin.
struct PulledPlace {
  Vector3 at = Vector3::Zero();
  double radius = 1;  ///< distance at which the pull has faded to nothing, at least
};

/// Pulls of all solids, in the order of these.
std::vector<PulledPlace> pulled_places(std::span<const Solid> solids, const Vector3& origin);

/// Distance at which a pull fades to nothing, if the surface is moved by `way` at its place: at least its own
/// radius, and so large that the moved part stays connected and bends no more than the edges of boxes.
double pull_reach(double radius, double way, double sigma);

/// Largest change of values by a pull at a distance, if the surface is moved by `way` at its place; pulls
/// beside it are allowed for.
double pull_bound(double way, double reach, double distance);

/// Bounding box of solids, larger where pulls outwards move the surface beyond it.
Eigen::AlignedBox3d pulled_box(const GrownUnion& solids, std::span<const PulledPlace> pulls, double sigma);

/// Offsets of a lattice's values, one per node, which subtracted from them before `passes` of the filter make
/// the field vanish at every place. `field`: the smoothed field without pulls. Negative where the surface is
/// pulled inwards. O(places x nodes).
std::vector<double> pull_offsets(const SplineField& field, int passes, std::span<const PulledPlace> places,
                                 double sigma);

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
  double radius, sigma;      ///< the radius is that of the rolling ball
  int passes;
  /// Nodes lie at multiples of the spacing from the object's origin, whatever the scene is, so that only the
  /// solids determine the surface.
  Vector3 origin;
  /// Axis of a symmetry plane: the solids are mirror images of each other.
  std::optional<Eigen::Index> mirror;
  std::vector<OwnBall> own_balls;
  std::vector<PulledPlace> pulls;  ///< relative to `origin`
};

/// Numbers of nodes: all, evaluated, and those where one solid alone does not determine the value.
struct LatticeReport {
  std::size_t nodes = 0, evaluated = 0, crease = 0;
  /// Number of evaluated nodes whose first value was not taken from the frame before.
  std::size_t searched = 0;
};

/// Computes the smoothed closing distance, whose zero surface is the envelope. Nodes farther from it than the
/// kernel reaches get a value between those of their neighbours. About a quarter of the nodes are evaluated.
/// `memory`, if not null: the frame before, of which values are taken where they are the same; it does not
/// change the result. With balls of their own between solids it is not used.
SplineField smoothed_closing(const LatticeRequest& request, LatticeReport& report, const CancelToken& cancel,
                             ClosingMemory* memory);

}  // namespace hariko
