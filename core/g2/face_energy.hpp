#pragma once

// Energy of a face in mode G2 as dense matrices over its controls, and the same with the centre's polynomial
// eliminated (g2.md section 5).

#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/g2/dense_kernel.hpp"
#include "core/g2/face_chart.hpp"

namespace hariko {

/// Weights of the energy (g2.md section 5).
struct G2Weights {
  double third = 0.015;          ///< of third derivatives
  double tension = 2;            ///< membrane energy per unit of excess tension
  double curve = 100;            ///< of the distance between an edge's curve and the cubic of its tangents
  double curve_tension = 50;     ///< more of it per unit of membrane weight
  double sharp_curve = 1e6;      ///< more of it on borders and creases
  double tangent = 1;            ///< of the distance between tangents and the network's
  double tangent_tension = 100;  ///< more of it per unit of tension
  double sharp_tangent = 1e4;    ///< more of it on borders and creases
};

/// A point of the face's quadrature: 8 x 8 Gauss points in each triangle, collapsed at the centre; as many on
/// both sides of where ribbons end before it, the triangle's own and those beside.
struct ChartPoint {
  Vector2 barycentric;  ///< (v, w) in the triangle of the side
  Vector2 point;        ///< in the chart
  double weight = 0;
};
std::vector<ChartPoint> chart_quadrature(const FaceChart& chart, int side);

/// Places of a chart's controls in local vectors: first what is unknown (three second derivatives of each
/// corner, five of each side, two first derivatives of each corner), then what is given, then the centre's.
struct ControlPlaces {
  std::vector<int> unknown, given, centre;
  explicit ControlPlaces(const FaceChart& chart);
};

/// The quadrature of a chart with the functions at its points. Those of faces with many sides are made anew
/// whenever they are asked for, since they are large.
template <class Jet>
class SamplesOf {
 public:
  struct Basis {
    std::vector<Jet> value;  ///< of each point: one function an active control
    std::size_t width = 0;
    std::span<const Jet> at(std::size_t point) const {
      return std::span(value).subspan(point * width, width);
    }
  };

  explicit SamplesOf(const FaceChart& of);

  const FaceChart& chart() const { return *chart_; }
  int sides() const { return chart_->sides(); }
  const std::vector<ChartPoint>& points(int side) const { return points_[static_cast<std::size_t>(side)]; }
  /// body(basis)
  template <class Body>
  void with_basis(int side, const Body& body) const {
    if (basis_.empty())
      body(make(side));
    else
      body(basis_[static_cast<std::size_t>(side)]);
  }

 private:
  Basis make(int side) const;

  const FaceChart* chart_;
  std::vector<std::vector<ChartPoint>> points_;
  std::vector<Basis> basis_;
};
using ChartSamples = SamplesOf<Jet2>;

/// A shape of the face that its chart is measured with: the chart's derivatives are taken by the coordinates
/// of its image, of the same area. Identity: the regular polygon.
struct ChartMeasure {
  Eigen::Matrix2d inverse = Eigen::Matrix2d::Identity();
  double weight = 1;
};

/// Derivatives of the functions of a triangle at a point (its number in the quadrature of the side) become
/// the rows whose squares the energy sums.
using BendingRows = std::function<void(int side, std::size_t point, std::span<const Jet2> basis,
                                       Eigen::Ref<Eigen::Matrix<double, 3, Eigen::Dynamic>> rows)>;
Eigen::MatrixXd bending_matrix(const ChartSamples& samples, const BendingRows& rows);

/// Second derivatives squared plus `third` times third ones.
Eigen::MatrixXd plate_matrix(const SamplesOf<Jet3>& samples, double third, const ChartMeasure& measure);
Eigen::MatrixXd membrane_matrix(const SamplesOf<Jet3>& samples, const ChartMeasure& measure);
/// (xx, sqrt(2) xy, yy) by the chart's coordinates become those by the measure's.
Eigen::Matrix3d second_order_change(const ChartMeasure& measure);

/// Measures that a face is weighted with, in its chart's order of sides.
struct FaceWeights {
  double tau = 0;    ///< membrane
  double plate = 1;  ///< share of the energy over the chart
  std::vector<double> curve;
  std::vector<double> tangent_out, tangent_in;  ///< at the corners: of the edges that open and close them
  ChartMeasure measure;

  friend bool operator<(const FaceWeights& a, const FaceWeights& b);
};

/// Adds the terms of the sides' curves (squared distance between a curve and the cubic with the same ends and
/// end tangents) and of the tangents at corners.
void add_network_terms(const FaceChart& chart, const FaceWeights& weights, Eigen::MatrixXd& energy);

/// A face's part of the system after its centre is eliminated.
struct CondensedFace {
  PaddedMatrix matrix;   ///< unknowns by unknowns
  PaddedMatrix load;     ///< unknowns by given controls
  PaddedMatrix centre;   ///< centre's coefficients by (unknowns, then given)
  PaddedMatrix inverse;  ///< of the centre's own matrix
};
CondensedFace condense(const ControlPlaces& places, const Eigen::MatrixXd& energy);

/// A chart with the places of its controls.
struct PlacedChart {
  FaceChart chart;
  ControlPlaces places;
  PlacedChart(const std::vector<CornerShape>& corners, const std::vector<int>& joined)
      : chart(corners, joined), places(chart) {}
};

}  // namespace hariko
