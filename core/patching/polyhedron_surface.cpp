#include "core/patching/polyhedron_surface.hpp"

#include <algorithm>
#include <numeric>

#include "core/patching/drag_response.hpp"
#include "core/patching/surface_parts.hpp"
#include "core/patching/surface_system.hpp"
#include "core/patching/surface_warnings.hpp"

namespace hariko {

namespace {

constexpr double drag_tolerance = 1e-6;  ///< of the fairness solve when tensions change in a drag

std::optional<Message> check_sides(const Polyhedron& polyhedron) {
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const Index sides = polyhedron.topology().side_count(f);
    if (sides <= largest_fair_side_count) continue;
    const FaceId id = polyhedron.face_id(f);
    return make_error(e_too_many_sides,
                      "Face " + std::to_string(id.value) + " has " + std::to_string(sides) +
                          " sides; mode FAIR takes " + std::to_string(largest_fair_side_count) +
                          " at the most.",
                      "Split the face, or use mode TARGET.", element_of(id));
  }
  return std::nullopt;
}

}  // namespace

struct PolyhedronSurfacer::State {
  // What the systems were built for.
  std::optional<Polyhedron> polyhedron;
  Shaping shaping;
  std::shared_ptr<const ElementAliases> aliases;
  std::optional<SurfaceSystem> system;
  Surface::Parts parts;
  std::shared_ptr<const QuarticTables> tables = std::make_shared<QuarticTables>();

  // Warm starts for quality `drag`; `final` never reads them.
  std::vector<Vector3> last_basis;
  FairSystem::Field last_unknowns;

  // The last `final` result, the base of a drag.
  struct Base {
    std::vector<Vector3> positions;
    QuarticPatchArray patches;
    Surface surface;
    std::uint64_t revision = 0;
  };
  std::optional<Base> base;
  std::optional<DragResponse> response;
  std::uint64_t revision = 0;

  std::optional<Message> prepare(const PolyhedronSurfaceInput& input);
  std::optional<PolyhedronSurface> drag(const PolyhedronSurfaceInput& input, const CancelToken& cancel);
  Result<PolyhedronSurface> solve(const PolyhedronSurfaceInput& input, Quality quality,
                                  const CancelToken& cancel);
};

std::optional<Message> PolyhedronSurfacer::State::prepare(const PolyhedronSurfaceInput& input) {
  const bool same_mesh = polyhedron && polyhedron->shared_topology() == input.polyhedron.shared_topology();
  const bool same_names =
      aliases == input.aliases || (aliases && input.aliases && *aliases == *input.aliases);
  const bool same =
      same_mesh && same_names && system && shaping == input.shaping && system->mode == input.mode;
  polyhedron = input.polyhedron;
  aliases = input.aliases;
  if (same) return std::nullopt;
  system.reset();
  base.reset();
  response.reset();
  if (!same_mesh) {
    last_basis.clear();
    last_unknowns = {};
  }
  if (input.mode == Mode::fair)
    if (auto failed = check_sides(input.polyhedron)) return failed;
  auto network = NetworkSystem::assemble(input.polyhedron, input.shaping);
  if (!network) return network.error();
  shaping = input.shaping;
  const auto& mesh = input.polyhedron.shared_topology();
  SurfaceSystem fresh{mesh, std::move(network).value(), {}, input.mode, nullptr};
  fresh.constants = patch_constants(*mesh, fresh.network.frames());
  if (input.mode == Mode::fair)
    fresh.fair = std::make_unique<FairSystem>(mesh, fresh.network, fresh.constants);
  parts = polyhedron_surface_parts(input.polyhedron, fresh.network.frames(), aliases.get());
  system = std::move(fresh);
  return std::nullopt;
}

