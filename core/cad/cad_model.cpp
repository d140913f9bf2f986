#include "core/cad/cad_model.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.hpp"
#include "core/cad/cad_edges.hpp"
#include "core/cad/cad_faces.hpp"

namespace hariko {

namespace {

constexpr int cubic = 3, quartic_degree = 4, quintic = 5;
/// Largest angle between the normals of faces and of the surface: a multiple of the angle between faces, and
/// a lower bound of it.
constexpr double turn_share = 20, least_turn = 2 * std::numbers::pi / 180;

/// Largest relative jump of the curvature of models in mode G2, per radian of the angle between faces: 2 % at
/// 0.02 degrees.
constexpr double bend_share = 0.02 / (0.02 * std::numbers::pi / 180);

template <class Form>
bool has_form(const Surface& surface) {
  return std::holds_alternative<Form>(surface.patches().exact_form(0));
}

/// Whether the patches may be ordinary quartics: their inner points coincide in pairs, nearly.
bool may_be_quartics(const Surface& surface, double size) {
  for (Index p = 0; p < surface.patch_count(); ++p) {
    const ExactForm form = surface.patches().exact_form(p);
    const auto* quartic = std::get_if<PairedQuartic>(&form);
    if (!quartic || quartic->pair_distance > 1e-9 * size) return false;
  }
  return true;
}

struct Attempt {
  CadPieces pieces;
  int degree;
  bool bends = false;  ///< see `EdgeTask::bends`
  /// With `CadPiece::warps`. An attempt without them is made only where faces of one with them have faults.
  bool warped = true;
};
/// Degrees and pieces to try. Cubics and polynomial Bezier patches keep their own degree; all else is fitted
/// by whatever weighs least. Attempts end as soon as they weigh more than those before; first come cubics of
/// single patches, whose time is bounded however tight the tolerance is. Faces that fold at warped vertices,
/// as on steep domes, lie better in their own parameters.
std::vector<Attempt> attempts_for(const Surface& surface, const CadModelOptions& options) {
  if (has_form<SubdivisionPatch>(surface) || has_form<BicubicPatch>(surface))
    return {{CadPieces::faces, cubic}, {CadPieces::faces, cubic, false, false}};
  if (const auto degree = bezier_degree(bezier_patches(surface))) return {{CadPieces::faces, *degree}};
  if (has_form<ChartPatch>(surface)) return {{CadPieces::faces, quintic, true}};
  if (surface.domain() == Domain::square)
    return {{CadPieces::faces, cubic}, {CadPieces::faces, quintic, true}};
  if (options.whole_faces) return {{CadPieces::faces, quintic, true}};
  if (options.exact) return {{CadPieces::patches, quintic}};
  return {{CadPieces::patches, cubic}, {CadPieces::faces, quintic, true}};
}

Eigen::AlignedBox3d box_of(const Surface& surface) {
  Eigen::AlignedBox3d box;
  for (Index p = 0; p < surface.patch_count(); ++p)
    for (int k = 0; k < corner_count(surface.domain()); ++k)
      box.extend(surface.patches().evaluate(p, corner_parameter(surface.domain(), k), Order::first).position);
  return box;
}

/// Measures how far the faces' own boundaries are from the edges.
void measure_edges(CadModel& model) {
  parallel_for(model.edges.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      CadEdge& edge = model.edges[e];
      const double span = edge.curve.space.end();
      for (int u = 0; u < edge.use_count; ++u) {
        const CadUse& use = edge.uses[std::size_t(u)];
        const SplineEvaluator spline(model.faces[use.piece].surface);
        const std::size_t steps = 4 * edge.curve.space.size();
        for (std::size_t k = 0; k <= steps; ++k) {
          const double f = double(k) / double(steps), g = u == 0 ? f : 1 - f;
          const Vector2 at =
              model.pieces[use.piece].parameter(use.side, use.begin + g * (use.end - use.begin));
          const Vector3 miss = spline.at(at.x(), at.y()).position - evaluate(edge.curve, f * span).position;
          edge.deviation = std::max(edge.deviation, miss.norm());
        }
      }
    }
  });
}

std::size_t weight(const CadModel& model) {
  std::size_t out = 0;
  for (const CadFace& face : model.faces) out += weight_of(face.surface.s, face.surface.t);
  return out;
}

/// Numbers of faces that are folded and that miss the tolerance; they are compared in this order, before the
/// weight.
using Faults = std::pair<std::size_t, std::size_t>;
Faults faults(const CadModel& model) {
  Faults out;
  for (const CadFace& face : model.faces) {
    out.first += face.folded;
    out.second += !face.reached;
  }
  return out;
}

bool has_warps(const CadModel& model) {
  return std::any_of(model.pieces.begin(), model.pieces.end(),
                     [](const CadPiece& piece) { return !piece.warps.empty(); });
}

