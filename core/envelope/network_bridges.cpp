#include "core/envelope/network_bridges.hpp"

namespace hariko {

std::vector<EnvelopeBridge> bridges_of(const CurveNetwork& network, std::span<const PlacedSolid> solids,
                                       const FlatMap<SolidPair, double>& waists) {
  std::vector<EnvelopeBridge> out;
  for (const NetworkCurve& curve : network.curves) {
    const CageVertex &a = network.cage.vertices[curve.low], &b = network.cage.vertices[curve.high];
    if (a.solid == no_index || b.solid == no_index || a.solid == b.solid) continue;
    EnvelopeBridge bridge;
    bridge.solids = SolidPair::of(solids[a.solid].id, solids[b.solid].id);
    const HomogeneousCubic& c = curve.ribbon.curve;
    const Homogeneous middle = (c[0] + 3 * c[1] + 3 * c[2] + c[3]) / 8;
    bridge.middle = cartesian(middle);
    bridge.outward = (a.normal + b.normal).stableNormalized();
    // The inner points lie along the tangents by lengths that the factor multiplies.
    const Vector3 handles =
        c[1].w() * (cartesian(c[1]) - a.position) + c[2].w() * (cartesian(c[2]) - b.position);
    bridge.way = 3 * handles / (8 * middle.w()) / waists.get_or(bridge.solids, 1.0);
    out.push_back(bridge);
  }
  return out;
}

}  // namespace hariko
