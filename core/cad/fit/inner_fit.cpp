#include "core/cad/fit/inner_fit.hpp"

#include <algorithm>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

using Number = Eigen::Index;

/// Gram matrix of the basis functions except the first and the last.
Eigen::MatrixXd inner_gram(const FitPlaces& places) {
  const Number inner = Number(places.space.size()) - 2;
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(inner, inner);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const SplineBasis& basis = places.basis[k];
    for (Number u = 0; u <= places.space.degree; ++u)
      for (Number v = 0; v <= places.space.degree; ++v) {
        const Number i = Number(basis.first) + u - 1, j = Number(basis.first) + v - 1;
        if (i < 0 || j < 0 || i >= inner || j >= inner) continue;
        out(i, j) += places.weight[k] * basis.value[std::size_t(u)] * basis.value[std::size_t(v)];
      }
  }
  return out;
}

double product(const std::array<Eigen::MatrixXd, 3>& a, const std::array<Eigen::MatrixXd, 3>& b) {
  double out = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) out += a[axis].cwiseProduct(b[axis]).sum();
  return out;
}

}  // namespace

InnerFit::InnerFit(const FitPlaces& s, const FitPlaces& t, double weight, std::size_t rows)
    : s_places_(s),
      t_places_(t),
      weight_(weight),
      m_(Number(s.space.size()) - 2),
      n_(Number(t.space.size()) - 2),
      s_(inner_gram(s)),
      t_(inner_gram(t)) {
  const auto beside = [&](Number i, Number count) { return i < Number(rows) || i >= count - Number(rows); };
  number_.assign(std::size_t(std::max<Number>(m_ * n_, 0)), -1);
  for (Number j = 0; j < n_; ++j)
    for (Number i = 0; i < m_; ++i) {
      if (!beside(i, m_) && !beside(j, n_)) continue;
      number_[std::size_t(i + j * m_)] = Number(rows_.size());
      rows_.push_back({i, j});
    }
  if (empty()) return;
  const Eigen::MatrixXd by_s = s_.solve(Eigen::MatrixXd::Identity(m_, m_)),
                        by_t = t_.solve(Eigen::MatrixXd::Identity(n_, n_));
  const Number count = Number(rows_.size());
  Eigen::MatrixXd flexibility(count, count);
  for (Number a = 0; a < count; ++a)
    for (Number b = 0; b < count; ++b) {
      const auto &p = rows_[std::size_t(a)], &q = rows_[std::size_t(b)];
      flexibility(a, b) = by_s(p[0], q[0]) * by_t(p[1], q[1]) / weight_;
    }
  stiffness_ = flexibility.llt().solve(Eigen::MatrixXd::Identity(count, count));
}

/// Sums, over the places, of values times basis functions.
InnerFit::Field InnerFit::gathered(std::span<const Vector3> values) const {
  Field out;
  out.fill(Eigen::MatrixXd::Zero(m_, n_));
  std::vector<Vector3> line(s_places_.space.size());
  for (std::size_t j = 0; j < t_places_.size(); ++j) {
    std::fill(line.begin(), line.end(), Vector3::Zero());
    for (std::size_t i = 0; i < s_places_.size(); ++i) {
      const SplineBasis& basis = s_places_.basis[i];
      const Vector3 value = s_places_.weight[i] * values[j * s_places_.size() + i];
      for (std::size_t u = 0; u <= std::size_t(s_places_.space.degree); ++u)
        line[basis.first + u] += basis.value[u] * value;
    }
    for (std::size_t v = 0; v <= std::size_t(t_places_.space.degree); ++v) {
      const Number row = Number(t_places_.basis[j].first + v) - 1;
      if (row < 0 || row >= n_) continue;
      const double factor = t_places_.weight[j] * t_places_.basis[j].value[v];
      for (Number i = 0; i < m_; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
          out[axis](i, row) += factor * line[std::size_t(i) + 1][Number(axis)];
    }
  }
  return out;
}

/// Solution of the distance term alone.
InnerFit::Field InnerFit::untied(const Field& right) const {
  Field out;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Eigen::MatrixXd half = s_.solve(right[axis]).transpose();
    out[axis] = t_.solve(half).transpose() / weight_;
  }
  return out;
}

Eigen::VectorXd InnerFit::rows_of(const Field& field) const {
  Eigen::VectorXd out(3 * Number(rows_.size()));
  for (Number r = 0; r < Number(rows_.size()); ++r)
    for (std::size_t axis = 0; axis < 3; ++axis)
      out[3 * r + Number(axis)] = field[axis](rows_[std::size_t(r)][0], rows_[std::size_t(r)][1]);
  return out;
}

/// Forces that hold the rows at given values against the distance term.
Eigen::VectorXd InnerFit::stiff(const Eigen::VectorXd& rows) const {
  Eigen::VectorXd out(rows.size());
  using Axes = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  Eigen::Map<Axes>(out.data(), rows.size() / 3, 3).noalias() =
      stiffness_ * Eigen::Map<const Axes>(rows.data(), rows.size() / 3, 3);
  return out;
}

