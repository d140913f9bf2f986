#include "core/envelope/valley_envelope.hpp"

namespace hariko {

namespace {

struct Rung {
  double least_sink, tightness;  ///< share of an edge; factor
};
constexpr Rung ladder[valley_levels] = {{0.07, 1}, {0.2, 1}, {0.07, 0.6}, {0.07, 0.3}};

constexpr double attempted_slides[] = {0.5, 0};

}  // namespace

ValleyEnvelope make_attempt(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                            const Vector3& origin, EnclosureSettings settings, const ValleyAttempt& attempt,
                            GrowthState start, const CancelToken& cancel) {
  const GrownSolids grown(input, placed, origin);
  const Rung& rung = ladder[attempt.level];
  ValleyRequest request;
  request.settings = {rung.tightness * input.settings.tightness, input.settings.waist, rung.least_sink,
                      attempt.slide};
  request.solids = &grown;
  settings.valleys = request;
  ValleyEnvelope out;
  out.attempt = attempt;
  out.found = search_enclosure(placed, settings, std::move(start), cancel);
  out.folds = folded_patches(out.found.network).size();
  return out;
}

std::optional<ValleyEnvelope> valley_envelope(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                                              const Vector3& origin, const EnclosureSettings& settings,
                                              int levels, const CancelToken& cancel) {
  for (int level = 0; level < levels; ++level)
    for (const double slide : attempted_slides) {
      if (cancel.cancelled()) return std::nullopt;
      ValleyEnvelope one = make_attempt(input, placed, origin, settings, {level, slide}, {}, cancel);
      if (one.found.enclosed && one.folds == 0) return one;
      if (one.folds == 0) break;
    }
  return std::nullopt;
}

}  // namespace hariko
