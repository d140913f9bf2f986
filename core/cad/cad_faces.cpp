#include "core/cad/cad_faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/cad/fit/edge_ties.hpp"
#include "core/cad/fit/face_fit.hpp"

namespace hariko {

namespace {

/// Fraction of the distance limit that a fit keeps to: between the sampled places the error is up to a third
/// larger.
constexpr double fit_share = 0.75;
/// Fraction of the limit of the angle between faces that a fit keeps to: between its places the angle is up
/// to a tenth larger.
constexpr double angle_share = 0.8;
/// The same of the limit of the jump of curvature.
constexpr double bend_fit_share = 0.6;
/// Largest number of rounds of knot insertion.
constexpr int most_rounds = 12;
/// Largest number of conjugate gradient steps towards common tangent planes, and of extensions to
/// neighbouring edges that these steps disturb, before knots are inserted.
constexpr int most_steps = 24, most_widenings = 3;

/// Test places in a span; none of them is a Greville place of a single span, where every interpolant is
/// exact.
constexpr std::array<std::pair<double, double>, 3> exact_looks{{{0.37, 0.61}, {0.11, 0.83}, {0.91, 0.13}}};

FaceBoundary boundary_of(const CadEdges& edges, Index piece, const SplineSpace& s, const SplineSpace& t) {
  FaceBoundary out;
  for (int side = 0; side < 4; ++side)
    out[std::size_t(side)] = edges.boundary(piece, side, side % 2 == 0 ? s : t);
  return out;
}

/// Spline spaces of a piece in s and t: its own breaks and those of the curves along its sides.
std::pair<SplineSpace, SplineSpace> spaces_of(const EdgeTask& task, const CadEdges& edges, Index piece) {
  SplineSpace s{task.degree, (*task.pieces)[piece].s}, t{task.degree, (*task.pieces)[piece].t};
  for (int side = 0; side < 4; ++side)
    for (const double b : edges.breaks(piece, side)) insert_break(side % 2 == 0 ? s.breaks : t.breaks, b);
  return {s, t};
}

/// Limits that the fits work with, stricter than the task's.
FitLimits limits_of(const EdgeTask& task) {
  FitLimits out = task.limits;
  out.distance *= fit_share - curve_share;
  out.angle *= angle_share;
  out.bend *= bend_fit_share;
  return out;
}

class FaceMaker {
 public:
  FaceMaker(const EdgeTask& task, const CadEdges& edges, const CancelToken& cancel, const Progress& progress)
      : task_(task),
        edges_(edges),
        cancel_(cancel),
        progress_(progress),
        limits_(limits_of(task)),
        faces_(task.pieces->size()),
        ties_(task, edges, limits_,
              {[this](Index f) -> const SplineSurface& { return surface(f); },
               [this](Index f) { return faces_[f].fit != nullptr; }}) {}

  std::optional<std::vector<CadFace>> run(std::size_t heaviest) {
    begin();
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
    std::unique_ptr<FaceFit> fit;  ///< null where the face is exact
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
      face.fit = new_fit(f);
    });
  }
  /// New fit in the present spaces of a face.
  std::unique_ptr<FaceFit> new_fit(Index f) const {
    const Face& face = faces_[f];
    return std::make_unique<FaceFit>((*task_.points)[f], face.s, face.t,
                                     boundary_of(edges_, f, face.s, face.t), limits_, face.fit.get());
  }

