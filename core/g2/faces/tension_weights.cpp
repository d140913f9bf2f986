#include "core/g2/faces/tension_weights.hpp"

#include <algorithm>
#include <cmath>

#include "core/g2/faces/face_measure.hpp"

namespace hariko {

namespace {

/// Number of sides above which faces measure their bending over their charts only.
constexpr Index largest_reference_side_count = 12;
/// Mean alpha at which half of a face's bending is measured over the reference.
constexpr double half_reference_alpha = 0.05;

void weigh_faces(const HalfEdgeMesh& mesh, const NetworkSystem& network, const G2Weights& weights,
                 TensionWeights& out) {
  for (Index f = 0; f < mesh.face_count(); ++f) {
    double excess = 0, alpha = 0;
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      excess += std::max(network.beta()[mesh.edge(h)] - 1, 0.0);
      alpha += network.alpha()[mesh.origin(h)] / double(mesh.side_count(f));
    }
    out.membrane.push_back(weights.tension * (excess / double(mesh.side_count(f)) + alpha));
    const bool few = mesh.side_count(f) <= largest_reference_side_count;
    out.over_reference.push_back(few ? alpha / (alpha + half_reference_alpha) : 0);
  }
}

}  // namespace

TensionWeights tension_weights(const HalfEdgeMesh& mesh, const NetworkSystem& network,
                               const G2Weights& weights) {
  TensionWeights out;
  weigh_faces(mesh, network, weights, out);
  out.curve.resize(mesh.half_edge_count());
  out.tangent.resize(2 * std::size_t(mesh.half_edge_count()));
  const FaceCharts& charts = network.frames().charts;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e), twin = mesh.twin(h);
    const bool border = twin == no_index, sharp = network.frames().sharp[e];
    const double at_origin = network.alpha()[mesh.origin(h)], at_target = network.alpha()[mesh.target(h)];
    const double loose = 1 + at_origin + at_target;
    const double own = out.membrane[mesh.face(h)];
    const double tau = border ? own : (own + out.membrane[mesh.face(twin)]) / 2;
    // Both faces have half of an inner edge's terms.
    const double share = (border ? 1.0 : 0.5) * edge_measure(charts, e);
    const double curve = share * (weights.curve / (loose * loose) + weights.curve_tension * tau +
                                  (sharp ? weights.sharp_curve : 0));
    const auto tangent = [&](double alpha) {
      return share * (weights.tangent + weights.tangent_tension * (alpha + std::abs(network.beta()[e] - 1)) +
                      (sharp ? weights.sharp_tangent : 0));
    };
    out.curve[h] = curve;
    out.tangent[2 * h] = tangent(at_origin);
    out.tangent[2 * h + 1] = tangent(at_target);
    if (border) continue;
    out.curve[twin] = curve;
    out.tangent[2 * twin] = tangent(at_target);
    out.tangent[2 * twin + 1] = tangent(at_origin);
  }
  return out;
}

}  // namespace hariko
