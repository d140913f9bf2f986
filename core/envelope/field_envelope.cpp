#include "core/envelope/field_envelope.hpp"

#include <algorithm>
#include <cmath>

#include "core/envelope/bar_rings.hpp"
#include "core/envelope/envelope.hpp"
#include "core/envelope/fillet_bridges.hpp"

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

/// Vertices of a symmetric field are images of each other but for rounding and the ties that it breaks.
constexpr double mirror_tolerance = 5e-3;  ///< of the diagonal

/// Of the way to the wanted thickness of bars, by factors, and of that to the wanted places of vertices; the
/// first that can be gone is.
constexpr double shares[] = {1, 0.6, 0.3};

std::vector<std::vector<Index>> cage_loops(const PolygonMesh& cage) {
  std::vector<std::vector<Index>> out;
  for (std::size_t f = 0; f < cage.face_count(); ++f)
    out.emplace_back(cage.face(f).begin(), cage.face(f).end());
  return out;
}

double miss_of(const CageSurface& surface) {
  return surface.check ? surface.check->worst : surface.worst;
}

/// With the cell of each vertex of its cage.
struct FieldAttempt {
  FieldEnvelope envelope;
  std::vector<double> cell;
  std::vector<GridChoice> grids = {};
  std::vector<BarRing> rings = {};
};

struct FieldJob {
  const EnvelopeInput& input;
  std::span<const PlacedSolid> placed;
  const Vector3& origin;
  Quality quality;
  const CancelToken& cancel;
  const FieldScene& scene;
  std::span<const GridChoice> grids;  ///< known ones

  double fillet_of(const Rung& rung) const {
    return rung.fillet + slack_fillet * (1 - input.settings.tightness);
  }

  FieldCage cage(const FieldScene& of, std::span<const GridReference> by, const Rung& rung) const {
    return field_cage(
        of, by, {fillet_of(rung), rung.crispness, rung.detail * input.settings.cage_detail, rung.budget},
        cancel, grids);
  }

  /// Round the solids, or at a distance from them.
  FieldCage cage(const Rung& rung, std::span<const GridReference> references) const {
    if (rung.distance == 0) return cage(scene, references, rung);
    EnvelopeInput wide = input;
    wide.settings.clearance += rung.distance * scene.diagonal;
    const FieldScene away = field_scene(wide, placed, origin);
    return cage(away, grid_references(away), rung);
  }

  std::optional<CageMirror> mirror_of(const PolygonMesh& cage) const {
    if (!scene.symmetry) return {};
    return find_mirror(cage.positions, cage_loops(cage), *scene.symmetry, mirror_tolerance * scene.diagonal);
  }

  /// Nothing where the cage has to be its own image and is not.
  Result<std::optional<CageSurface>> surface_over(PolygonMesh cage, std::vector<double> cell,
                                                  std::vector<CageFullness> fullness = {}) const {
    CageSurfaceRequest request;
    request.cage = std::move(cage);
    request.mirror = mirror_of(request.cage);
    if (scene.symmetry && !request.mirror) return std::optional<CageSurface>();
    if (request.mirror) even(*request.mirror, request.cage.positions);
    request.cell = std::move(cell);
    request.fullness = std::move(fullness);
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
    return std::optional<CageSurface>(std::move(made).value());
  }

  bool encloses(const CageSurface& surface) const {
    return miss_of(surface) <= CageSurfaceRequest{}.tolerance * scene.diagonal;
  }