  const SplineSurface& surface(Index f) const {
    return faces_[f].fit ? faces_[f].fit->surface() : faces_[f].out.surface;
  }
  void fit(const std::vector<char>& dirty) {
    std::vector<char> chosen(edges_.edges().size(), 0);
    for (std::size_t e = 0; e < chosen.size(); ++e) {
      const CadEdge& edge = edges_.edges()[e];
      chosen[e] = ties_.tied(Index(e)) && (dirty[edge.uses[0].piece] || dirty[edge.uses[1].piece]);
    }
    each(chosen, 4, [&](Index e) { ties_.place(e); });
    const std::vector<char> faces = neighbours(chosen, dirty);
    each(faces, 1, [&](Index f) {
      if (!faces_[f].fit) return;
      faces_[f].fit->set_ties(ties_.ties(f));
      faces_[f].fit->solve();
      faces_[f].fit->slide();
    });
    each(chosen, 4, [&](Index e) { ties_.retie(e); });
    each(faces, 1, [&](Index f) {
      if (!faces_[f].fit) return;
      faces_[f].fit->set_ties(ties_.ties(f));
      faces_[f].fit->solve();
    });
  }
  /// Faces of the chosen edges, and the faces marked in `also`.
  std::vector<char> neighbours(const std::vector<char>& chosen, std::vector<char> also) const {
    for (std::size_t e = 0; e < chosen.size(); ++e)
      for (int u = 0; chosen[e] && u < 2; ++u) also[edges_.edges()[e].uses[std::size_t(u)].piece] = 1;
    return also;
  }
  std::vector<char> neighbours(const std::vector<char>& chosen) const {
    return neighbours(chosen, std::vector<char>(faces_.size(), 0));
  }
  /// Tied edges of the chosen faces.
  std::vector<char> edges_of(const std::vector<char>& chosen) const {
    std::vector<char> out(edges_.edges().size(), 0);
    for (std::size_t e = 0; e < out.size(); ++e) {
      const CadEdge& edge = edges_.edges()[e];
      out[e] = !ties_.places(Index(e)).empty() && (chosen[edge.uses[0].piece] || chosen[edge.uses[1].piece]);
    }
    return out;
  }

  /// Moves both faces of each edge to common tangent planes, as far as their knots allow.
  void settle() {
    std::vector<char> looked = edges_of(std::vector<char>(faces_.size(), 1)), active(looked.size(), 0);
    for (int widening = 0; widening < most_widenings && !cancel_.cancelled(); ++widening) {
      each(looked, 4, [&](Index e) { ties_.compare(e); });
      std::vector<char> missed(looked.size(), 0);
      bool some = false;
      for (std::size_t e = 0; e < looked.size(); ++e)
        if (std::max(ties_.worst(Index(e)), ties_.worst_bend(Index(e))) > 1) missed[e] = some = true;
      if (!some) break;
      active = edges_of(neighbours(missed));
      if (widening > 0) {
        each(active, 4, [&](Index e) { ties_.retie(e); });
        each(neighbours(active), 1, [&](Index f) {
          if (faces_[f].fit) faces_[f].fit->set_ties(ties_.ties(f));
        });
      }
      agree(active);
      looked = edges_of(neighbours(active));
    }
    each(looked, 4, [&](Index e) { ties_.compare(e); });
  }

  /// Conjugate gradients towards common values at the active edges. The faces' values are linear in the
  /// wanted ones; the least-squares optimum over all faces together is where each wanted value is the mean of
  /// the two faces' values.
  void agree(const std::vector<char>& active) {
    const std::vector<char> faces = neighbours(active);
    std::vector<Agreed*> agreed;
    for (std::size_t e = 0; e < active.size(); ++e)
      if (active[e]) ties_.agreed(Index(e), agreed);
    const auto look = [&] {
      each(faces, 1, [&](Index f) {
        if (!faces_[f].fit) return;
        faces_[f].fit->want(ties_.wanted(f));
        faces_[f].fit->solve_rows();
      });
      each(active, 4, [&](Index e) { ties_.compare(e); });
    };
    for (Agreed* one : agreed)
      if (!one->free[0] || !one->free[1]) one->wanted = one->mean();
    look();
    const std::size_t n = agreed.size();
    std::vector<double> at(n), rest(n), step(n);
    std::vector<std::array<double, 2>> has(n);
    double square = 0;
    for (std::size_t k = 0; k < n; ++k) {
      at[k] = agreed[k]->wanted;
      has[k] = agreed[k]->has;
      step[k] = rest[k] = agreed[k]->mean() - at[k];
      square += agreed[k]->cost() * rest[k] * rest[k];
    }
    const double least = 1e-6 * square;
    for (int round = 0; round < most_steps && square > least && !cancel_.cancelled(); ++round) {
      for (std::size_t k = 0; k < n; ++k) agreed[k]->wanted = at[k] + step[k];
      look();
      std::vector<double> change(n);
      double slope = 0;
      for (std::size_t k = 0; k < n; ++k) {
        change[k] = rest[k] + agreed[k]->wanted - agreed[k]->mean();
        slope += agreed[k]->cost() * step[k] * change[k];
      }
      if (!(slope > 0)) break;
      const double length = square / slope, before = square;
      double worst = 0;
      square = 0;
      for (std::size_t k = 0; k < n; ++k) {
        at[k] += length * step[k];
        rest[k] -= length * change[k];
        for (std::size_t u = 0; u < 2; ++u) has[k][u] += length * (agreed[k]->has[u] - has[k][u]);
        worst = std::max(worst, std::abs(has[k][0] - has[k][1]) / agreed[k]->limit);
        square += agreed[k]->cost() * rest[k] * rest[k];
      }
      if (!(worst > 1)) break;
      for (std::size_t k = 0; k < n; ++k) step[k] = rest[k] + square / before * step[k];
    }
    for (std::size_t k = 0; k < n; ++k) agreed[k]->wanted = at[k];
    look();
    each(faces, 1, [&](Index f) {
      if (faces_[f].fit) faces_[f].fit->solve();
    });
  }

