#include "core/g2/round_energy.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/g2/face_energy.hpp"

namespace hariko {

namespace {

constexpr double least_metric = 1e-6;  ///< of the mean over the face

/// Derivatives of the reference by the chart's x and y.
struct Reference {
  Vector3 x, y, xx, xy, yy;
};

Reference reference_at(const FaceChart& chart, const PatchSet& patches, Index patch, int side,
                       const ChartPoint& at) {
  const PatchPoint p = patches.evaluate(patch, at.barycentric, Order::second);
  Eigen::Matrix2d edges;
  edges << chart.vertex(side), chart.vertex((side + 1) % chart.sides());
  const Eigen::Matrix2d inverse = edges.inverse();
  const double a = inverse(0, 0), b = inverse(0, 1), c = inverse(1, 0), d = inverse(1, 1);
  return {a * p.ds + c * p.dt, b * p.ds + d * p.dt, a * a * p.dss + 2 * a * c * p.dst + c * c * p.dtt,
          a * b * p.dss + (a * d + b * c) * p.dst + c * d * p.dtt,
          b * b * p.dss + 2 * b * d * p.dst + d * d * p.dtt};
}

Eigen::Matrix2d metric(const Reference& s) {
  Eigen::Matrix2d g;
  g << s.x.dot(s.x), s.x.dot(s.y), s.x.dot(s.y), s.y.dot(s.y);
  return g;
}

}  // namespace

Eigen::MatrixXd round_plate(const FaceChart& chart, const PatchSet& reference, const PatchOfSide& patch) {
  double mean = 0;
  for (int side = 0; side < chart.sides(); ++side)
    for (const ChartPoint& at : chart_quadrature(chart, side))
      mean += at.weight * metric(reference_at(chart, reference, patch(side), side, at)).trace() /
              (2 * chart.area());
  if (!(mean > 0)) return plate_matrix(chart);  // shrunk to a point: any measure will do
  return bending_matrix(chart, [&](int side, const ChartPoint& at, std::span<const Jet2> basis, auto rows) {
    const Reference s = reference_at(chart, reference, patch(side), side, at);
    const Eigen::Matrix2d g = metric(s) + least_metric * mean * Eigen::Matrix2d::Identity();
    const Eigen::Matrix2d inverse = g.inverse();
    const auto christoffel = [&](const Vector3& second) -> Eigen::Vector2d {
      return inverse * Eigen::Vector2d(second.dot(s.x), second.dot(s.y));
    };
    const Eigen::Vector2d gxx = christoffel(s.xx), gxy = christoffel(s.xy), gyy = christoffel(s.yy);
    // Orthonormal frame: g = L L^T.
    const double l11 = std::sqrt(g(0, 0)), l21 = g(0, 1) / l11, l22 = std::sqrt(g(1, 1) - l21 * l21);
    const double a = 1 / l11, b = -l21 / (l11 * l22), c = 1 / l22;
    const double root = std::sqrt(l11 * l22);
    for (std::size_t k = 0; k < basis.size(); ++k) {
      const Jet2& f = basis[k];
      const double xx = f.xx - gxx[0] * f.x - gxx[1] * f.y, xy = f.xy - gxy[0] * f.x - gxy[1] * f.y;
      const double yy = f.yy - gyy[0] * f.x - gyy[1] * f.y;
      rows.col(Eigen::Index(k)) << root * (a * a * xx), root * std::numbers::sqrt2 * a * (b * xx + c * xy),
          root * (b * b * xx + 2 * b * c * xy + c * c * yy);
    }
  });
}

double round_scale(const HalfEdgeMesh& mesh, const PatchSet& reference,
                   const std::function<const FaceChart&(Index)>& chart,
                   const std::function<Index(Index, int)>& half_edge) {
  const auto surface = parallel_sum(mesh.face_count(), 32, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (auto f = static_cast<Index>(begin); f < end; ++f)
      for (int side = 0; side < chart(f).sides(); ++side)
        for (const ChartPoint& at : chart_quadrature(chart(f), side)) {
          const Reference s = reference_at(chart(f), reference, half_edge(f, side), side, at);
          sum += at.weight * s.x.cross(s.y).norm();
        }
    return sum;
  });
  double charts = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) charts += chart(f).area();
  return surface > 0 ? surface / charts : 1;
}

}  // namespace hariko
