#include "core/envelope/ball/spline_field.hpp"

#include "core/base/parallel.hpp"

namespace hariko {

namespace {

/// Values and derivatives of the four cubic B-splines over a cell, at fraction x of it.
struct Weights {
  double value[4], first[4], second[4];
  explicit Weights(double x) {
    const double y = 1 - x, xx = x * x, yy = y * y;
    value[0] = y * yy * (1.0 / 6), value[3] = x * xx * (1.0 / 6);
    value[1] = 2.0 / 3 + xx * (0.5 * x - 1), value[2] = 2.0 / 3 + yy * (0.5 * y - 1);
    first[0] = -0.5 * yy, first[3] = 0.5 * xx;
    first[1] = 1.5 * xx - 2 * x, first[2] = 2 * y - 1.5 * yy;
    second[0] = y, second[3] = x, second[1] = -2 + 3 * x, second[2] = -2 + 3 * y;
  }
};

/// Four numbers along x.
using Row = Eigen::Array4d;

double along_x(const double* weights, const Row& row) {
  return (Eigen::Map<const Row>(weights) * row).sum();
}

/// Sum over the rows of one plane, weighted along y.
Row weighted(const double* weights, const std::array<Row, 4>& rows) {
  return (weights[0] * rows[0] + weights[1] * rows[1]) + (weights[2] * rows[2] + weights[3] * rows[3]);
}

// Sums over planes are kept as rows along x, which takes fewer operations than sums over coefficients. Names
// tell the derivatives along y and z.

struct ValueSum {
  Row plain = Row::Zero();
  void add(const std::array<Row, 4>& rows, const Weights& y, const Weights& z, int k) {
    plain += z.value[k] * weighted(y.value, rows);
  }
};

struct GradientSum {
  Row plain = Row::Zero(), dy = Row::Zero(), dz = Row::Zero();
  void add(const std::array<Row, 4>& rows, const Weights& y, const Weights& z, int k) {
    const Row value = weighted(y.value, rows);
    plain += z.value[k] * value;
    dz += z.first[k] * value;
    dy += z.value[k] * weighted(y.first, rows);
  }
};

struct HessianSum {
  Row plain = Row::Zero(), dy = Row::Zero(), dz = Row::Zero(), dyy = Row::Zero(), dyz = Row::Zero(),
      dzz = Row::Zero();
  void add(const std::array<Row, 4>& rows, const Weights& y, const Weights& z, int k) {
    const Row value = weighted(y.value, rows), first = weighted(y.first, rows);
    plain += z.value[k] * value;
    dz += z.first[k] * value;
    dzz += z.second[k] * value;
    dy += z.value[k] * first;
    dyz += z.first[k] * first;
    dyy += z.value[k] * weighted(y.second, rows);
  }
};

}  // namespace

template <class Sum>
Sum SplineField::sum(const Vector3& point, std::array<double, 3>& share) const {
  const Vector3 at = (point - corner_) / spacing_;
  std::array<int, 3> low;
  for (std::size_t a = 0; a < 3; ++a) {
    const double x = std::clamp(at[Eigen::Index(a)], 1.0, double(size_[a] - 2));
    low[a] = std::min(int(x), size_[a] - 3);
    share[a] = x - low[a];
  }
  const Weights y(share[1]), z(share[2]);
  const double* first = weights_.data() + node_index(size_, low[0] - 1, low[1] - 1, low[2] - 1);
  const auto line = std::size_t(size_[0]), plane = line * std::size_t(size_[1]);
  Sum out;
  for (int k = 0; k < 4; ++k, first += plane)
    out.add({Eigen::Map<const Row>(first), Eigen::Map<const Row>(first + line),
             Eigen::Map<const Row>(first + 2 * line), Eigen::Map<const Row>(first + 3 * line)},
            y, z, k);
  return out;
}

double SplineField::value(const Vector3& point) const {
  std::array<double, 3> share;
  const auto s = sum<ValueSum>(point, share);
  return along_x(Weights(share[0]).value, s.plain);
}

/// Value and gradient of a sum at a place along x.
template <class Sum>
static FieldPoint point_of(const Sum& s, const Weights& x, double spacing) {
  return {along_x(x.value, s.plain),
          Vector3(along_x(x.first, s.plain), along_x(x.value, s.dy), along_x(x.value, s.dz)) / spacing};
}

FieldPoint SplineField::at(const Vector3& point) const {
  std::array<double, 3> share;
  const auto s = sum<GradientSum>(point, share);
  return point_of(s, Weights(share[0]), spacing_);
}

BentFieldPoint SplineField::bent_at(const Vector3& point) const {
  std::array<double, 3> share;
  const auto s = sum<HessianSum>(point, share);
  const Weights x(share[0]);
  BentFieldPoint out{point_of(s, x, spacing_)};
  const double xx = along_x(x.second, s.plain), yy = along_x(x.value, s.dyy), zz = along_x(x.value, s.dzz);
  const double xy = along_x(x.first, s.dy), yz = along_x(x.value, s.dyz), zx = along_x(x.first, s.dz);
  out.hessian << xx, xy, zx, xy, yy, yz, zx, yz, zz;
  out.hessian /= spacing_ * spacing_;
  return out;
}

void SplineField::lower(const Vector3& at, double by, double radius) {
  for_nodes_about(at, radius, [&](std::size_t node, const Vector3& p) {
    const double square = (p - at).squaredNorm() / (radius * radius);
    if (square < 1) weights_[node] -= by * (1 - square) * (1 - square) * (1 - square);
  });
}

void smooth_lattice(const std::array<int, 3>& size, std::vector<double>& values) {
  const std::array<std::size_t, 3> stride{1, std::size_t(size[0]),
                                          std::size_t(size[0]) * std::size_t(size[1])};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t s = stride[axis], n = std::size_t(size[axis]);
    const std::size_t lines = values.size() / n;
    parallel_for(lines, 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t line = begin; line < end; ++line) {
        double* v = values.data() + line / s * s * n + line % s;
        double before = v[0];
        for (std::size_t i = 0; i < n; ++i) {
          const double here = v[i * s], after = v[std::min(i + 1, n - 1) * s];
          v[i * s] = 0.5 * here + 0.25 * (before + after);
          before = here;
        }
      }
    });
  }
}

void even_lattice(const std::array<int, 3>& size, std::size_t axis, std::vector<double>& values) {
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        std::array<int, 3> n{i, j, k};
        n[axis] = size[axis] - 1 - n[axis];
        double &a = values[node_index(size, i, j, k)], &b = values[node_index(size, n[0], n[1], n[2])];
        a = b = std::max(a, b);
      }
}

LevelCurvature level_curvature(const SplineField& field, const Vector3& point) {
  const BentFieldPoint at = field.bent_at(point);
  const double slope = at.gradient.norm();
  if (!(slope > 0)) return {};
  return {at.gradient / slope, at.hessian / -slope, slope};
}

Vector3 projected(const SplineField& field, Vector3 point, int steps, double longest) {
  for (int k = 0; k < steps; ++k) {
    const FieldPoint at = field.at(point);
    const double square = at.gradient.squaredNorm();
    if (!(square > 1e-12)) break;
    Vector3 step = -at.value / square * at.gradient;
    if (const double length = step.norm(); length > longest) step *= longest / length;
    point += step;
  }
  return point;
}

}  // namespace hariko