  /// Nothing where there is no cage, or none that is its own image.
  Result<std::optional<FieldAttempt>> attempt(int level, std::span<const GridReference> references) const {
    const FieldCage made_cage = cage(ladder[level], references);
    if (cancel.cancelled()) return make_error(e_cancelled, "The surface was cancelled.");
    if (made_cage.quads.empty()) return std::optional<FieldAttempt>();
    PolygonMesh mesh;
    mesh.positions = made_cage.positions;
    for (const auto& quad : made_cage.quads) mesh.add_face(quad);
    auto made = surface_over(std::move(mesh), made_cage.cell);
    if (!made) return made.error();
    if (!*made) return std::optional<FieldAttempt>();
    FieldEnvelope out{*std::move(*made),       level,
                      ladder[level].distance,  false,
                      made_cage.components,    made_cage.tunnels,
                      made_cage.wanted_tunnels};
    out.enclosed = encloses(out.surface);
    out.fillet = fillet_of(ladder[level]);
    return std::optional<FieldAttempt>({std::move(out), made_cage.cell, made_cage.grids});
  }

  std::vector<FieldBar> all_bars() const {
    std::vector<FieldBar> out;
    for (const FieldCluster& cluster : scene.clusters)
      out.insert(out.end(), cluster.bars.begin(), cluster.bars.end());
    return out;
  }

  /// Draws the bars' rings in, or widens them, as far as the surface stays sound. Of one that is not sound
  /// anyway bars stay as they are.
  Result<Done> follow_waists(FieldAttempt& attempt) const {
    FieldEnvelope& envelope = attempt.envelope;
    const std::vector<FieldBar> bars = all_bars();
    const auto rings_now = [&] {
      return bar_rings(bars, envelope.surface.cage, envelope.surface.made.surface);
    };
    std::vector<BarRing> rings = rings_now();
    const auto wants = [&](const auto& of) { return wanted_thickness(input.settings, of.solids) != 1; };
    // Where a bar has no ring, nothing follows its waist.
    const bool all_ringed = std::ranges::count_if(bars, wants) == std::ranges::count_if(rings, wants);
    envelope.waists_followed = all_ringed;
    if (std::ranges::any_of(rings, wants)) {
      envelope.waists_followed = false;
      for (const double share : shares) {
        if (!envelope.sound() && quality == Quality::final) break;
        std::vector<double> factors;
        for (const BarRing& ring : rings)
          factors.push_back(std::pow(wanted_thickness(input.settings, ring.solids), share));
        RingedCage ringed = ringed_cage(envelope.surface.cage, attempt.cell, rings, factors);
        auto made = surface_over(std::move(ringed.mesh), ringed.cell);
        if (cancel.cancelled()) return make_error(e_cancelled, "The surface was cancelled.");
        if (!made || !*made || (*made)->is_folded() || (quality == Quality::final && !encloses(**made)))
          continue;
        envelope.surface = *std::move(*made);
        envelope.enclosed = encloses(envelope.surface);
        attempt.cell = std::move(ringed.cell);
        envelope.waists_followed = all_ringed && share == 1;
        rings = rings_now();
        break;
      }
    }
    attempt.rings = std::move(rings);
    return Done{};
  }

  /// What was pulled by hand. Rings may have added vertices; those go with the waist.
  Result<Done> follow_pulls(FieldAttempt& attempt, const FieldBase& base) const {
    FieldEnvelope& envelope = attempt.envelope;
    const EnvelopeSettings& settings = input.settings;
    const PolygonMesh first = base.envelope.surface.cage.to_mesh();
    const std::optional<CageMirror> found = mirror_of(first);
    const CageMirror* mirror = found ? &*found : nullptr;
    const FieldNames names =
        field_names({input.solids, scene.distances, first.positions, base.cell, mirror}, settings);
    const FieldPulls pulls = field_pulls(names, envelope.surface.cage.topology(), settings, mirror);
    envelope.pulls_followed = pulls.empty();
    for (const double share : shares) {
      if (envelope.pulls_followed) break;
      PolygonMesh mesh = envelope.surface.cage.to_mesh();
      std::vector<double> cell = attempt.cell;
      for (Index v = 0; v < pulls.moves.size(); ++v) {
        mesh.positions[v] += share * pulls.moves[v];
        // As far as it was pulled into a solid it may be pushed out again.
        cell[v] = std::max(cell[v], pulls.moves[v].norm());
      }
      auto made = surface_over(std::move(mesh), std::move(cell), pulls.fullness);
      if (cancel.cancelled()) return make_error(e_cancelled, "The surface was cancelled.");
      if (!made || !*made) continue;
      envelope.surface = *std::move(*made);
      envelope.enclosed = encloses(envelope.surface);
      envelope.pulls_followed = share == 1;
      attempt.rings = bar_rings(all_bars(), envelope.surface.cage, envelope.surface.made.surface);
      break;
    }
    add_field_handles(names, envelope.surface, settings, mirror, envelope.handles);
    return Done{};
  }