  /// Inserts knots where faces or edges miss the limits; returns the faces that got some.
  std::vector<char> refine(bool last) {
    std::vector<FaceMiss> misses(faces_.size());
    FitLimits reach = limits_;
    reach.distance = fit_share * task_.limits.distance;
    each(std::vector<char>(faces_.size(), 1), 1, [&](Index f) {
      if (faces_[f].fit) misses[f] = faces_[f].fit->miss(reach);
    });
    for (std::size_t e = 0; e < edges_.edges().size(); ++e) mark(Index(e), misses);
    std::vector<char> out(faces_.size(), 0);
    each(std::vector<char>(faces_.size(), 1), 1, [&](Index f) {
      Face& face = faces_[f];
      if (!face.fit) return;
      face.out.surface = face.fit->surface();
      face.out.reached = !(misses[f].worst > 1);
      face.out.folded = face.fit->folds();
      if (last) return;
      const bool s = halve(face.s, misses[f].s), t = halve(face.t, misses[f].t);
      if (!s && !t) return;
      out[f] = 1;
      face.fit = new_fit(f);
    });
    return out;
  }

  /// Marks spans where the two faces of an edge disagree: along the edge, and across it at corners and where
  /// spans are longer across than along.
  void mark(Index e, std::vector<FaceMiss>& misses) const {
    const CadEdge& edge = edges_.edges()[e];
    const auto miss = [&](const EdgePlace& at) { return std::max(ties_.miss(at), ties_.bend_miss(at)); };
    const double worst = std::max(ties_.worst(e), ties_.worst_bend(e));
    if (!(worst > 1)) return;
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
      for (const EdgePlace& at : ties_.places(e)) {
        if (!(miss(at) > std::max(1.0, 0.5 * worst))) continue;
        const std::size_t span = ties_.span(edge, u, at.x);
        along_marks[span] = 1;
        if (span == 0 || span + 1 == along.span_count() || width(along, span) < 0.4 * depth)
          across_marks[beside] = 1;
      }
    }
  }
  /// Width of a span relative to the whole space.
  static double width(const SplineSpace& space, std::size_t span) {
    return (space.breaks[span + 1] - space.breaks[span]) / (space.end() - space.begin());
  }

  const EdgeTask& task_;
  const CadEdges& edges_;
  const CancelToken& cancel_;
  Progress progress_;
  FitLimits limits_;
  std::vector<Face> faces_;
  EdgeTies ties_;
};

}  // namespace

std::optional<CadFace> exact_cad_face(const EdgeTask& task, const CadEdges& edges, Index piece) {
  const auto [s, t] = spaces_of(task, edges, piece);
  const PieceEvaluator& model = (*task.points)[piece];
  CadFace out;
  out.surface = interpolated(s, t, model, boundary_of(edges, piece, s, t));
  const SplineEvaluator spline(out.surface);
  double distance = 0;
  const auto inside = [](const SplineSpace& space, std::size_t i, double f) {
    return space.breaks[i] + f * (space.breaks[i + 1] - space.breaks[i]);
  };
  // Rectangles of merged patches are already known to be splines.
  const bool known = (*task.pieces)[piece].cells.size() > 1;
  for (std::size_t j = 0; j < t.span_count(); ++j)
    for (std::size_t i = 0; i < s.span_count(); ++i)
      for (const auto& [f, g] : exact_looks) {
        const double x = inside(s, i, f), y = inside(t, j, g);
        distance = std::max(distance, (model.at(x, y).position - spline.at(x, y).position).norm());
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
