#include "core/envelope/field_envelope.hpp"

#include <algorithm>

#include "core/envelope/envelope.hpp"

namespace hariko {

namespace {

struct Rung {
  double fillet, crispness, detail, budget;
};
constexpr Rung ladder[] = {{0.5, 0.7, 1, 400},   {1, 0.7, 1, 400}, {1, 0.2, 1, 400},
                           {0.7, 0.7, 0.8, 400}, {1, 0.7, 1, 220}, {1.5, 0.2, 1.2, 280}};

constexpr double accepted_score = 0.5;
constexpr double slack_fillet = 2;  ///< of the cell: what a lower tightness adds to the fillets

/// Vertices of a symmetric field are images of each other but for rounding and the ties that it breaks.
constexpr double mirror_tolerance = 5e-3;  ///< of the diagonal

std::vector<std::vector<Index>> cage_loops(const FieldCage& cage) {
  std::vector<std::vector<Index>> out;
  for (const auto& quad : cage.quads) out.emplace_back(quad.begin(), quad.end());
  return out;
}

double score_of(const FieldEnvelope& one, int wanted_components, double diagonal) {
  const double miss = one.surface.check ? one.surface.check->worst : one.surface.worst;
  return double(one.surface.folds) + 200 * std::max(0.0, miss / diagonal - 1e-3) +
         2 * std::abs(one.tunnels - one.wanted_tunnels) + 2 * std::abs(one.components - wanted_components);
}

}  // namespace

Result<FieldEnvelope> field_envelope(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                                     const Vector3& origin, Quality quality, const CancelToken& cancel) {
  const FieldScene scene = field_scene(input, placed, origin);
  const std::vector<GridReference> references = grid_references(scene);
  std::optional<FieldEnvelope> best;
  double least = 1e300;
  std::optional<Message> failure;
  for (int level = 0; level < int(std::size(ladder)); ++level) {
    const Rung& rung = ladder[level];
    const FieldCage cage = field_cage(scene, references,
                                      {rung.fillet + slack_fillet * (1 - input.settings.tightness),
                                       rung.crispness, rung.detail * input.settings.cage_detail, rung.budget},
                                      cancel);
    if (cancel.cancelled()) return make_error(e_cancelled, "The surface was cancelled.");
    if (cage.quads.empty()) continue;
    CageSurfaceRequest request;
    request.cage.positions = cage.positions;
    for (const auto& quad : cage.quads) request.cage.add_face(quad);
    if (scene.symmetry) {
      const std::vector<std::vector<Index>> loops(cage_loops(cage));
      request.mirror = find_mirror(cage.positions, loops, *scene.symmetry, mirror_tolerance * scene.diagonal);
      if (!request.mirror) continue;
      even(*request.mirror, request.cage.positions);
    }
    request.cell = cage.cell;
    request.origin = origin;
    request.diagonal = scene.diagonal;
    request.distances = scene.distances;
    request.placed = placed;
    if (quality == Quality::drag) {
      request.rounds = 2;
      request.strict = false;
    }
    auto made = cage_surface(request, cancel);
    if (!made) {
      failure = made.error();
      if (cancel.cancelled()) return *failure;
      continue;
    }
    FieldEnvelope one{std::move(made).value(), level, cage.components, cage.tunnels, cage.wanted_tunnels};
    const double score = score_of(one, int(scene.clusters.size()), scene.diagonal);
    if (score < least) least = score, best = std::move(one);
    if (least < accepted_score || quality == Quality::drag) break;
  }
  if (best) return *std::move(best);
  if (failure) return *failure;
  return make_error(e_envelope_flat, "No cage was found round the solids.",
                    "Make the thinnest solid thicker, or choose the network.");
}

}  // namespace hariko