/// The fast path: since the last final result vertices moved along one displacement only, each by a share of
/// it.
std::optional<PolyhedronSurface> PolyhedronSurfacer::State::drag(const PolyhedronSurfaceInput& input,
                                                                 const CancelToken& cancel) {
  if (!base || system->network.couples_coordinates() || base->surface.origin() != input.origin)
    return std::nullopt;
  std::vector<Index> moved;
  std::vector<Vector3> moves;
  Vector3 displacement = Vector3::Zero();
  for (Index v = 0; v < input.polyhedron.vertex_count(); ++v) {
    const Vector3 move = input.polyhedron.position(v) - base->positions[v];
    if (move.isZero(0)) continue;
    if (move.squaredNorm() > displacement.squaredNorm()) displacement = move;
    moved.push_back(v);
    moves.push_back(move);
  }
  if (moved.empty() && !response) return std::nullopt;
  const auto follows = [&](std::size_t i, double weight) {
    return (moves[i] - weight * displacement).norm() <= 1e-9 * displacement.norm();
  };
  const auto fits = [&] {
    if (response->moved != moved) return false;
    for (std::size_t i = 0; i < moved.size(); ++i)
      if (!follows(i, response->weight[i])) return false;
    return true;
  };
  if (!moved.empty() && !(response && fits())) {
    std::vector<double> weight(moved.size());
    for (std::size_t i = 0; i < moved.size(); ++i) {
      weight[i] = moves[i].dot(displacement) / displacement.squaredNorm();
      if (!follows(i, weight[i])) return std::nullopt;
    }
    response = drag_response(*system, std::move(moved), std::move(weight), cancel);
    if (cancel.cancelled()) {
      response.reset();
      return std::nullopt;
    }
  }
  QuarticPatchArray patches = displaced(base->patches, *response, displacement);
  auto normals = std::make_shared<std::vector<Vector3>>(base->surface.node_count());
  for (Index n = 0; n < base->surface.node_count(); ++n) (*normals)[n] = base->surface.node_normal(n);
  update_node_normals(*system->mesh, system->network.frames(), parts, patches, *response->patches, *normals);

  PolyhedronSurface out;
  out.surface =
      base->surface.with_patches(std::make_shared<QuarticPatchSet>(std::move(patches), tables), normals);
  out.revision = ++revision;
  out.base_revision = base->revision;
  out.changed = response->patches;
  return out;
}

Result<PolyhedronSurface> PolyhedronSurfacer::State::solve(const PolyhedronSurfaceInput& input,
                                                           Quality quality, const CancelToken& cancel) {
  const HalfEdgeMesh& mesh = *system->mesh;
  const std::vector<Vector3> positions = input.polyhedron.positions();
  const bool warm = quality == Quality::drag;
  const auto cancelled = [] { return make_error(e_cancelled, "The surface was not finished."); };

  NetworkSystem::SolveOptions network_options;
  if (warm && !last_basis.empty()) network_options.start = &last_basis;
  auto solution = system->network.solve(positions, network_options);
  PolyhedronSurface out;
  out.report.network_iterations = solution.iterations;
  auto network = std::make_shared<Network>(system->network.network(solution, positions));
  last_basis = std::move(solution.basis);
  if (cancel.cancelled()) return cancelled();

  std::vector<Index> faces(mesh.face_count()), vertices(mesh.vertex_count());
  std::iota(faces.begin(), faces.end(), Index(0));
  std::iota(vertices.begin(), vertices.end(), Index(0));
  FairSystem::SolveOptions options;
  if (warm) options.tolerance = drag_tolerance;
  if (warm && system->fair && last_unknowns.size() == system->fair->unknown_count())
    options.start = &last_unknowns;
  std::vector<QuarticPatch> patches(mesh.half_edge_count());
  auto fair = build_patches(*system, positions, *network, {faces, vertices}, options, cancel, patches);
  if (fair.cancelled || cancel.cancelled()) return cancelled();
  out.report.fair_iterations = fair.iterations;
  out.report.fair_converged = fair.converged;
  last_unknowns = std::move(fair.unknowns);

  QuarticPatchArray array(patches);
  Surface::Parts full = parts;
  full.origin = input.origin;
  full.node_normals =
      std::make_shared<std::vector<Vector3>>(node_normals(mesh, system->network.frames(), parts, array));
  full.patches = std::make_shared<QuarticPatchSet>(array, tables);
  out.surface = Surface(std::move(full));
  out.revision = out.base_revision = ++revision;
  if (quality == Quality::final) {
    out.warnings = surface_warnings(input.polyhedron, *network, out.surface);
    base = Base{positions, std::move(array), out.surface, out.revision};
    response.reset();
  }
  out.network = std::move(network);
  return out;
}

PolyhedronSurfacer::PolyhedronSurfacer() : state_(std::make_unique<State>()) {}
PolyhedronSurfacer::~PolyhedronSurfacer() = default;
PolyhedronSurfacer::PolyhedronSurfacer(PolyhedronSurfacer&&) noexcept = default;
PolyhedronSurfacer& PolyhedronSurfacer::operator=(PolyhedronSurfacer&&) noexcept = default;

Result<PolyhedronSurface> PolyhedronSurfacer::rebuild(const PolyhedronSurfaceInput& input, Quality quality,
                                                      const CancelToken& cancel) {
  if (auto failed = state_->prepare(input)) {
    if (input.aliases) failed->element = input.aliases->original(failed->element);
    return *failed;
  }
  if (quality == Quality::drag)
    if (auto fast = state_->drag(input, cancel)) return std::move(*fast);
  auto made = state_->solve(input, quality, cancel);
  // What is said of a copy was said of its original.
  if (made && input.aliases)
    std::erase_if(made.value().warnings,
                  [&](const Message& warning) { return input.aliases->is_copy(warning.element); });
  return made;
}

}  // namespace hariko
