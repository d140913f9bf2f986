#include "core/patching/polyhedron_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/base/index_list.hpp"
#include "core/patching/fair/drag_response.hpp"
#include "core/patching/g2_surface.hpp"
#include "core/patching/joins/g2_joins.hpp"
#include "core/patching/surface_adjacency.hpp"
#include "core/patching/surface_system.hpp"
#include "core/patching/surface_warnings.hpp"

namespace hariko {

namespace {

constexpr double drag_tolerance = 1e-6;    ///< tolerance of the fairness solve when tensions change in a drag
constexpr double drag_negligible = 1e-10;  ///< movement of patches that is ignored, relative to the size
/// Number of half-edges up to which metric frames follow a drag: such a surface is rebuilt within a frame's
/// time.
constexpr Index largest_live_frames = 1000;

std::optional<Message> check_sides(const Polyhedron& polyhedron, Mode mode) {
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const Index sides = polyhedron.topology().side_count(f);
    if (sides <= largest_fair_side_count) continue;
    const FaceId id = polyhedron.face_id(f);
    return make_error(e_too_many_sides,
                      "Face " + std::to_string(id.value) + " has " + std::to_string(sides) + " sides; mode " +
                          (mode == Mode::fair ? "FAIR" : "G2") + " takes " +
                          std::to_string(largest_fair_side_count) + " at the most.",
                      "Split the face, or use mode TARGET.", element_of(id));
  }
  return std::nullopt;
}

bool equal_but_pins(const Shaping& a, const Shaping& b) {
  return a.alpha == b.alpha && a.beta == b.beta && a.crease == b.crease && a.tag == b.tag &&
         a.form == b.form && a.kept_area == b.kept_area;
}

/// Diagonal of the bounding box of the positions.
double size_of(std::span<const Vector3> positions) {
  Eigen::AlignedBox3d box;
  for (const Vector3& p : positions) box.extend(p);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

/// Flags of pinned vertices; empty where nothing is pinned.
std::vector<bool> pinned_vertices(const PolyhedronSurfaceInput& input) {
  std::vector<bool> out;
  for (const auto& [id, pin] : input.shaping.pin) {
    const Index v = input.polyhedron.find(id);
    if (v == no_index) continue;
    out.resize(input.polyhedron.vertex_count());
    out[v] = true;
  }
  return out;
}

/// Common displacement between two states of a polyhedron, of which each moved vertex makes a share.
struct CommonMove {
  std::vector<Index> moved;
  std::vector<double> weight;
  Vector3 displacement = Vector3::Zero();
};

/// Common displacement of the moved vertices; nothing where their moves are not shares of one displacement.
/// The weights of `known` are kept if it moves the same vertices and they fit.
template <class Response>
std::optional<CommonMove> common_move(const Polyhedron& polyhedron, const std::vector<Vector3>& from,
                                      const std::optional<Response>& known) {
  CommonMove out;
  std::vector<Vector3> moves;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
    const Vector3 move = polyhedron.position(v) - from[v];
    if (move.isZero(0)) continue;
    if (move.squaredNorm() > out.displacement.squaredNorm()) out.displacement = move;
    out.moved.push_back(v);
    moves.push_back(move);
  }
  if (out.moved.empty()) {
    if (!known) return std::nullopt;
    out.moved = known->moved;
    out.weight = known->weight;
    return out;
  }
  const auto follows = [&](const std::vector<double>& weight) {
    for (std::size_t i = 0; i < moves.size(); ++i)
      if (!((moves[i] - weight[i] * out.displacement).norm() <= 1e-9 * out.displacement.norm())) return false;
    return true;
  };
  if (known && known->moved == out.moved && follows(known->weight)) {
    out.weight = known->weight;
    return out;
  }
  for (const Vector3& move : moves)
    out.weight.push_back(move.dot(out.displacement) / out.displacement.squaredNorm());
  if (!follows(out.weight)) return std::nullopt;
  return out;
}

}  // namespace

