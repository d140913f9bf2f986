#pragma once

// Energy of a face in mode G2 as dense matrices over its controls, and the same with the centre's polynomial
// eliminated (g2.md section 5).

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/g2/dense_kernel.hpp"
#include "core/g2/face_chart.hpp"

namespace hariko {

/// Weights of the energy (g2.md section 5).
struct G2Weights {
  double curve = 1e4;         ///< of the distance between an edge's curve and the network's
  double curve_tension = 50;  ///< more of it per unit of membrane weight
  double sharp_curve = 1e6;   ///< more of it on borders and creases
  double tension = 2;         ///< membrane energy per unit of excess tension
};

/// A point of the face's quadrature: 8 x 8 Gauss points in each triangle, collapsed at the centre.
struct ChartPoint {
  Vector2 barycentric;  ///< (v, w) in the triangle of the side
  Vector2 point;        ///< in the chart
  double weight = 0;
};
std::vector<ChartPoint> chart_quadrature(const FaceChart& chart, int side);

/// Places of a chart's controls in local vectors: first what is unknown (three of each corner, five of each
/// side, then the second tangents of straight corners), then what the network and joins give, then the
/// centre's.
struct ControlPlaces {
  std::vector<int> unknown, given, centre;
  explicit ControlPlaces(const FaceChart& chart);
};

/// The quadrature of a chart with the functions at its points.
struct ChartSamples {
  const FaceChart* chart;
  struct Side {
    std::vector<ChartPoint> points;
    std::vector<Jet2> basis;  ///< of each point: one function an active control
    std::span<const Jet2> at(std::size_t point) const {
      const std::size_t width = basis.size() / points.size();
      return std::span(basis).subspan(point * width, width);
    }
  };
  std::vector<Side> sides;

  explicit ChartSamples(const FaceChart& of);
};

/// Derivatives of the functions of a triangle at a point (its number in the quadrature of the side) become
/// the rows whose squares the energy sums; the default takes (xx, sqrt(2) xy, yy).
using BendingRows = std::function<void(int side, std::size_t point, std::span<const Jet2> basis,
                                       Eigen::Ref<Eigen::Matrix<double, 3, Eigen::Dynamic>> rows)>;
Eigen::MatrixXd bending_matrix(const ChartSamples& samples, const BendingRows& rows);
Eigen::MatrixXd plate_matrix(const ChartSamples& samples);
Eigen::MatrixXd membrane_matrix(const ChartSamples& samples);
/// Of the squared distance between a side's curve and the cubic with the same ends and end tangents, over
/// `FaceChart::curve_controls`.
using CurveMatrix = Eigen::Matrix<double, FaceChart::curve_control_count, FaceChart::curve_control_count>;
CurveMatrix curve_matrix(const FaceChart& chart, int side);

/// A face's part of the system after its centre is eliminated.
struct CondensedFace {
  PaddedMatrix matrix;  ///< unknowns by unknowns
  PaddedMatrix load;    ///< unknowns by given controls
  PaddedMatrix centre;  ///< centre's coefficients by (unknowns, then given)
};
CondensedFace condense(const ControlPlaces& places, const Eigen::MatrixXd& energy);

/// A chart with what all its faces share.
struct ChartEnergy {
  FaceChart chart;
  ControlPlaces places;
  Eigen::MatrixXd plate, membrane;
  std::vector<CurveMatrix> curve;  ///< per side

  ChartEnergy(std::vector<double> angles, const std::vector<int>& joined);
};

/// Charts and elements by what they depend on; equal faces share them. Not thread-safe.
class G2Elements {
 public:
  std::shared_ptr<const ChartEnergy> chart(const std::vector<double>& angles, const std::vector<int>& joined);
  /// `tau`: membrane weight; `curve_weight`: one a side.
  std::shared_ptr<const CondensedFace> element(const std::shared_ptr<const ChartEnergy>& chart, double tau,
                                               std::span<const double> curve_weight);
  std::size_t chart_count() const { return charts_.size(); }
  std::size_t element_count() const { return elements_.size(); }

 private:
  std::map<std::pair<std::vector<double>, std::vector<int>>, std::shared_ptr<const ChartEnergy>> charts_;
  std::map<std::pair<const ChartEnergy*, std::vector<double>>, std::shared_ptr<const CondensedFace>>
      elements_;
};

/// plate + tau * membrane + the sides' curves.
Eigen::MatrixXd face_energy(const ChartEnergy& chart, const Eigen::MatrixXd& plate, double tau,
                            std::span<const double> curve_weight);

}  // namespace hariko
