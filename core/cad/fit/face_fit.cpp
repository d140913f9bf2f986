#include "core/cad/fit/face_fit.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/solvers/banded_cholesky.hpp"
#include "core/geometry/angles.hpp"

namespace hariko {

namespace {

/// Fraction of the distance limit below which offsets along the surface are not reprojected.
constexpr double slide_share = 0.05;
/// Number of rows of control points beside a side, without the boundary, that ties depend on: those of the
/// first derivative across it, or of the second.
std::size_t tied_rows(const FitLimits& limits) {
  return std::isfinite(limits.bend) ? 2 : 1;
}

/// Orthonormal frame: along ds, across it in the tangent plane, normal.
Matrix3 frame(const PatchPoint& point) {
  if (!has_normal(point)) return Matrix3::Identity();
  Matrix3 out;
  out.col(0) = point.ds.stableNormalized();
  out.col(2) = unit_normal(point);
  out.col(1) = out.col(2).cross(out.col(0));
  return out;
}

/// Deviation of the given sides from the surface's, blended over the rectangle as a Coons patch whose blend
/// has zero slope at the sides and so does not turn normals there. Without it a spline would run from its
/// boundary to the surface within its first span, and turn normals the more the narrower that span is.
/// Blended in the surface's own frames, so that tangential deviations stay tangential.
class BoundaryMiss {
 public:
  BoundaryMiss(const SplineSurface& boundary, const std::vector<double>& along, const std::vector<double>& up,
               const PieceEvaluator& model) {
    const SplineEvaluator spline(boundary);
    const double s0 = boundary.s.begin(), s1 = boundary.s.end(), t0 = boundary.t.begin(),
                 t1 = boundary.t.end();
    const auto miss = [&](double s, double t) -> Vector3 {
      const PatchPoint point = model.at(s, t);
      return frame(point).transpose() * (spline.at(s, t).position - point.position);
    };
    corners_ = {miss(s0, t0), miss(s1, t0), miss(s1, t1), miss(s0, t1)};
    for (const double s : along) {
      blend_s_.push_back(blend((s - s0) / (s1 - s0)));
      low_t_.push_back(miss(s, t0));
      high_t_.push_back(miss(s, t1));
    }
    for (const double t : up) {
      blend_t_.push_back(blend((t - t0) / (t1 - t0)));
      high_s_.push_back(miss(s1, t));
      low_s_.push_back(miss(s0, t));
    }
  }
  /// Deviation at place i along s and j along t, in the frame there.
  Vector3 at(std::size_t i, std::size_t j) const {
    const double a = blend_s_[i], b = blend_t_[j];
    return (1 - b) * (low_t_[i] - (1 - a) * corners_[0] - a * corners_[1]) +
           b * (high_t_[i] - (1 - a) * corners_[3] - a * corners_[2]) + (1 - a) * low_s_[j] + a * high_s_[j];
  }

