#include "core/cad/cad_model.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "core/base/parallel.hpp"
#include "core/cad/spline_fit.hpp"
#include "core/g2/g2_patch_set.hpp"
#include "core/patching/quartic_patch.hpp"
#include "core/skinning/subdivision_surface.hpp"
#include "core/surface/bicubic_patch.hpp"
#include "core/surface/tensor_bezier.hpp"

namespace hariko {

namespace {

/// Of the tolerances: what curves between faces may take. Normals of both faces turn with their tangents.
constexpr double curve_share = 0.05, ringed_curve_share = 0.125;
/// Likewise for what is farther off between the places that the fit looks at.
constexpr double fit_share = 0.4;
/// Cubics, quartics and polynomial Bezier patches have their own degree, the curves of mode G2 are sextics;
/// the rest is interpolated.
constexpr int cubic = 3, quartic_degree = 4, quintic = 5, sextic_degree = 6;

/// The patches may be ordinary quartics: their inner points coincide in pairs, nearly.
bool may_be_quartics(const Surface& surface, double size) {
  const auto* patches = dynamic_cast<const QuarticPatchSet*>(&surface.patches());
  if (!patches) return false;
  for (Index p = 0; p < patches->patch_count(); ++p) {
    const auto& control = patches->patch(p).control;
    for (const std::size_t k : {quartic::d211w, quartic::d121w, quartic::d112v})
      if ((control[k] - control[k + 1]).norm() > 1e-9 * size) return false;
  }
  return true;
}

int spline_degree(const Surface& surface) {
  const PatchSet* patches = &surface.patches();
  if (subdivision_patches(surface) || dynamic_cast<const BicubicPatchSet*>(patches)) return cubic;
  if (const auto* bezier = dynamic_cast<const BezierPatchSet*>(patches))
    return bezier_degree(*bezier).value_or(quintic);
  return dynamic_cast<const G2PatchSet*>(patches) ? sextic_degree : quintic;
}

Eigen::AlignedBox3d box_of(const Surface& surface) {
  Eigen::AlignedBox3d box;
  for (Index p = 0; p < surface.patch_count(); ++p)
    for (int k = 0; k < corner_count(surface.domain()); ++k)
      box.extend(surface.patches().evaluate(p, corner_parameter(surface.domain(), k), Order::first).position);
  return box;
}

class Maker {
 public:
  Maker(const Surface& surface, const CadModelOptions& options, int degree, const CancelToken& cancel,
        const Progress& progress)
      : surface_(surface), degree_(degree), cancel_(cancel), progress_(progress) {
    out_.origin = surface.origin();
    const Eigen::AlignedBox3d box = box_of(surface);
    out_.size = box.isEmpty() ? 0 : box.diagonal().norm();
    limits_.distance =
        fit_share * (options.tolerance > 0 ? options.tolerance : usual_cad_tolerance * out_.size);
    limits_.angle = options.normal_angle;
  }

  /// Splines without knots, however far they are off.
  void take_no_knots() { limits_.distance = limits_.angle = std::numeric_limits<double>::infinity(); }

  Result<CadModel> run() {
    out_.pieces = cad_pieces(surface_);
    CadPlan plan = plan_cad(surface_, out_.pieces);
    sides_ = std::move(plan.sides);
    take_edges(plan);
    fit_divided_sides();
    fit_edges();
    take_vertices(plan.vertex_count);
    if (!fit_faces()) return make_error(e_cancelled, "The export was cancelled.");
    measure_edges();
    return std::move(out_);
  }

 private:
  const CadPiece& piece(const CadUse& use) const { return out_.pieces[use.piece]; }
  double length(const CadUse& use) const { return piece(use).length(use.side); }
  bool whole(const CadUse& use) const { return use.begin == 0 && use.end == length(use); }

