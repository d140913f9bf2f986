#pragma once

// PolyhedronSurfacer: from a polyhedron with its shaping to a Surface; the producer that the rest of the
// program calls.

#include <memory>
#include <optional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/result.hpp"
#include "core/network/network.hpp"
#include "core/network/shaping.hpp"
#include "core/patching/joins/join_plan.hpp"
#include "core/polyhedron/element_aliases.hpp"
#include "core/polyhedron/polyhedron.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

inline constexpr Code e_too_many_sides{"E_TOO_MANY_SIDES"};
inline constexpr Code w_long_tangent{"W_LONG_TANGENT"};
inline constexpr Code w_fold{"W_FOLD"};

/// Solver statistics of a surface, as recorded in reproducible files.
struct SolveReport {
  int fair_iterations = 0;
  bool fair_converged = true;
  int g2_iterations = 0;
  bool g2_converged = true;
};

/// Quality of a rebuild. `final`: a function of the input alone, from a cold start. `drag`: may reuse the
/// last result; where vertices moved by shares of one common displacement since the last `final` result, it
/// differs from `final` by less than 1e-6 of the displacement (mode G2: 1e-9 of the object's size, with
/// unchanged target curvatures) and changes only the patches that it affects. Metric frames that stay fixed
/// meanwhile (see `frames`) add the effect of their change.
enum class Quality { drag, final };

/// Largest number of sides of a face in modes FAIR and G2; faces with more are refused. Mode FAIR keeps a
/// dense matrix of (4n)^2 numbers for an n-sided face, mode G2 one of (10n)^2.
inline constexpr Index largest_fair_side_count = 128;

/// Input of a surface: all that a `final` result depends on.
struct PolyhedronSurfaceInput {
  Polyhedron polyhedron;
  Shaping shaping;
  Mode mode = Mode::fair;
  Vector3 origin = Vector3::Zero();  ///< origin of the polyhedron's positions
  /// Aliases where some elements are copies of others: provenance and messages then name the originals. May
  /// be null.
  std::shared_ptr<const ElementAliases> aliases = {};
  /// Border edges joined to sides of bicubic patches: their vertices are moved to the ends of the sides.
  std::vector<Join> joins = {};
  /// Frames of the surface; mode PAPER keeps equal frames. While an object of mode G2 or a large one is
  /// dragged, metric frames are those of the last `final` result.
  Frames frames = Frames::equal;
};

/// Surface with its report and warnings.
struct PolyhedronSurface {
  Surface surface;
  /// Curves along the polyhedron's edges; null where only some patches were updated (`changed` is set).
  std::shared_ptr<const Network> network;
  /// Warnings W_LONG_TANGENT, W_FOLD and W_JOIN_SCALE; filled at quality `final` only.
  std::vector<Message> warnings;
  SolveReport report;
  /// Coefficients per join, in the order of the half-edges; meaningless for G0. Kept from the last full
  /// solve.
  std::shared_ptr<const std::vector<JoinCoefficients>> joins;

  /// Revision of this result, unique within a surfacer. When `changed` is set, all other patches are equal to
  /// those of the result with revision `base_revision`; results of one drag share that base.
  std::uint64_t revision = 0, base_revision = 0;
  std::shared_ptr<const std::vector<Index>> changed;
  /// False in the first frames of a drag: the response to the move is not solved completely, and the next
  /// calls with quality `drag` continue it. The surface is smooth, but off by some 1e-4 of the move.
  bool settled = true;
  /// Whether frames or target curvatures are those of the last `final` result: the `final` surface of the
  /// same input differs by the effect of their change.
  bool provisional = false;
};

/// Producer of one object's surfaces. Keeps data that depends on connectivity and tensions only (assembled
/// systems, factorisations, responses) between calls. One per object; calls must not overlap. The result of a
/// `final` call does not depend on earlier calls.
class PolyhedronSurfacer {
 public:
  PolyhedronSurfacer();
  ~PolyhedronSurfacer();
  PolyhedronSurfacer(PolyhedronSurfacer&&) noexcept;
  PolyhedronSurfacer& operator=(PolyhedronSurfacer&&) noexcept;

  /// Computes the surface. Errors: those of `NetworkSystem::assemble` and of `JoinPlan`, E_TOO_MANY_SIDES in
  /// modes FAIR and G2, and E_CANCELLED.
  Result<PolyhedronSurface> rebuild(const PolyhedronSurfaceInput& input, Quality quality = Quality::final,
                                    const CancelToken& cancel = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hariko
