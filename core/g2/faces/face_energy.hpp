#pragma once

// Energy of a face in mode G2 as dense matrices over its controls, and with the centre's polynomial
// eliminated (g2.md section 5).

#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/g2/faces/dense_kernel.hpp"
#include "core/g2/faces/face_chart.hpp"
#include "core/g2/faces/opened_chart.hpp"

namespace hariko {

/// Weights of the energy (g2.md section 5).
struct G2Weights {
  double third = 0.015;  ///< weight of third derivatives
  double tension = 2;    ///< membrane energy per unit of excess tension
  double curve = 100;    ///< weight of the distance between an edge's curve and the cubic of its tangents
  double curve_tension = 50;     ///< added to it per unit of membrane weight
  double sharp_curve = 1e6;      ///< added to it on borders and creases
  double tangent = 1;            ///< weight of the distance between tangents and the network's
  double tangent_tension = 100;  ///< added to it per unit of tension
  double sharp_tangent = 1e4;    ///< added to it on borders and creases
};

/// Point of a face's quadrature: 8 x 8 Gauss points in each triangle, collapsed at the centre; as many on
/// both sides of the places where the triangle's own ribbon, or one beside it, ends early.
struct ChartPoint {
  Vector2 barycentric;  ///< (v, w) in the triangle of the side
  Vector2 point;        ///< position in the chart
  Vector2 opened;       ///< position in the opened chart
  double weight = 0;
};
/// Quadrature of the triangle at a side.
std::vector<ChartPoint> chart_quadrature(const FaceChart& chart, int side);

/// Order of a chart's controls in local vectors: first the unknown ones (three second derivatives of each
/// corner, five of each side, two first derivatives of each corner), then the given ones, then the centre's.
struct ControlPlaces {
  std::vector<int> unknown, given, centre;
  explicit ControlPlaces(const FaceChart& chart);
};

/// Quadrature of a chart with the basis functions at its points. For faces with many sides the functions are
/// recomputed at each use, since they are large.
class ChartSamples {
 public:
  struct Basis {
    std::vector<Jet3> value;  ///< per point: one function per active control
    std::size_t width = 0;
    std::span<const Jet3> at(std::size_t point) const {
      return std::span(value).subspan(point * width, width);
    }
  };

  explicit ChartSamples(const FaceChart& of);

  const FaceChart& chart() const { return *chart_; }
  int sides() const { return chart_->sides(); }
  const std::vector<ChartPoint>& points(int side) const { return points_[static_cast<std::size_t>(side)]; }
  /// Changes to the opened chart's coordinates at these points; empty where the chart is not opened.
  const std::vector<CoordinateChange>& changes(int side) const {
    return changes_[static_cast<std::size_t>(side)];
  }
  /// Calls body(basis) with the functions of a side's triangle.
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
  std::vector<std::vector<CoordinateChange>> changes_;
  std::vector<Basis> basis_;
};

/// Metric in which a chart is measured: derivatives are taken by the coordinates of an affine image of the
/// chart with the same area. Identity: the regular polygon.
struct ChartMeasure {
  Eigen::Matrix2d inverse = Eigen::Matrix2d::Identity();
  double weight = 1;
  /// Width of the affine image over its length: 1 for the regular polygon. Third derivatives are measured by
  /// the image's mean extent, so across a thin face they would outweigh the second ones by the reciprocal.
  double thinness() const;
};

/// Rows of an energy at a point (its number in the quadrature of the side), from the derivatives of the
/// triangle's functions; the energy sums their squares.
using BendingRows = std::function<void(int side, std::size_t point, std::span<const Jet3> basis,
                                       Eigen::Ref<Eigen::Matrix<double, 3, Eigen::Dynamic>> rows)>;
/// Energy matrix of these rows over a face.
Eigen::MatrixXd bending_matrix(const ChartSamples& samples, const BendingRows& rows);

/// Plate energy: second derivatives squared plus `third` times third derivatives squared, the latter times
/// the face's thinness as well.
Eigen::MatrixXd plate_matrix(const ChartSamples& samples, double third, const ChartMeasure& measure);
/// Membrane energy: first derivatives squared.
Eigen::MatrixXd membrane_matrix(const ChartSamples& samples, const ChartMeasure& measure);
/// Change of (xx, sqrt(2) xy, yy) from the chart's coordinates to the measure's.
Eigen::Matrix3d second_order_change(const ChartMeasure& measure);
/// Change of (xxx, sqrt(3) xxy, sqrt(3) xyy, yyy) from the chart's coordinates to the measure's.
Eigen::Matrix4d third_order_change(const ChartMeasure& measure);

/// Weights of a face's energy, in its chart's order of sides.
struct FaceWeights {
  double tau = 0;    ///< weight of the membrane energy
  double plate = 1;  ///< share of the energy over the chart
  std::vector<double> curve;
  /// At the corners: weights of the edges that open and close them.
  std::vector<double> tangent_out, tangent_in;
  ChartMeasure measure;

  friend bool operator<(const FaceWeights& a, const FaceWeights& b);
};

/// Adds the terms of the sides' curves (squared distance between a curve and the cubic with the same ends and
/// end tangents) and of the tangents at corners.
void add_network_terms(const FaceChart& chart, const FaceWeights& weights, Eigen::MatrixXd& energy);

/// Part of a face in the system after its centre is eliminated.
struct CondensedFace {
  PaddedMatrix matrix;   ///< unknowns by unknowns
  PaddedMatrix load;     ///< unknowns by given controls
  PaddedMatrix centre;   ///< centre's coefficients by (unknowns, then given)
  PaddedMatrix inverse;  ///< inverse of the centre's own matrix
};
/// Eliminates the centre's coefficients from a face's energy.
CondensedFace condense(const ControlPlaces& places, const Eigen::MatrixXd& energy);

/// Chart with the order of its controls.
struct PlacedChart {
  FaceChart chart;
  ControlPlaces places;
  PlacedChart(const std::vector<CornerShape>& corners, const std::vector<Vector2>& polygon,
              const std::vector<int>& joined)
      : chart(corners, polygon, joined), places(chart) {}
};

}  // namespace hariko
