#include "core/cad/cad_measure.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.hpp"
#include "core/cad/cad_edges.hpp"
#include "core/cad/fit/side_tie.hpp"
#include "core/geometry/angles.hpp"

namespace hariko {

namespace {

/// Breaks of an edge together with those of its faces along it.
SplineSpace edge_space(const CadModel& model, const CadEdge& edge) {
  SplineSpace out = edge.curve.space;
  for (int u = 0; u < edge.use_count; ++u) {
    const CadUse& use = edge.uses[std::size_t(u)];
    const SplineSurface& face = model.faces[use.piece].surface;
    const SplineSpace& along = use.side % 2 == 0 ? face.s : face.t;
    for (const double b : (use.side < 2 ? along : along.reversed()).breaks) {
      const double f = (b - use.begin) / (use.end - use.begin);
      if (f > 0 && f < 1) insert_break(out.breaks, (u == 0 ? f : 1 - f) * edge.curve.space.end());
    }
  }
  return out;
}

/// Sample places: every break, and between them places that are no Greville places of a single span, where
/// every spline is exact.
std::vector<double> places(const SplineSpace& space, int samples) {
  std::vector<double> out{space.begin()};
  for (std::size_t i = 0; i < space.span_count(); ++i) {
    const double width = space.breaks[i + 1] - space.breaks[i];
    for (int k = 0; k < samples; ++k) out.push_back(space.breaks[i] + (k + 0.47) / samples * width);
    out.push_back(space.breaks[i + 1]);
  }
  return out;
}

/// Nearest of several places of the surface to a point, improved step by step. Each candidate's distance is
/// an upper bound of the distance to the surface.
class NearestPlace {
 public:
  NearestPlace(const PieceEvaluator& surface, const CadPiece& piece, const Vector3& from, double s, double t)
      : surface_(surface), piece_(piece), from_(from), at_(s, t) {
    look(at_);
  }
  double distance() const { return distance_; }

  /// Newton steps to the foot of the perpendicular, as long as each reduces the distance by a tenth.
  void step(double enough) {
    constexpr int steps = 4;
    for (int step = 0; step < steps && distance_ > enough; ++step) {
      const Vector3 miss = from_ - point_.position;
      const double e = point_.ds.squaredNorm(), f = point_.ds.dot(point_.dt), g = point_.dt.squaredNorm();
      const double area = e * g - f * f, a = point_.ds.dot(miss), b = point_.dt.dot(miss);
      if (!(area > 1e-10 * e * g)) break;
      const double before = distance_;
      const Vector2 move((g * a - f * b) / area, (e * b - f * a) / area);
      reach_ = std::max(reach_, move.cwiseAbs().maxCoeff());
      if (!look(at_ + move) || !(distance_ < 0.9 * before)) break;
    }
  }

  /// Pattern search on ever smaller squares; needs no derivatives, which jump where patches of a piece meet.
  void search(double enough) {
    constexpr double least = 1e-4;
    for (double width = reach_; width > least * reach_ && distance_ > enough;) {
      const Vector2 middle = at_;
      bool nearer = false;
      for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
          if (i != 0 || j != 0) nearer = look(middle + width * Vector2(i, j)) || nearer;
      if (!nearer) width /= 2;
    }
  }

 private:
  /// Takes a place if it is nearer than those before; tells whether it is.
  bool look(Vector2 at) {
    at = at.cwiseMax(Vector2::Zero()).cwiseMin(Vector2(piece_.s.back(), piece_.t.back()));
    const PatchPoint point = surface_.at(at.x(), at.y());
    const double distance = (from_ - point.position).norm();
    if (!(distance < distance_)) return false;
    at_ = at;
    point_ = point;
    distance_ = distance;
    return true;
  }

  const PieceEvaluator& surface_;
  const CadPiece& piece_;
  const Vector3& from_;
  Vector2 at_;
  PatchPoint point_;
  double distance_ = std::numeric_limits<double>::infinity();
  double reach_ = 0;  ///< longest step so far
};

/// Upper bound of the distance from a point to the surface near (s, t); improved until it is at most `enough`
/// or no better place is found.
double distance_near(const PieceEvaluator& surface, const CadPiece& piece, double s, double t,
                     const Vector3& from, double enough) {
  NearestPlace nearest(surface, piece, from, s, t);
  nearest.step(enough);
  nearest.search(enough);
  return nearest.distance();
}

double face_distance(const Surface& surface, const CadModel& model, Index face, int samples) {
  const SplineSurface& spline = model.faces[face].surface;
  const CadPiece& piece = model.pieces[face];
  const PieceEvaluator near(surface, piece);
  const std::vector<double> s = places(spline.s, samples), t = places(spline.t, samples);
  const std::vector<PatchPoint> points =
      evaluate_grid(spline, spline_bases(spline.s, s), spline_bases(spline.t, t));
  double largest = 0;
  for (std::size_t j = 0; j < t.size(); ++j)
    for (std::size_t i = 0; i < s.size(); ++i)
      largest = std::max(largest,
                         distance_near(near, piece, s[i], t[j], points[j * s.size() + i].position, largest));
  return largest;
}

struct Jump {
  double normal = 0, curvature = 0;
};

/// Largest jumps between the two faces of an edge.
Jump jump(const CadModel& model, const CadEdge& edge, int samples) {
  const SplineEvaluator first(model.faces[edge.uses[0].piece].surface),
      second(model.faces[edge.uses[1].piece].surface);
  const double span = edge.curve.space.end();
  Jump out;
  for (const double x : places(edge_space(model, edge), samples)) {
    const auto point = [&](const SplineEvaluator& face, const CadUse& use, double f) {
      const Vector2 at = model.pieces[use.piece].parameter(use.side, use.begin + f * (use.end - use.begin));
      return face.at(at.x(), at.y(), model.curvature ? Order::second : Order::first);
    };
    const PatchPoint p = point(first, edge.uses[0], x / span), q = point(second, edge.uses[1], 1 - x / span);
    if (!has_normal(p) || !has_normal(q)) continue;
    const Vector3 a = unit_normal(p), b = unit_normal(q);
    out.normal = std::max(out.normal, angle_between(a, b));
    if (!model.curvature) continue;
    const Vector3 across = a.cross(evaluate(edge.curve, x).derivative).stableNormalized();
    const NormalBend one = normal_bend(p, across), other = normal_bend(q, across);
    const double whole = std::max({one.largest, other.largest, 1 / model.size});
    out.curvature = std::max(out.curvature, std::abs(one.across - other.across) / whole);
  }
  return out;
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
  std::vector<Jump> jumps(model.edges.size());
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
    out.curvature_jump = std::max(out.curvature_jump, jumps[e].curvature);
    if (!(jumps[e].normal > out.normal_jump)) continue;
    out.normal_jump = jumps[e].normal;
    out.jump_edge = Index(e);
  }
  return out;
}

}  // namespace hariko
