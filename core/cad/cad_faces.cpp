#include "core/cad/cad_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/cad/face_fit.hpp"

namespace hariko {

namespace {

/// Share of the limits that a fit keeps to: between the places that it looks at up to a fifth more is
/// measured.
constexpr double fit_share = 0.78;
/// Likewise of the angle between faces.
constexpr double angle_share = 0.7;
/// How often knots are added.
constexpr int most_rounds = 12;
/// How often both faces of an edge are brought to the mean of their tangent planes before knots are added.
constexpr int most_sweeps = 6;

/// Places of a span, none of them a Greville place of a single one: there every interpolation is right.
constexpr std::array<std::pair<double, double>, 3> exact_looks{{{0.37, 0.61}, {0.11, 0.83}, {0.91, 0.13}}};

FaceFit::Model model_of(const EdgeTask& task, Index piece) {
  return [&surface = *task.surface, &own = (*task.pieces)[piece]](double s, double t) {
    return evaluate(surface, own, s, t);
  };
}

std::array<std::vector<Vector3>, 4> boundary_of(const CadEdges& edges, Index piece, const SplineSpace& s,
                                                const SplineSpace& t) {
  std::array<std::vector<Vector3>, 4> out;
  for (int side = 0; side < 4; ++side)
    out[std::size_t(side)] = edges.boundary(piece, side, side % 2 == 0 ? s : t);
  return out;
}

/// The breaks of a piece, and those of the curves along its sides.
std::pair<SplineSpace, SplineSpace> spaces_of(const EdgeTask& task, const CadEdges& edges, Index piece) {
  SplineSpace s{task.degree, (*task.pieces)[piece].s}, t{task.degree, (*task.pieces)[piece].t};
  for (int side = 0; side < 4; ++side)
    for (const double b : edges.breaks(piece, side)) insert_break(side % 2 == 0 ? s.breaks : t.breaks, b);
  return {s, t};
}

/// A place of a smooth edge, with what both faces have there.
struct EdgePlace {
  double x = 0;  ///< of the edge
  double width = 0;
  Vector3 normal = Vector3::Zero();  ///< the surface's, perpendicular to the curve; zero where there is none
  std::array<Vector3, 2> across{};   ///< as SidePlace
  std::array<double, 2> speed{};
  std::array<double, 2> turn{};  ///< that the faces have
  double wanted = 0;             ///< that both should have
  double sine = 1;               ///< the lesser of those between the edge and the derivatives across it
  /// Hardly determined planes, where sides of a corner run on straight, count little.
  double jump() const { return sine * std::abs(turn[0] - turn[1]); }
};

class FaceMaker {
 public:
  FaceMaker(const EdgeTask& task, const CadEdges& edges, const CancelToken& cancel, const Progress& progress)
      : task_(task), edges_(edges), cancel_(cancel), progress_(progress), faces_(task.pieces->size()) {
    limits_ = task.limits;
    limits_.distance *= fit_share - curve_share;
    limits_.angle *= angle_share;
  }

  std::optional<std::vector<CadFace>> run(std::size_t heaviest) {
    begin();
    places_.resize(edges_.edges().size());
    std::vector<char> dirty(faces_.size(), 1);
    for (int round = 0; !cancel_.cancelled(); ++round) {
      progress_.report(1 - std::pow(0.75, round));
      std::size_t weight = 0;
      for (const Face& face : faces_) weight += weight_of(face.s, face.t);
      if (weight > heaviest) return {};
      fit(dirty);
      settle();
      const bool last = round + 1 == most_rounds;
      dirty = refine(last);
      if (last || std::find(dirty.begin(), dirty.end(), 1) == dirty.end()) break;
    }
    std::vector<CadFace> out;
    for (Face& face : faces_) out.push_back(std::move(face.out));
    return out;
  }

 private:
  struct Face {
    CadFace out;
    SplineSpace s, t;
    std::unique_ptr<FaceFit> fit;  ///< none where the face is exact
  };

  void each(const std::vector<char>& chosen, std::size_t grain, const std::function<void(Index)>& visit) {
    parallel_for(chosen.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !cancel_.cancelled(); ++i)
        if (chosen[i]) visit(Index(i));
    });
  }

  void begin() {
    each(std::vector<char>(faces_.size(), 1), 1, [&](Index f) {
      Face& face = faces_[f];
      if (auto exact = exact_cad_face(task_, edges_, f)) {
        face.out = std::move(*exact);
        face.s = face.out.surface.s;
        face.t = face.out.surface.t;
        return;
      }
      std::tie(face.s, face.t) = spaces_of(task_, edges_, f);
      face.fit = std::make_unique<FaceFit>(model_of(task_, f), face.s, face.t,
                                           boundary_of(edges_, f, face.s, face.t));
    });
  }

