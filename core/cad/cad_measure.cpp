#include "core/cad/cad_measure.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/cad/spline_fit.hpp"

namespace hariko {

namespace {

/// Every break, and places between that are no Greville places of a single span: there every spline is right.
std::vector<double> places(const SplineSpace& space, int samples) {
  std::vector<double> out{space.begin()};
  for (std::size_t i = 0; i < space.span_count(); ++i) {
    const double width = space.breaks[i + 1] - space.breaks[i];
    for (int k = 0; k < samples; ++k) out.push_back(space.breaks[i] + (k + 0.47) / samples * width);
    out.push_back(space.breaks[i + 1]);
  }
  return out;
}

double face_distance(const Surface& surface, const CadModel& model, Index face, int samples) {
  const SplineSurface& spline = model.faces[face].surface;
  const SplineEvaluator evaluator(spline);
  double largest = 0;
  for (const double t : places(spline.t, samples))
    for (const double s : places(spline.s, samples)) {
      const Vector3 miss = evaluate(surface, model.pieces[face], s, t).position - evaluator.at(s, t).position;
      largest = std::max(largest, miss.norm());
    }
  return largest;
}

/// Angle between the tangent planes of the two faces of an edge.
double jump(const CadModel& model, const CadEdge& edge, int samples) {
  const SplineEvaluator first(model.faces[edge.uses[0].piece].surface),
      second(model.faces[edge.uses[1].piece].surface);
  const double span = edge.curve.space.end();
  double largest = 0;
  for (const double x : places(edge.curve.space, samples)) {
    const auto normal = [&](const SplineEvaluator& face, const CadUse& use, double f) {
      const Vector2 at = model.pieces[use.piece].parameter(use.side, use.begin + f * (use.end - use.begin));
      const PatchPoint point = face.at(at.x(), at.y());
      return has_normal(point) ? unit_normal(point) : Vector3(Vector3::Zero());
    };
    const Vector3 a = normal(first, edge.uses[0], x / span), b = normal(second, edge.uses[1], 1 - x / span);
    if (a.isZero(0) || b.isZero(0)) continue;
    largest = std::max(largest, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return largest;
}

}  // namespace

CadMeasure measure_cad(const Surface& surface, const CadModel& model, int samples,
                       const CancelToken& cancel) {
  CadMeasure out;
  out.distances.resize(model.faces.size());
  parallel_for(model.faces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end && !cancel.cancelled(); ++f)
      out.distances[f] = face_distance(surface, model, Index(f), samples);
  });
  std::vector<double> jumps(model.edges.size(), 0);
  parallel_for(model.edges.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end && !cancel.cancelled(); ++e)
      if (model.edges[e].use_count == 2 && model.edges[e].smooth)
        jumps[e] = jump(model, model.edges[e], samples);
  });
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    out.largest = std::max(out.largest, out.distances[f]);
    out.exact += out.distances[f] <= exact_face * model.size;
    out.control_points += model.faces[f].surface.points.size();
  }
  for (std::size_t e = 0; e < jumps.size(); ++e) {
    out.edge_deviation = std::max(out.edge_deviation, model.edges[e].deviation);
    if (!(jumps[e] > out.normal_jump)) continue;
    out.normal_jump = jumps[e];
    out.jump_edge = Index(e);
  }
  return out;
}

}  // namespace hariko
