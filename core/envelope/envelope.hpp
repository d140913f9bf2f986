#pragma once

// Solids become one smooth surface round them: the producer that the rest of the program calls.

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
/// Some of the surface lies inside of another part of it.
inline constexpr Code w_envelope_crossing{"W_ENVELOPE_CROSSING"};
inline constexpr Code w_solid_hull{"W_SOLID_HULL"};
inline constexpr Code w_not_symmetric{"W_NOT_SYMMETRIC"};
/// Patches are not as near to the shape as wanted.
inline constexpr Code w_envelope_coarse{"W_ENVELOPE_COARSE"};
/// Another method made the surface before, or settings of the file mean nothing any more.
inline constexpr Code w_envelope_method{"W_ENVELOPE_METHOD"};
/// The rounding is too small for the size of the solids.
inline constexpr Code w_rounding_raised{"W_ROUNDING_RAISED"};

struct EnvelopeSurface {
  Surface surface;
  std::shared_ptr<const CurveNetwork> network;  ///< null of the ball
  std::shared_ptr<const BallCage> cage;         ///< quads of the ball's patches; null of the network
  int components = 1, tunnels = 0;              ///< separate parts, holes
  Vector3 origin = Vector3::Zero();             ///< what everything is relative to
  double diagonal = 0;                          ///< of the solids
  bool enclosed = false;  ///< to 1e-4 of the diagonal; while dragging the ball alone knows
  /// Length by which solids stick out of a ball whose faces lie on theirs; of no other surface.
  std::optional<double> sticks_out;
  std::optional<EnclosureReport>
      check;               ///< of the final network, and of a final ball whose patches miss its shape
  std::size_t folds = 0;   ///< patches with a fold
  std::size_t coarse = 0;  ///< patches of the ball that miss its shape
  int rounds = 0;          ///< in which cubes below patches of the ball were halved
  bool symmetric = false;  ///< in the plane of the settings
  std::vector<Message> warnings;
};

/// One per object; calls must not overlap. The result of a `final` call does not depend on earlier calls.
class EnvelopeSurfacer {
 public:
  /// Errors: those of `check_envelope`; E_ENVELOPE_FLAT, E_CANCELLED. Warnings: W_NOT_ENCLOSED,
  /// W_ENVELOPE_FOLD, W_ENVELOPE_CROSSING, W_SOLID_HULL (a polyhedron with points inside of its hull),
  /// W_NOT_SYMMETRIC, W_ENVELOPE_COARSE, W_ENVELOPE_METHOD, W_ROUNDING_RAISED.
  Result<EnvelopeSurface> rebuild(const EnvelopeInput& input, Quality quality = Quality::final,
                                  const CancelToken& cancel = {});
};

}  // namespace hariko
