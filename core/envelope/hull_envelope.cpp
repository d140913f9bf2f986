#include "core/envelope/hull_envelope.hpp"

#include <algorithm>

namespace hariko {

namespace {

constexpr int local_rounds = 3;
constexpr double local_step = 0.5;  ///< on the waists of bridges whose patches fold
constexpr double most_detail = 0.3;
/// Thinning can leave points between which there is no hull, or none that is symmetric.
constexpr double less_details[] = {-0.03, -0.06, -most_detail};
constexpr double growths[] = {
    1.03, 1.07, 1.15,
    1.35, 1.7,  2.2};  ///< of all solids at the beginning of a search: other corners are thinned out then

struct Rung {
  double more_detail, waist;
  bool paired = true;
};
/// In the order of how little they change.
constexpr Rung ladder[] = {{0, 0.5},   {0, 0.25}, {0.03, 1},   {0.03, 0.5},   {0.06, 1},      {0.06, 0.5},
                           {-0.03, 1}, {0.12, 1}, {0.12, 0.5}, {0, 1, false}, {0, 0.5, false}};

double badness(const HullEnvelope& made) {
  const EnclosedNetwork& found = made.found;
  if (found.network.patches.empty()) return 1e300;
  return double(made.folds) + (found.enclosed ? 0 : outside_folds + 1000 * found.worst / found.diagonal);
}

/// Between the solids of faces with folded patches.
std::set<std::pair<Index, Index>> folded_bridges(const CurveNetwork& network) {
  std::set<std::pair<Index, Index>> out;
  for (const Index patch : folded_patches(network)) {
    const CageFace& face = network.cage.faces[network.patch_places[patch].face];
    for (const Index v : face.loop)
      for (const Index w : face.loop) {
        const Index a = network.cage.vertices[v].solid, b = network.cage.vertices[w].solid;
        if (a < b && b != no_index) out.insert({a, b});
      }
  }
  return out;
}

}  // namespace

HullEnvelope make_attempt(std::span<const PlacedSolid> solids, EnclosureSettings settings,
                          const HullAttempt& attempt, GrowthState start, const CancelToken& cancel) {
  settings.detail = std::clamp(settings.detail + attempt.more_detail, 0.0, most_detail);
  settings.waist *= attempt.waist;
  if (!attempt.paired) settings.merge_angle = 0;
  std::map<std::pair<Index, Index>, double> waists;
  if (settings.waists) waists = *settings.waists;
  for (const auto& [pair, factor] : attempt.waists) waists.try_emplace(pair, 1.0).first->second *= factor;
  settings.waists = &waists;
  HullEnvelope out;
  out.attempt = attempt;
  out.found = search_enclosure(solids, settings, std::move(start), cancel);
  out.folds = folded_patches(out.found.network).size();
  return out;
}

HullEnvelope hull_envelope(std::span<const PlacedSolid> solids, const EnclosureSettings& settings,
                           const CancelToken& cancel) {
  HullEnvelope best = make_attempt(solids, settings, {}, {}, cancel);
  for (const double less : less_details) {
    if (!best.found.network.patches.empty() || cancel.cancelled()) break;
    best = make_attempt(solids, settings, {less, 1, true, {}}, {}, cancel);
  }
  if (best.found.network.patches.empty()) return best;
  double least = badness(best);
  const auto attempt = [&](const HullAttempt& how, double growth = 1) {
    GrowthState start;
    start.sigma.assign(solids.size(), growth);
    HullEnvelope one = make_attempt(solids, settings, how, std::move(start), cancel);
    if (const double bad = badness(one); bad < least) least = bad, best = one;
    return one;
  };
  HullEnvelope last = best;
  HullAttempt local;
  for (int round = 0; round < local_rounds && last.folds > 0 && least > 0 && !cancel.cancelled(); ++round) {
    for (const auto& pair : folded_bridges(last.found.network))
      local.waists.try_emplace(pair, 1.0).first->second *= local_step;
    last = attempt(local);
  }
  for (const Rung& rung : ladder) {
    if (!(least > 0) || cancel.cancelled()) break;
    attempt({rung.more_detail, rung.waist, rung.paired, {}});
  }
  for (const double growth : growths) {
    if (!(least > 0) || cancel.cancelled()) break;
    attempt({}, growth);
    if (least > 0) attempt({0, 0.5, true, {}}, growth);
  }
  return best;
}

}  // namespace hariko
