#include "core/cad/cad_shells.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "core/base/disjoint_sets.hpp"
#include "core/base/gauss_legendre.hpp"
#include "core/geometry/winding_tree.hpp"

namespace hariko {

namespace {

using Box = Eigen::AlignedBox3d;

/// Volume under a face, seen from `apex`: a third of the integral of position times normal. Exact but for
/// rounding, by as many Gauss points a span as the polynomial's degree needs.
double volume_under(const SplineSurface& face, const Vector3& apex) {
  struct Rule {
    std::vector<double> places, weights;
    explicit Rule(const SplineSpace& space) {
      const std::vector<GaussPoint> unit = gauss_legendre_unit((3 * space.degree + 1) / 2);
      for (std::size_t k = 0; k < space.span_count(); ++k)
        for (const GaussPoint& point : unit) {
          const double width = space.breaks[k + 1] - space.breaks[k];
          places.push_back(space.breaks[k] + width * point.node);
          weights.push_back(width * point.weight);
        }
    }
  };
  const Rule s(face.s), t(face.t);
  const auto points = evaluate_grid(face, spline_bases(face.s, s.places), spline_bases(face.t, t.places));
  double out = 0;
  for (std::size_t j = 0; j < t.places.size(); ++j)
    for (std::size_t i = 0; i < s.places.size(); ++i) {
      const PatchPoint& at = points[j * s.places.size() + i];
      out += s.weights[i] * t.weights[j] * (at.position - apex).dot(at.ds.cross(at.dt)) / 3;
    }
  return out;
}

/// Box round the control points of a shell, which contains its faces.
Box control_box(const CadModel& model, const CadShell& shell) {
  Box out;
  for (const Index f : shell.faces)
    for (const Vector3& p : model.faces[f].surface.points) out.extend(p);
  return out;
}

/// Places of points inside each face of a shell, some dozens over all.
std::vector<Vector3> probes_of(const CadModel& model, const CadShell& shell) {
  constexpr std::size_t wanted = 40;
  const std::size_t faces = std::min(wanted, shell.faces.size());
  const auto along = int(std::ceil(std::sqrt(double(wanted) / double(faces))));
  std::vector<Vector3> out;
  for (std::size_t k = 0; k < faces; ++k) {
    const SplineSurface& face = model.faces[shell.faces[k * shell.faces.size() / faces]].surface;
    const SplineEvaluator evaluator(face);
    for (int j = 0; j < along; ++j)
      for (int i = 0; i < along; ++i) {
        const double x = (i + 0.5) / along, y = (j + 0.5) / along;
        out.push_back(evaluator
                          .at(face.s.begin() + x * (face.s.end() - face.s.begin()),
                              face.t.begin() + y * (face.t.end() - face.t.begin()))
                          .position);
      }
  }
  return out;
}

enum class SideOfShell { inside, outside, unknown };

/// Interior of a closed shell.
class ShellInterior {
 public:
  ShellInterior(const CadModel& model, const CadShell& shell)
      : model_(model), inward_(shell.volume < 0), size_(control_box(model, shell).diagonal().norm()) {
    for (const Index f : shell.faces) triangulate(f);
    tree_ = std::make_unique<WindingTree>(positions_, triangles_);
  }
  ShellInterior(const ShellInterior&) = delete;
  ShellInterior& operator=(const ShellInterior&) = delete;

  /// Side on which a point is; unknown where it is too near to the shell, or its foot lies on an edge.
  SideOfShell side(const Vector3& point) const {
    const WindingTree::Nearest nearest = tree_->nearest(point);
    if (nearest.distance > 2 * deviation_)
      return std::abs(tree_->winding(point)) > 0.5 ? SideOfShell::inside : SideOfShell::outside;
    return side_of_face(point, starts_[nearest.triangle], nearest.distance);
  }

 private:
  /// Parameters in the middle of a triangle.
  struct Start {
    Index face = no_index;
    double s = 0, t = 0;
  };

  static std::vector<double> grid_places(const SplineSpace& space) {
    std::vector<double> out{space.begin()};
    for (std::size_t k = 0; k < space.span_count(); ++k) {
      out.push_back(0.5 * (space.breaks[k] + space.breaks[k + 1]));
      out.push_back(space.breaks[k + 1]);
    }
    return out;
  }

  /// Adds the triangles of a grid of two by two cells a span. Their deviation is at most that of the chords
  /// of whole spans, for nearly straight spans; it is measured there.
  void triangulate(Index number) {
    const SplineSurface& face = model_.faces[number].surface;
    const std::vector<double> s = grid_places(face.s), t = grid_places(face.t);
    const auto points = evaluate_grid(face, spline_bases(face.s, s), spline_bases(face.t, t));
    const auto first = Index(positions_.size());
    const auto row = Index(s.size());
    for (const PatchPoint& at : points) positions_.push_back(at.position);
    const auto measure = [&](Index before, Index middle, Index behind) {
      const Vector3 chord = 0.5 * (points[before].position + points[behind].position);
      deviation_ = std::max(deviation_, (points[middle].position - chord).norm());
    };
    for (Index j = 0; j < t.size(); ++j)
      for (Index i = 1; i < row; i += 2) measure(j * row + i - 1, j * row + i, j * row + i + 1);
    for (Index j = 1; j < t.size(); j += 2)
      for (Index i = 0; i < row; ++i) measure((j - 1) * row + i, j * row + i, (j + 1) * row + i);
    for (Index j = 0; j + 1 < t.size(); ++j)
      for (Index i = 0; i + 1 < row; ++i) {
        const Index a = first + j * row + i, b = a + 1, c = a + row, d = c + 1;
        triangles_.push_back({a, b, d});
        triangles_.push_back({a, d, c});
        const double width = s[i + 1] - s[i], height = t[j + 1] - t[j];
        starts_.push_back({number, s[i] + width * 2 / 3, t[j] + height / 3});
        starts_.push_back({number, s[i] + width / 3, t[j] + height * 2 / 3});
      }
  }

