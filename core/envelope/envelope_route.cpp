#include "core/envelope/envelope_route.hpp"

#include <algorithm>

#include "core/envelope/field_cage.hpp"

namespace hariko {

namespace {

constexpr std::size_t most_valley_solids = 3;  ///< with more of them the search for enclosure seldom ends

}  // namespace

EnvelopeRoute envelope_route(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                             const Vector3& origin) {
  const EnvelopeSettings& settings = input.settings;
  if (settings.method == EnvelopeMethod::field) return EnvelopeRoute::field;
  if (settings.tightness == 0) return EnvelopeRoute::hull;
  const bool ring = std::any_of(input.solids.begin(), input.solids.end(),
                                [](const Solid& solid) { return solid.kind == SolidKind::torus; });
  // One convex solid is its own hull.
  if (input.solids.size() == 1 && (!ring || settings.method == EnvelopeMethod::network))
    return EnvelopeRoute::hull;
  if (settings.method == EnvelopeMethod::network) return EnvelopeRoute::valleys;
  if (ring || input.solids.size() > most_valley_solids) return EnvelopeRoute::field;
  const FieldScene scene = field_scene(input, placed, origin);
  if (scene.clusters.size() > 1) return EnvelopeRoute::field;
  // Two convex solids have no hole between them.
  return input.solids.size() > 2 && tunnels_of(scene) > 0 ? EnvelopeRoute::field : EnvelopeRoute::valleys;
}

}  // namespace hariko
