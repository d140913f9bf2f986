#include "core/g2/faces/face_measure.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

/// Exponent of areas in the weights of faces: as in the network and in mode FAIR, between "long edges
/// dominate" and true bending (kuriyama.md section 12.5).
constexpr double area_power = 0.25;
constexpr double least_length = 1e-4;  ///< relative to the mean

}  // namespace

ChartMeasure face_measure(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index face, Index first,
                          std::span<const Vector2> polygon) {
  ChartMeasure out;
  if (charts.frames == Frames::equal) return out;
  const Index n = mesh.side_count(face), begin = mesh.face_begin(face);
  Eigen::Matrix2d product = Eigen::Matrix2d::Zero(), square = product;
  for (Index j = 0; j < n; ++j) {
    product += charts.corner[begin + (j + first) % n] * polygon[j].transpose();
    square += polygon[j] * polygon[j].transpose();
  }
  const Eigen::Matrix2d image = product * square.inverse();
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
