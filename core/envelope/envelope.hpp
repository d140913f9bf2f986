#pragma once

// EnvelopeSurfacer: the smooth surface around solids, for the rest of the program.

#include <memory>

#include "core/base/cancellation.hpp"
#include "core/base/result.hpp"
#include "core/envelope/ball/ball_cage.hpp"
#include "core/envelope/enclosure_check.hpp"
#include "core/envelope/network/curve_network.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

inline constexpr Code e_envelope_flat{"E_ENVELOPE_FLAT"};
inline constexpr Code w_not_enclosed{"W_NOT_ENCLOSED"};
inline constexpr Code w_envelope_fold{"W_ENVELOPE_FOLD"};
/// Warning: part of the surface lies inside another part of it.
inline constexpr Code w_envelope_crossing{"W_ENVELOPE_CROSSING"};
inline constexpr Code w_solid_hull{"W_SOLID_HULL"};
inline constexpr Code w_not_symmetric{"W_NOT_SYMMETRIC"};
/// Warning: patches deviate from the shape by more than the tolerance.
inline constexpr Code w_envelope_coarse{"W_ENVELOPE_COARSE"};
/// Warning: another method made the surface before, or settings of the file are obsolete.
inline constexpr Code w_envelope_method{"W_ENVELOPE_METHOD"};
/// Warning: places where the surface was pulled mean nothing to method `network`.
inline constexpr Code w_pulls_unused{"W_PULLS_UNUSED"};
/// Warning: the rounding is too small for the size of the solids and was raised.
inline constexpr Code w_rounding_raised{"W_ROUNDING_RAISED"};

struct EnvelopeSurface {
  Surface surface;
  std::shared_ptr<const CurveNetwork> network;  ///< null for method `ball`
  std::shared_ptr<const BallCage> cage;         ///< quads of the ball's patches; null for method `network`
  int components = 1, tunnels = 0;              ///< number of components and of tunnels
  Vector3 origin = Vector3::Zero();             ///< origin of all positions
  double diagonal = 0;                          ///< diagonal of the solids' bounding box
  bool enclosed = false;  ///< to 1e-4 of the diagonal; while dragging known for method `ball` only
  /// Length by which solids protrude from a ball envelope whose faces lie on theirs; nothing for other
  /// surfaces.
  std::optional<double> sticks_out;
  /// Check of a final network, and of a final ball envelope with coarse patches.
  std::optional<EnclosureReport> check;
  std::size_t folds = 0;   ///< number of patches with a fold
  std::size_t coarse = 0;  ///< number of patches of the ball that deviate from its shape
  int rounds = 0;          ///< number of rounds in which cubes below patches of the ball were split
  bool symmetric = false;  ///< with respect to the plane of the settings
  std::vector<Message> warnings;
};

struct BallMemory;

/// Makes envelopes. One per object; calls must not overlap. Results do not depend on earlier calls, which
/// only make later ones faster.
class EnvelopeSurfacer {
 public:
  EnvelopeSurfacer();
  ~EnvelopeSurfacer();
  EnvelopeSurfacer(const EnvelopeSurfacer&) = delete;
  EnvelopeSurfacer& operator=(const EnvelopeSurfacer&) = delete;

  /// Makes the surface. Errors: those of `check_envelope`; E_ENVELOPE_FLAT, E_CANCELLED. Warnings:
  /// W_NOT_ENCLOSED, W_ENVELOPE_FOLD, W_ENVELOPE_CROSSING, W_SOLID_HULL (a polyhedron with points inside its
  /// hull), W_NOT_SYMMETRIC, W_ENVELOPE_COARSE, W_ENVELOPE_METHOD, W_ROUNDING_RAISED,
  /// W_PULLS_UNUSED.
  Result<EnvelopeSurface> rebuild(const EnvelopeInput& input, Quality quality = Quality::final,
                                  const CancelToken& cancel = {});

 private:
  std::unique_ptr<BallMemory> memory_;
};

}  // namespace hariko
