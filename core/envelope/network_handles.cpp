#include "core/envelope/network_handles.hpp"

namespace hariko {

namespace {

class HandleMaker {
 public:
  HandleMaker(const CurveNetwork& network, std::span<const PlacedSolid> solids,
              const EnvelopeSettings& settings)
      : network_(network), solids_(solids), settings_(settings) {}

  EnvelopeHandles make() const {
    EnvelopeHandles out;
    for (Index v = 0; v < network_.cage.vertices.size(); ++v)
      if (vertex(v).solid != no_index) out.vertices.push_back(handle(v));
    for (const NetworkCurve& curve : network_.curves) {
      const CageVertex &a = vertex(curve.low), &b = vertex(curve.high);
      if (a.solid == no_index || b.solid == no_index) continue;
      const EnvelopeCurve made = handle(curve);
      out.curves.push_back(made);
      if (a.solid == b.solid) continue;
      const SolidPair pair = SolidPair::of(solids_[a.solid].id, solids_[b.solid].id);
      // A whole factor on the waist does the same as one on the curve's own tangents.
      const double share = settings_.fullness.get_or(made.curve, 1.0) / settings_.waists.get_or(pair, 1.0);
      out.bridges.push_back({pair, made.middle, made.outward, share * made.way});
    }
    return out;
  }

 private:
  const CageVertex& vertex(Index v) const { return network_.cage.vertices[v]; }
  NetworkVertexKey name(Index v) const { return settings_key(key_of(vertex(v), solids_)); }

  EnvelopeVertex handle(Index v) const {
    EnvelopeVertex out{name(v), vertex(v).position, vertex(v).normal, solids_[vertex(v).solid].rotation};
    const auto& mirror = network_.cage.mirror;
    const Index image = mirror ? mirror->image[v] : v;
    if (image == v || vertex(image).solid == no_index) return out;
    // Of a pair one offset moves both: the first one's, unless only the second has one.
    const auto place = [&](Index of) { return std::pair(vertex(of).solid, vertex(of).vertex); };
    const Index first = place(v) < place(image) ? v : image, second = first == v ? image : v;
    const bool by_second = !settings_.offsets.find(name(first)) && settings_.offsets.find(name(second));
    const Index moved = by_second ? second : first;
    out.vertex = name(moved);
    out.axes = solids_[vertex(moved).solid].rotation;
    if (moved != v) out.axes.row(mirror->axis) *= -1;
    return out;
  }

  EnvelopeCurve handle(const NetworkCurve& curve) const {
    const CageVertex &a = vertex(curve.low), &b = vertex(curve.high);
    EnvelopeCurve out;
    out.curve = NetworkEdgeKey::of(name(curve.low), name(curve.high));
    const HomogeneousCubic& c = curve.ribbon.curve;
    const Homogeneous middle = (c[0] + 3 * c[1] + 3 * c[2] + c[3]) / 8;
    out.middle = cartesian(middle);
    out.outward = (a.normal + b.normal).stableNormalized();
    // The inner points lie along the tangents by lengths that the factor multiplies.
    const Vector3 tangents =
        c[1].w() * (cartesian(c[1]) - a.position) + c[2].w() * (cartesian(c[2]) - b.position);
    out.way = 3 * tangents / (8 * middle.w()) / settings_.fullness.get_or(out.curve, 1.0);
    return out;
  }

  const CurveNetwork& network_;
  std::span<const PlacedSolid> solids_;
  const EnvelopeSettings& settings_;
};

}  // namespace

EnvelopeHandles handles_of(const CurveNetwork& network, std::span<const PlacedSolid> solids,
                           const EnvelopeSettings& settings) {
  return HandleMaker(network, solids, settings).make();
}

}  // namespace hariko
