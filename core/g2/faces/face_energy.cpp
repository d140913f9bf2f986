#include "core/g2/faces/face_energy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/base/assert.hpp"
#include "core/base/gauss_legendre.hpp"
#include "core/base/solvers/dense_solver.hpp"

namespace hariko {

namespace {

constexpr int triangle_points = 8;  ///< in each direction
constexpr int curve_points = 6;
constexpr int most_held_sides = 12;

/// Integral of rows^T rows over a face; rows(side, point, basis, out) computes the rows of one point.
template <int RowCount, class Rows>
Eigen::MatrixXd integrate(const ChartSamples& samples, const Rows& rows) {
  const FaceChart& chart = samples.chart();
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(chart.control_count(), chart.control_count());
  Eigen::MatrixXd all, square;
  for (int side = 0; side < chart.sides(); ++side) {
    const std::span<const int> active = chart.active_controls(side);
    const std::vector<ChartPoint>& points = samples.points(side);
    const auto width = static_cast<Eigen::Index>(active.size());
    all.resize(RowCount * Eigen::Index(points.size()), width);
    Eigen::Matrix<double, RowCount, Eigen::Dynamic> own(RowCount, width);
    samples.with_basis(side, [&](const auto& basis) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        rows(side, i, basis.at(i), own);
        all.middleRows(RowCount * Eigen::Index(i), RowCount) = std::sqrt(points[i].weight) * own;
      }
    });
    square = lower_gram_matrix(all);
    for (Eigen::Index a = 0; a < width; ++a)
      for (Eigen::Index b = 0; b <= a; ++b)
        out(active[std::size_t(a)], active[std::size_t(b)]) += square(a, b);
  }
  // Active controls ascend, so all entries went below the diagonal.
  return out.selfadjointView<Eigen::Lower>();
}

Eigen::MatrixXd part(const Eigen::MatrixXd& from, const std::vector<int>& rows,
                     const std::vector<int>& columns) {
  Eigen::MatrixXd out(Eigen::Index(rows.size()), Eigen::Index(columns.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < columns.size(); ++k)
      out(Eigen::Index(i), Eigen::Index(k)) = from(rows[i], columns[k]);
  return out;
}

/// Gauss rule on [0, 1], split at the given places.
std::vector<GaussPoint> split_rule(std::vector<double> places) {
  places.insert(places.begin(), 0.0);
  places.push_back(1.0);
  std::vector<GaussPoint> out;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double width = places[i + 1] - places[i];
    for (const GaussPoint& g : gauss_legendre_unit(triangle_points))
      out.push_back({places[i] + width * g.node, width * g.weight});
  }
  return out;
}

/// Rule between the centre and a side, split where the side's ribbon ends.
std::vector<GaussPoint> radial_points(const FaceChart& chart, int side) {
  if (chart.reach(side) >= 1) return split_rule({});
  return split_rule({1 - chart.reach(side)});
}

/// Rule along a side, split where the ribbons of the sides beside it end early.
std::vector<GaussPoint> lateral_points(const FaceChart& chart, int side) {
  const int n = chart.sides();
  std::vector<double> places;
  if (chart.ends_early((side + n - 1) % n)) places.push_back(std::min(chart.end_along(side, 0), 0.5));
  if (chart.ends_early((side + 1) % n)) {
    const double place = std::max(1 - chart.end_along(side, 1), 0.5);
    if (places.empty() || place > places[0]) places.push_back(place);
  }
  return split_rule(places);
}

std::vector<double> numbers_of(const FaceWeights& w) {
  std::vector<double> out{w.tau,
                          w.plate,
                          w.measure.weight,
                          w.measure.inverse(0, 0),
                          w.measure.inverse(0, 1),
                          w.measure.inverse(1, 0),
                          w.measure.inverse(1, 1)};
  for (const auto* each : {&w.curve, &w.tangent_out, &w.tangent_in})
    out.insert(out.end(), each->begin(), each->end());
  return out;
}

/// Matrix of the squared distance between a side's curve and the cubic with the same ends and end tangents.
using CurveMatrix = Eigen::Matrix<double, FaceChart::curve_control_count, FaceChart::curve_control_count>;
CurveMatrix curve_matrix(const FaceChart& chart, int side) {
  CurveMatrix out = CurveMatrix::Zero();
  for (const auto& [t, weight] : gauss_legendre_unit(curve_points)) {
    FaceChart::Curve curve = FaceChart::curve(t);
    const double a = 1 - t;
    curve.value[0] -= a * a * (1 + 2 * t);
    curve.value[1] -= t * a * a;
    curve.value[3] -= t * t * (1 + 2 * a);
    curve.value[4] -= a * t * t;  // the cubic's tangent at b, seen from b
    const auto spread = chart.spread_curve(side, curve.value);
    const Eigen::Map<const Eigen::Matrix<double, FaceChart::curve_control_count, 1>> row(spread.data());
    out += weight * row * row.transpose();
  }
  return out;
}

}  // namespace