  /// Side of a point near a face, from the foot of the perpendicular, by Newton's method.
  SideOfShell side_of_face(const Vector3& point, const Start& start, double distance) const {
    const SplineSurface& face = model_.faces[start.face].surface;
    const SplineEvaluator evaluator(face);
    constexpr int most_steps = 30;
    constexpr double settled = 1e-10, least_distance = 1e-9;
    double s = start.s, t = start.t;
    for (int step = 0; step < most_steps; ++step) {
      const PatchPoint at = evaluator.at(s, t);
      const Vector3 away = point - at.position;
      const double e = at.ds.squaredNorm(), f = at.ds.dot(at.dt), g = at.dt.squaredNorm();
      const double area = e * g - f * f, a = at.ds.dot(away), b = at.dt.dot(away);
      if (!(area > 1e-10 * e * g)) return SideOfShell::unknown;
      const double move_s = (g * a - f * b) / area, move_t = (e * b - f * a) / area;
      if (std::abs(move_s) <= settled * (face.s.end() - face.s.begin()) &&
          std::abs(move_t) <= settled * (face.t.end() - face.t.begin())) {
        const double height = away.dot(at.ds.cross(at.dt)) / std::sqrt(area);
        // A point as near as that touches; a farther foot than the nearest triangle's is another one.
        if (std::abs(height) < least_distance * size_ || std::abs(height) > distance + 2 * deviation_)
          return SideOfShell::unknown;
        return (height < 0) != inward_ ? SideOfShell::inside : SideOfShell::outside;
      }
      s += move_s;
      t += move_t;
      if (s < face.s.begin() || s > face.s.end() || t < face.t.begin() || t > face.t.end())
        return SideOfShell::unknown;
    }
    return SideOfShell::unknown;
  }

  const CadModel& model_;
  bool inward_ = false;
  double size_ = 0, deviation_ = 0;
  std::vector<Vector3> positions_;
  std::vector<std::array<Index, 3>> triangles_;
  std::vector<Start> starts_;  ///< by triangle
  std::unique_ptr<WindingTree> tree_;
};

/// Nesting of closed shells.
class Nesting {
 public:
  Nesting(const CadModel& model, std::vector<CadShell>& shells)
      : model_(model), shells_(shells), interiors_(shells.size()) {
    for (const CadShell& shell : shells_) boxes_.push_back(control_box(model_, shell));
  }

  /// Sets `hollows` of all shells.
  void run() {
    std::vector<Index> order;  // large ones first, so that those around a shell are known before it
    for (Index k = 0; k < shells_.size(); ++k)
      if (shells_[k].closed && shells_[k].volume != 0) order.push_back(k);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
      return std::abs(shells_[a].volume) > std::abs(shells_[b].volume);
    });
    for (std::size_t k = 0; k < order.size(); ++k) {
      const CadShell& shell = shells_[order[k]];
      for (std::size_t outer = k; outer-- > 0;) {  // the innermost one is the smallest
        if (!is_inside(order[k], order[outer])) continue;
        const CadShell& around = shells_[order[outer]];
        if (around.hollows == no_index && (around.volume < 0) != (shell.volume < 0))
          shells_[order[k]].hollows = order[outer];
        break;
      }
    }
  }

 private:
  /// Whether a shell lies within another, larger one: all points of it that are told are inside.
  bool is_inside(Index inner, Index outer) {
    // Control points of a fitted face may stick out a little where the face does not.
    const Vector3 slack = Vector3::Constant(0.05 * boxes_[outer].diagonal().norm());
    if (!Box(boxes_[outer].min() - slack, boxes_[outer].max() + slack).contains(boxes_[inner])) return false;
    auto& interior = interiors_[outer];
    if (!interior) interior = std::make_unique<ShellInterior>(model_, shells_[outer]);
    bool any = false;
    for (const Vector3& probe : probes_of(model_, shells_[inner])) {
      const SideOfShell side = interior->side(probe);
      if (side == SideOfShell::outside) return false;
      any = any || side == SideOfShell::inside;
    }
    return any;
  }

  const CadModel& model_;
  std::vector<CadShell>& shells_;
  std::vector<std::unique_ptr<ShellInterior>> interiors_;  ///< made when first needed
  std::vector<Box> boxes_;
};

}  // namespace

std::vector<CadShell> cad_shells(const CadModel& model) {
  DisjointSets parts(model.faces.size());
  for (const CadEdge& edge : model.edges)
    if (edge.use_count == 2) parts.join(edge.uses[0].piece, edge.uses[1].piece);
  std::map<Index, CadShell> by_part;
  for (Index f = 0; f < model.faces.size(); ++f) {
    CadShell& shell = by_part.try_emplace(parts.find(f)).first->second;
    if (shell.faces.empty()) shell.closed = true;
    shell.faces.push_back(f);
  }
  for (const CadEdge& edge : model.edges)
    if (edge.use_count == 1 && !edge.degenerate) by_part.at(parts.find(edge.uses[0].piece)).closed = false;
  std::vector<CadShell> out;
  for (auto& [part, shell] : by_part) out.push_back(std::move(shell));
  for (CadShell& shell : out) {
    if (!shell.closed) continue;
    const Vector3 apex = control_box(model, shell).center();
    for (const Index f : shell.faces) shell.volume += volume_under(model.faces[f].surface, apex);
  }
  Nesting(model, out).run();
  return out;
}

}  // namespace hariko
