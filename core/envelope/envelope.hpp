#pragma once

// Solids become one smooth surface round them: the producer that the rest of the program calls.

#include <memory>

#include "core/base/cancellation.hpp"
#include "core/base/result.hpp"
#include "core/envelope/enclosure.hpp"
#include "core/envelope/enclosure_check.hpp"
#include "core/envelope/envelope_handles.hpp"
#include "core/envelope/envelope_route.hpp"
#include "core/envelope/field_envelope.hpp"
#include "core/envelope/hull_envelope.hpp"
#include "core/envelope/valley_envelope.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

inline constexpr Code e_envelope_flat{"E_ENVELOPE_FLAT"};
inline constexpr Code w_not_enclosed{"W_NOT_ENCLOSED"};
inline constexpr Code w_envelope_fold{"W_ENVELOPE_FOLD"};
/// Some of the surface lies inside of another part of it.
inline constexpr Code w_envelope_crossing{"W_ENVELOPE_CROSSING"};
inline constexpr Code w_tightness_reduced{"W_TIGHTNESS_REDUCED"};
inline constexpr Code w_solid_hull{"W_SOLID_HULL"};
inline constexpr Code w_not_symmetric{"W_NOT_SYMMETRIC"};
/// Patches are not as near to the shape as wanted.
inline constexpr Code w_envelope_coarse{"W_ENVELOPE_COARSE"};
/// Another method made the surface before.
inline constexpr Code w_envelope_method{"W_ENVELOPE_METHOD"};
/// The rounding is too small for the size of the solids.
inline constexpr Code w_rounding_raised{"W_ROUNDING_RAISED"};

struct EnvelopeSurface {
  Surface surface;
  std::shared_ptr<const CurveNetwork> network;  ///< null on a field's cage
  /// That the surface is fair over, or of whose quads the ball's patches are; null for rational patches, and
  /// while dragging of the ball.
  std::shared_ptr<const Polyhedron> cage;
  Shaping shaping;                            ///< tensions of the cage's edges
  int components = 1, tunnels = 0;            ///< separate parts, holes
  Vector3 origin = Vector3::Zero();           ///< what everything is relative to
  double diagonal = 0;                        ///< of the solids
  bool enclosed = false;                      ///< by the search's own test, to 1e-4 of the diagonal
  double worst = 0;                           ///< of that test, length
  std::optional<EnclosureReport> check;       ///< quality `final` only: the independent one
  EnvelopeRoute route = EnvelopeRoute::hull;  ///< what it was made on
  int level = 0;          ///< of the route's ladder, 0: the tightness asked for; 9: the hull instead
  std::size_t folds = 0;  ///< patches with a fold
  int builds = 0;
  bool symmetric = false;   ///< in the plane of the settings
  EnvelopeHandles handles;  ///< relative to `origin`
  std::vector<Message> warnings;
};

/// Keeps the last result to start a drag from. One per object; calls must not overlap. The result of a
/// `final` call does not depend on earlier calls.
class EnvelopeSurfacer {
 public:
  /// Errors: those of `check_envelope`; E_ENVELOPE_FLAT. Warnings: W_NOT_ENCLOSED, W_ENVELOPE_FOLD,
  /// W_ENVELOPE_CROSSING, W_TIGHTNESS_REDUCED, W_TIGHTNESS_LOOSE, W_WAIST_LIMITED, W_PULL_LIMITED,
  /// W_SOLID_HULL (a polyhedron with points inside of its hull), W_NOT_SYMMETRIC, W_ENVELOPE_COARSE,
  /// W_ENVELOPE_METHOD, W_ROUNDING_RAISED.
  Result<EnvelopeSurface> rebuild(const EnvelopeInput& input, Quality quality = Quality::final,
                                  const CancelToken& cancel = {});

 private:
  struct Job;
  /// False where the valleys cannot be followed.
  Result<bool> make_valleys(Job& job);
  /// False where every cage folds.
  Result<bool> make_field(Job& job);
  /// That of the last final result, where it was made of the same.
  Result<std::shared_ptr<const FieldBase>> base_of(const Job& job);
  Result<Done> make_ball(Job& job);
  Result<Done> make_hull(Job& job);
  Result<Done> make_fair_hull(Job& job, HullEnvelope first);
  Result<Done> take_network(Job& job, EnclosedNetwork found);
  /// Of the last result, where it was made of the same solids.
  GrowthState last_state(const Job& job) const;

  GrowthState last_;
  EnvelopeRoute last_route_ = EnvelopeRoute::hull;
  int last_level_ = 0;
  ValleyAttempt last_attempt_;
  HullAttempt last_hull_;
  EnvelopeInput last_base_input_;  ///< without waists and what was pulled
  std::shared_ptr<const FieldBase> last_base_;
  std::vector<GridChoice> last_grids_;                                ///< of the last frame
  std::vector<std::pair<std::uint32_t, std::uint32_t>> last_solids_;  ///< id and part
};

}  // namespace hariko