 private:
  /// Smoothstep from 0 to 1 with zero slopes.
  static double blend(double x) { return x * x * (3 - 2 * x); }
  std::array<Vector3, 4> corners_;
  std::vector<double> blend_s_, blend_t_;
  std::vector<Vector3> low_t_, high_t_, low_s_, high_s_;
};

/// Surface with the boundary's control points and zero inside.
SplineSurface outer_surface(SplineSpace s, SplineSpace t, const FaceBoundary& boundary) {
  SplineSurface out{std::move(s), std::move(t), {}};
  const std::size_t m = out.s.size(), n = out.t.size();
  out.points.assign(m * n, Vector3::Zero());
  for (std::size_t j = 0; j < n; ++j) {
    out.points[out.index(0, j)] = boundary[3][j];
    out.points[out.index(m - 1, j)] = boundary[1][j];
  }
  for (std::size_t i = 0; i < m; ++i) {
    out.points[out.index(i, 0)] = boundary[0][i];
    out.points[out.index(i, n - 1)] = boundary[2][i];
  }
  return out;
}

}  // namespace

FaceFit::FaceFit(const PieceEvaluator& model, SplineSpace s, SplineSpace t, FaceBoundary boundary,
                 const FitLimits& limits, const FaceFit* before)
    : model_(model),
      limits_(limits),
      surface_(outer_surface(std::move(s), std::move(t), boundary)),
      outer_(surface_),
      samples_(model, FitPlaces(surface_.s), FitPlaces(surface_.t), before ? &before->samples_ : nullptr),
      under_(samples_.points),
      inner_(samples_.s, samples_.t, 1 / (limits.distance * limits.distance), tied_rows(limits)) {
  for (const PatchPoint& point : fitted()) outer_part_.push_back(point.position);
  const BoundaryMiss miss(surface_, samples_.s.at, samples_.t.at, model_);
  for (std::size_t j = 0; j < samples_.t.size(); ++j)
    for (std::size_t i = 0; i < samples_.s.size(); ++i) {
      const PatchPoint& point = under_[place(i, j)];
      places_.emplace_back(samples_.s.at[i], samples_.t.at[j]);
      misses_.push_back(miss.at(i, j));
      targets_.emplace_back(point.position + frame(point) * misses_.back());
      areas_.push_back(point.ds.cross(point.dt));
    }
  aim();
}

/// Sets targets and the volume condition. Least squares alone do not distinguish the two sides of the
/// surface, and would leave a net volume between it and the face.
void FaceFit::aim() {
  std::vector<Vector3> inside(targets_.size());
  double volume = 0;
  for (std::size_t j = 0; j < samples_.t.size(); ++j)
    for (std::size_t i = 0; i < samples_.s.size(); ++i) {
      const std::size_t k = place(i, j);
      inside[k] = targets_[k] - outer_part_[k];
      volume +=
          samples_.s.weight[i] * samples_.t.weight[j] * areas_[k].dot(under_[k].position - outer_part_[k]);
    }
  inner_.aim(inside, areas_, volume);
}

void FaceFit::slide() {
  const std::vector<PatchPoint> got = fitted();
  const SplineSpace &s = surface_.s, &t = surface_.t;
  for (std::size_t k = 0; k < got.size(); ++k) {
    const PatchPoint& point = under_[k];
    const Vector3 off = got[k].position - targets_[k];
    const double e = point.ds.squaredNorm(), f = point.ds.dot(point.dt), g = point.dt.squaredNorm();
    const double area = e * g - f * f, a = point.ds.dot(off), b = point.dt.dot(off);
    if (!(area > 1e-4 * e * g)) continue;
    const Vector2 move = Vector2(g * a - f * b, e * b - f * a) / area;
    if ((move.x() * point.ds + move.y() * point.dt).norm() > slide_share * limits_.distance) {
      Vector2& at = places_[k];
      at += move;
      at.x() = std::clamp(at.x(), s.begin(), s.end());
      at.y() = std::clamp(at.y(), t.begin(), t.end());
      under_[k] = model_.at(at.x(), at.y());
      targets_[k] = under_[k].position + frame(under_[k]) * misses_[k];
    }
    areas_[k] = unit_normal(under_[k]) * got[k].ds.cross(got[k].dt).norm();
  }
  aim();
}

/// Residual of the nearest splines of one direction's space, fitted along the lines of that direction: its
/// component normal to the surface, at the samples.
std::vector<double> FaceFit::residual(const FitPlaces& own, bool by_s) const {
  const std::size_t count = own.size(), lines = by_s ? samples_.t.size() : samples_.s.size(),
                    p = std::size_t(own.space.degree);
  BandedCholesky gram(own.space.size(), p);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t u = 0; u <= p; ++u)
      for (std::size_t v = 0; v <= u; ++v)
        gram.entry(own.basis[i].first + u, own.basis[i].first + v) +=
            own.weight[i] * own.basis[i].value[u] * own.basis[i].value[v];
  std::vector<double> out(under_.size(), 0);
  if (!gram.factor()) return out;
  std::array<std::vector<double>, 3> points;
  for (std::size_t line = 0; line < lines; ++line) {
    const auto at = [&](std::size_t i) { return by_s ? place(i, line) : place(line, i); };
    for (int axis = 0; axis < 3; ++axis) {
      auto& right = points[std::size_t(axis)];
      right.assign(own.space.size(), 0);
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t u = 0; u <= p; ++u)
          right[own.basis[i].first + u] +=
              own.weight[i] * own.basis[i].value[u] * under_[at(i)].position[axis];
      gram.solve(right);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const PatchPoint& want = under_[at(i)];
      Vector3 miss = want.position;
      for (std::size_t u = 0; u <= p; ++u)
        for (int axis = 0; axis < 3; ++axis)
          miss[axis] -= own.basis[i].value[u] * points[std::size_t(axis)][own.basis[i].first + u];
      out[at(i)] = has_normal(want) ? std::abs(miss.dot(unit_normal(want))) : miss.norm();
    }
  }
  return out;
}

/// Deviation of the face from the surface at the samples, in multiples of the limits.
std::vector<double> FaceFit::times(const FitLimits& limits) const {
  const std::vector<PatchPoint> all = fitted();
  std::vector<double> out(all.size(), 0);
  for (std::size_t j = 0; j < samples_.t.size(); ++j)
    for (std::size_t i = 0; i < samples_.s.size(); ++i) {
      const std::size_t k = place(i, j);
      const PatchPoint &want = under_[k], &got = all[k];
      const Vector3 off = got.position - want.position;
      if (!has_normal(want)) {
        out[k] = off.norm() / limits.distance;
        continue;
      }
      const Vector3 normal = unit_normal(want);
      out[k] = std::max(std::abs(off.dot(normal)), 0.5 * along_share * off.norm()) / limits.distance;
      if (!has_normal(got)) continue;
      // Normals at corners whose sides run on straight are ill-determined.
      const double sine = want.ds.cross(want.dt).norm() / (want.ds.norm() * want.dt.norm());
      // A deviation of `distance` over one span turns it by this angle: narrower knots would only increase
      // it.
      const double narrower = std::min(want.ds.norm() * span_width(surface_.s, samples_.s.span(i)),
                                       want.dt.norm() * span_width(surface_.t, samples_.t.span(j)));
      out[k] = std::max(out[k], sine * angle_between(normal, unit_normal(got)) /
                                    (limits.turn + limits.distance / narrower));
    }
  return out;
}

