#include "core/g2/curvature_target.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/base/assert.hpp"
#include "core/base/solvers/dense_solver.hpp"

namespace hariko {

namespace {

constexpr double least_metric = 1e-6;  ///< relative to the mean over the face
constexpr int form_degree = 4;
constexpr int form_terms = (form_degree + 1) * (form_degree + 2) / 2;

template <class Each>  // each(side, number of the point, point)
void for_points(const ChartSamples& samples, const Each& each) {
  for (int side = 0; side < samples.sides(); ++side)
    for (std::size_t i = 0; i < samples.points(side).size(); ++i)
      each(static_cast<std::size_t>(side), i, samples.points(side)[i]);
}

/// Calls add(side, number of the point, point, functions, their controls) for every point of the quadrature.
template <class Add>
void for_functions(const ChartSamples& samples, const Add& add) {
  for (int side = 0; side < samples.sides(); ++side) {
    const std::span<const int> active = samples.chart().active_controls(side);
    samples.with_basis(side, [&](const ChartSamples::Basis& basis) {
      for (std::size_t i = 0; i < samples.points(side).size(); ++i)
        add(static_cast<std::size_t>(side), i, samples.points(side)[i], basis.at(i), active);
    });
  }
}

struct FormBasis {
  std::array<double, form_terms> v, x, y;
};
/// Monomials in x / R and y / R, with derivatives by x and y.
FormBasis form_basis(const Vector2& point, double radius) {
  const double unit = 1 / radius;
  std::array<double, form_degree + 1> x{1}, y{1};
  for (std::size_t i = 1; i <= form_degree; ++i) {
    x[i] = x[i - 1] * point.x() * unit;
    y[i] = y[i - 1] * point.y() * unit;
  }
  FormBasis out;
  std::size_t k = 0;
  for (std::size_t degree = 0; degree <= form_degree; ++degree)
    for (std::size_t j = 0; j <= degree; ++j, ++k) {
      const std::size_t i = degree - j;
      out.v[k] = x[i] * y[j];
      out.x[k] = i == 0 ? 0 : unit * double(i) * x[i - 1] * y[j];
      out.y[k] = j == 0 ? 0 : unit * double(j) * x[i] * y[j - 1];
    }
  return out;
}

/// Coefficients of polynomials in the least-squares sense. `rows`: the terms at each point, then the values.
Eigen::MatrixXd fitted(const Eigen::MatrixXd& rows, int values) {
  const Eigen::MatrixXd gram = Eigen::MatrixXd(lower_gram_matrix(rows).selfadjointView<Eigen::Lower>());
  Eigen::MatrixXd matrix = gram.topLeftCorner(form_terms, form_terms);
  matrix.diagonal().array() += 1e-10 * matrix.trace() / form_terms;
  const auto solved = solve_definite(matrix, Eigen::MatrixXd(gram.topRightCorner(form_terms, values)));
  HARIKO_ASSERT(solved, "the fit of polynomials is positive definite");
  return *solved;
}

/// Product m f m of symmetric matrices.
SymmetricMatrix2 congruent(const SymmetricMatrix2& m, const SymmetricMatrix2& f) {
  return {m[0] * m[0] * f[0] + 2 * m[0] * m[1] * f[1] + m[1] * m[1] * f[2],
          m[0] * m[1] * f[0] + (m[0] * m[2] + m[1] * m[1]) * f[1] + m[1] * m[2] * f[2],
          m[1] * m[1] * f[0] + 2 * m[1] * m[2] * f[1] + m[2] * m[2] * f[2]};
}

/// Form in the chart's coordinates: L t L.
SymmetricMatrix2 in_chart(const FramedPoint& p) {
  return congruent(p.root, p.t);
}

/// Christoffel symbols of the reference: tangential parts of its second derivatives xx, xy, yy, as
/// combinations of its first ones.
using Christoffel = std::array<Eigen::Vector2d, 3>;
Christoffel christoffel(const ReferencePoint& s, const FramedPoint& p) {
  const SymmetricMatrix2 m = p.inverse_root();
  Eigen::Matrix2d inverse;  // inverse of the metric
  inverse << m[0] * m[0] + m[1] * m[1], m[1] * (m[0] + m[2]), m[1] * (m[0] + m[2]), m[1] * m[1] + m[2] * m[2];
  const auto of = [&](const Vector3& second) -> Eigen::Vector2d {
    return inverse * Eigen::Vector2d(second.dot(s.x), second.dot(s.y));
  };
  return {of(s.xx), of(s.xy), of(s.yy)};
}

/// Second derivatives (xx, xy, yy) of the target: the tangential part of the reference's, with the smoothed
/// form.
std::array<Vector3, 3> second_derivatives(const ReferencePoint& s, const FramedPoint& own,
                                          const FramedPoint& smooth) {
  const SymmetricMatrix2 h = in_chart(own), smoothed = in_chart(smooth);
  return {s.xx - (h[0] - smoothed[0]) * own.normal, s.xy - (h[1] - smoothed[1]) * own.normal,
          s.yy - (h[2] - smoothed[2]) * own.normal};
}

/// Coefficients of the polynomials of degree four nearest to the target's second derivatives: one row per
/// term, three columns for each of xx, xy, yy.
Eigen::MatrixXd fitted_second_derivatives(const ChartSamples& samples, const FaceReference& reference,
                                          const FramedFace& own, const FramedFace& smooth) {
  std::size_t count = 0;
  for_points(samples, [&](std::size_t, std::size_t, const ChartPoint&) { ++count; });
  Eigen::MatrixXd rows(Eigen::Index(count), form_terms + 9);
  Eigen::Index at = 0;
  for_points(samples, [&](std::size_t side, std::size_t i, const ChartPoint& point) {
    const double weight = std::sqrt(point.weight);
    const FormBasis f = form_basis(point.opened, samples.chart().radius());
    for (int k = 0; k < form_terms; ++k) rows(at, k) = weight * f.v[std::size_t(k)];
    const auto second = second_derivatives(reference[side][i], own[side][i], smooth[side][i]);
    for (int c = 0; c < 3; ++c)
      rows.block<1, 3>(at, form_terms + 3 * c) = weight * second[std::size_t(c)].transpose();
    ++at;
  });
  return fitted(rows, 9);
}

/// Third derivatives (xxx, xxy, xyy, yyy) of the target. Along the surface they are those of the fitted
/// second derivatives; across it, those with which the smoothed form is parallel: its covariant derivative,
/// the change of curvature, is zero.
using ThirdDerivatives = std::array<Vector3, 4>;
ThirdDerivatives third_derivatives(const Eigen::MatrixXd& fit, const FormBasis& f, const Christoffel& g,
                                   const FramedPoint& smooth) {
  Eigen::Matrix<double, 1, 9> by_x = Eigen::Matrix<double, 1, 9>::Zero(), by_y = by_x;
  for (int k = 0; k < form_terms; ++k) {
    by_x += f.x[std::size_t(k)] * fit.row(k);
    by_y += f.y[std::size_t(k)] * fit.row(k);
  }
  const auto part = [](const Eigen::Matrix<double, 1, 9>& of, int which) -> Vector3 {
    return of.segment<3>(3 * which).transpose();
  };
  ThirdDerivatives out{part(by_x, 0), (part(by_y, 0) + 2 * part(by_x, 1)) / 3,
                       (part(by_x, 2) + 2 * part(by_y, 1)) / 3, part(by_y, 2)};
  const SymmetricMatrix2 h = in_chart(smooth);
  const auto turned = [&](int ab, int c) {  // Gamma^k_ab h_kc
    return g[std::size_t(ab)][0] * h[std::size_t(c)] + g[std::size_t(ab)][1] * h[std::size_t(c + 1)];
  };
  const std::array<double, 4> across{3 * turned(0, 0), turned(0, 1) + 2 * turned(1, 0),
                                     turned(2, 0) + 2 * turned(1, 1), 3 * turned(2, 1)};
  for (std::size_t c = 0; c < 4; ++c) out[c] += (across[c] - out[c].dot(smooth.normal)) * smooth.normal;
  return out;
}

/// Rows (11, sqrt(2) 12, 22) of second covariant derivatives in the orthonormal frame, times the root of the
/// area element.
struct CovariantRows {
  SymmetricMatrix2 m;  // inverse of L
  double root;
  Christoffel g;

