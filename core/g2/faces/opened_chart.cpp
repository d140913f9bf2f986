#include "core/g2/faces/opened_chart.hpp"

#include <Eigen/LU>

namespace hariko {

namespace {

using Pair = Eigen::Vector2d;
/// Factors of (xx, xy, yy) in the second derivative along p and q.
Eigen::Vector3d second_along(const Pair& p, const Pair& q) {
  return {p[0] * q[0], p[0] * q[1] + p[1] * q[0], p[1] * q[1]};
}
/// Factors of (xxx, xxy, xyy, yyy) in the third derivative along p, q and r.
Eigen::Vector4d third_along(const Pair& p, const Pair& q, const Pair& r) {
  return {p[0] * q[0] * r[0], p[0] * q[0] * r[1] + p[0] * q[1] * r[0] + p[1] * q[0] * r[0],
          p[0] * q[1] * r[1] + p[1] * q[0] * r[1] + p[1] * q[1] * r[0], p[1] * q[1] * r[1]};
}

}  // namespace

CoordinateChange::CoordinateChange(const Jet3& first, const Jet3& second) {
  Eigen::Matrix2d slope;
  slope << first.x, first.y, second.x, second.y;
  Eigen::Matrix<double, 2, 3> bend;
  bend << first.xx, first.xy, first.yy, second.xx, second.xy, second.yy;
  Eigen::Matrix<double, 2, 4> third;
  third << first.xxx, first.xxy, first.xyy, first.yyy, second.xxx, second.xxy, second.xyy, second.yyy;
  area = slope.determinant();
  const Eigen::Matrix2d inverse = slope.inverse();
  // Derivatives of the chart's coordinates by the new ones.
  const Pair by[2] = {inverse.col(0), inverse.col(1)};
  Pair twice[2][2];
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) twice[a][b] = -inverse * (bend * second_along(by[a], by[b]));
  matrix.setZero();
  for (int a = 0; a < 2; ++a) matrix.row(a).head<2>() = by[a];
  constexpr int pairs[3][2] = {{0, 0}, {0, 1}, {1, 1}};
  for (int i = 0; i < 3; ++i) {
    const auto [a, b] = pairs[i];
    matrix.row(2 + i).head<2>() = twice[a][b];
    matrix.row(2 + i).segment<3>(2) = second_along(by[a], by[b]);
  }
  constexpr int triples[4][3] = {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  for (int i = 0; i < 4; ++i) {
    const auto [a, b, c] = triples[i];
    const Eigen::Vector3d mixed = second_along(twice[a][b], by[c]) + second_along(twice[a][c], by[b]) +
                                  second_along(twice[b][c], by[a]);
    const Eigen::Vector4d along = third_along(by[a], by[b], by[c]);
    matrix.row(5 + i).head<2>() = -inverse * (third * along + bend * mixed);
    matrix.row(5 + i).segment<3>(2) = mixed;
    matrix.row(5 + i).tail<4>() = along;
  }
}

Jet3 CoordinateChange::operator()(const Jet3& f) const {
  Eigen::Matrix<double, 9, 1> from, to;
  from << f.x, f.y, f.xx, f.xy, f.yy, f.xxx, f.xxy, f.xyy, f.yyy;
  to.noalias() = matrix * from;
  return {f.v, to[0], to[1], to[2], to[3], to[4], to[5], to[6], to[7], to[8]};
}

}  // namespace hariko
