#include "core/envelope/envelope.hpp"

#include <algorithm>

#include "core/envelope/convex_hull.hpp"
#include "core/envelope/field_envelope.hpp"

namespace hariko {

namespace {

constexpr double tolerance = 1e-4;  ///< of the diagonal
constexpr int drag_builds = 2;
constexpr int hull_level = 9;
constexpr double decay = 0.98;  ///< of what growth is above 1, a frame

EnclosureSettings search_settings(const EnvelopeInput& input,
                                  const std::map<std::pair<Index, Index>, double>& waists, Quality quality) {
  EnclosureSettings out;
  out.detail = input.settings.detail;
  out.merge_angle = input.settings.merge_angle;
  out.waist = input.settings.waist;
  out.tolerance = tolerance;
  out.waists = &waists;
  out.fullness = &input.settings.fullness;
  out.offsets = &input.settings.offsets;
  if (quality == Quality::drag) {
    out.largest_builds = drag_builds;
    out.fine = false;
    out.strict = false;
  }
  return out;
}

/// The designer's factors, between the placed parts of two solids.
std::map<std::pair<Index, Index>, double> waists_of(const EnvelopeInput& input,
                                                    std::span<const PlacedSolid> solids) {
  std::map<std::pair<Index, Index>, double> out;
  if (input.settings.waists.empty()) return out;
  for (Index a = 0; a < solids.size(); ++a)
    for (Index b = a + 1; b < solids.size(); ++b)
      if (const double* factor = input.settings.waists.find(SolidPair::of(solids[a].id, solids[b].id)))
        out[{a, b}] = *factor;
  return out;
}

void relax(GrowthState& state) {
  for (double& s : state.sigma) s = 1 + decay * (s - 1);
  for (auto& [pair, factor] : state.cuts) factor = 1 - decay * (1 - factor);
}

/// A network that folds is made again with fewer vertices, then with tauter bridges; the better one is kept.
void unfold(std::span<const PlacedSolid> solids, EnclosureSettings settings, EnclosedNetwork& found,
            const CancelToken& cancel) {
  const auto badness = [&](const EnclosedNetwork& n) {
    return double(folded_patches(n.network)) + (n.enclosed ? 0 : 1000 * n.worst / n.diagonal);
  };
  double least = badness(found);
  for (int round = 0; round < 3 && least > 0 && !cancel.cancelled(); ++round) {
    if (round < 2)
      settings.detail = std::min(0.3, settings.detail + 0.03);
    else
      settings.waist *= 0.5;
    EnclosedNetwork other = search_enclosure(solids, settings, {}, cancel);
    if (other.network.patches.empty()) continue;
    if (const double bad = badness(other); bad < least) least = bad, found = std::move(other);
  }
}

std::string percent(double part) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", 100 * part);
  return text;
}

void add_warnings(EnvelopeSurface& out) {
  const double miss = out.check ? std::max(out.check->worst, out.enclosed ? 0.0 : out.worst) : out.worst;
  if (miss > tolerance * out.diagonal)
    out.warnings.push_back(make_warning(w_not_enclosed,
                                        "The surface does not contain the solids: they reach out by up to " +
                                            percent(miss / out.diagonal) + " % of their size.",
                                        "Give a larger clearance, or raise the detail."));
  if (out.folds > 0)
    out.warnings.push_back(make_warning(w_envelope_fold,
                                        std::to_string(out.folds) + " patches of the surface fold over.",
                                        "Lower the waist or the roundness, or move the solids apart."));
}

/// Of solids whose points are not all on their hull.
void add_hull_warnings(const EnvelopeInput& input, std::vector<Message>& warnings) {
  for (std::size_t i = 0; i < input.solids.size(); ++i)
    if (input.solids[i].kind == SolidKind::polyhedron && !is_convex(input.solids[i].points))
      warnings.push_back(make_warning(w_solid_hull,
                                      "Solid " + std::to_string(i) + " is not convex; its hull is used.",
                                      "Make it of several convex solids."));
}

/// Solids in their places relative to the origin that is chosen for them.
std::vector<PlacedSolid> placed_about(const EnvelopeInput& input, Vector3& origin) {
  std::vector<PlacedSolid> solids = place_solids(input);
  std::vector<Vector3> corners;
  for (const PlacedSolid& solid : solids)
    for (const Vector3& u : solid.unit_vertices) corners.push_back(solid.world(u));
  origin = origin_for(corners);
  for (PlacedSolid& solid : solids) {
    solid.centre -= origin;
    for (Vector3& p : solid.test_points) p -= origin;
  }
  return solids;
}

void take_cage(CageSurface cage, EnvelopeSurface& out) {
  out.surface = std::move(cage.made.surface);
  out.cage = std::make_shared<const Polyhedron>(std::move(cage.cage));
  out.worst = cage.worst;
  out.folds = cage.folds;
  out.builds = cage.rounds + 1;
  out.check = std::move(cage.check);
  const double miss = out.check ? out.check->worst : out.worst;
  out.enclosed = miss <= tolerance * out.diagonal;
}

/// The fair surface over the cage of a network, which is pushed out on its own.
Result<Done> make_fair(const EnvelopeInput& input, std::span<const PlacedSolid> solids, Quality quality,
                       const CancelToken& cancel, EnvelopeSurface& out) {
  std::vector<SolidDistance> distances;
  for (const Solid& solid : input.solids) distances.emplace_back(solid, input.settings.clearance, out.origin);
  CageSurfaceRequest request;
  for (const CageVertex& vertex : out.network->cage.vertices)
    request.cage.positions.push_back(vertex.position);
  for (const CageFace& face : out.network->cage.faces) request.cage.add_face(face.loop);
  request.cell.assign(request.cage.positions.size(), 0.25 * out.diagonal);
  request.origin = out.origin;
  request.diagonal = out.diagonal;
  request.distances = distances;
  request.placed = solids;
  request.strict = quality == Quality::final;
  if (quality == Quality::drag) request.rounds = drag_builds;
  auto made = cage_surface(request, cancel);
  if (!made) return made.error();
  take_cage(std::move(made).value(), out);
  return Done{};
}

}  // namespace