/// Complete solution whose rows have given values instead of those without ties.
InnerFit::Field InnerFit::completed(const Field& untied_field, const Eigen::VectorXd& rows) const {
  const Eigen::VectorXd force = stiff(rows - rows_of(untied_field));
  Field pulled;
  pulled.fill(Eigen::MatrixXd::Zero(m_, n_));
  for (std::size_t r = 0; r < rows_.size(); ++r)
    for (std::size_t axis = 0; axis < 3; ++axis)
      pulled[axis](rows_[r][0], rows_[r][1]) = force[Number(3 * r + axis)];
  Field out = untied(pulled);
  for (std::size_t axis = 0; axis < 3; ++axis) out[axis] += untied_field[axis];
  return out;
}

void InnerFit::aim(std::span<const Vector3> targets, std::span<const Vector3> areas, double volume) {
  if (empty()) return;
  right_ = gathered(targets);
  for (Eigen::MatrixXd& axis : right_) axis *= weight_;
  free_ = untied(right_);
  free_pull_ = stiff(rows_of(free_));
  areas_ = gathered(areas);
  volume_ = volume;
}

void InnerFit::tie(std::span<const FaceTie> ties, const SplineSurface& boundary) {
  ties_.clear();
  if (empty()) return;
  const Number count = Number(rows_.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * count, 3 * count);
  for (Number a = 0; a < count; ++a)
    for (Number b = 0; b <= a; ++b)
      for (Number axis = 0; axis < 3; ++axis) matrix(3 * a + axis, 3 * b + axis) = stiffness_(a, b);
  tie_pull_ = Eigen::VectorXd::Zero(3 * count);
  for (const FaceTie& tie : ties) {
    const Vector3& normal = tie.tie.normal;
    const Matrix3 counts = tie.weight * (tie.rest_share * Matrix3::Identity() +
                                         (1 - tie.rest_share) * normal * normal.transpose());
    Tie local{{}, tie.weight * normal, tie.wanted};
    Vector3 miss = tie.rest;
    for (const PointShare& at : tie.tie.shares) {
      const Number i = Number(at.i) - 1, j = Number(at.j) - 1;
      if (i < 0 || i >= m_ || j < 0 || j >= n_) {
        miss -= at.factor * boundary.points[boundary.index(at.i, at.j)];
        continue;
      }
      const Number number = number_[std::size_t(i + j * m_)];
      HARIKO_ASSERT(number >= 0, "a tie sees a row that is not solved for");
      local.shares.emplace_back(number, at.factor);
    }
    const Vector3 pull = counts * miss;
    for (const auto& [a, factor] : local.shares) {
      tie_pull_.segment<3>(3 * a) += factor * pull;
      for (const auto& [b, other] : local.shares)
        if (b <= a) matrix.block<3, 3>(3 * a, 3 * b) += (factor * other) * counts;
    }
    ties_.push_back(std::move(local));
  }
  tied_.compute(matrix);
  find_volume_move();
}

void InnerFit::find_volume_move() {
  const Field alone = untied(areas_);
  volume_rows_ = tied_.solve(stiff(rows_of(alone)));
  volume_move_ = completed(alone, volume_rows_);
  volume_change_ = product(areas_, volume_move_);
  volume_untied_ = product(right_, volume_move_);
}

void InnerFit::want(std::span<const double> values) {
  for (std::size_t k = 0; k < ties_.size(); ++k) ties_[k].wanted = values[k];
}

/// Rows without the volume condition, and the multiple of the volume move that is missing.
Eigen::VectorXd InnerFit::tied_rows(double& missing) const {
  Eigen::VectorXd pull = tie_pull_;
  for (const Tie& tie : ties_)
    for (const auto& [a, factor] : tie.shares) pull.segment<3>(3 * a) += (factor * tie.wanted) * tie.pull;
  const double volume = volume_untied_ + volume_rows_.dot(pull);
  missing = volume_change_ > 0 ? (volume_ - volume) / volume_change_ : 0;
  pull += free_pull_;
  return tied_.solve(pull);
}

void InnerFit::solve_rows(SplineSurface& surface) const {
  if (empty()) return;
  double missing = 0;
  Eigen::VectorXd rows = tied_rows(missing);
  rows += missing * volume_rows_;
  for (std::size_t r = 0; r < rows_.size(); ++r)
    surface.points[surface.index(std::size_t(rows_[r][0]) + 1, std::size_t(rows_[r][1]) + 1)] =
        rows.segment<3>(Number(3 * r));
}

void InnerFit::solve(SplineSurface& surface) const {
  if (empty()) return;
  double missing = 0;
  const Eigen::VectorXd rows = tied_rows(missing);
  const Field field = completed(free_, rows);
  for (Number j = 0; j < n_; ++j)
    for (Number i = 0; i < m_; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        surface.points[surface.index(std::size_t(i) + 1, std::size_t(j) + 1)][Number(axis)] =
            field[axis](i, j) + missing * volume_move_[axis](i, j);
}

}  // namespace hariko
