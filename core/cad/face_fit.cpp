#include "core/cad/face_fit.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace hariko {

namespace {

/// How much the length and the lean of the derivative across a side count beside the angle.
constexpr double slope_share = 0.05;

double angle_between(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Weight of a miss, as a symmetric matrix.
Matrix3 metric(const PatchPoint& point) {
  if (!has_normal(point)) return Matrix3::Identity();
  const Vector3 normal = unit_normal(point);
  constexpr double along = along_share * along_share;
  return along * Matrix3::Identity() + (1 - along) * normal * normal.transpose();
}

/// Unit vectors along ds, across it in the tangent plane, and normal.
Matrix3 frame(const PatchPoint& point) {
  if (!has_normal(point)) return Matrix3::Identity();
  Matrix3 out;
  out.col(0) = point.ds.stableNormalized();
  out.col(2) = unit_normal(point);
  out.col(1) = out.col(2).cross(out.col(0));
  return out;
}

/// Difference of the given sides from the surface's, as a smooth field over the rectangle (Coons) that does
/// not turn normals along the sides: a spline that ran from its boundary to the surface within its first span
/// would turn them the more the narrower that span is. It is blended in the surface's own frames, so that
/// what is off along the surface stays in it.
class BoundaryMiss {
 public:
  BoundaryMiss(const SplineSurface& boundary, const std::vector<double>& along, const std::vector<double>& up,
               const FaceFit::Model& model) {
    const SplineEvaluator spline(boundary);
    const double s0 = boundary.s.begin(), s1 = boundary.s.end(), t0 = boundary.t.begin(),
                 t1 = boundary.t.end();
    const auto miss = [&](double s, double t) -> Vector3 {
      const PatchPoint point = model(s, t);
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
  /// At place i along s and j along t, in the frame there.
  Vector3 at(std::size_t i, std::size_t j) const {
    const double a = blend_s_[i], b = blend_t_[j];
    return (1 - b) * (low_t_[i] - (1 - a) * corners_[0] - a * corners_[1]) +
           b * (high_t_[i] - (1 - a) * corners_[3] - a * corners_[2]) + (1 - a) * low_s_[j] + a * high_s_[j];
  }

 private:
  /// 0 to 1 with slopes of zero.
  static double blend(double x) { return x * x * (3 - 2 * x); }
  std::array<Vector3, 4> corners_;
  std::vector<double> blend_s_, blend_t_;
  std::vector<Vector3> low_t_, high_t_, low_s_, high_s_;
};

/// Sums over the samples of a rectangle of products of its functions, u along s and v along t, with a
/// symmetric matrix a sample.
class RectangleSums {
 public:
  RectangleSums(std::size_t us, std::size_t vs)
      : us_(us), vs_(vs), line_(us * us, Matrix3::Zero()), line_pull_(us, Vector3::Zero()) {
    blocks_.assign(us * us * vs * vs, Matrix3::Zero());
    pulls_.assign(us * vs, Vector3::Zero());
  }
  void begin_line() {
    std::fill(line_.begin(), line_.end(), Matrix3::Zero());
    std::fill(line_pull_.begin(), line_pull_.end(), Vector3::Zero());
  }
  void add(const SplineBasis& s, const Matrix3& counts, const Vector3& pull) {
    for (std::size_t u = 0; u < us_; ++u) {
      line_pull_[u] += s.value[u] * pull;
      for (std::size_t w = 0; w <= u; ++w) line_[u * us_ + w] += (s.value[u] * s.value[w]) * counts;
    }
  }
  void end_line(const SplineBasis& t) {
    for (std::size_t v = 0; v < vs_; ++v) {
      for (std::size_t u = 0; u < us_; ++u) pulls_[v * us_ + u] += t.value[v] * line_pull_[u];
      for (std::size_t z = 0; z <= v; ++z)
        for (std::size_t u = 0; u < us_; ++u)
          for (std::size_t w = 0; w <= u; ++w)
            blocks_[place(u, v, w, z)] += (t.value[v] * t.value[z]) * line_[u * us_ + w];
    }
  }
  const Vector3& pull(std::size_t u, std::size_t v) const { return pulls_[v * us_ + u]; }
  const Matrix3& block(std::size_t u, std::size_t v, std::size_t w, std::size_t z) const {
    return blocks_[place(std::max(u, w), std::max(v, z), std::min(u, w), std::min(v, z))];
  }

 private:
  std::size_t place(std::size_t u, std::size_t v, std::size_t w, std::size_t z) const {
    return ((v * vs_ + z) * us_ + u) * us_ + w;
  }
  std::size_t us_, vs_;
  std::vector<Matrix3> line_, blocks_;
  std::vector<Vector3> line_pull_, pulls_;
};

}  // namespace

FaceFit::Direction FaceFit::direction(const SplineSpace& space) {
  Direction out;
  // A single span needs as many places as it has functions, and more show what is missed between them.
  const SpanPlaces& places = span_places(space.span_count() < 3 ? space.degree + 2 : space.degree + 1);
  const std::vector<double> knots = space.knots();
  for (std::size_t span = 0; span < space.span_count(); ++span) {
    const double width = space.breaks[span + 1] - space.breaks[span];
    for (std::size_t g = 0; g < places.at.size(); ++g) {
      out.at.push_back(space.breaks[span] + places.at[g] * width);
      out.weight.push_back(places.weight[g] * width / (space.end() - space.begin()));
      out.span.push_back(span);
      out.basis.push_back(spline_basis(space, knots, out.at.back()));
    }
  }
  return out;
}

FaceFit::FaceFit(Model model, SplineSpace s, SplineSpace t, std::array<std::vector<Vector3>, 4> boundary)
    : model_(std::move(model)) {
  surface_.s = std::move(s);
  surface_.t = std::move(t);
  const std::size_t m = surface_.s.size(), n = surface_.t.size();
  surface_.points.assign(m * n, Vector3::Zero());
  for (std::size_t j = 0; j < n; ++j) {
    surface_.points[surface_.index(0, j)] = boundary[3][j];
    surface_.points[surface_.index(m - 1, j)] = boundary[1][j];
  }
  for (std::size_t i = 0; i < m; ++i) {
    surface_.points[surface_.index(i, 0)] = boundary[0][i];
    surface_.points[surface_.index(i, n - 1)] = boundary[2][i];
  }
  inner_s_ = m - 2;
  inner_t_ = n - 2;
  s_ = direction(surface_.s);
  t_ = direction(surface_.t);
  for (const double y : t_.at)
    for (const double x : s_.at) {
      places_.emplace_back(x, y);
      samples_.push_back(model_(x, y));
    }
  const BoundaryMiss miss(surface_, s_.at, t_.at, model_);
  for (std::size_t j = 0; j < t_.at.size(); ++j)
    for (std::size_t i = 0; i < s_.at.size(); ++i) {
      misses_.push_back(miss.at(i, j));
      targets_.emplace_back(sample(i, j).position + frame(sample(i, j)) * misses_.back());
      areas_.push_back(sample(i, j).ds.cross(sample(i, j).dt));
    }
}

void FaceFit::slide() {
  for (std::size_t j = 0; j < t_.at.size(); ++j)
    for (std::size_t i = 0; i < s_.at.size(); ++i) {
      const std::size_t k = j * s_.at.size() + i;
      const PatchPoint& point = samples_[k];
      const PatchPoint got = fitted(i, j);
      const Vector3 off = got.position - targets_[k];
      const double e = point.ds.squaredNorm(), f = point.ds.dot(point.dt), g = point.dt.squaredNorm();
      const double area = e * g - f * f, a = point.ds.dot(off), b = point.dt.dot(off);
      if (!(area > 1e-4 * e * g)) continue;
      Vector2& at = places_[k];
      at += Vector2(g * a - f * b, e * b - f * a) / area;
      at.x() = std::clamp(at.x(), surface_.s.begin(), surface_.s.end());
      at.y() = std::clamp(at.y(), surface_.t.begin(), surface_.t.end());
      samples_[k] = model_(at.x(), at.y());
      targets_[k] = samples_[k].position + frame(samples_[k]) * misses_[k];
      areas_[k] = unit_normal(samples_[k]) * got.ds.cross(got.dt).norm();
    }
  matrix_.reset();
}

/// Places of a span: from the first on, and the end.
std::pair<std::size_t, std::size_t> FaceFit::samples_of(const Direction& direction, std::size_t span) {
  const auto [from, to] = std::equal_range(direction.span.begin(), direction.span.end(), span);
  return {std::size_t(from - direction.span.begin()), std::size_t(to - direction.span.begin())};
}

void FaceFit::set_ties(std::vector<FaceTie> ties) {
  ties_ = std::move(ties);
  matrix_.reset();
}

void FaceFit::want(std::span<const double> values) {
  for (std::size_t k = 0; k < ties_.size(); ++k) ties_[k].wanted = values[k];
}

/// Number of the control point (i, j) inside, along the shorter direction first.
std::size_t FaceFit::unknown(std::size_t i, std::size_t j) const {
  return inner_s_ <= inner_t_ ? (j - 1) * inner_s_ + i - 1 : (i - 1) * inner_t_ + j - 1;
}

void FaceFit::add_block(std::size_t a, std::size_t b, double factor, const Matrix3& block) {
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      if (3 * b + c <= 3 * a + r)
        matrix_->entry(3 * a + r, 3 * b + c) += factor * block(Eigen::Index(r), Eigen::Index(c));
}

/// Adds the samples of a rectangle between knots. The sums along s come first, as they are the same for
/// all functions of t.
void FaceFit::add_rectangle(std::size_t column, std::size_t row, double weight) {
  const std::size_t us = std::size_t(surface_.s.degree) + 1, vs = std::size_t(surface_.t.degree) + 1;
  const auto [from_i, to_i] = samples_of(s_, column);
  const auto [from_j, to_j] = samples_of(t_, row);
  RectangleSums sums(us, vs);
  for (std::size_t j = from_j; j < to_j; ++j) {
    sums.begin_line();
    for (std::size_t i = from_i; i < to_i; ++i) {
      const Matrix3 counts = weight * s_.weight[i] * t_.weight[j] * metric(sample(i, j));
      sums.add(s_.basis[i], counts, counts * targets_[j * s_.at.size() + i]);
    }
    sums.end_line(t_.basis[j]);
  }
  const std::size_t first_s = s_.basis[from_i].first, first_t = t_.basis[from_j].first;
  const auto is_free = [&](std::size_t u, std::size_t v) {
    const std::size_t x = first_s + u, y = first_t + v;
    return x > 0 && x <= inner_s_ && y > 0 && y <= inner_t_;
  };
  for (std::size_t v = 0; v < vs; ++v)
    for (std::size_t u = 0; u < us; ++u) {
      if (!is_free(u, v)) continue;
      const std::size_t k = unknown(first_s + u, first_t + v);
      Vector3 pull = sums.pull(u, v);
      for (std::size_t z = 0; z < vs; ++z)
        for (std::size_t w = 0; w < us; ++w) {
          const Matrix3 block = sums.block(u, v, w, z);
          if (!is_free(w, z)) {
            pull -= block * surface_.points[surface_.index(first_s + w, first_t + z)];
          } else if (const std::size_t l = unknown(first_s + w, first_t + z); l <= k) {
            add_block(k, l, 1, block);
          }
        }
      for (std::size_t axis = 0; axis < 3; ++axis) right_[3 * k + axis] += pull[Eigen::Index(axis)];
    }
}

void FaceFit::add_tie(const FaceTie& tie) {
  const Vector3& normal = tie.tie.normal;
  constexpr double along = slope_share * slope_share;
  const Matrix3 counts =
      tie.weight * (along * Matrix3::Identity() + (1 - along) * normal * normal.transpose());
  Vector3 miss = tie.rest;
  std::vector<std::pair<std::size_t, double>> local;
  for (const PointShare& at : tie.tie.shares) {
    if (is_free(at))
      local.emplace_back(unknown(at.i, at.j), at.factor);
    else
      miss -= at.factor * surface_.points[surface_.index(at.i, at.j)];
  }
  const Vector3 pull = counts * miss;
  for (const auto& [k, value] : local) {
    for (std::size_t axis = 0; axis < 3; ++axis) right_[3 * k + axis] += value * pull[Eigen::Index(axis)];
    for (const auto& [l, other] : local)
      if (l <= k) add_block(k, l, value * other, counts);
  }
}

/// The volume between the surface and the face, of which the least squares alone leave some: squares do not
/// see on which side of the surface a face lies.
void FaceFit::add_volume() {
  volume_.assign(right_.size(), 0);
  volume_wanted_ = 0;
  for (std::size_t j = 0; j < t_.at.size(); ++j)
    for (std::size_t i = 0; i < s_.at.size(); ++i) {
      const Vector3 area = s_.weight[i] * t_.weight[j] * areas_[j * s_.at.size() + i];
      volume_wanted_ += area.dot(sample(i, j).position);
      for (std::size_t v = 0; v <= std::size_t(surface_.t.degree); ++v)
        for (std::size_t u = 0; u <= std::size_t(surface_.s.degree); ++u) {
          const PointShare at{s_.basis[i].first + u, t_.basis[j].first + v,
                              s_.basis[i].value[u] * t_.basis[j].value[v]};
          if (!is_free(at)) {
            volume_wanted_ -= at.factor * area.dot(surface_.points[surface_.index(at.i, at.j)]);
            continue;
          }
          const std::size_t k = 3 * unknown(at.i, at.j);
          for (std::size_t axis = 0; axis < 3; ++axis)
            volume_[k + axis] += at.factor * area[Eigen::Index(axis)];
        }
    }
  volume_move_ = volume_;
  matrix_->solve(volume_move_);
  const double change = std::inner_product(volume_.begin(), volume_.end(), volume_move_.begin(), 0.0);
  for (double& move : volume_move_) move = change > 0 ? move / change : 0;
}

void FaceFit::assemble(const FitLimits& limits) {
  const std::size_t unknowns = 3 * inner_s_ * inner_t_;
  const bool s_first = inner_s_ <= inner_t_;
  const std::size_t row = std::min(inner_s_, inner_t_),
                    steps = std::size_t(s_first ? surface_.t.degree : surface_.s.degree),
                    within = std::size_t(s_first ? surface_.s.degree : surface_.t.degree);
  matrix_ = std::make_unique<BandedCholesky>(unknowns, 3 * (steps * row + within) + 2);
  right_.assign(unknowns, 0);
  const double distance = 1 / (limits.distance * limits.distance);
  for (std::size_t row_number = 0; row_number < surface_.t.span_count(); ++row_number)
    for (std::size_t column = 0; column < surface_.s.span_count(); ++column)
      add_rectangle(column, row_number, distance);
  for (const FaceTie& tie : ties_) add_tie(tie);
  if (matrix_->factor())
    add_volume();
  else
    matrix_.reset();
}

void FaceFit::solve(const FitLimits& limits) {
  if (!matrix_) assemble(limits);
  if (!matrix_) return;
  std::vector<double> right = right_;
  for (const FaceTie& tie : ties_)
    for (const PointShare& at : tie.tie.shares) {
      if (!is_free(at)) continue;
      const Vector3 pull = tie.weight * tie.wanted * at.factor * tie.tie.normal;
      for (std::size_t axis = 0; axis < 3; ++axis)
        right[3 * unknown(at.i, at.j) + axis] += pull[Eigen::Index(axis)];
    }
  matrix_->solve(right);
  const double missing =
      volume_wanted_ - std::inner_product(volume_.begin(), volume_.end(), right.begin(), 0.0);
  for (std::size_t k = 0; k < right.size(); ++k) right[k] += missing * volume_move_[k];
  for (std::size_t j = 1; j <= inner_t_; ++j)
    for (std::size_t i = 1; i <= inner_s_; ++i) {
      const double* at = right.data() + 3 * unknown(i, j);
      surface_.points[surface_.index(i, j)] = {at[0], at[1], at[2]};
    }
}

PatchPoint FaceFit::fitted(std::size_t i, std::size_t j) const {
  const SplineBasis &a = s_.basis[i], &b = t_.basis[j];
  PatchPoint out;
  for (std::size_t v = 0; v <= std::size_t(surface_.t.degree); ++v) {
    Vector3 row = Vector3::Zero(), row_s = Vector3::Zero();
    for (std::size_t u = 0; u <= std::size_t(surface_.s.degree); ++u) {
      const Vector3& p = surface_.points[surface_.index(a.first + u, b.first + v)];
      row += a.value[u] * p;
      row_s += a.derivative[u] * p;
    }
    out.position += b.value[v] * row;
    out.ds += b.value[v] * row_s;
    out.dt += b.derivative[v] * row;
  }
  return out;
}

/// Difference of the surface from the nearest splines of one direction's space, along the lines of that
/// direction; the part across the surface, at the samples.
std::vector<double> FaceFit::residual(const SplineSpace& space, const Direction& own, bool by_s) const {
  const std::size_t count = own.at.size(), lines = by_s ? t_.at.size() : s_.at.size(),
                    p = std::size_t(space.degree);
  BandedCholesky gram(space.size(), p);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t u = 0; u <= p; ++u)
      for (std::size_t v = 0; v <= u; ++v)
        gram.entry(own.basis[i].first + u, own.basis[i].first + v) +=
            own.weight[i] * own.basis[i].value[u] * own.basis[i].value[v];
  std::vector<double> out(samples_.size(), 0);
  if (!gram.factor()) return out;
  for (std::size_t line = 0; line < lines; ++line) {
    const auto place = [&](std::size_t i) {
      return by_s ? line * s_.at.size() + i : i * s_.at.size() + line;
    };
    std::array<std::vector<double>, 3> points;
    for (int axis = 0; axis < 3; ++axis) {
      auto& right = points[std::size_t(axis)];
      right.assign(space.size(), 0);
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t u = 0; u <= p; ++u)
          right[own.basis[i].first + u] +=
              own.weight[i] * own.basis[i].value[u] * samples_[place(i)].position[axis];
      gram.solve(right);
    }
    for (std::size_t i = 0; i < count; ++i) {
      Vector3 miss = samples_[place(i)].position;
      for (std::size_t u = 0; u <= p; ++u)
        for (int axis = 0; axis < 3; ++axis)
          miss[axis] -= own.basis[i].value[u] * points[std::size_t(axis)][own.basis[i].first + u];
      out[place(i)] =
          has_normal(samples_[place(i)]) ? std::abs(miss.dot(unit_normal(samples_[place(i)]))) : miss.norm();
    }
  }
  return out;
}

FaceMiss FaceFit::miss(const FitLimits& limits) const {
  FaceMiss out{0, std::vector<char>(surface_.s.span_count(), 0),
               std::vector<char>(surface_.t.span_count(), 0)};
  std::vector<double> times(samples_.size(), 0);
  for (std::size_t j = 0; j < t_.at.size(); ++j)
    for (std::size_t i = 0; i < s_.at.size(); ++i) {
      const PatchPoint &want = sample(i, j), got = fitted(i, j);
      const Vector3 off = got.position - want.position;
      double& here = times[j * s_.at.size() + i];
      if (!has_normal(want)) {
        here = off.norm() / limits.distance;
        continue;
      }
      const Vector3 normal = unit_normal(want);
      here = std::max(std::abs(off.dot(normal)), 0.5 * along_share * off.norm()) / limits.distance;
      // Normals in corners whose sides run on straight are hardly determined.
      const double sine = want.ds.cross(want.dt).norm() / (want.ds.norm() * want.dt.norm());
      // A miss of the distance over a span turns it: knots that are narrower than that would only add to
      // it.
      const double narrower = std::min(want.ds.norm() * span_width(surface_.s, s_.span[i]),
                                       want.dt.norm() * span_width(surface_.t, t_.span[j]));
      if (has_normal(got))
        here = std::max(here, sine * angle_between(normal, unit_normal(got)) /
                                  (limits.turn + limits.distance / narrower));
    }
  out.worst = *std::max_element(times.begin(), times.end());
  if (!(out.worst > 1)) return out;
  const std::vector<double> by_s = residual(surface_.s, s_, true), by_t = residual(surface_.t, t_, false);
  const std::size_t columns = surface_.s.span_count(), tiles = columns * surface_.t.span_count();
  std::vector<std::array<double, 3>> tile(tiles, {0, 0, 0});
  for (std::size_t j = 0; j < t_.at.size(); ++j)
    for (std::size_t i = 0; i < s_.at.size(); ++i) {
      const std::size_t k = j * s_.at.size() + i;
      auto& largest = tile[t_.span[j] * columns + s_.span[i]];
      largest[0] = std::max(largest[0], times[k]);
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

SplineSurface interpolated(const SplineSpace& s, const SplineSpace& t, const FaceFit::Model& model,
                           const std::array<std::vector<Vector3>, 4>& boundary) {
  SplineSurface out{s, t, std::vector<Vector3>(s.size() * t.size())};
  const SplineInterpolation along(s), up(t);
  const std::size_t m = s.size(), n = t.size();
  const SplineCurve left{t, boundary[3]}, right{t, boundary[1]};
  for (std::size_t j = 1; j + 1 < n; ++j) {
    out.points[out.index(0, j)] = evaluate(left, up.places()[j]).position;
    out.points[out.index(m - 1, j)] = evaluate(right, up.places()[j]).position;
    for (std::size_t i = 1; i + 1 < m; ++i)
      out.points[out.index(i, j)] = model(along.places()[i], up.places()[j]).position;
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
