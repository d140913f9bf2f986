#include "core/envelope/field_envelope.hpp"

#include <algorithm>

#include "core/envelope/envelope.hpp"

namespace hariko {

namespace {

struct Rung {
  double fillet, crispness, detail, budget;
  double distance = 0;  ///< from the solids, of the diagonal
};
/// The first six follow the solids. Crowds whose surfaces fold or miss a solid there get ones that keep away
/// from them, with fillets that fill narrow notches.
constexpr Rung ladder[] = {{0.5, 0.7, 1, 400},       {1, 0.7, 1, 400},     {1, 0.2, 1, 400},
                           {0.7, 0.7, 0.8, 400},     {1, 0.7, 1, 220},     {1.5, 0.2, 1.2, 280},
                           {1.5, 0.2, 1, 280, 0.01}, {3, 0, 1, 280, 0.02}, {4, 0, 1.2, 200, 0.05}};

constexpr double slack_fillet = 2;  ///< of the cell: what a lower tightness adds to the fillets

/// Vertices of a symmetric field are images of each other but for rounding and the ties that it breaks.
constexpr double mirror_tolerance = 5e-3;  ///< of the diagonal

std::vector<std::vector<Index>> cage_loops(const FieldCage& cage) {
  std::vector<std::vector<Index>> out;
  for (const auto& quad : cage.quads) out.emplace_back(quad.begin(), quad.end());
  return out;
}

double miss_of(const CageSurface& surface) {
  return surface.check ? surface.check->worst : surface.worst;
}

struct FieldJob {
  const EnvelopeInput& input;
  std::span<const PlacedSolid> placed;
  const Vector3& origin;
  Quality quality;
  const CancelToken& cancel;
  FieldScene scene;
  std::vector<GridReference> references;

  FieldCage cage(const FieldScene& of, std::span<const GridReference> by, const Rung& rung) const {
    return field_cage(of, by,
                      {rung.fillet + slack_fillet * (1 - input.settings.tightness), rung.crispness,
                       rung.detail * input.settings.cage_detail, rung.budget},
                      cancel);
  }

  /// Round the solids, or at a distance from them.
  FieldCage cage(const Rung& rung) const {
    if (rung.distance == 0) return cage(scene, references, rung);
    EnvelopeInput wide = input;
    wide.settings.clearance += rung.distance * scene.diagonal;
    const FieldScene away = field_scene(wide, placed, origin);
    return cage(away, grid_references(away), rung);
  }

  /// Nothing where there is no cage, or none that is its own image.
  Result<std::optional<FieldEnvelope>> attempt(int level) const {
    const FieldCage made_cage = cage(ladder[level]);
    if (cancel.cancelled()) return make_error(e_cancelled, "The surface was cancelled.");
    if (made_cage.quads.empty()) return std::optional<FieldEnvelope>();
    CageSurfaceRequest request;
    request.cage.positions = made_cage.positions;
    for (const auto& quad : made_cage.quads) request.cage.add_face(quad);
    if (scene.symmetry) {
      request.mirror = find_mirror(made_cage.positions, cage_loops(made_cage), *scene.symmetry,
                                   mirror_tolerance * scene.diagonal);
      if (!request.mirror) return std::optional<FieldEnvelope>();
      even(*request.mirror, request.cage.positions);
    }
    request.cell = made_cage.cell;
    request.origin = origin;
    request.diagonal = scene.diagonal;
    request.distances = scene.distances;
    request.placed = placed;
    if (quality == Quality::drag) {
      request.rounds = 2;
      request.strict = false;
    }
    auto made = cage_surface(request, cancel);
    if (!made) return made.error();
    FieldEnvelope out{std::move(made).value(), level,
                      ladder[level].distance,  false,
                      made_cage.components,    made_cage.tunnels,
                      made_cage.wanted_tunnels};
    out.enclosed = miss_of(out.surface) <= request.tolerance * scene.diagonal;
    return std::optional<FieldEnvelope>(std::move(out));
  }

  /// 0 for what is wanted; what is not sound comes last.
  double badness(const FieldEnvelope& one) const {
    const int other =
        std::abs(one.tunnels - one.wanted_tunnels) + std::abs(one.components - int(scene.clusters.size()));
    if (one.sound()) return 2 * other;
    return 1000 + double(one.surface.folds) + 200 * miss_of(one.surface) / scene.diagonal + 2 * other;
  }
};

}  // namespace

Result<FieldEnvelope> field_envelope(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                                     const Vector3& origin, Quality quality, int level,
                                     const CancelToken& cancel) {
  FieldJob job{input, placed, origin, quality, cancel, field_scene(input, placed, origin), {}};
  job.references = grid_references(job.scene);
  std::optional<FieldEnvelope> best;
  double least = 1e300;
  std::optional<Message> failure;
  for (; level < int(std::size(ladder)); ++level) {
    if (ladder[level].distance > 0 && best && best->sound()) break;
    auto made = job.attempt(level);
    if (!made) {
      failure = made.error();
      if (cancel.cancelled()) return *failure;
      continue;
    }
    std::optional<FieldEnvelope> one = std::move(made).value();
    if (!one) continue;
    if (const double bad = job.badness(*one); bad < least) least = bad, best = std::move(one);
    if (least == 0 || quality == Quality::drag) break;
  }
  if (best) return *std::move(best);
  if (failure) return *failure;
  return make_error(e_envelope_flat, "No cage was found round the solids.",
                    "Make the thinnest solid thicker, or choose the network.");
}

}  // namespace hariko
