#include "core/envelope/envelope.hpp"

#include <algorithm>

#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

namespace {

constexpr double tolerance = 1e-4;  ///< of the diagonal
constexpr int drag_builds = 2;
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

}  // namespace

Result<EnvelopeSurface> EnvelopeSurfacer::rebuild(const EnvelopeInput& input, Quality quality,
                                                  const CancelToken& cancel) {
  if (const auto checked = check_envelope(input); !checked) return checked.error();
  EnvelopeSurface out;
  std::vector<PlacedSolid> solids = place_solids(input);
  std::vector<Vector3> corners;
  for (const PlacedSolid& solid : solids)
    for (const Vector3& u : solid.unit_vertices) corners.push_back(solid.world(u));
  out.origin = origin_for(corners);
  for (PlacedSolid& solid : solids) {
    solid.centre -= out.origin;
    for (Vector3& p : solid.test_points) p -= out.origin;
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> names;
  for (const PlacedSolid& solid : solids) names.emplace_back(solid.id, solid.part);
  GrowthState start;
  if (quality == Quality::drag && names == last_solids_) {
    start = last_;
    relax(start);
  }
  const auto waists = waists_of(input, solids);
  EnclosureSettings settings = search_settings(input, waists, quality);
  EnclosedNetwork found = search_enclosure(solids, settings, std::move(start), cancel);
  if (quality == Quality::final) unfold(solids, settings, found, cancel);
  if (cancel.cancelled()) return make_error(e_cancelled, "The surface was cancelled.");
  if (found.network.patches.empty())
    return make_error(e_envelope_flat, "The solids are too flat for a surface round them.",
                      "Make one of them thicker.");
  last_ = found.state;
  last_solids_ = std::move(names);
  out.diagonal = found.diagonal;
  out.enclosed = found.enclosed;
  out.worst = found.worst;
  out.builds = found.builds;
  out.surface = network_surface(found.network, out.origin);
  if (quality == Quality::final) {
    out.folds = folded_patches(found.network);
    out.check = std::move(found.check);
  }
  out.network = std::make_shared<const CurveNetwork>(std::move(found.network));
  add_warnings(out);
  return out;
}

}  // namespace hariko
