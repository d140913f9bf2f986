#pragma once

// A polyhedron with its shaping becomes a Surface: the producer that the rest of the program calls.

#include <memory>
#include <optional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/result.hpp"
#include "core/network/network.hpp"
#include "core/network/shaping.hpp"
#include "core/patching/join_plan.hpp"
#include "core/polyhedron/element_aliases.hpp"
#include "core/polyhedron/polyhedron.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

inline constexpr Code e_too_many_sides{"E_TOO_MANY_SIDES"};
inline constexpr Code w_long_tangent{"W_LONG_TANGENT"};
inline constexpr Code w_fold{"W_FOLD"};

/// How a surface was made: what a reproducible file of it records.
struct SolveReport {
  int network_iterations = 0;
  int fair_iterations = 0;
  bool fair_converged = true;
  int g2_iterations = 0;
  bool g2_converged = true;
};

/// `final`: a function of the input alone, from a cold start. `drag`: may reuse the last result; where
/// vertices moved by shares of one common displacement since the last `final` result, it differs from `final`
/// by less than 1e-6 of the displacement (mode G2: 1e-9 of the object's size, with target curvatures as they
/// were) and touches only the patches that feel it. Frames by measure that rest (see `frames`) add what they
/// would have changed.
enum class Quality { drag, final };

/// Mode FAIR keeps a dense matrix of (4n)^2 numbers for an n-sided face, mode G2 one of (10n)^2; more sides
/// than this are refused.
inline constexpr Index largest_fair_side_count = 128;

struct PolyhedronSurfaceInput {
  Polyhedron polyhedron;
  Shaping shaping;
  Mode mode = Mode::fair;
  Vector3 origin = Vector3::Zero();  ///< what the polyhedron's positions are relative to
  /// Where some elements are copies of others: provenance and messages then name the originals. May be null.
  std::shared_ptr<const ElementAliases> aliases = {};
  /// Border edges that take the sides of bicubic patches: their vertices lie where the sides end.
  std::vector<Join> joins = {};
  /// Mode PAPER keeps equal frames. While an object of mode G2 or a large one is dragged, frames by measure
  /// are those of the last `final` result.
  Frames frames = Frames::equal;
};

struct PolyhedronSurface {
  Surface surface;
  /// Curves along the polyhedron's edges; null where only some patches were updated (`changed` is set).
  std::shared_ptr<const Network> network;
  /// W_LONG_TANGENT, W_FOLD and W_JOIN_SCALE; filled at quality `final` only.
  std::vector<Message> warnings;
  /// Round solids: by how much these stick out on purpose, a length (`EnvelopeSurface`).
  std::optional<double> sticks_out;
  SolveReport report;
  /// One a join, in the order of the half-edges; those of G0 mean nothing. Kept from the last full solve.
  std::shared_ptr<const std::vector<JoinCoefficients>> joins;

  /// Every result of a surfacer has its own revision. When `changed` is set, all patches but these are equal
  /// to those of the result with revision `base_revision`; results of one drag share that base.
  std::uint64_t revision = 0, base_revision = 0;
  std::shared_ptr<const std::vector<Index>> changed;
  /// False in the first frames of a drag: the answer to the move is not solved to the end yet, which the next
  /// calls with quality `drag` go on with. The surface is smooth, but some 1e-4 of the move off.
  bool settled = true;
};

/// Keeps what depends on connectivity and tensions only (assembled systems, factorisations, responses)
/// between calls. One per object; calls must not overlap. The result of a `final` call does not depend on
/// earlier calls.
class PolyhedronSurfacer {
 public:
  PolyhedronSurfacer();
  ~PolyhedronSurfacer();
  PolyhedronSurfacer(PolyhedronSurfacer&&) noexcept;
  PolyhedronSurfacer& operator=(PolyhedronSurfacer&&) noexcept;

  /// Errors: those of `NetworkSystem::assemble`, of `JoinPlan`, E_TOO_MANY_SIDES in modes FAIR and G2,
  /// and E_CANCELLED.
  Result<PolyhedronSurface> rebuild(const PolyhedronSurfaceInput& input, Quality quality = Quality::final,
                                    const CancelToken& cancel = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hariko
