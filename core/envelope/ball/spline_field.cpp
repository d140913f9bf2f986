#include "core/envelope/ball/spline_field.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

/// Values and derivatives of the four cubic B-splines over a cell, at fraction x of it.
struct Weights {
  double value[4], first[4], second[4];
  explicit Weights(double x) {
    const double y = 1 - x;
    value[0] = y * y * y / 6, value[3] = x * x * x / 6;
    value[1] = (4 - 6 * x * x + 3 * x * x * x) / 6, value[2] = (4 - 6 * y * y + 3 * y * y * y) / 6;
    first[0] = -y * y / 2, first[3] = x * x / 2;
    first[1] = -2 * x + 1.5 * x * x, first[2] = 2 * y - 1.5 * y * y;
    second[0] = y, second[3] = x, second[1] = -2 + 3 * x, second[2] = -2 + 3 * y;
  }
};

struct ValueSum {
  double out = 0;
  void add(const double* row, const Weights& x, const Weights& y, const Weights& z, int j, int k) {
    double v = 0;
    for (int i = 0; i < 4; ++i) v += x.value[i] * row[i];
    out += y.value[j] * z.value[k] * v;
  }
};

struct GradientSum {
  double value = 0, dx = 0, dy = 0, dz = 0;
  void add(const double* row, const Weights& x, const Weights& y, const Weights& z, int j, int k) {
    double v = 0, d = 0;
    for (int i = 0; i < 4; ++i) v += x.value[i] * row[i], d += x.first[i] * row[i];
    value += y.value[j] * z.value[k] * v;
    dx += y.value[j] * z.value[k] * d;
    dy += y.first[j] * z.value[k] * v;
    dz += y.value[j] * z.first[k] * v;
  }
};

struct HessianSum {
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
  void add(const double* row, const Weights& x, const Weights& y, const Weights& z, int j, int k) {
    double v = 0, d = 0, dd = 0;
    for (int i = 0; i < 4; ++i)
      v += x.value[i] * row[i], d += x.first[i] * row[i], dd += x.second[i] * row[i];
    xx += y.value[j] * z.value[k] * dd;
    yy += y.second[j] * z.value[k] * v;
    zz += y.value[j] * z.second[k] * v;
    xy += y.first[j] * z.value[k] * d;
    yz += y.first[j] * z.first[k] * v;
    zx += y.value[j] * z.first[k] * d;
  }
};

}  // namespace

template <class Sum>
Sum SplineField::sum(const Vector3& point) const {
  const Vector3 at = (point - corner_) / spacing_;
  std::array<int, 3> low;
  std::array<double, 3> share;
  for (std::size_t a = 0; a < 3; ++a) {
    const double x = std::clamp(at[Eigen::Index(a)], 1.0, double(size_[a] - 2));
    low[a] = std::min(int(x), size_[a] - 3);
    share[a] = x - low[a];
  }
  const Weights x(share[0]), y(share[1]), z(share[2]);
  Sum out;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      const std::size_t row = index(low[0] - 1, low[1] + j - 1, low[2] + k - 1);
      out.add(weights_.data() + row, x, y, z, j, k);
    }
  return out;
}

double SplineField::value(const Vector3& point) const {
  return sum<ValueSum>(point).out;
}

FieldPoint SplineField::at(const Vector3& point) const {
  const auto s = sum<GradientSum>(point);
  return {s.value, Vector3(s.dx, s.dy, s.dz) / spacing_};
}

Matrix3 SplineField::hessian(const Vector3& point) const {
  const auto s = sum<HessianSum>(point);
  Matrix3 out;
  out << s.xx, s.xy, s.zx, s.xy, s.yy, s.yz, s.zx, s.yz, s.zz;
  return out / (spacing_ * spacing_);
}

void SplineField::lower(const Vector3& at, double by, double radius) {
  std::array<int, 3> first, last;
  for (std::size_t a = 0; a < 3; ++a) {
    const double middle = (at[Eigen::Index(a)] - corner_[Eigen::Index(a)]) / spacing_;
    first[a] = std::max(int(std::ceil(middle - radius / spacing_)), 0);
    last[a] = std::min(int(std::floor(middle + radius / spacing_)), size_[a] - 1);
  }
  for (int k = first[2]; k <= last[2]; ++k)
    for (int j = first[1]; j <= last[1]; ++j)
      for (int i = first[0]; i <= last[0]; ++i) {
        const double square = (corner_ + spacing_ * Vector3(i, j, k) - at).squaredNorm() / (radius * radius);
        if (square < 1) weights_[index(i, j, k)] -= by * (1 - square) * (1 - square) * (1 - square);
      }
}

LevelCurvature level_curvature(const SplineField& field, const Vector3& point) {
  const Vector3 gradient = field.at(point).gradient;
  const double slope = gradient.norm();
  if (!(slope > 0)) return {};
  return {gradient / slope, field.hessian(point) / -slope, slope};
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