  CovariantRows(const ReferencePoint& s, const FramedPoint& p)
      : m(p.inverse_root()), root(std::sqrt(p.area)), g(christoffel(s, p)) {}
  Eigen::Vector3d operator()(const Jet3& f) const {
    const SymmetricMatrix2 rows =
        congruent(m, {f.xx - g[0][0] * f.x - g[0][1] * f.y, f.xy - g[1][0] * f.x - g[1][1] * f.y,
                      f.yy - g[2][0] * f.x - g[2][1] * f.y});
    return {root * rows[0], root * std::numbers::sqrt2 * rows[1], root * rows[2]};
  }
};

}  // namespace

FramedFace framed(const ChartSamples& samples, const FaceReference& reference) {
  double mean = 0;
  for_points(samples, [&](std::size_t side, std::size_t i, const ChartPoint& point) {
    const ReferencePoint& s = reference[side][i];
    mean += point.weight * (s.x.squaredNorm() + s.y.squaredNorm()) / (2 * samples.chart().area());
  });
  FramedFace out;
  if (!(mean > 0)) return out;
  for (std::size_t side = 0; side < reference.size(); ++side) {
    auto& own = out.emplace_back();
    for (const ReferencePoint& s : reference[side]) {
      FramedPoint p;
      const double floor = least_metric * mean, g11 = s.x.squaredNorm() + floor, g12 = s.x.dot(s.y),
                   g22 = s.y.squaredNorm() + floor;
      p.area = std::sqrt(g11 * g22 - g12 * g12);
      const double trace = std::sqrt(g11 + g22 + 2 * p.area);  // trace of L
      p.root = {(g11 + p.area) / trace, g12 / trace, (g22 + p.area) / trace};
      p.normal = s.x.cross(s.y).stableNormalized();
      if (!p.normal.allFinite()) p.normal.setZero();
      p.t = congruent(p.inverse_root(), {s.xx.dot(p.normal), s.xy.dot(p.normal), s.yy.dot(p.normal)});
      own.push_back(p);
    }
  }
  return out;
}

void smooth_forms(const ChartSamples& samples, double width, FramedFace& face) {
  const FaceChart& chart = samples.chart();
  Eigen::Matrix2d mean = Eigen::Matrix2d::Zero();
  std::size_t count = 0;
  for_points(samples, [&](std::size_t side, std::size_t i, const ChartPoint& point) {
    const FramedPoint& p = face[side][i];
    Eigen::Matrix2d g;
    const auto& [l11, l12, l22] = p.root;
    g << l11 * l11 + l12 * l12, l12 * (l11 + l22), l12 * (l11 + l22), l12 * l12 + l22 * l22;
    mean += point.weight / chart.area() * g;
    ++count;
  });
  const double half = (mean(0, 0) + mean(1, 1)) / 2;
  const double smaller = half - std::hypot((mean(0, 0) - mean(1, 1)) / 2, mean(0, 1));
  const double length = width * 2 * chart.apothem() * std::sqrt(std::max(smaller, 0.0));
  Eigen::MatrixXd rows(3 * Eigen::Index(count), form_terms + 3);
  Eigen::Index at = 0;
  for_points(samples, [&](std::size_t side, std::size_t i, const ChartPoint& point) {
    const FramedPoint& p = face[side][i];
    const FormBasis f = form_basis(point.opened, chart.radius());
    const double weight = std::sqrt(point.weight * p.area), bent = length * weight;
    const SymmetricMatrix2 m = p.inverse_root();
    for (int k = 0; k < form_terms; ++k) {
      const auto term = static_cast<std::size_t>(k);
      rows(at, k) = weight * f.v[term];
      rows(at + 1, k) = bent * (m[0] * f.x[term] + m[1] * f.y[term]);
      rows(at + 2, k) = bent * (m[1] * f.x[term] + m[2] * f.y[term]);
    }
    for (int i3 = 0; i3 < 3; ++i3) {
      rows(at, form_terms + i3) = weight * p.t[std::size_t(i3)];
      rows(at + 1, form_terms + i3) = rows(at + 2, form_terms + i3) = 0;
    }
    at += 3;
  });
  const Eigen::MatrixXd solved = fitted(rows, 3);
  for_points(samples, [&](std::size_t side, std::size_t i, const ChartPoint& point) {
    const FormBasis f = form_basis(point.opened, chart.radius());
    for (int i3 = 0; i3 < 3; ++i3) {
      double sum = 0;
      for (int k = 0; k < form_terms; ++k) sum += f.v[std::size_t(k)] * solved(k, i3);
      face[side][i].t[std::size_t(i3)] = sum;
    }
  });
}

std::vector<Vector3> chart_load(const ChartSamples& samples, const FaceReference& reference,
                                const FramedFace& own, const FramedFace& smooth, double share,
                                const ChartMeasure& measure) {
  std::vector<Vector3> out(std::size_t(samples.chart().control_count()), Vector3::Zero());
  const Eigen::Matrix3d change = second_order_change(measure);
  const Eigen::Matrix3d square = measure.weight * (change.transpose() * change);
  for_functions(samples, [&](std::size_t side, std::size_t i, const ChartPoint& point,
                             std::span<const Jet3> basis, std::span<const int> active) {
    const auto second = second_derivatives(reference[side][i], own[side][i], smooth[side][i]);
    const double weight = share * point.weight;
    Eigen::Matrix3d target;
    target.row(0) = weight * second[0];
    target.row(1) = weight * std::numbers::sqrt2 * second[1];
    target.row(2) = weight * second[2];
    const Eigen::Matrix3d load = (square * target).transpose();
    for (std::size_t k = 0; k < active.size(); ++k)
      out[std::size_t(active[k])] +=
          load * Eigen::Vector3d(basis[k].xx, std::numbers::sqrt2 * basis[k].xy, basis[k].yy);
  });
  return out;
}

std::vector<Vector3> third_load(const ChartSamples& samples, const FaceReference& reference,
                                const FramedFace& own, const FramedFace& smooth, double third,
                                const ChartMeasure& measure) {
  std::vector<Vector3> out(std::size_t(samples.chart().control_count()), Vector3::Zero());
  const Eigen::MatrixXd fit = fitted_second_derivatives(samples, reference, own, smooth);
  const Eigen::Matrix4d change = third_order_change(measure);
  const Eigen::Matrix4d square = third * measure.thinness() * measure.weight * (change.transpose() * change);
  for_functions(samples, [&](std::size_t side, std::size_t i, const ChartPoint& point,
                             std::span<const Jet3> basis, std::span<const int> active) {
    const auto target = third_derivatives(fit, form_basis(point.opened, samples.chart().radius()),
                                          christoffel(reference[side][i], own[side][i]), smooth[side][i]);
    Eigen::Matrix<double, 4, 3> rows;
    for (int c = 0; c < 4; ++c)
      rows.row(c) = point.weight * (c == 1 || c == 2 ? std::numbers::sqrt3 : 1) * target[std::size_t(c)];
    const Eigen::Matrix<double, 3, 4> load = (square * rows).transpose();
    for (std::size_t k = 0; k < active.size(); ++k)
      out[std::size_t(active[k])] += load * Eigen::Vector4d(basis[k].xxx, std::numbers::sqrt3 * basis[k].xxy,
                                                            std::numbers::sqrt3 * basis[k].xyy, basis[k].yyy);
  });
  return out;
}

Eigen::MatrixXd metric_plate(const ChartSamples& samples, const FaceReference& reference,
                             const FramedFace& frames) {
  return bending_matrix(samples, [&](int side, std::size_t point, std::span<const Jet3> basis, auto rows) {
    const auto at = static_cast<std::size_t>(side);
    const CovariantRows covariant(reference[at][point], frames[at][point]);
    for (std::size_t k = 0; k < basis.size(); ++k) rows.col(Eigen::Index(k)) = covariant(basis[k]);
  });
}

std::vector<Vector3> metric_load(const ChartSamples& samples, const FaceReference& reference,
                                 const FramedFace& smooth) {
  std::vector<Vector3> out(std::size_t(samples.chart().control_count()), Vector3::Zero());
  for_functions(samples, [&](std::size_t side, std::size_t i, const ChartPoint& point,
                             std::span<const Jet3> basis, std::span<const int> active) {
    const FramedPoint& p = smooth[side][i];
    const CovariantRows covariant(reference[side][i], p);
    const double weight = point.weight * std::sqrt(p.area);
    const Eigen::Vector3d form(p.t[0], std::numbers::sqrt2 * p.t[1], p.t[2]);
    for (std::size_t k = 0; k < active.size(); ++k)
      out[std::size_t(active[k])] += weight * form.dot(covariant(basis[k])) * p.normal;
  });
  return out;
}

}  // namespace hariko