std::vector<ChartPoint> chart_quadrature(const FaceChart& chart, int side) {
  const Vector2 &a = chart.vertex(side), &b = chart.vertex((side + 1) % chart.sides());
  const double determinant = std::abs(a.x() * b.y() - a.y() * b.x());
  const std::vector<GaussPoint> lateral = lateral_points(chart, side);
  std::vector<ChartPoint> out;
  for (const auto& gs : radial_points(chart, side))
    for (const auto& gt : lateral) {
      const double v = gs.node * (1 - gt.node), w = gs.node * gt.node;
      const Vector2 point = v * a + w * b;
      out.push_back({{v, w}, point, point, gs.weight * gt.weight * gs.node * determinant});
    }
  return out;
}

ControlPlaces::ControlPlaces(const FaceChart& chart) {
  const int n = chart.sides();
  for (int j = 0; j < n; ++j)
    for (const CornerControl which : {corner_g11, corner_g12, corner_g22})
      unknown.push_back(chart.corner_control(j, which));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < side_control_count; ++i) unknown.push_back(chart.side_control(j, SideControl(i)));
  for (int j = 0; j < n; ++j)
    for (const CornerControl which : {corner_g1, corner_g2})
      unknown.push_back(chart.corner_control(j, which));
  for (int j = 0; j < n; ++j) given.push_back(chart.corner_control(j, corner_p));
  for (int i = chart.first_departure_control(); i < chart.control_count(); ++i) given.push_back(i);
  for (int i = chart.first_centre_control(); i < chart.first_departure_control(); ++i) centre.push_back(i);
}

ChartSamples::ChartSamples(const FaceChart& of) : chart_(&of) {
  for (int side = 0; side < of.sides(); ++side) {
    points_.push_back(chart_quadrature(of, side));
    changes_.emplace_back();
    for (ChartPoint& at : points_.back()) {
      if (!of.opens()) break;
      const auto [x, y] = of.opened(at.point);
      at.opened = {x.v, y.v};
      changes_.back().emplace_back(x, y);
      at.weight *= changes_.back().back().area;
    }
  }
  if (of.sides() > most_held_sides) return;
  for (int side = 0; side < of.sides(); ++side) basis_.push_back(make(side));
}

ChartSamples::Basis ChartSamples::make(int side) const {
  Basis out;
  out.width = chart_->active_controls(side).size();
  out.value.resize(out.width * points(side).size());
  FaceChart::Room<Jet3> room;
  for (std::size_t i = 0; i < points(side).size(); ++i)
    chart_->basis(side, points(side)[i].point, std::span(out.value).subspan(i * out.width, out.width), room);
  for (std::size_t i = 0; i < changes(side).size(); ++i)
    for (Jet3& f : std::span(out.value).subspan(i * out.width, out.width)) f = changes(side)[i](f);
  return out;
}

double ChartMeasure::thinness() const {
  // The smaller of the squared singular values, whose product is 1.
  const double sum = inverse.squaredNorm();
  return 2 / (sum + std::sqrt(std::max(sum * sum - 4, 0.0)));
}

Eigen::MatrixXd bending_matrix(const ChartSamples& samples, const BendingRows& rows) {
  return integrate<3>(samples, rows);
}

Eigen::Matrix3d second_order_change(const ChartMeasure& measure) {
  const Eigen::Matrix2d& b = measure.inverse;
  const double root = std::numbers::sqrt2;
  const double p = b(0, 0), q = b(1, 0), r = b(0, 1), s = b(1, 1);  // d/du = p d/dx + q d/dy, d/dv = r, s
  Eigen::Matrix3d out;
  out << p * p, root * p * q, q * q, root * p * r, p * s + q * r, root * q * s, r * r, root * r * s, s * s;
  return out;
}

Eigen::Matrix4d third_order_change(const ChartMeasure& measure) {
  const Eigen::Matrix2d& b = measure.inverse;
  const double root = std::numbers::sqrt3;
  const double p = b(0, 0), q = b(1, 0), r = b(0, 1), s = b(1, 1);
  Eigen::Matrix4d out;
  out.row(0) << p * p * p, root * p * p * q, root * p * q * q, q * q * q;
  out.row(1) << root * p * p * r, p * p * s + 2 * p * q * r, q * q * r + 2 * p * q * s, root * q * q * s;
  out.row(2) << root * p * r * r, r * r * q + 2 * r * s * p, s * s * p + 2 * r * s * q, root * q * s * s;
  out.row(3) << r * r * r, root * r * r * s, root * r * s * s, s * s * s;
  return out;
}

