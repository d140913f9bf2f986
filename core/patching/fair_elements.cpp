#include "core/patching/fair_elements.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/dense_solver.hpp"
#include "core/base/gauss.hpp"
#include "core/base/vector.hpp"

namespace hariko {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int jump_points = 6;
constexpr int energy_points = 12;

/// Corner of a patch as a homogeneous variable.
enum Variable { var_u, var_v, var_w };

/// Second derivative of the 18 functions along the topological transversal of an edge: start and end of the
/// edge and the third variable, at fraction t (kuriyama.md section 6, J(t)).
std::array<double, quartic_control_count> transversal_row(Variable start, Variable end, Variable third,
                                                          double t, double c_start, double c_end,
                                                          double amount) {
  Vector3 point = Vector3::Zero();
  point[start] = 1 - t;
  point[end] = t;
  const double p = (1 - t) * (1 - c_start) + t * c_end;
  Vector3 direction = Vector3::Zero();
  direction[third] = amount;
  direction[start] = -amount * (4 * p / 3 - (1 - t) / 3);
  direction[end] = -amount * (4 * (1 - p) / 3 - t / 3);
  const QuarticBasis basis = quartic_basis(point[0], point[1], point[2]);
  std::array<double, quartic_control_count> row;
  for (std::size_t k = 0; k < quartic_control_count; ++k)
    row[k] = direction.dot(basis.hessian[k] * direction);
  return row;
}

JumpRows jump_rows(Variable start, Variable end, Variable third, double c_start, double c_end, double amount,
                   double weight) {
  const auto gauss = gauss_legendre_unit(jump_points);
  JumpRows rows;
  for (int i = 0; i < jump_points; ++i) {
    const double scale = std::sqrt(weight * gauss[std::size_t(i)].weight);
    const auto row = transversal_row(start, end, third, gauss[std::size_t(i)].node, c_start, c_end, amount);
    for (std::size_t k = 0; k < quartic_control_count; ++k) rows(i, Eigen::Index(k)) = scale * row[k];
  }
  return rows;
}

/// How the 18 control points of patch j depend on its 9 unknowns.
PatchMatrix patch_dependence(Index sides, Index side, double c_start, double c_end) {
  using namespace quartic;
  const double c_centre = 0.75 * std::cos(2 * pi / double(sides));
  PatchMatrix m = PatchMatrix::Zero();
  m(d400, 0) = m(d310, 0) = m(d301, 0) = 1;
  m(d220, 0) = m(d202, 0) = 0.5;
  struct SplitEdge {
    Index number;
    double c_vertex;
    Control outer, middle, at_centre, at_vertex;
    int z;
    double centre_sign;
  };
  const SplitEdge splits[2] = {{side, c_start, d310, d220, d211w, d121w, 3, 0.5},
                               {side + 1, c_end, d301, d202, d211v, d112v, 5, -0.5}};
  for (const SplitEdge& s : splits) {
    const double angle = 2 * pi * double(s.number % sides) / double(sides);
    const double y[2] = {std::sin(angle), std::cos(angle)};
    for (int i = 0; i < 2; ++i) {
      m(s.outer, 1 + i) += 0.75 * y[i];
      m(s.middle, 1 + i) += 0.5 * y[i];
      m(s.at_centre, 1 + i) += (3 - 2 * c_centre - s.c_vertex) / 3 * y[i];
      m(s.at_vertex, 1 + i) += 2 * s.c_vertex / 3 * y[i];
    }
    m(s.at_centre, 0) += 1 - 2 * c_centre / 3;
    m(s.at_vertex, 0) += 2 * s.c_vertex / 3;
    m(s.at_centre, s.z) = s.centre_sign;
    m(s.at_vertex, s.z + 1) = -s.centre_sign;
  }
  m(d121u, 7) = 1;
  m(d112u, 8) = 1;
  return m;
}

double vertex_constant(Index sides, bool free) {
  return free ? 0.0 : 3 / (8 * split_factor(sides));
}

JumpColumns times(const JumpRows& rows, const PatchMatrix& dependence) {
  const Eigen::MatrixXd product = matrix_product(Eigen::MatrixXd(rows), Eigen::MatrixXd(dependence));
  JumpColumns out;
  std::copy_n(product.data(), product.size(), out.data());
  return out;
}

}  // namespace