/// Builds CAD models of one surface, each of one degree.
class Maker {
 public:
  Maker(const Surface& surface, const Attempt& attempt, const CadModelOptions& options,
        const CancelToken& cancel)
      : surface_(surface),
        cancel_(cancel),
        pieces_(cad_pieces(surface, attempt.pieces, attempt.warped)),
        plan_(plan_cad(surface, pieces_)) {
    for (const CadPiece& piece : pieces_) points_.emplace_back(surface, piece);
    const Eigen::AlignedBox3d box = box_of(surface);
    size_ = box.isEmpty() ? 0 : box.diagonal().norm();
    limits_.distance = std::max(options.tolerance, options.share * size_);
    limits_.angle = options.angle;
    limits_.turn = std::max(turn_share * options.angle, least_turn);
    if (has_form<ChartPatch>(surface)) limits_.bend = bend_share * options.angle;
  }

  double size() const { return size_; }

  /// Model by fitting; nothing where it would weigh more than `heaviest`, or when cancelled.
  std::optional<CadModel> make(const Attempt& attempt, std::size_t heaviest, const Progress& progress) const {
    const EdgeTask task{&pieces_, &points_, attempt.degree, limits_, size_, rounding(), attempt.bends};
    const CadEdges edges(task, plan_, cancel_);
    if (cancel_.cancelled()) return {};
    auto faces = cad_faces(task, edges, heaviest, cancel_, progress);
    return faces ? finished(edges, std::move(*faces)) : std::nullopt;
  }
  /// Model without fitting; nothing where not all faces are splines of the degree without knots, or when
  /// cancelled.
  std::optional<CadModel> make_exact(int degree) const {
    EdgeTask task{&pieces_, &points_, degree, limits_, size_, rounding()};
    task.limits = FitLimits{infinite, infinite, infinite};
    const CadEdges edges(task, plan_, cancel_);
    std::vector<CadFace> faces;
    for (Index f = 0; f < pieces_.size(); ++f) {
      auto face = cancel_.cancelled() ? std::nullopt : exact_cad_face(task, edges, f);
      if (!face || !face->exact) return {};
      faces.push_back(std::move(*face));
    }
    return finished(edges, std::move(faces));
  }

 private:
  double rounding() const {
    const double farthest = surface_.origin().norm() + size_;
    return std::max(1e-11 * size_, 1e3 * std::numeric_limits<double>::epsilon() * farthest);
  }
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  std::optional<CadModel> finished(const CadEdges& edges, std::vector<CadFace> faces) const {
    if (cancel_.cancelled()) return {};
    CadModel out;
    out.origin = surface_.origin();
    out.size = size_;
    out.vertices = edges.vertices();
    out.edges = edges.edges();
    out.faces = std::move(faces);
    out.pieces = pieces_;
    for (Index f = 0; f < out.faces.size(); ++f) out.faces[f].sides = edges.sides(f);
    out.curvature = has_form<ChartPatch>(surface_);
    measure_edges(out);
    return out;
  }

  const Surface& surface_;
  const CancelToken& cancel_;
  std::vector<CadPiece> pieces_;
  std::vector<PieceEvaluator> points_;
  CadPlan plan_;
  FitLimits limits_;
  double size_ = 0;
};

}  // namespace

bool CadModel::closed() const {
  return std::all_of(edges.begin(), edges.end(),
                     [](const CadEdge& edge) { return edge.use_count == 2 || edge.degenerate; });
}

std::string_view why_not_exact(const Surface& surface) {
  if (has_form<PairedQuartic>(surface))
    return "rational triangles, whose inner points do not coincide in pairs";
  if (has_form<ChartPatch>(surface)) return "rational patches of mode G2";
  if (has_form<SubdivisionPatch>(surface))
    return "patches round extraordinary vertices, which are endless rows of splines";
  if (has_form<BezierPatch>(surface)) return "rational patches, or such of a degree above 9";
  return "rational patches";
}

Result<CadModel> make_cad_model(const Surface& surface, const CadModelOptions& options,
                                const CancelToken& cancel, const Progress& progress) {
  if (surface.patch_count() == 0) return CadModel{};
  std::optional<CadModel> best;
  if (!options.whole_faces && may_be_quartics(surface, box_of(surface).diagonal().norm()))
    best = Maker(surface, Attempt{CadPieces::patches, quartic_degree}, options, cancel)
               .make_exact(quartic_degree);
  if (!best || !options.exact) {
    const std::vector<Attempt> attempts = attempts_for(surface, options);
    double done = 0;
    for (const Attempt& attempt : attempts) {
      const double next = done + 1.0 / double(attempts.size());
      const bool fine = best && faults(*best) == Faults();
      const bool wanted = attempt.warped || (best && !fine && has_warps(*best));
      const std::size_t heaviest = fine ? weight(*best) : std::numeric_limits<std::size_t>::max();
      auto made =
          wanted ? Maker(surface, attempt, options, cancel).make(attempt, heaviest, progress.part(done, next))
                 : std::nullopt;
      // One that is as good weighs less.
      if (made && (!best || (fine ? faults(*made) == Faults() : faults(*made) < faults(*best))))
        best = std::move(made);
      done = next;
    }
  }
  if (cancel.cancelled() || !best) return make_error(e_cancelled, "The export was cancelled.");
  return std::move(*best);
}

}  // namespace hariko