Eigen::MatrixXd plate_matrix(const ChartSamples& samples, double third, const ChartMeasure& measure) {
  const Eigen::Matrix3d second = second_order_change(measure);
  const Eigen::Matrix4d change = std::sqrt(third * measure.thinness()) * third_order_change(measure);
  const Eigen::MatrixXd out = integrate<7>(samples, [&](int, std::size_t, std::span<const Jet3> basis,
                                                        auto& rows) {
    for (std::size_t k = 0; k < basis.size(); ++k) {
      const Jet3& f = basis[k];
      auto column = rows.col(Eigen::Index(k));
      column.template head<3>().noalias() = second * Eigen::Vector3d(f.xx, std::numbers::sqrt2 * f.xy, f.yy);
      column.template tail<4>().noalias() =
          change * Eigen::Vector4d(f.xxx, std::numbers::sqrt3 * f.xxy, std::numbers::sqrt3 * f.xyy, f.yyy);
    }
  });
  return measure.weight * out;
}

Eigen::MatrixXd membrane_matrix(const ChartSamples& samples, const ChartMeasure& measure) {
  const Eigen::Matrix2d change = measure.inverse.transpose();
  const Eigen::MatrixXd out =
      integrate<2>(samples, [&](int, std::size_t, std::span<const Jet3> basis, auto& rows) {
        for (std::size_t k = 0; k < basis.size(); ++k)
          rows.col(Eigen::Index(k)).noalias() = change * Eigen::Vector2d(basis[k].x, basis[k].y);
      });
  return measure.weight * out;
}

bool operator<(const FaceWeights& a, const FaceWeights& b) {
  return numbers_of(a) < numbers_of(b);
}

void add_network_terms(const FaceChart& chart, const FaceWeights& weights, Eigen::MatrixXd& energy) {
  for (int j = 0; j < chart.sides(); ++j) {
    const auto at = static_cast<std::size_t>(j);
    const auto controls = chart.curve_controls(j);
    const CurveMatrix curve = curve_matrix(chart, j);
    for (std::size_t a = 0; a < controls.size(); ++a)
      for (std::size_t b = 0; b < controls.size(); ++b)
        energy(controls[a], controls[b]) += weights.curve[at] * curve(Eigen::Index(a), Eigen::Index(b));
    const int g1 = chart.corner_control(j, corner_g1), g2 = chart.corner_control(j, corner_g2);
    const CornerShape& corner = chart.corner(j);
    const double out = weights.tangent_out[at] * corner.out * corner.out;
    const double in = weights.tangent_in[at] * corner.in * corner.in;
    const double c = chart.cosine(j), s = chart.sine(j);
    energy(g1, g1) += out + in * c * c;
    energy(g1, g2) += in * c * s;
    energy(g2, g1) += in * c * s;
    energy(g2, g2) += in * s * s;
  }
}

CondensedFace condense(const ControlPlaces& places, const Eigen::MatrixXd& energy) {
  const Eigen::MatrixXd cu = part(energy, places.centre, places.unknown);
  const Eigen::MatrixXd cg = part(energy, places.centre, places.given);
  const Eigen::Index size = cu.rows();
  Eigen::MatrixXd right(size, cu.cols() + cg.cols() + size);
  right << cu, cg, -Eigen::MatrixXd::Identity(size, size);
  const auto solved = solve_definite(part(energy, places.centre, places.centre), right);
  HARIKO_ASSERT(solved, "the energy of a face's centre is positive definite");
  const Eigen::MatrixXd centre = -solved->leftCols(cu.cols() + cg.cols());
  const Eigen::MatrixXd inverse = -solved->rightCols(size);
  const Eigen::MatrixXd uu = part(energy, places.unknown, places.unknown) +
                             transposed_product(cu, Eigen::MatrixXd(centre.leftCols(cu.cols())));
  const Eigen::MatrixXd ug = part(energy, places.unknown, places.given) +
                             transposed_product(cu, Eigen::MatrixXd(centre.rightCols(cg.cols())));
  return {PaddedMatrix(0.5 * (uu + uu.transpose())), PaddedMatrix(ug), PaddedMatrix(centre),
          PaddedMatrix(0.5 * (inverse + inverse.transpose()))};
}

}  // namespace hariko