struct PolyhedronSurfacer::State {
  // Input that the systems were built for.
  std::optional<Polyhedron> polyhedron;
  Shaping shaping;
  std::shared_ptr<const ElementAliases> aliases;
  std::optional<SurfaceSystem> system;
  std::vector<Vector3> charted;  ///< metric frames: the positions that they were computed from
  JoinPlan joins;
  Surface::Parts parts;
  std::shared_ptr<const QuarticTables> tables = std::make_shared<QuarticTables>();

  // Initial guesses for quality `drag`; `final` never reads them.
  std::vector<Vector3> last_basis;
  FairSystem::Field last_unknowns;
  G2System::Field last_g2;
  G2Target g2_target;  ///< target of the last surface; stays while dragging

  // Last `final` result, the base of a drag.
  struct Base {
    std::vector<Vector3> positions;
    double size = 0;
    QuarticPatchArray patches;             // in all modes except G2
    std::shared_ptr<const G2PatchSet> g2;  // in mode G2
    Surface surface;
    std::vector<Vector3> basis;  ///< basis vectors of the network
    std::uint64_t revision = 0;
    std::vector<Join> joins;
    std::shared_ptr<const std::vector<JoinCoefficients>> coefficients;
  };
  std::optional<Base> base;
  std::optional<DragResponse> response;
  std::optional<G2DragResponse> g2_response;
  std::uint64_t revision = 0;

  /// Whether metric frames and target curvatures stay as they are while the object is dragged.
  static bool holds_frames(const PolyhedronSurfaceInput& input) {
    return input.mode == Mode::g2 || (frames_in(input.mode, input.frames) == Frames::metric &&
                                      input.polyhedron.topology().half_edge_count() > largest_live_frames);
  }
  std::optional<Message> prepare(const PolyhedronSurfaceInput& input, Quality quality);
  Result<NetworkSystem> assemble(const PolyhedronSurfaceInput& input) const;
  /// Solves the network, and the coefficients of the joins.
  Result<NetworkSystem::Solution> solve_network(std::span<const Vector3> positions, Quality quality,
                                                JoinPlan::Solution& joined);
  std::optional<Message> prepare_pins(const PolyhedronSurfaceInput& input);
  bool base_has(const PolyhedronSurfaceInput& input) const;
  bool moves_rim(const CommonMove& move) const;
  std::optional<PolyhedronSurface> drag(const PolyhedronSurfaceInput& input, const CancelToken& cancel);
  void make_fair() {
    if (!system->fair)
      system->fair =
          std::make_unique<FairSystem>(system->mesh, system->network, system->constants, system->given_side);
  }
  std::optional<QuarticPatchArray> fair_patches(const std::vector<Vector3>& positions, const Network& network,
                                                const JoinGeometry& joined,
                                                const FairSystem::SolveOptions& options,
                                                const CancelToken& cancel, SolveReport& report);
  std::shared_ptr<const G2PatchSet> solve_g2(const std::vector<Vector3>& positions, const Network& network,
                                             const JoinPlan::Solution& joined, Quality quality,
                                             const CancelToken& cancel, SolveReport& report,
                                             std::shared_ptr<Network>& drawn);
  Result<PolyhedronSurface> solve(const PolyhedronSurfaceInput& input, Quality quality,
                                  const CancelToken& cancel);
};

Result<NetworkSystem> PolyhedronSurfacer::State::assemble(const PolyhedronSurfaceInput& input) const {
  const std::vector<Index> joined = joins.half_edges();
  return NetworkSystem::assemble(joins.polyhedron(), input.shaping,
                                 {frames_in(input.mode, input.frames), joins.requests(), joined});
}