  const SplineSurface& surface(Index f) const {
    return faces_[f].fit ? faces_[f].fit->surface() : faces_[f].out.surface;
  }
  bool tied(const CadEdge& edge) const {
    return edge.smooth && edge.use_count == 2 &&
           (faces_[edge.uses[0].piece].fit || faces_[edge.uses[1].piece].fit);
  }
  double length(const CadUse& use) const { return (*task_.pieces)[use.piece].length(use.side); }
  /// Counter-clockwise along the side of a use, of a place of the edge.
  static double on_side(const CadEdge& edge, int use, double x) {
    const CadUse& own = edge.uses[std::size_t(use)];
    const double f = x / edge.curve.space.end();
    return own.begin + (use == 0 ? f : 1 - f) * (own.end - own.begin);
  }
  /// In the direction of growing s or t.
  double growing(const CadUse& use, double along) const { return use.side < 2 ? along : length(use) - along; }

  /// Breaks of both faces along an edge, of the edge.
  std::vector<double> edge_breaks(const CadEdge& edge) const {
    const double span = edge.curve.space.end();
    std::vector<double> out{0, span};
    for (int u = 0; u < 2; ++u) {
      const CadUse& use = edge.uses[std::size_t(u)];
      for (const double b : (use.side % 2 == 0 ? faces_[use.piece].s : faces_[use.piece].t).breaks) {
        const double f = (growing(use, b) - use.begin) / (use.end - use.begin);
        if (f > 0 && f < 1) insert_break(out, (u == 0 ? f : 1 - f) * span);
      }
    }
    return out;
  }

  void place(Index e) {
    const CadEdge& edge = edges_.edges()[e];
    const std::vector<EdgePlace> before = std::move(places_[e]);
    auto& list = places_[e];
    list.clear();
    const SpanPlaces& gauss = span_places(task_.degree + 1);
    const std::vector<double> breaks = edge_breaks(edge);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
      for (std::size_t g = 0; g < gauss.at.size(); ++g) {
        EdgePlace at;
        const double width = breaks[k + 1] - breaks[k];
        at.x = breaks[k] + gauss.at[g] * width;
        at.width = gauss.weight[g] * width / edge.curve.space.end();
        if (const auto* old = nearest(before, at.x)) at.wanted = old->wanted;
        if (measure(edge, at)) list.push_back(at);
      }
  }

  /// Kept from places that were there before.
  static const EdgePlace* nearest(const std::vector<EdgePlace>& places, double x) {
    if (places.empty()) return nullptr;
    const auto above = std::lower_bound(places.begin(), places.end(), x,
                                        [](const EdgePlace& p, double y) { return p.x < y; });
    if (above == places.end()) return &places.back();
    return above == places.begin() || above->x - x < x - above[-1].x ? &*above : &above[-1];
  }

  PatchPoint side_point(const CadUse& use, double x) const {
    const CadPiece& piece = (*task_.pieces)[use.piece];
    const Vector2 at = piece.parameter(use.side, x);
    return evaluate(*task_.surface, piece, at.x(), at.y());
  }

  /// Normal and speeds; false where there is no normal.
  bool measure(const CadEdge& edge, EdgePlace& at) const {
    const SplinePoint curve = evaluate(edge.curve, at.x);
    const Vector3 tangent = curve.derivative.stableNormalized();
    for (int u = 0; u < 2; ++u) {
      const CadUse& use = edge.uses[std::size_t(u)];
      // The curve may run ahead of the surface's.
      double x = on_side(edge, u, at.x);
      const PatchPoint near = side_point(use, x);
      const Vector3 along = (use.side % 2 == 0 ? near.ds : near.dt) * (use.side < 2 ? 1 : -1);
      x += (curve.position - near.position).dot(along) / along.squaredNorm();
      const PatchPoint p = side_point(use, std::clamp(x, 0.0, length(use)));
      if (!has_normal(near) || !has_normal(p)) return false;
      at.across[std::size_t(u)] = use.side % 2 == 0 ? p.dt : p.ds;
      at.normal += unit_normal(p);
    }
    at.normal = (at.normal - at.normal.dot(tangent) * tangent).stableNormalized();
    const Vector3 left = at.normal.cross(tangent);
    for (std::size_t u = 0; u < 2; ++u) {
      at.speed[u] = at.across[u].dot(left);
      const double sine = std::abs(at.speed[u]) / at.across[u].norm();
      if (!(sine > 1e-5)) return false;
      at.sine = std::min(at.sine, sine / 0.05);
    }
    return true;
  }