  void add_bridges(FieldAttempt& attempt) const {
    FieldEnvelope& envelope = attempt.envelope;
    envelope.handles.bridges = bridges_of(attempt.rings, input.settings);
    const auto more = fillet_bridges(scene, input, envelope.surface, attempt.cell, envelope.fillet,
                                     envelope.distance * scene.diagonal);
    envelope.handles.bridges.insert(envelope.handles.bridges.end(), more.begin(), more.end());
  }

  /// 0 for what is wanted; what is not sound comes last.
  double badness(const FieldEnvelope& one) const {
    const int other =
        std::abs(one.tunnels - one.wanted_tunnels) + std::abs(one.components - int(scene.clusters.size()));
    if (one.sound()) return 2 * other;
    const std::size_t covered = one.surface.check ? one.surface.check->covered : 0;
    return 1000 + double(one.surface.folds + covered) + 200 * miss_of(one.surface) / scene.diagonal +
           2 * other;
  }
};

}  // namespace

bool suits(const FieldBase& base, const EnvelopeInput& input) {
  return std::ranges::all_of(base.scene.fillets, [&](const auto& fillet) {
    const auto& [a, b] = fillet.first;
    return fillet.second ==
           wanted_thickness(input.settings, SolidPair::of(input.solids[a].id, input.solids[b].id));
  });
}

Result<FieldBase> field_base(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                             const Vector3& origin, Quality quality, const FieldStart& start,
                             const CancelToken& cancel) {
  FieldScene scene = field_scene(input, placed, origin);
  const FieldJob job{input, placed, origin, quality, cancel, scene, start.grids};
  const std::vector<GridReference> references = grid_references(scene);
  std::optional<FieldAttempt> best;
  double least = 1e300;
  std::optional<Message> failure;
  for (int level = start.level; level < int(std::size(ladder)); ++level) {
    if (ladder[level].distance > 0 && best && best->envelope.sound()) break;
    auto made = job.attempt(level, references);
    if (!made) {
      failure = made.error();
      if (cancel.cancelled()) return *failure;
      continue;
    }
    std::optional<FieldAttempt> one = std::move(made).value();
    if (!one) continue;
    if (const double bad = job.badness(one->envelope); bad < least) least = bad, best = std::move(one);
    if (least == 0 || quality == Quality::drag) break;
  }
  if (best)
    return FieldBase{std::move(scene), std::move(best->envelope), std::move(best->cell),
                     std::move(best->grids)};
  if (failure) return *failure;
  return make_error(e_envelope_flat, "No cage was found round the solids.",
                    "Make the thinnest solid thicker, or choose the network.");
}

Result<FieldEnvelope> field_envelope(const FieldBase& base, const EnvelopeInput& input,
                                     std::span<const PlacedSolid> placed, const Vector3& origin,
                                     Quality quality, const CancelToken& cancel) {
  const FieldJob job{input, placed, origin, quality, cancel, base.scene, {}};
  FieldAttempt out{base.envelope, base.cell};
  if (const auto followed = job.follow_waists(out); !followed) return followed.error();
  if (const auto followed = job.follow_pulls(out, base); !followed) return followed.error();
  job.add_bridges(out);
  return std::move(out.envelope);
}

}  // namespace hariko