std::optional<Message> PolyhedronSurfacer::State::prepare(const PolyhedronSurfaceInput& input,
                                                          Quality quality) {
  const bool same_mesh = polyhedron && polyhedron->shared_topology() == input.polyhedron.shared_topology();
  const bool same_names =
      aliases == input.aliases || (aliases && input.aliases && *aliases == *input.aliases);
  auto plan = JoinPlan::make(input.polyhedron, input.shaping, input.joins);
  if (!plan) return plan.error();
  const Frames frames = frames_in(input.mode, input.frames);
  const bool metric = frames == Frames::metric;
  const bool same_structure = same_mesh && same_names && system && system->mode == input.mode &&
                              system->network.frames().charts.frames == frames && joins.same_structure(*plan);
  const bool same_charts = !metric || (quality == Quality::drag && holds_frames(input)) ||
                           plan->polyhedron().positions() == charted;
  const bool same = same_structure && same_charts && shaping == input.shaping;
  const bool same_but_pins = same_structure && !metric && equal_but_pins(shaping, input.shaping);
  joins = std::move(plan).value();
  polyhedron = input.polyhedron;
  aliases = input.aliases;
  if (same) return std::nullopt;
  if (same_but_pins) return prepare_pins(input);
  system.reset();
  base.reset();
  response.reset();
  g2_response.reset();
  g2_target.clear();
  if (!same_mesh) {
    last_basis.clear();
    last_unknowns = {};
    last_g2.clear();
  }
  if (input.mode == Mode::fair || input.mode == Mode::g2)
    if (auto failed = check_sides(input.polyhedron, input.mode)) return failed;
  auto network = assemble(input);
  if (!network) return network.error();
  shaping = input.shaping;
  if (metric) charted = joins.polyhedron().positions();
  const auto& mesh = input.polyhedron.shared_topology();
  system =
      SurfaceSystem{mesh, std::move(network).value(), {}, input.mode, nullptr, nullptr, joins.smooth_sides()};
  system->constants = patch_constants(*mesh, system->network.frames());
  if (input.mode == Mode::fair || input.mode == Mode::g2)
    system->rims = clamped_boundary_edges(input.polyhedron, input.shaping);
  if (input.mode == Mode::fair) make_fair();
  if (input.mode == Mode::g2) {
    system->g2 = std::make_unique<G2System>(mesh, system->network, G2Weights{}, given_ribbons(joins));
    system->g2->fix_tangents(pinned_vertices(input));
  }
  parts = polyhedron_surface_parts(input.polyhedron, system->network.frames(), aliases.get(),
                                   input.mode == Mode::g2 ? Continuity::g2 : Continuity::g1);
  return std::nullopt;
}

/// Takes over changed pins, which concern the network only. Where they fix the tangents that the base has
/// anyway (the beginning of a local edit), it remains the base of the drag that follows.
std::optional<Message> PolyhedronSurfacer::State::prepare_pins(const PolyhedronSurfaceInput& input) {
  if (!joins.empty() || !base_has(input)) base.reset();
  response.reset();
  g2_response.reset();
  auto network = assemble(input);
  if (!network) {
    system.reset();
    return network.error();
  }
  system->network = std::move(network).value();
  if (system->g2) system->g2->fix_tangents(pinned_vertices(input));
  if (input.mode == Mode::fair || input.mode == Mode::g2) {
    std::vector<Index> rims = clamped_boundary_edges(input.polyhedron, input.shaping);
    if (rims != system->rims) base.reset();
    system->rims = std::move(rims);
  }
  shaping = input.shaping;
  return std::nullopt;
}

/// Whether the input adds to the base's pins at most pins of the tangents that the base's network has.
bool PolyhedronSurfacer::State::base_has(const PolyhedronSurfaceInput& input) const {
  if (!base) return false;
  const auto& before = shaping.pin;
  const auto& after = input.shaping.pin;
  const std::vector<Index>& begin = system->network.frames().basis_begin;
  for (const auto& [id, pin] : before)
    if (const Pin* kept = after.find(id); !kept || !(*kept == pin)) return false;
  for (const auto& [id, pin] : after) {
    const Index v = input.polyhedron.find(id);
    if (before.contains(id) || v == no_index) continue;
    if (pin.kind != Pin::Kind::tangents || pin.vectors.size() != begin[v + 1] - begin[v]) return false;
    if (!std::equal(pin.vectors.begin(), pin.vectors.end(), base->basis.begin() + begin[v])) return false;
  }
  return true;
}

