#include "core/gaussmap/bending_fill.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/solvers/sparse_solver.hpp"
#include "core/gaussmap/control_points.hpp"
#include "core/gaussmap/lloyd_relaxed_mesh.hpp"
#include "core/gaussmap/sphere/spherical_delaunay.hpp"
#include "core/geometry/angles.hpp"

namespace hariko {
namespace {

using Positions = Eigen::MatrixX3d;

/// Cotangent Laplacian and vertex areas of a mesh in its present shape.
struct Geometry {
  SparseMatrix laplacian;  ///< positive semidefinite
  Eigen::VectorXd areas;
};

Geometry geometry_of(const PositionMesh& mesh) {
  const Eigen::Index count = Eigen::Index(mesh.points.size());
  Geometry out{{}, Eigen::VectorXd::Zero(count)};
  SparseEntries entries;
  entries.reserve(mesh.triangles.size() * 12);
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = triangle[k], b = triangle[(k + 1) % 3], c = triangle[(k + 2) % 3];
      const Vector3 u = mesh.points[a] - mesh.points[c], v = mesh.points[b] - mesh.points[c];
      const double twice = std::max(u.cross(v).norm(), 1e-300);
      const double weight = std::clamp(u.dot(v) / twice, -1.0, 20.0) / 2;
      out.areas[c] += twice / 6;
      entries.emplace_back(a, a, weight);
      entries.emplace_back(b, b, weight);
      entries.emplace_back(a, b, -weight);
      entries.emplace_back(b, a, -weight);
    }
  out.laplacian = sparse_matrix(count, count, entries);
  out.areas = out.areas.cwiseMax(1e-12 * out.areas.maxCoeff());
  return out;
}

/// Boundary term of the Laplacian of the position from the conormal along the loops: its integral along each
/// edge, by the edge and the normal at its midpoint, half of it at each end. Exact on planes.
Positions boundary_flux(const PositionMesh& mesh, const std::vector<Vector3>& normals) {
  Positions out = Positions::Zero(Eigen::Index(mesh.points.size()), 3);
  for (Index i = 0; i < mesh.boundary_count; ++i) {
    const Index k = mesh.next[i];
    const Vector3 middle = normals[i] + normals[k];
    if (!(middle.norm() > 0)) continue;
    const Vector3 half = (mesh.points[k] - mesh.points[i]).cross(middle.normalized()) / 2;
    out.row(i) += half.transpose();
    out.row(k) += half.transpose();
  }
  return out;
}

Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> matrix_of(
    const std::vector<Vector3>& points) {
  return {points.data()->data(), Eigen::Index(points.size()), 3};
}

void measure(const PositionMesh& mesh, const std::vector<Vector3>& given, PositionResult& out) {
  out.normals.assign(mesh.points.size(), Vector3::Zero());
  std::vector<double> angles(mesh.points.size(), 0), areas(mesh.points.size(), 0);
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = triangle[k];
      const Vector3 u = mesh.points[triangle[(k + 1) % 3]] - mesh.points[a],
                    v = mesh.points[triangle[(k + 2) % 3]] - mesh.points[a];
      const Vector3 cross = u.cross(v);
      // Weights that are exact on spheres (Max 1999).
      const double lengths = u.squaredNorm() * v.squaredNorm();
      if (lengths > 0) out.normals[a] += cross / lengths;
      angles[a] += angle_between(u, v);
      areas[a] += cross.norm() / 6;
    }
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const double flat = i < mesh.boundary_count ? std::numbers::pi : 2 * std::numbers::pi;
    out.curvature.push_back(areas[i] > 0 ? (flat - angles[i]) / areas[i] : 0);
    out.normals[i].normalize();
    if (i < mesh.boundary_count) out.normals[i] = given[i];
  }
}

}  // namespace

Result<PositionResult> fill_positions(PositionMesh& mesh, const std::vector<Vector3>& normals, double size,
                                      int rounds, const CancelToken& cancel) {
  PositionResult out;
  // Number of spreading rounds after each of five steps, so that vertices are distributed over the developing
  // shape.
  const int portion = (rounds + 4) / 5;
  if (mesh.in_rows) rounds = 0;
  const Eigen::Index boundary = mesh.boundary_count, inner = Eigen::Index(mesh.points.size()) - boundary;
  const Positions flux = boundary_flux(mesh, normals);
  constexpr int most_steps = 60;
  double before = HUGE_VAL;
  out.settled = inner == 0;
  while (!out.settled && out.iterations < most_steps) {
    if (cancel.cancelled()) return make_error(e_cancelled, "The computation was cancelled.");
    const Geometry geometry = geometry_of(mesh);
    const Positions residual = geometry.laplacian * matrix_of(mesh.points) - flux;
    const SparseMatrix columns = geometry.laplacian.rightCols(inner);
    const SparseMatrix weighted = scaled_rows(geometry.areas.cwiseInverse(), columns);
    const SparseCholesky solver(transposed_product(columns, weighted));
    const Eigen::MatrixXd move = -solver.solve(Eigen::MatrixXd(weighted.transpose() * residual));
    if (!solver.succeeded() || !move.allFinite())
      return make_error(e_diverged, "The boundary data do not determine a bounded surface.",
                        "Sample the outline more densely, or check its normals.");
    const double longest = move.rowwise().norm().maxCoeff();
    const double share = std::min(1.0, 0.1 * size / std::max(longest, 1e-300));
    for (Eigen::Index i = 0; i < inner; ++i)
      mesh.points[std::size_t(boundary + i)] += share * move.row(i).transpose();
    ++out.iterations;
    // The weights lag behind the shape, so that steps do not vanish; convergence is that of the energy
    // (gaussmap.md 4).
    const double energy = residual.cwiseAbs2().rowwise().sum().cwiseQuotient(geometry.areas).sum();
    out.settled = share == 1 && std::abs(before - energy) <= 1e-5 * energy;
    // Near a minimal surface the energy is almost zero, so a relative test fails.
    if (out.iterations == most_steps)
      out.settled = share == 1 && std::abs(before - energy) <= 0.05 * energy + 1e-3;
    before = energy;
    if (share < 1 || rounds <= 0 || out.iterations == most_steps) continue;
    spread_evenly(mesh, std::min(rounds, portion));
    rounds -= portion;
    out.settled = false;
    before = HUGE_VAL;
  }
  measure(mesh, normals, out);
  return out;
}

}  // namespace hariko