  PatchPoint point(Index number, double s, double t) const {
    return evaluate(surface_, out_.pieces[number], s, t);
  }
  /// Along a side, counter-clockwise.
  SplinePoint side_point(Index number, int side, double x) const {
    const Vector2 at = out_.pieces[number].parameter(side, x);
    const PatchPoint p = point(number, at.x(), at.y());
    const Vector3 along = side % 2 == 0 ? p.ds : p.dt;
    return {p.position, side < 2 ? along : Vector3(-along)};
  }
  /// Round extraordinary vertices a subdivision surface is made of ever smaller rings of bicubic pieces;
  /// knots that are there as well make a spline of all but the innermost.
  bool has_rings(const CadPiece& piece, int corner) const {
    if (piece.cells.size() > 1) return false;
    const SubdivisionPatchSet* patches = subdivision_patches(surface_);
    if (!patches || patches->topology().polynomial(piece.cells[0].patch)) return false;
    for (int k = 0; k < 4; ++k)
      if (piece.cells[0].corners[std::size_t(corner)] == corner_parameter(Domain::square, k))
        return patches->second_order_at_corner(piece.cells[0].patch, k) != CornerSecondOrder::exact;
    return false;
  }
  SplineSpace ringed(bool at_begin, bool at_end) const {
    SplineSpace space{degree_, {0}};
    constexpr int rings = 6;
    for (int k = rings; at_begin && k > 0; --k) space.breaks.push_back(std::ldexp(1.0, -k));
    for (int k = at_begin ? 2 : 1; at_end && k <= rings; ++k) space.breaks.push_back(1 - std::ldexp(1.0, -k));
    space.breaks.push_back(1);
    return space;
  }
  /// What the splines along a side begin with.
  SplineSpace side_start(Index number, int side) const {
    const CadPiece& all = out_.pieces[number];
    const bool begin = has_rings(all, side), end = has_rings(all, (side + 1) % 4);
    return begin || end ? ringed(begin, end) : SplineSpace{degree_, all.knots(side)};
  }

  FitLimits curve_limits() const {
    FitLimits out = limits_;
    const double share = subdivision_patches(surface_) ? ringed_curve_share : curve_share;
    out.distance *= share;
    out.angle *= share;
    return out;
  }

  void take_edges(const CadPlan& plan) {
    for (const PlannedEdge& planned : plan.edges) {
      CadEdge edge;
      edge.begin = planned.begin;
      edge.end = planned.end;
      edge.uses = planned.uses;
      edge.use_count = planned.use_count;
      edge.smooth = planned.smooth;
      out_.edges.push_back(std::move(edge));
    }
  }

  /// Sides with several edges have curves of their own, of which the edges take parts.
  void fit_divided_sides() {
    divided_.resize(out_.pieces.size());
    parallel_for(out_.pieces.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end && !cancel_.cancelled(); ++p)
        for (int side = 0; side < 4; ++side) {
          if (sides_[p][std::size_t(side)].size() < 2) continue;
          divided_[p][std::size_t(side)] =
              fit_curve(
                  SplineSpace{degree_, out_.pieces[p].knots(side)},
                  [&](double x) { return side_point(Index(p), side, x); }, curve_limits())
                  .curve;
        }
    });
  }

