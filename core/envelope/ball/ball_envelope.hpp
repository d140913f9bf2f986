#pragma once

// The smooth surface that a rolling ball leaves round solids: from solids to patches (docs/envelope.md).

#include <optional>

#include "core/base/result.hpp"
#include "core/envelope/ball/ball_cage.hpp"
#include "core/envelope/ball/ball_lattice.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Lengths.
struct BallSettings {
  double radius = 1;     ///< of the ball
  double sigma = 0.03;   ///< of the rounding
  double clearance = 0;  ///< that is kept from every solid
};

struct BallEnvelope {
  Surface surface;
  BallCage cage;
  SplineField field;
  CageTopology topology;
  double outward = 0, inward = 0;  ///< farthest samples of patches from the field's zero, lengths
  std::size_t folds = 0;           ///< patches with normals that look away from the field's
  std::size_t coarse = 0;          ///< patches that are farther from it than `tolerance`
  double tolerance = 0;            ///< length that every solid lies below the field's zero at least
  int rounds = 0;                  ///< in which cubes were halved
  LatticeReport lattice;
};

/// `solids` with the images of those beyond the plane across `mirror`, relative to `origin`. Nothing where
/// there is no surface; cancelled work gives nothing, too. O(nodes of the lattice).
std::optional<BallEnvelope> ball_envelope(std::span<const Solid> solids, const BallSettings& settings,
                                          const Vector3& origin, std::optional<Eigen::Index> mirror,
                                          Quality quality, const CancelToken& cancel = {});

}  // namespace hariko