/// Whether a move affects the bending at a rim, which is not linear in the positions of its triangle's
/// corners.
bool PolyhedronSurfacer::State::moves_rim(const CommonMove& move) const {
  const HalfEdgeMesh& mesh = *system->mesh;
  const auto moved = [&](Index v) { return std::binary_search(move.moved.begin(), move.moved.end(), v); };
  return std::any_of(system->rims.begin(), system->rims.end(), [&](Index h) {
    return moved(mesh.origin(h)) || moved(mesh.target(h)) || moved(mesh.target(mesh.next(h)));
  });
}

/// Fast path of a drag: since the last final result vertices moved along one displacement only, each by a
/// share of it.
std::optional<PolyhedronSurface> PolyhedronSurfacer::State::drag(const PolyhedronSurfaceInput& input,
                                                                 const CancelToken& cancel) {
  if (!base || system->network.couples_coordinates() || base->surface.origin() != input.origin ||
      base->joins != joins.joins())
    return std::nullopt;
  std::shared_ptr<const PatchSet> patches;
  CornerNormal normal;
  /// Keeps `response` or solves a new one for this move; false when it was cancelled.
  const auto prepare_response = [&](auto& known, CommonMove& move, const auto& make) {
    if (known && known->moved == move.moved && known->weight == move.weight) {
      if (!known->settled) refine(*system, *known, cancel);
      return !cancel.cancelled();
    }
    known = make(*system, std::move(move.moved), std::move(move.weight), cancel);
    if (cancel.cancelled()) known.reset();
    return known.has_value();
  };
  std::vector<Index> touched;
  bool settled = true;
  const double negligible = drag_negligible * base->size;
  if (system->g2) {
    auto move = common_move(joins.polyhedron(), base->positions, g2_response);
    if (!move || !prepare_response(g2_response, *move, g2_drag_response)) return std::nullopt;
    auto moved = displaced(*system->mesh, *base->g2, *g2_response, move->displacement, negligible, touched);
    settled = g2_response->settled;
    normal = [moved](Index patch, int corner) { return moved->corner_normal(patch, corner); };
    patches = std::move(moved);
  } else {
    auto move = common_move(joins.polyhedron(), base->positions, response);
    if (move && moves_rim(*move)) return std::nullopt;
    if (!move || !prepare_response(response, *move, drag_response)) return std::nullopt;
    auto moved = std::make_shared<QuarticPatchSet>(
        displaced(base->patches, *response, move->displacement, negligible, touched), tables);
    settled = response->settled;
    normal = corner_normals(moved->array());
    patches = std::move(moved);
  }
  auto changed = std::make_shared<const std::vector<Index>>(std::move(touched));
  auto normals = std::make_shared<std::vector<Vector3>>(base->surface.node_count());
  for (Index n = 0; n < base->surface.node_count(); ++n) (*normals)[n] = base->surface.node_normal(n);
  update_node_normals(*system->mesh, system->network.frames(), parts, normal, *changed, *normals);

  PolyhedronSurface out;
  out.surface = base->surface.with_patches(std::move(patches), normals);
  out.revision = ++revision;
  out.base_revision = base->revision;
  out.changed = std::move(changed);
  out.settled = settled;
  out.provisional = holds_frames(input);
  out.joins = base->coefficients;
  return out;
}

