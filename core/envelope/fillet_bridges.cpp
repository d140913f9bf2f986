#include "core/envelope/fillet_bridges.hpp"

#include <algorithm>

#include "core/envelope/bar_rings.hpp"

namespace hariko {

namespace {

constexpr double reach = 1.2;          ///< of the cell, beside the fillet: what is farther lies in no notch
constexpr double flush = 0.8;          ///< cosine between the solids' normals: above it there is no notch
constexpr double least_opening = 0.3;  ///< of the notch: narrower ones would tell of ways without end
constexpr int bisections = 12;

class Finder {
 public:
  Finder(const FieldScene& scene, const EnvelopeInput& input, const CageSurface& surface)
      : scene_(scene), input_(input), surface_(surface), mesh_(surface.cage.topology()) {
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      nearest_.push_back(nearest_solid(scene.distances, surface.cage.position(v)).first);
  }

  /// `cell`: about the edge; `farthest`: from the solids.
  std::optional<EnvelopeBridge> bridge(Index edge, double fillet, double cell, double farthest) const {
    const Index h = mesh_.half_edge_of_edge(edge);
    const Index a = nearest_[mesh_.origin(h)], b = nearest_[mesh_.target(h)];
    if (a == b || !scene_.fillets.contains(std::minmax(a, b))) return {};
    const SolidDistance &from = scene_.distances[a], &to = scene_.distances[b];
    double low = 0, high = 1;
    for (int i = 0; i < bisections; ++i) {
      const double middle = 0.5 * (low + high);
      const Vector3 p = at(h, middle);
      (from(p) < to(p) ? low : high) = middle;
    }
    const Vector3 place = at(h, low), ga = from.gradient(place), gb = to.gradient(place);
    if (from(place) > farthest || ga.dot(gb) > flush) return {};
    // The middle of a fillet of radius k lies k (1 / c - 1) from the bottom of the notch.
    const double c = std::max(0.5 * (ga + gb).norm(), least_opening);
    const SolidPair pair = SolidPair::of(input_.solids[a].id, input_.solids[b].id);
    const double growth = wanted_thickness(input_.settings, pair) < 1 ? fillet : slack_fillet;
    const double way = thickness_growth(input_.settings) * growth * cell * (1 / c - 1);
    const Vector3 outward = surface_.made.surface.normal(h, {1 - low, low});
    return EnvelopeBridge{pair, place, outward, way * outward};
  }

 private:
  Vector3 at(Index half_edge, double along) const {
    return surface_.made.surface.patches().evaluate(half_edge, {1 - along, along}, Order::first).position;
  }

  const FieldScene& scene_;
  const EnvelopeInput& input_;
  const CageSurface& surface_;
  const HalfEdgeMesh& mesh_;
  std::vector<Index> nearest_;  ///< solid of each vertex
};

}  // namespace

std::vector<EnvelopeBridge> fillet_bridges(const FieldScene& scene, const EnvelopeInput& input,
                                           const CageSurface& surface, std::span<const double> cell,
                                           double fillet, double distance) {
  std::vector<EnvelopeBridge> out;
  const HalfEdgeMesh& mesh = surface.cage.topology();
  const Finder finder(scene, input, surface);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const double size = cell[mesh.origin(mesh.half_edge_of_edge(e))];
    const double farthest = distance + (fillet + slack_fillet + reach) * size;
    if (const auto found = finder.bridge(e, fillet, size, farthest)) out.push_back(*found);
  }
  return out;
}

}  // namespace hariko
