#pragma once

// Rolling-ball envelope of solids: from solids to patches (docs/envelope.md).

#include <optional>

#include "core/base/result.hpp"
#include "core/envelope/ball/ball_cage.hpp"
#include "core/envelope/ball/ball_lattice.hpp"
#include "core/envelope/solid_shape.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Settings of the envelope; all numbers are lengths.
struct BallSettings {
  double radius = 1;     ///< radius of the ball
  double sigma = 0.03;   ///< standard deviation of the rounding
  double clearance = 0;  ///< distance kept from every solid
  bool on_faces = false, finer_patches = false;
};

/// Tolerance in units of sigma: the largest distance of patches from the field's zero surface, and the depth
/// of solids below it.
inline constexpr double patch_tolerance = 0.1;
inline constexpr double least_ball = 3;  ///< smallest radius of the ball, in sigma

/// Settings for solids of a size (the diagonal of their bounding box): the hull becomes a very large ball;
/// rounding and radius are raised to the smallest values that can be computed.
BallSettings ball_settings(const EnvelopeSettings& settings, double size);

/// Offset of solids beyond their growth constants, a length.
double room_outside(const BallSettings& settings);

/// Memory shared by calls for the same solids, kept from one to the next: constants, shapes, and while
/// dragging the closing. Results do not depend on it.
struct BallMemory {
  KnownSolids solids;
  ClosingMemory closing;
};

/// Field whose zero surface is the envelope.
struct BallField {
  SplineField field;
  LatticeReport lattice;
  std::size_t pinches = 0;       ///< number of necks that were joined and holes that were closed
  std::vector<Vector3> middles;  ///< one point inside every solid
};

/// Deviations of patches from a field's zero surface, at sampled points.
struct BallFit {
  double outward = 0, inward = 0;  ///< largest distances, lengths
  std::size_t folds = 0;           ///< number of patches with a normal opposite to the field's gradient
  std::size_t coarse = 0;          ///< number of patches that deviate by more than the tolerance
  int rounds = 0;                  ///< number of rounds in which quads or cubes were split
};

/// Envelope with its field, mesh, patches and measured deviations.
struct BallEnvelope : BallField, BallFit {
  Surface surface;
  BallCage cage;
  CageTopology topology;
  /// Largest distance by which solids protrude from the field's zero surface, if flat faces lie on it.
  double sticks_out = 0;
  std::size_t lost = 0;  ///< number of solids whose part of the zero surface has no patches
  /// Least depth of every solid below the field's zero surface, unless faces lie on it.
  double tolerance = 0;

  /// Whether the patches contain every solid, unless faces lie on the zero surface: a solid lies in one part
  /// of the field's inside, which patches near its zero surface leave only together with the solid's middle.
  bool contains_solids() const { return inward <= tolerance && lost == 0; }
};

/// Computes the field: the first step of `ball_envelope`. `memory`: of the calls before, or null.
BallField ball_field(std::span<const Solid> solids, const BallSettings& settings, const Vector3& origin,
                     std::optional<Eigen::Index> mirror, Quality quality, const CancelToken& cancel = {},
                     BallMemory* memory = nullptr);
/// Largest distance of points of the solids outside the field's zero surface from that surface: surface
/// points, corners and points of edges and rims. O(solids).
double sticking_out(const SplineField& field, std::span<const SolidShape> solids, double sigma);

/// Quad mesh over cubes of the default size, fine enough to count components.
BallCage cage_of(const BallField& field, const Vector3& origin, double sigma);

/// Makes the envelope. `solids` include the mirror images where `mirror` is given, and are placed relative to
/// `origin`. Nothing where there is no surface or the work was cancelled. O(nodes of the lattice).
std::optional<BallEnvelope> ball_envelope(std::span<const Solid> solids, const BallSettings& settings,
                                          const Vector3& origin, std::optional<Eigen::Index> mirror,
                                          Quality quality, const CancelToken& cancel = {},
                                          BallMemory* memory = nullptr);

}  // namespace hariko
