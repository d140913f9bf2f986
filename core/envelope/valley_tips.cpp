#include "core/envelope/valley_tips.hpp"

#include <algorithm>

namespace hariko {

std::size_t valley_tips(const NetworkCage& cage) {
  return std::size_t(std::count_if(cage.faces.begin(), cage.faces.end(), [&](const CageFace& face) {
    return face.loop.size() == 3 && std::any_of(face.loop.begin(), face.loop.end(),
                                                [&](Index v) { return cage.vertices[v].solid == no_index; });
  }));
}

bool suits_valleys(const EnvelopeInput& input, std::span<const PlacedSolid> placed, const Vector3& origin,
                   EnclosureSettings settings) {
  settings.largest_builds = 1;
  settings.fine = settings.strict = false;
  const ValleyEnvelope first = make_attempt(input, placed, origin, settings, {}, {});
  return !first.found.network.patches.empty() && valley_tips(first.found.network.cage) == 0;
}

}  // namespace hariko