/// Solves the network. Joined sides are satisfied in two steps: first with tangents kept in the sides'
/// planes, then with the tangents that one lambda per side requires.
Result<NetworkSystem::Solution> PolyhedronSurfacer::State::solve_network(std::span<const Vector3> positions,
                                                                         Quality quality,
                                                                         JoinPlan::Solution& joined) {
  NetworkSystem& network = system->network;
  NetworkSystem::SolveOptions options;
  if (quality == Quality::drag && !last_basis.empty()) options.start = &last_basis;
  if (!joins.empty()) network.set_conditions(joins.first_conditions(network.frames()));
  auto solution = network.solve(positions, options);
  if (!joins.any_smooth()) return solution;
  auto met = joins.solve(network.frames(), system->constants, solution.basis);
  if (!met) return met.error();
  joined = std::move(met).value();
  network.set_conditions(joined.conditions);
  options.start = &solution.basis;
  auto second = network.solve(positions, options);
  second.iterations += solution.iterations;
  return second;
}

/// Patches of mode G2 over a solved network; nothing when cancelled. Target curvatures come from the surface
/// of mode FAIR, and then from the surface solved with these. `drawn` becomes the network with the surface's
/// tangents.
std::shared_ptr<const G2PatchSet> PolyhedronSurfacer::State::solve_g2(
    const std::vector<Vector3>& positions, const Network& network, const JoinPlan::Solution& joined,
    Quality quality, const CancelToken& cancel, SolveReport& report, std::shared_ptr<Network>& drawn) {
  G2System& g2 = *system->g2;
  G2System::SolveOptions options;
  if (quality == Quality::drag) {
    options.tolerance = drag_tolerance;
    if (last_g2.size() == g2.unknown_count()) options.start = &last_g2;
  }
  std::optional<GivenSides> sides;
  if (!joins.empty())
    sides = g2.resolve(given_sides(joins, joined, system->network.frames(), system->constants, network));
  G2System::Given given{positions, &network, sides ? &*sides : nullptr, &g2_target};
  G2System::Solution first;
  if (quality == Quality::final || g2_target.empty()) {
    make_fair();
    const auto fair = fair_patches(positions, network, joined.geometry, {}, cancel, report);
    if (!fair) return nullptr;
    const G2System::References by_fair = g2.over(reference_patches(*fair));
    g2.bend_over(by_fair);
    g2_target = g2.target(by_fair, positions);
    if (quality == Quality::final) {
      first = g2.solve(given, options, cancel);
      if (first.cancelled || cancel.cancelled()) return nullptr;
      const G2System::References by_first = g2.over(g2_patches(g2, given, first.unknowns));
      g2.bend_over(by_first);
      g2_target = g2.target(by_first, positions, &by_fair);
      options.start = &first.unknowns;
    }
  }
  auto solution = g2.solve(given, options, cancel);
  if (solution.cancelled || cancel.cancelled()) return nullptr;
  report.g2_iterations = first.iterations + solution.iterations;
  report.g2_converged = first.converged && solution.converged;
  last_g2 = std::move(solution.unknowns);
  drawn = std::make_shared<Network>(g2.network_of(given, last_g2));
  return g2_patches(g2, given, last_g2);
}

/// Patches of the other modes; nothing when cancelled.
std::optional<QuarticPatchArray> PolyhedronSurfacer::State::fair_patches(
    const std::vector<Vector3>& positions, const Network& network, const JoinGeometry& joined,
    const FairSystem::SolveOptions& options, const CancelToken& cancel, SolveReport& report) {
  const HalfEdgeMesh& mesh = *system->mesh;
  const std::vector<Index> faces = ascending_indices(mesh.face_count()),
                           vertices = ascending_indices(mesh.vertex_count());
  std::vector<QuarticPatch> patches(mesh.half_edge_count());
  auto fair = build_patches(*system, positions, network, {faces, vertices}, options, cancel, patches, joined,
                            system->rims);
  if (fair.cancelled || cancel.cancelled()) return std::nullopt;
  report.fair_iterations = fair.iterations;
  report.fair_converged = fair.converged;
  last_unknowns = std::move(fair.unknowns);
  return QuarticPatchArray(patches);
}