bool FaceFit::folds() const {
  const auto turned = [](const PatchPoint& want, const PatchPoint& got) {
    return has_normal(want) && has_normal(got) && unit_normal(want).dot(unit_normal(got)) < 0;
  };
  const std::vector<PatchPoint> all = fitted();
  for (std::size_t k = 0; k < all.size(); ++k)
    if (turned(under_[k], all[k])) return true;
  // Sides, where no sample lies, are looked at as well: narrow faces fold there first.
  constexpr int steps = 4;
  const SplineEvaluator face(surface_);
  const auto folds_at = [&](double s, double t) { return turned(model_.at(s, t), face.at(s, t)); };
  const auto along = [&](const SplineSpace& space, const auto& folds_there) {
    for (std::size_t span = 0; span < space.span_count(); ++span)
      for (int i = 0; i <= steps; ++i)
        if (folds_there(space.breaks[span] + i * span_width(space, span) / steps)) return true;
    return false;
  };
  const SplineSpace &s = surface_.s, &t = surface_.t;
  return along(s, [&](double x) { return folds_at(x, t.begin()) || folds_at(x, t.end()); }) ||
         along(t, [&](double x) { return folds_at(s.begin(), x) || folds_at(s.end(), x); });
}

FaceMiss FaceFit::miss(const FitLimits& limits) const {
  FaceMiss out{0, std::vector<char>(surface_.s.span_count(), 0),
               std::vector<char>(surface_.t.span_count(), 0)};
  const std::vector<double> here = times(limits);
  out.worst = *std::max_element(here.begin(), here.end());
  if (!(out.worst > 1)) return out;
  const std::vector<double> by_s = residual(samples_.s, true), by_t = residual(samples_.t, false);
  const std::size_t columns = surface_.s.span_count(), tiles = columns * surface_.t.span_count();
  std::vector<std::array<double, 3>> tile(tiles, {0, 0, 0});
  for (std::size_t j = 0; j < samples_.t.size(); ++j)
    for (std::size_t i = 0; i < samples_.s.size(); ++i) {
      const std::size_t k = place(i, j);
      auto& largest = tile[samples_.t.span(j) * columns + samples_.s.span(i)];
      largest[0] = std::max(largest[0], here[k]);
      largest[1] = std::max(largest[1], by_s[k]);
      largest[2] = std::max(largest[2], by_t[k]);
    }
  for (std::size_t k = 0; k < tiles; ++k) {
    if (!(tile[k][0] > std::max(1.0, 0.25 * out.worst))) continue;
    if (tile[k][1] >= 0.5 * tile[k][2]) out.s[k % columns] = 1;
    if (tile[k][2] >= 0.5 * tile[k][1]) out.t[k / columns] = 1;
  }
  return out;
}

SplineSurface interpolated(const SplineSpace& s, const SplineSpace& t, const PieceEvaluator& surface,
                           const FaceBoundary& boundary) {
  SplineSurface out{s, t, std::vector<Vector3>(s.size() * t.size())};
  const SplineInterpolation along(s), up(t);
  const std::size_t m = s.size(), n = t.size();
  const SplineCurve left{t, boundary[3]}, right{t, boundary[1]};
  for (std::size_t j = 1; j + 1 < n; ++j) {
    out.points[out.index(0, j)] = evaluate(left, up.places()[j]).position;
    out.points[out.index(m - 1, j)] = evaluate(right, up.places()[j]).position;
    for (std::size_t i = 1; i + 1 < m; ++i)
      out.points[out.index(i, j)] = surface.at(along.places()[i], up.places()[j]).position;
  }
  if (n > 2) along.solve({out.points.data() + m, m * (n - 2)}, 1, n - 2, m);
  for (std::size_t i = 0; i < m; ++i) {
    out.points[out.index(i, 0)] = boundary[0][i];
    out.points[out.index(i, n - 1)] = boundary[2][i];
  }
  up.solve(out.points, m, m, 1);
  for (std::size_t j = 0; j < n; ++j) {
    out.points[out.index(0, j)] = boundary[3][j];
    out.points[out.index(m - 1, j)] = boundary[1][j];
  }
  return out;
}

}  // namespace hariko