PatchEnergy patch_energy(Index sides) {
  const double n = double(sides), scale = 2 * std::sin(pi / n);
  // Columns: the two neighbouring vertices of the regular n-gon of unit side, seen from its centre.
  Eigen::Matrix2d chart;
  chart << 1, std::cos(2 * pi / n), 0, std::sin(2 * pi / n);
  chart /= scale;
  const Eigen::Matrix2d inverse = chart.inverse();
  const double determinant = std::abs(chart.determinant());

  PatchEnergy energy{ControlMatrix::Zero(), ControlMatrix::Zero()};
  const auto gauss = gauss_legendre_unit(energy_points);
  for (const auto& gs : gauss)
    for (const auto& gt : gauss) {
      const double s = gs.node, t = gt.node;
      const double weight = gs.weight * gt.weight * s * determinant;
      const QuarticBasis basis = quartic_basis(1 - s, s * (1 - t), s * t);
      std::array<Vector2, quartic_control_count> gradient;
      std::array<Vector3, quartic_control_count> bending;
      for (std::size_t k = 0; k < quartic_control_count; ++k) {
        const auto g = basis.gradient.row(Eigen::Index(k));
        const Eigen::Matrix3d& h = basis.hessian[k];
        const Eigen::Vector2d local(g(1) - g(0), g(2) - g(0));
        Eigen::Matrix2d second;
        second(0, 0) = h(1, 1) - 2 * h(0, 1) + h(0, 0);
        second(1, 1) = h(2, 2) - 2 * h(0, 2) + h(0, 0);
        second(0, 1) = second(1, 0) = h(1, 2) - h(0, 1) - h(0, 2) + h(0, 0);
        const Eigen::Matrix2d plane = inverse.transpose() * second * inverse;
        gradient[k] = inverse.transpose() * local;
        bending[k] = Vector3(plane(0, 0), std::sqrt(2.0) * plane(0, 1), plane(1, 1));
      }
      for (std::size_t b = 0; b < quartic_control_count; ++b)
        for (std::size_t a = 0; a < quartic_control_count; ++a) {
          const auto i = Eigen::Index(a), k = Eigen::Index(b);
          energy.plate(i, k) += weight * (bending[a][0] * bending[b][0] + bending[a][1] * bending[b][1] +
                                          bending[a][2] * bending[b][2]);
          energy.membrane(i, k) +=
              weight * (gradient[a][0] * gradient[b][0] + gradient[a][1] * gradient[b][1]);
        }
    }
  return energy;
}

std::array<int, patch_unknown_count> FaceElement::columns(Index side) const {
  const int n = int(sides), j = int(side), following = (j + 1) % n;
  return {0,
          1,
          2,
          3 + 2 * j,
          4 + 2 * j,
          3 + 2 * following,
          4 + 2 * following,
          3 + 2 * n + 2 * j,
          4 + 2 * n + 2 * j};
}