Result<PolyhedronSurface> PolyhedronSurfacer::State::solve(const PolyhedronSurfaceInput& input,
                                                           Quality quality, const CancelToken& cancel) {
  const HalfEdgeMesh& mesh = *system->mesh;
  const std::vector<Vector3> positions = joins.polyhedron().positions();
  const bool warm = quality == Quality::drag;
  const auto cancelled = [] { return make_error(e_cancelled, "The surface was not finished."); };

  JoinPlan::Solution joined;
  auto solution = solve_network(positions, quality, joined);
  if (!solution) return solution.error();
  PolyhedronSurface out;
  auto network = std::make_shared<Network>(system->network.network(*solution, positions));
  last_basis = std::move(solution->basis);
  if (cancel.cancelled()) return cancelled();

  Base fresh;
  std::shared_ptr<const PatchSet> patches;
  CornerNormal normal;
  if (system->g2) {
    std::shared_ptr<Network> drawn;
    fresh.g2 = solve_g2(positions, *network, joined, quality, cancel, out.report, drawn);
    if (!fresh.g2) return cancelled();
    network = drawn;
    patches = fresh.g2;
    normal = [&](Index patch, int corner) { return fresh.g2->corner_normal(patch, corner); };
  } else {
    FairSystem::SolveOptions options;
    if (warm) options.tolerance = drag_tolerance;
    if (warm && system->fair && last_unknowns.size() == system->fair->unknown_count())
      options.start = &last_unknowns;
    auto array = fair_patches(positions, *network, joined.geometry, options, cancel, out.report);
    if (!array) return cancelled();
    fresh.patches = std::move(*array);
    patches = std::make_shared<QuarticPatchSet>(fresh.patches, tables);
    normal = corner_normals(fresh.patches);
  }
  Surface::Parts full = parts;
  full.origin = input.origin;
  full.node_normals =
      std::make_shared<std::vector<Vector3>>(node_normals(mesh, system->network.frames(), parts, normal));
  full.patches = std::move(patches);
  out.surface = Surface(std::move(full));
  out.revision = out.base_revision = ++revision;
  out.joins = std::make_shared<std::vector<JoinCoefficients>>(std::move(joined.coefficients));
  if (quality == Quality::final) {
    out.warnings = surface_warnings(joins.polyhedron(), *network, out.surface, input.aliases.get());
    out.warnings.insert(out.warnings.end(), joined.warnings.begin(), joined.warnings.end());
    fresh.positions = positions;
    fresh.size = size_of(positions);
    fresh.surface = out.surface;
    fresh.revision = out.revision;
    fresh.joins = joins.joins();
    fresh.coefficients = out.joins;
    fresh.basis = last_basis;
    base = std::move(fresh);
    response.reset();
    g2_response.reset();
  }
  out.provisional = warm && holds_frames(input);
  out.network = std::move(network);
  return out;
}

PolyhedronSurfacer::PolyhedronSurfacer() : state_(std::make_unique<State>()) {}
PolyhedronSurfacer::~PolyhedronSurfacer() = default;
PolyhedronSurfacer::PolyhedronSurfacer(PolyhedronSurfacer&&) noexcept = default;
PolyhedronSurfacer& PolyhedronSurfacer::operator=(PolyhedronSurfacer&&) noexcept = default;

Result<PolyhedronSurface> PolyhedronSurfacer::rebuild(const PolyhedronSurfaceInput& input, Quality quality,
                                                      const CancelToken& cancel) {
  if (auto failed = state_->prepare(input, quality)) {
    if (input.aliases) failed->element = input.aliases->original(failed->element);
    return *failed;
  }
  if (quality == Quality::drag)
    if (auto fast = state_->drag(input, cancel)) return std::move(*fast);
  auto made = state_->solve(input, quality, cancel);
  if (!made && input.aliases) {
    Message failed = made.error();
    failed.element = input.aliases->original(failed.element);
    return failed;
  }
  return made;
}

}  // namespace hariko