  void fit(const std::vector<char>& dirty) {
    std::vector<char> chosen(places_.size(), 0);
    for (std::size_t e = 0; e < places_.size(); ++e) {
      const CadEdge& edge = edges_.edges()[e];
      chosen[e] = tied(edge) && (dirty[edge.uses[0].piece] || dirty[edge.uses[1].piece]);
    }
    each(chosen, 4, [&](Index e) { place(e); });
    for (std::size_t e = 0; e < places_.size(); ++e)
      for (const CadUse& use : edges_.edges()[e].uses)
        if (chosen[e] && faces_[use.piece].fit) faces_[use.piece].fit->forget();
    solve(neighbours(chosen, dirty), true);
  }
  /// Faces of chosen edges, and `also`.
  std::vector<char> neighbours(const std::vector<char>& chosen, std::vector<char> also) const {
    for (std::size_t e = 0; e < chosen.size(); ++e)
      for (int u = 0; chosen[e] && u < 2; ++u) also[edges_.edges()[e].uses[std::size_t(u)].piece] = 1;
    return also;
  }

  void solve(const std::vector<char>& chosen, bool slides = false) {
    each(chosen, 1, [&](Index f) {
      if (!faces_[f].fit) return;
      for (int side = 0; side < 4; ++side) faces_[f].fit->set_side(side, side_places(f, side));
      faces_[f].fit->solve(limits_);
      if (!slides) return;
      faces_[f].fit->slide();
      faces_[f].fit->solve(limits_);
    });
  }

  std::vector<SidePlace> side_places(Index f, int side) const {
    std::vector<SidePlace> out;
    for (const Index e : edges_.sides(f)[std::size_t(side)]) {
      const CadEdge& edge = edges_.edges()[e];
      const int u = edge.uses[0].piece == f && edge.uses[0].side == side ? 0 : 1;
      const CadUse& use = edge.uses[std::size_t(u)];
      const double share = (use.end - use.begin) / length(use);
      for (const EdgePlace& at : places_[e])
        out.push_back({growing(use, on_side(edge, u, at.x)), at.sine * at.sine * at.width * share, at.normal,
                       at.speed[std::size_t(u)], at.across[std::size_t(u)], at.wanted});
    }
    return out;
  }

  /// Turns of both faces, and what both should have.
  void compare(Index e) {
    const CadEdge& edge = edges_.edges()[e];
    for (int u = 0; u < 2; ++u) {
      const CadUse& use = edge.uses[std::size_t(u)];
      const SplineEvaluator evaluator(surface(use.piece));
      for (EdgePlace& at : places_[e]) {
        const Vector2 p = (*task_.pieces)[use.piece].parameter(use.side, on_side(edge, u, at.x));
        const PatchPoint point = evaluator.at(p.x(), p.y());
        at.turn[std::size_t(u)] =
            (use.side % 2 == 0 ? point.dt : point.ds).dot(at.normal) / at.speed[std::size_t(u)];
      }
    }
    const bool first = faces_[edge.uses[0].piece].fit != nullptr,
               second = faces_[edge.uses[1].piece].fit != nullptr;
    for (EdgePlace& at : places_[e])
      at.wanted = first && second ? 0.5 * (at.turn[0] + at.turn[1]) : at.turn[first ? 1 : 0];
  }
  double largest_jump(Index e) const {
    double out = 0;
    for (const EdgePlace& at : places_[e]) out = std::max(out, at.jump());
    return out;
  }

  /// Both faces of an edge turn towards the mean of their tangent planes.
  void settle() {
    std::vector<char> chosen(places_.size(), 0);
    for (std::size_t e = 0; e < places_.size(); ++e) chosen[e] = !places_[e].empty();
    std::vector<char> moved = chosen;
    for (int sweep = 0; !cancel_.cancelled(); ++sweep) {
      each(moved, 4, [&](Index e) { compare(e); });
      std::vector<char> missed(places_.size(), 0);
      bool some = false;
      for (std::size_t e = 0; e < places_.size(); ++e)
        if (largest_jump(Index(e)) > limits_.angle) missed[e] = some = true;
      if (!some || sweep == most_sweeps) break;
      const std::vector<char> again = neighbours(missed, std::vector<char>(faces_.size(), 0));
      solve(again);
      for (std::size_t e = 0; e < places_.size(); ++e) {
        const CadEdge& edge = edges_.edges()[e];
        moved[e] = chosen[e] && (again[edge.uses[0].piece] || again[edge.uses[1].piece]);
      }
    }
  }