  void fit_edges() {
    parallel_for(out_.edges.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end && !cancel_.cancelled(); ++e) fit(out_.edges[e]);
    });
  }

  void fit(CadEdge& edge) const {
    const CadUse &first = edge.uses[0], &second = edge.uses[1];
    const bool two = edge.use_count == 2;
    const double span = first.end - first.begin;
    if (!whole(first)) {
      edge.curve = part(first);
    } else if (two && !whole(second)) {
      edge.curve = reversed(part(second));
      for (double& b : edge.curve.space.breaks) b *= span / (second.end - second.begin);
    } else {
      SplineSpace start = side_start(first.piece, first.side);
      if (two)
        for (const double b : side_start(second.piece, second.side).reversed().breaks)
          insert(start, b * span / length(second));
      edge.curve =
          fit_curve(
              start, [&](double x) { return side_point(first.piece, first.side, x); }, curve_limits())
              .curve;
    }
    edge.curve.space.breaks.back() = span;
  }
  /// Part of a divided side, from 0 on.
  SplineCurve part(const CadUse& use) const {
    const SplineCurve& all = divided_[use.piece][std::size_t(use.side)];
    SplineSpace space{degree_, {0}};
    for (const double b : all.space.breaks)
      if (b > use.begin && b < use.end) space.breaks.push_back(b - use.begin);
    space.breaks.push_back(use.end - use.begin);
    const SplineInterpolation interpolation(space);
    SplineCurve out{space, {}};
    for (const double x : interpolation.places()) out.points.push_back(evaluate(all, use.begin + x).position);
    interpolation.solve(out.points, 1, 1, 0);
    return out;
  }
  static void insert(SplineSpace& space, double at) {
    const auto above = std::lower_bound(space.breaks.begin(), space.breaks.end(), at - 1e-9);
    if (above != space.breaks.end() && *above <= at + 1e-9) return;
    space.breaks.insert(above, at);
  }

  /// Vertices lie at the ends of parts of divided sides, else where the first edge ends; all curves get them.
  void take_vertices(Index count) {
    out_.vertices.resize(count);
    std::vector<char> known(count, 0);
    const auto take = [&](Index vertex, const Vector3& position) {
      if (known[vertex]) return;
      known[vertex] = 1;
      out_.vertices[vertex] = position;
    };
    for (const bool parts : {true, false})
      for (const CadEdge& edge : out_.edges) {
        const bool is_part = !whole(edge.uses[0]) || (edge.use_count == 2 && !whole(edge.uses[1]));
        if (is_part != parts || edge.curve.points.empty()) continue;
        take(edge.begin, edge.curve.points.front());
        take(edge.end, edge.curve.points.back());
      }
    for (CadEdge& edge : out_.edges) {
      if (edge.curve.points.empty()) continue;  // cancelled
      edge.curve.points.front() = out_.vertices[edge.begin];
      edge.curve.points.back() = out_.vertices[edge.end];
      const auto shrunk = [&](const Vector3& p) {
        return (p - edge.curve.points.front()).norm() <= 1e-9 * out_.size;
      };
      edge.degenerate =
          edge.use_count == 1 && std::all_of(edge.curve.points.begin(), edge.curve.points.end(), shrunk);
    }
  }

  /// The edge's curve along one of its uses, counter-clockwise, in the side's parameter from 0 on.
  SplineCurve along(const CadEdge& edge, Index face, int side) const {
    const bool is_first = edge.uses[0].piece == face && edge.uses[0].side == side;
    const CadUse& use = edge.uses[is_first ? 0 : 1];
    SplineCurve out = is_first ? edge.curve : reversed(edge.curve);
    const double scale = (use.end - use.begin) / (edge.uses[0].end - edge.uses[0].begin);
    if (scale != 1)
      for (double& b : out.space.breaks) b *= scale;
    return out;
  }
  SplineCurve side_curve(Index face, int side) const {
    const auto& edges = sides_[face][std::size_t(side)];
    if (edges.size() == 1) return along(out_.edges[edges.front()], face, side);
    SplineCurve out = divided_[face][std::size_t(side)];
    const auto vertex = [&](Index e, bool end) {
      const CadEdge& edge = out_.edges[e];
      const bool is_first = edge.uses[0].piece == face && edge.uses[0].side == side;
      return out_.vertices[end == is_first ? edge.end : edge.begin];
    };
    out.points.front() = vertex(edges.front(), false);
    out.points.back() = vertex(edges.back(), true);
    return out;
  }

  /// Control points along a side in the direction of growing s or t. Solved for in the direction of the edge,
  /// so that both of its faces get the same bits from the same knots.
  std::vector<Vector3> boundary(Index face, int side, const SplineCurve& curve,
                                const SplineSpace& space) const {
    const bool against = side >= 2;  // counter-clockwise is against s and t there
    const auto& edges = sides_[face][std::size_t(side)];
    const CadEdge& edge = out_.edges[edges.front()];
    const bool turned = edges.size() == 1 && !(edge.uses[0].piece == face && edge.uses[0].side == side);
    const SplineSpace counter_clockwise = against ? space.reversed() : space;
    SplineCurve solved = turned ? reversed(in_space(reversed(curve), counter_clockwise.reversed()))
                                : in_space(curve, counter_clockwise);
    if (against) std::reverse(solved.points.begin(), solved.points.end());
    return std::move(solved.points);
  }

  bool fit_faces() {
    out_.faces.resize(out_.pieces.size());
    std::atomic<std::size_t> finished{0};
    parallel_for(out_.pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end && !cancel_.cancelled(); ++f) {
        fit_face(Index(f));
        progress_.report(double(++finished) / double(out_.pieces.size()));
      }
    });
    return !cancel_.cancelled();
  }

  void fit_face(Index f) {
    const CadPiece& piece = out_.pieces[f];
    CadFace& face = out_.faces[f];
    face.sides = sides_[f];
    std::array<SplineCurve, 4> curves;
    SplineSpace s{degree_, piece.s}, t{degree_, piece.t};
    for (int side = 0; side < 4; ++side) {
      SplineCurve& curve = curves[std::size_t(side)] = side_curve(f, side);
      const SplineSpace upward = side < 2 ? curve.space : curve.space.reversed();
      for (const double b : upward.breaks) insert(side % 2 == 0 ? s : t, b);
    }
    // Rectangles of patches are splines already; few places show it.
    const bool few = piece.cells.size() > 1;
    FittedSurface fitted = fit_surface(
        s, t, [&](double x, double y) { return point(f, x, y); },
        [&](int side, const SplineSpace& space) {
          return boundary(f, side, curves[std::size_t(side)], space);
        },
        limits_, few);
    face.surface = std::move(fitted.surface);
    face.exact = fitted.distance <= exact_face * out_.size;
    face.reached = fitted.reached;
  }

  /// How far the faces' own boundaries are from the edges.
  void measure_edges() {
    parallel_for(out_.edges.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e) {
        CadEdge& edge = out_.edges[e];
        const double span = edge.curve.space.end();
        for (int u = 0; u < edge.use_count; ++u) {
          const CadUse& use = edge.uses[std::size_t(u)];
          const SplineEvaluator spline(out_.faces[use.piece].surface);
          const std::size_t steps = 4 * edge.curve.space.size();
          for (std::size_t k = 0; k <= steps; ++k) {
            const double f = double(k) / double(steps), g = u == 0 ? f : 1 - f;
            const Vector2 at = piece(use).parameter(use.side, use.begin + g * (use.end - use.begin));
            const Vector3 miss = spline.at(at.x(), at.y()).position - evaluate(edge.curve, f * span).position;
            edge.deviation = std::max(edge.deviation, miss.norm());
          }
        }
      }
    });
  }

  const Surface& surface_;
  int degree_;
  const CancelToken& cancel_;
  Progress progress_;
  FitLimits limits_;
  CadModel out_;
  std::vector<std::array<std::vector<Index>, 4>> sides_;  ///< edges of each piece
  std::vector<std::array<SplineCurve, 4>> divided_;       ///< curves of sides with several edges
};

}  // namespace

bool CadModel::closed() const {
  return std::all_of(edges.begin(), edges.end(),
                     [](const CadEdge& edge) { return edge.use_count == 2 || edge.degenerate; });
}

Result<CadModel> make_cad_model(const Surface& surface, const CadModelOptions& options,
                                const CancelToken& cancel, const Progress& progress) {
  if (surface.patch_count() == 0) return CadModel{};
  if (may_be_quartics(surface, box_of(surface).diagonal().norm())) {
    Maker quartics(surface, options, quartic_degree, cancel, {});
    quartics.take_no_knots();
    auto made = quartics.run();
    if (!made.ok()) return made;
    if (std::all_of(made->faces.begin(), made->faces.end(), [](const CadFace& face) { return face.exact; }))
      return made;
  }
  return Maker(surface, options, spline_degree(surface), cancel, progress).run();
}

}  // namespace hariko
