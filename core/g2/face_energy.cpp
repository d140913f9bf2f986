#include "core/g2/face_energy.hpp"

#include <cmath>
#include <numbers>

#include "core/base/assert.hpp"
#include "core/base/dense_solver.hpp"
#include "core/base/gauss.hpp"

namespace hariko {

namespace {

constexpr int triangle_points = 8;  ///< in each direction
constexpr int curve_points = 6;

/// Adds up rows^T rows over all quadrature points of a face; rows(side, point, basis, out) fills one point's.
template <int RowCount, class Rows>
Eigen::MatrixXd integrate(const ChartSamples& samples, const Rows& rows) {
  const FaceChart& chart = *samples.chart;
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(chart.control_count(), chart.control_count());
  Eigen::MatrixXd all, square;
  for (int side = 0; side < chart.sides(); ++side) {
    const std::span<const int> active = chart.active_controls(side);
    const ChartSamples::Side& of = samples.sides[std::size_t(side)];
    const auto width = static_cast<Eigen::Index>(active.size());
    all.resize(RowCount * Eigen::Index(of.points.size()), width);
    Eigen::Matrix<double, RowCount, Eigen::Dynamic> own(RowCount, width);
    for (std::size_t i = 0; i < of.points.size(); ++i) {
      rows(side, i, of.at(i), own);
      all.middleRows(RowCount * Eigen::Index(i), RowCount) = std::sqrt(of.points[i].weight) * own;
    }
    square = lower_gram_matrix(all);
    for (Eigen::Index a = 0; a < width; ++a)
      for (Eigen::Index b = 0; b <= a; ++b)
        out(active[std::size_t(a)], active[std::size_t(b)]) += square(a, b);
  }
  // Active controls ascend, so all went below the diagonal.
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

}  // namespace

std::vector<ChartPoint> chart_quadrature(const FaceChart& chart, int side) {
  const Vector2 &a = chart.vertex(side), &b = chart.vertex((side + 1) % chart.sides());
  const double determinant = std::abs(a.x() * b.y() - a.y() * b.x());
  const auto gauss = gauss_legendre_unit(triangle_points);
  std::vector<ChartPoint> out;
  for (const auto& gs : gauss)
    for (const auto& gt : gauss) {
      const double v = gs.node * (1 - gt.node), w = gs.node * gt.node;
      out.push_back({{v, w}, v * a + w * b, gs.weight * gt.weight * gs.node * determinant});
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
  for (int j = 0; j < n; ++j) {
    given.push_back(chart.corner_control(j, corner_p));
    given.push_back(chart.corner_control(j, corner_g1));
    (chart.straight(j) ? unknown : given).push_back(chart.corner_control(j, corner_g2));
  }
  for (int i = chart.first_departure_control(); i < chart.control_count(); ++i) given.push_back(i);
  for (int i = chart.first_centre_control(); i < chart.first_departure_control(); ++i) centre.push_back(i);
}

ChartSamples::ChartSamples(const FaceChart& of) : chart(&of) {
  FaceChart::Scratch scratch;
  for (int side = 0; side < of.sides(); ++side) {
    Side made{chart_quadrature(of, side), {}};
    const std::size_t width = of.active_controls(side).size();
    made.basis.resize(width * made.points.size());
    for (std::size_t i = 0; i < made.points.size(); ++i)
      of.basis(side, made.points[i].point, std::span(made.basis).subspan(i * width, width), scratch);
    sides.push_back(std::move(made));
  }
}

Eigen::MatrixXd bending_matrix(const ChartSamples& samples, const BendingRows& rows) {
  return integrate<3>(samples, rows);
}

Eigen::MatrixXd plate_matrix(const ChartSamples& samples) {
  return integrate<3>(samples, [](int, std::size_t, std::span<const Jet2> basis, auto& rows) {
    for (std::size_t k = 0; k < basis.size(); ++k)
      rows.col(Eigen::Index(k)) << basis[k].xx, std::numbers::sqrt2 * basis[k].xy, basis[k].yy;
  });
}

Eigen::MatrixXd membrane_matrix(const ChartSamples& samples) {
  return integrate<2>(samples, [](int, std::size_t, std::span<const Jet2> basis, auto& rows) {
    for (std::size_t k = 0; k < basis.size(); ++k) rows.col(Eigen::Index(k)) << basis[k].x, basis[k].y;
  });
}

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

CondensedFace condense(const ControlPlaces& places, const Eigen::MatrixXd& energy) {
  const Eigen::MatrixXd cu = part(energy, places.centre, places.unknown);
  const Eigen::MatrixXd cg = part(energy, places.centre, places.given);
  Eigen::MatrixXd centre(cu.rows(), cu.cols() + cg.cols());
  centre << cu, cg;
  const auto solved = solve_definite(part(energy, places.centre, places.centre), centre);
  HARIKO_ASSERT(solved, "the energy of a face's centre is positive definite");
  centre = -*solved;
  const Eigen::MatrixXd uu = part(energy, places.unknown, places.unknown) +
                             transposed_product(cu, Eigen::MatrixXd(centre.leftCols(cu.cols())));
  const Eigen::MatrixXd ug = part(energy, places.unknown, places.given) +
                             transposed_product(cu, Eigen::MatrixXd(centre.rightCols(cg.cols())));
  return {PaddedMatrix(0.5 * (uu + uu.transpose())), PaddedMatrix(ug), PaddedMatrix(centre)};
}

ChartEnergy::ChartEnergy(std::vector<double> angles, const std::vector<int>& joined)
    : chart(std::move(angles), joined), places(chart) {
  const ChartSamples samples(chart);
  plate = plate_matrix(samples);
  membrane = membrane_matrix(samples);
  for (int side = 0; side < chart.sides(); ++side) curve.push_back(curve_matrix(chart, side));
}

Eigen::MatrixXd face_energy(const ChartEnergy& chart, const Eigen::MatrixXd& plate, double tau,
                            std::span<const double> curve_weight) {
  Eigen::MatrixXd energy = plate;
  if (tau != 0) energy += tau * chart.membrane;
  for (std::size_t j = 0; j < curve_weight.size(); ++j) {
    const auto controls = chart.chart.curve_controls(static_cast<int>(j));
    for (std::size_t a = 0; a < controls.size(); ++a)
      for (std::size_t b = 0; b < controls.size(); ++b)
        energy(controls[a], controls[b]) +=
            curve_weight[j] * chart.curve[j](Eigen::Index(a), Eigen::Index(b));
  }
  return energy;
}

std::shared_ptr<const ChartEnergy> G2Elements::chart(const std::vector<double>& angles,
                                                     const std::vector<int>& joined) {
  auto& slot = charts_[{angles, joined}];
  if (!slot) slot = std::make_shared<const ChartEnergy>(angles, joined);
  return slot;
}

std::shared_ptr<const CondensedFace> G2Elements::element(const std::shared_ptr<const ChartEnergy>& chart,
                                                         double tau, std::span<const double> curve_weight) {
  std::vector<double> key{tau};
  key.insert(key.end(), curve_weight.begin(), curve_weight.end());
  auto& slot = elements_[{chart.get(), key}];
  if (!slot)
    slot = std::make_shared<const CondensedFace>(
        condense(chart->places, face_energy(*chart, chart->plate, tau, curve_weight)));
  return slot;
}

}  // namespace hariko
