#include "core/envelope/network_handles.hpp"

#include "core/envelope/pulled_vertices.hpp"

namespace hariko {

namespace {

class HandleMaker {
 public:
  HandleMaker(const CurveNetwork& network, std::span<const PlacedSolid> solids,
              const EnvelopeSettings& settings)
      : network_(network), solids_(solids), settings_(settings) {}

  EnvelopeHandles make() const {
    EnvelopeHandles out;
    for (Index v = 0; v < network_.cage.vertices.size(); ++v) out.vertices.push_back(handle(v));
    for (const NetworkCurve& curve : network_.curves) {
      const CageVertex &a = vertex(curve.low), &b = vertex(curve.high);
      const EnvelopeCurve made = handle(curve);
      out.curves.push_back(made);
      if (a.solid == no_index || b.solid == no_index || a.solid == b.solid) continue;
      const SolidPair pair = SolidPair::of(solids_[a.solid].id, solids_[b.solid].id);
      // A whole factor on the waist does the same as one on the curve's own tangents.
      const double share = settings_.fullness.get_or(made.curve, 1.0) / settings_.waists.get_or(pair, 1.0);
      out.bridges.push_back({pair, made.middle, made.outward, share * made.way});
    }
    return out;
  }

 private:
  const CageVertex& vertex(Index v) const { return network_.cage.vertices[v]; }
  NetworkVertexKey name(Index v) const { return settings_name(network_.cage, v, solids_); }

  EnvelopeVertex handle(Index v) const {
    const Index owner = offset_owner(network_.cage, v, solids_, settings_.offsets);
    EnvelopeVertex out;
    out.vertex = name(owner);
    out.position = vertex(v).position;
    out.outward = vertex(v).normal;
    out.axes = offset_axes(vertex(owner), solids_);
    if (owner != v) out.axes.row(network_.cage.mirror->axis) *= -1;
    return out;
  }

  EnvelopeCurve handle(const NetworkCurve& curve) const {
    EnvelopeCurve out;
    out.curve = NetworkEdgeKey::of(name(curve.low), name(curve.high));
    const HomogeneousCubic& c = curve.ribbon.curve;
    const Homogeneous middle = (c[0] + 3 * c[1] + 3 * c[2] + c[3]) / 8;
    out.middle = cartesian(middle);
    out.outward = (vertex(curve.low).normal + vertex(curve.high).normal).stableNormalized();
    // The inner points lie along the tangents by lengths that the factor multiplies.
    out.way = 3 * curve.pull / (8 * middle.w()) / settings_.fullness.get_or(out.curve, 1.0);
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
