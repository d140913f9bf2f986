#pragma once

// Pulls: places chosen by hand through which the ball's surface passes (docs/envelope.md).

#include <span>
#include <vector>

#include "core/envelope/ball/spline_field.hpp"
#include "core/envelope/solid.hpp"

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

/// Length by which a pull outwards moves the surface over a plane at the most, where the unpulled one lies
/// behind the plane and the place is `beyond` it, or before it where that is negative.
double pulled_over(double beyond, double way, double reach);

/// Offsets of a lattice's values, one per node, which subtracted from them before `passes` of the filter make
/// the field vanish at every place. `field`: the smoothed field without pulls. Negative where the surface is
/// pulled inwards. O(places x nodes).
std::vector<double> pull_offsets(const SplineField& field, int passes, std::span<const PulledPlace> places,
                                 double sigma);

}  // namespace hariko
