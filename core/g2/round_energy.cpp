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

/// From derivatives by the patch's parameters.
class ToChart {
 public:
  ToChart(const FaceChart& chart, int side) {
    Eigen::Matrix2d edges;
    edges << chart.vertex(side), chart.vertex((side + 1) % chart.sides());
    const Eigen::Matrix2d inverse = edges.inverse();
    a_ = inverse(0, 0), b_ = inverse(0, 1), c_ = inverse(1, 0), d_ = inverse(1, 1);
  }
  Reference operator()(const PatchPoint& p) const {
    return {a_ * p.ds + c_ * p.dt, b_ * p.ds + d_ * p.dt,
            a_ * a_ * p.dss + 2 * a_ * c_ * p.dst + c_ * c_ * p.dtt,
            a_ * b_ * p.dss + (a_ * d_ + b_ * c_) * p.dst + c_ * d_ * p.dtt,
            b_ * b_ * p.dss + 2 * b_ * d_ * p.dst + d_ * d_ * p.dtt};
  }

 private:
  double a_, b_, c_, d_;
};

Eigen::Matrix2d metric(const Reference& s) {
  Eigen::Matrix2d g;
  g << s.x.dot(s.x), s.x.dot(s.y), s.x.dot(s.y), s.y.dot(s.y);
  return g;
}

/// Of the chart's coordinates by a triangle's: area of the chart an area of the parameters.
double determinant(const FaceChart& chart, int side) {
  const Vector2 &a = chart.vertex(side), &b = chart.vertex((side + 1) % chart.sides());
  return std::abs(a.x() * b.y() - a.y() * b.x());
}

}  // namespace

std::vector<Vector2> reference_parameters() {
  // Barycentric, so those of any chart.
  static const FaceChart triangle({1, 1, 1});
  std::vector<Vector2> out;
  for (const ChartPoint& at : chart_quadrature(triangle, 0)) out.push_back(at.barycentric);
  return out;
}

Eigen::MatrixXd round_plate(const ChartSamples& samples, const ReferencePoints& reference,
                            const PatchOfSide& patch) {
  const FaceChart& chart = *samples.chart;
  std::vector<std::vector<Reference>> points;  // of each side
  std::vector<PatchPoint> room;
  double mean = 0;
  for (int side = 0; side < chart.sides(); ++side) {
    const std::vector<ChartPoint>& at = samples.sides[std::size_t(side)].points;
    room.resize(at.size());
    reference(patch(side), room);
    const ToChart to_chart(chart, side);
    auto& own = points.emplace_back();
    for (std::size_t i = 0; i < at.size(); ++i) {
      own.push_back(to_chart(room[i]));
      mean += at[i].weight * metric(own.back()).trace() / (2 * chart.area());
    }
  }
  if (!(mean > 0)) return plate_matrix(samples);  // shrunk to a point: any measure will do
  return bending_matrix(samples, [&](int side, std::size_t point, std::span<const Jet2> basis, auto rows) {
    const Reference& s = points[std::size_t(side)][point];
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

double round_scale(const HalfEdgeMesh& mesh, const ReferencePoints& reference,
                   const std::function<const FaceChart&(Index)>& chart,
                   const std::function<Index(Index, int)>& half_edge) {
  const auto surface = parallel_sum(mesh.face_count(), 32, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    std::vector<PatchPoint> room;
    std::vector<double> weight;  // of each point, per unit of the triangle's determinant
    for (auto f = static_cast<Index>(begin); f < end; ++f)
      for (int side = 0; side < chart(f).sides(); ++side) {
        if (weight.empty())
          for (const ChartPoint& at : chart_quadrature(chart(f), side))
            weight.push_back(at.weight / determinant(chart(f), side));
        room.resize(weight.size());
        reference(half_edge(f, side), room);
        for (std::size_t i = 0; i < room.size(); ++i) sum += weight[i] * room[i].ds.cross(room[i].dt).norm();
      }
    return sum;
  });
  double charts = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) charts += chart(f).area();
  return surface > 0 ? surface / charts : 1;
}

}  // namespace hariko
