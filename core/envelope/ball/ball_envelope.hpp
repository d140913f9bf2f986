#pragma once

// The smooth surface that a rolling ball leaves round solids: from solids to patches (docs/envelope.md).

#include <optional>

#include "core/base/result.hpp"
#include "core/envelope/ball/ball_cage.hpp"
#include "core/envelope/ball/ball_lattice.hpp"
#include "core/envelope/solid_shape.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Lengths.
struct BallSettings {
  double radius = 1;     ///< of the ball
  double sigma = 0.03;   ///< of the rounding
  double clearance = 0;  ///< that is kept from every solid
  bool on_faces = false, finer_patches = false;
};

/// Tolerance in units of sigma: patches may be so far from the field's zero, and solids lie below it by as
/// much.
inline constexpr double patch_tolerance = 0.1;

/// Settings for solids of a size (the diagonal of the box round them): the hull as a very large ball, neither
/// rounding nor ball too small to be computed.
BallSettings ball_settings(const EnvelopeSettings& settings, double size);

/// Length that solids are grown by beyond their constants.
double room_outside(const BallSettings& settings);

/// A field whose zero is the surface.
struct BallField {
  SplineField field;
  LatticeReport lattice;
  std::size_t pinches = 0;  ///< necks that were joined and holes that were closed
};

struct BallEnvelope : BallField {
  Surface surface;
  BallCage cage;
  CageTopology topology;
  /// Length by which solids stick out of the field's zero, where flat faces lie on them.
  double sticks_out = 0;
  double outward = 0, inward = 0;  ///< farthest samples of patches from the field's zero, lengths
  std::size_t folds = 0;           ///< patches with normals that look away from the field's
  std::size_t coarse = 0;          ///< patches that are farther from it than `tolerance`
  /// Length that every solid lies below the field's zero at least, where faces do not lie on them.
  double tolerance = 0;
  int rounds = 0;  ///< in which cubes were halved
};

/// The first step of `ball_envelope`.
BallField ball_field(std::span<const Solid> solids, const BallSettings& settings, const Vector3& origin,
                     std::optional<Eigen::Index> mirror, Quality quality, const CancelToken& cancel = {});
/// Farthest that points of the solids lie outside of the field's zero, a length: spread points, corners and
/// points of edges and rims, the way along the gradient. O(solids).
double sticking_out(const SplineField& field, std::span<const SolidShape> solids, double sigma);

/// A cage over cubes of the usual size: enough to count parts.
BallCage cage_of(const BallField& field, const Vector3& origin, double sigma);

/// `solids` with the images of those beyond the plane across `mirror`, relative to `origin`. Nothing where
/// there is no surface; cancelled work gives nothing, too. O(nodes of the lattice).
std::optional<BallEnvelope> ball_envelope(std::span<const Solid> solids, const BallSettings& settings,
                                          const Vector3& origin, std::optional<Eigen::Index> mirror,
                                          Quality quality, const CancelToken& cancel = {});

}  // namespace hariko