const FaceElement* FairElements::face(Index sides, const std::vector<bool>& free_corner, double tau) {
  std::vector<double> key{double(sides), tau};
  for (const bool free : free_corner) key.push_back(free ? 1 : 0);
  auto& slot = faces_[key];
  if (slot) return slot.get();
  slot = std::make_unique<FaceElement>();
  FaceElement& element = *slot;
  element.sides = sides;

  auto [found, fresh] = energies_.try_emplace(sides);
  if (fresh) found->second = patch_energy(sides);
  element.energy = found->second.plate + tau * found->second.membrane;
  for (const Eigen::Index first : {12, 14, 16}) {
    element.energy(first, first) += weights_.pair_distance;
    element.energy(first + 1, first + 1) += weights_.pair_distance;
    element.energy(first, first + 1) -= weights_.pair_distance;
    element.energy(first + 1, first) -= weights_.pair_distance;
  }

  const auto c_vertex = [&](Index j) { return vertex_constant(sides, free_corner[j % sides]); };
  const double c_centre = 0.75 * std::cos(2 * pi / double(sides));
  for (Index j = 0; j < sides; ++j) {
    element.dependence.push_back(patch_dependence(sides, j, c_vertex(j), c_vertex(j + 1)));
    // Split edge j from O outward: patch j on its left (edge w = 0), patch j - 1 on its right (edge v = 0).
    element.split_left.push_back(
        jump_rows(var_u, var_v, var_w, c_centre, c_vertex(j), 0.5, weights_.curvature_jump));
    element.split_right.push_back(
        -jump_rows(var_u, var_w, var_v, c_centre, c_vertex(j), 0.5, weights_.curvature_jump));
  }

  const int size = 3 + 4 * int(sides);
  element.matrix = Eigen::MatrixXd::Zero(size, size);
  for (Index j = 0; j < sides; ++j) {
    const auto columns = element.columns(j);
    const Eigen::MatrixXd dependence = element.dependence[j];
    const Eigen::MatrixXd local =
        matrix_product(transposed_product(dependence, Eigen::MatrixXd(element.energy)), dependence);
    for (int a = 0; a < patch_unknown_count; ++a)
      for (int b = 0; b < patch_unknown_count; ++b) element.matrix(columns[a], columns[b]) += local(a, b);
    const Index behind = (j + sides - 1) % sides;
    // A split edge's jump touches the unknowns of the two patches beside it only.
    const auto behind_columns = element.columns(behind);
    const JumpColumns left = times(element.split_left[j], element.dependence[j]),
                      right = times(element.split_right[j], element.dependence[behind]);
    Eigen::MatrixXd rows(jump_points, 2 * patch_unknown_count);
    std::copy_n(left.data(), left.size(), rows.data());
    std::copy_n(right.data(), right.size(), rows.data() + left.size());
    const Eigen::MatrixXd square = transposed_product(rows, rows);
    const auto column = [&](int a) {
      return a < patch_unknown_count ? columns[std::size_t(a)]
                                     : behind_columns[std::size_t(a - patch_unknown_count)];
    };
    for (int a = 0; a < 2 * patch_unknown_count; ++a)
      for (int b = 0; b < 2 * patch_unknown_count; ++b) element.matrix(column(a), column(b)) += square(a, b);
  }
  return slot.get();
}

const EdgeElement* FairElements::edge(const FaceElement* first, Index first_side, const FaceElement* second,
                                      Index second_side, double c_start, double c_end) {
  // Element addresses are stable for the life of this object, so they stand for what they depend on.
  std::vector<double> key{double(reinterpret_cast<std::uintptr_t>(first)),
                          double(first_side),
                          double(reinterpret_cast<std::uintptr_t>(second)),
                          double(second_side),
                          c_start,
                          c_end};
  auto& slot = edges_[key];
  if (slot) return slot.get();
  slot = std::make_unique<EdgeElement>();
  const double first_f = split_factor(first->sides), second_f = split_factor(second->sides);
  const double a1 = second_f / (first_f + second_f), a2 = first_f / (first_f + second_f);
  // The first face's half-edge runs from start to end, the second face's from end to start.
  slot->first_rows = jump_rows(var_v, var_w, var_u, c_start, c_end, a1, weights_.curvature_jump);
  slot->second_rows = -jump_rows(var_w, var_v, var_u, c_start, c_end, a2, weights_.curvature_jump);
  slot->first_columns = times(slot->first_rows, first->dependence[first_side]);
  slot->second_columns = times(slot->second_rows, second->dependence[second_side]);
  return slot.get();
}

}  // namespace hariko