  /// Knots where faces or edges miss the limits; the faces that got some.
  std::vector<char> refine(bool last) {
    std::vector<FaceMiss> misses(faces_.size());
    each(std::vector<char>(faces_.size(), 1), 1, [&](Index f) {
      if (faces_[f].fit) misses[f] = faces_[f].fit->miss(limits_);
    });
    for (std::size_t e = 0; e < places_.size(); ++e) mark(Index(e), misses);
    std::vector<char> out(faces_.size(), 0);
    each(std::vector<char>(faces_.size(), 1), 1, [&](Index f) {
      Face& face = faces_[f];
      if (!face.fit) return;
      face.out.surface = face.fit->surface();
      face.out.reached = !(misses[f].worst > 1);
      if (last) return;
      const bool s = halve(face.s, misses[f].s), t = halve(face.t, misses[f].t);
      if (!s && !t) return;
      out[f] = 1;
      face.fit = std::make_unique<FaceFit>(model_of(task_, f), face.s, face.t,
                                           boundary_of(edges_, f, face.s, face.t));
    });
    return out;
  }

  /// Marks where the faces of an edge do not agree: knots along it, and across it in corners and where spans
  /// are longer across.
  void mark(Index e, std::vector<FaceMiss>& misses) const {
    const CadEdge& edge = edges_.edges()[e];
    const double worst = largest_jump(e);
    if (!(worst > limits_.angle)) return;
    for (int u = 0; u < 2; ++u) {
      const CadUse& use = edge.uses[std::size_t(u)];
      const Face& face = faces_[use.piece];
      if (!face.fit) continue;
      const bool horizontal = use.side % 2 == 0;
      const SplineSpace &along = horizontal ? face.s : face.t, &across = horizontal ? face.t : face.s;
      std::vector<char>&along_marks = horizontal ? misses[use.piece].s : misses[use.piece].t,
      &across_marks = horizontal ? misses[use.piece].t : misses[use.piece].s;
      along_marks.resize(along.span_count(), 0);
      across_marks.resize(across.span_count(), 0);
      const std::size_t beside = use.side == 1 || use.side == 2 ? across.span_count() - 1 : 0;
      const double depth = width(across, beside);
      for (const EdgePlace& at : places_[e]) {
        if (!(at.jump() > std::max(limits_.angle, 0.5 * worst))) continue;
        const std::size_t span = along.span(growing(use, on_side(edge, u, at.x)));
        along_marks[span] = 1;
        if (span == 0 || span + 1 == along.span_count() || width(along, span) < 0.4 * depth)
          across_marks[beside] = 1;
      }
    }
  }
  /// Share of the whole.
  static double width(const SplineSpace& space, std::size_t span) {
    return (space.breaks[span + 1] - space.breaks[span]) / (space.end() - space.begin());
  }

  const EdgeTask& task_;
  const CadEdges& edges_;
  const CancelToken& cancel_;
  Progress progress_;
  FitLimits limits_;
  std::vector<Face> faces_;
  std::vector<std::vector<EdgePlace>> places_;  ///< of each edge that ties faces
};

}  // namespace

std::optional<CadFace> exact_cad_face(const EdgeTask& task, const CadEdges& edges, Index piece) {
  const auto [s, t] = spaces_of(task, edges, piece);
  const FaceFit::Model model = model_of(task, piece);
  CadFace out;
  out.surface = interpolated(s, t, model, boundary_of(edges, piece, s, t));
  const SplineEvaluator spline(out.surface);
  double distance = 0;
  const auto inside = [](const SplineSpace& space, std::size_t i, double f) {
    return space.breaks[i] + f * (space.breaks[i + 1] - space.breaks[i]);
  };
  // Rectangles of patches are known to be splines.
  const bool known = (*task.pieces)[piece].cells.size() > 1;
  for (std::size_t j = 0; j < t.span_count(); ++j)
    for (std::size_t i = 0; i < s.span_count(); ++i)
      for (const auto& [f, g] : exact_looks) {
        const double x = inside(s, i, f), y = inside(t, j, g);
        distance = std::max(distance, (model(x, y).position - spline.at(x, y).position).norm());
        if (!known && distance > task.rounding) return {};
      }
  out.exact = distance <= exact_face * task.size;
  return out;
}

std::optional<std::vector<CadFace>> cad_faces(const EdgeTask& task, const CadEdges& edges,
                                              std::size_t heaviest, const CancelToken& cancel,
                                              const Progress& progress) {
  return FaceMaker(task, edges, cancel, progress).run(heaviest);
}

}  // namespace hariko