Result<bool> EnvelopeSurfacer::take_field(const EnvelopeInput& input, std::span<const PlacedSolid> solids,
                                          Quality quality, const CancelToken& cancel, EnvelopeSurface& out) {
  if (!wants_field(input, solids, out.origin)) return false;
  auto made = field_envelope(input, solids, out.origin, quality, cancel);
  if (cancel.cancelled()) return make_error(e_cancelled, "The surface was cancelled.");
  // A folded surface is no answer, unless the designer insists on the field.
  const bool insists = input.settings.method == EnvelopeMethod::field;
  if (!made || (made->surface.folds > 0 && !insists)) {
    if (!made && insists) return made.error();
    out.level = hull_level;
    out.warnings.push_back(make_warning(
        w_tightness_reduced, "The surface cannot follow the notches between these solids; it is their hull.",
        "Move the solids apart or into each other, or choose smaller cells."));
    return false;
  }
  out.level = made->level;
  out.components = made->components;
  out.tunnels = made->tunnels;
  take_cage(std::move(made->surface), out);
  return true;
}

Result<EnvelopeSurface> EnvelopeSurfacer::rebuild(const EnvelopeInput& input, Quality quality,
                                                  const CancelToken& cancel) {
  if (const auto checked = check_envelope(input); !checked) return checked.error();
  EnvelopeSurface out;
  const std::vector<PlacedSolid> solids = placed_about(input, out.origin);
  out.diagonal = scene_diagonal(solids);
  const auto field = take_field(input, solids, quality, cancel, out);
  if (!field) return field.error();
  if (!*field)
    if (const auto made = make_network(input, solids, quality, cancel, out); !made) return made.error();
  if (quality == Quality::final) add_hull_warnings(input, out.warnings);
  add_warnings(out);
  return out;
}

Result<Done> EnvelopeSurfacer::make_network(const EnvelopeInput& input, std::span<const PlacedSolid> solids,
                                            Quality quality, const CancelToken& cancel,
                                            EnvelopeSurface& out) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> names;
  for (const PlacedSolid& solid : solids) names.emplace_back(solid.id, solid.part);
  GrowthState start;
  if (quality == Quality::drag && names == last_solids_) {
    start = last_;
    relax(start);
  }
  const auto waists = waists_of(input, solids);
  const EnclosureSettings settings = search_settings(input, waists, quality);
  EnclosedNetwork found = search_enclosure(solids, settings, std::move(start), cancel);
  if (quality == Quality::final) unfold(solids, settings, found, cancel);
  if (cancel.cancelled()) return make_error(e_cancelled, "The surface was cancelled.");
  if (found.network.patches.empty())
    return make_error(e_envelope_flat, "The solids are too flat for a surface round them.",
                      "Make one of them thicker.");
  last_ = found.state;
  last_solids_ = std::move(names);
  out.enclosed = found.enclosed;
  out.worst = found.worst;
  out.builds = found.builds;
  if (quality == Quality::final) {
    out.folds = folded_patches(found.network);
    out.check = std::move(found.check);
  }
  out.network = std::make_shared<const CurveNetwork>(std::move(found.network));
  if (input.settings.patches == EnvelopePatches::fair) return make_fair(input, solids, quality, cancel, out);
  out.surface = network_surface(*out.network, out.origin);
  return Done{};
}

}  // namespace hariko
