#include "core/g2/faces/face_measure.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace hariko {

namespace {

/// Exponent of areas in the weights of faces: as in the network and in mode FAIR, between "long edges
/// dominate" and true bending (kuriyama.md section 12.5).
constexpr double area_power = 0.25;
constexpr double least_length = 1e-4;  ///< relative to the mean

}  // namespace

ChartMeasure face_measure(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index face, Index first) {
  ChartMeasure out;
  if (charts.frames == Frames::equal) return out;
  const Index n = mesh.side_count(face), begin = mesh.face_begin(face);
  const double radius = 1 / (2 * std::sin(std::numbers::pi / double(n)));
  Eigen::Matrix2d image = Eigen::Matrix2d::Zero();
  for (Index j = 0; j < n; ++j) {
    const double angle = 2 * std::numbers::pi * double(j) / double(n);
    image += 2 / (double(n) * radius) * charts.corner[begin + (j + first) % n] *
             Eigen::RowVector2d(std::cos(angle), std::sin(angle));
  }
  const double determinant = image.determinant();
  if (!(determinant > 0)) return out;
  out.inverse = std::sqrt(determinant) * image.inverse();
  out.weight = std::pow(determinant / (charts.mean_length * charts.mean_length), area_power);
  return out;
}

double edge_measure(const FaceCharts& charts, Index edge) {
  if (charts.frames == Frames::equal) return 1;
  const double length = std::max(charts.edge_length[edge] / charts.mean_length, least_length);
  return std::pow(length, 2 * area_power);
}

}  // namespace hariko
