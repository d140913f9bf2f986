#include "core/gaussmap/support_function_solve.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/solvers/sparse_solver.hpp"
#include "core/gaussmap/control_points.hpp"

namespace hariko {
namespace {

using Vector = Eigen::VectorXd;

/// Operators of gaussmap.md 4 on the polytope around the unit sphere: w = a^-1 (J h + b) approximates the sum
/// of the radii of curvature, Lambda is the Laplacian.
struct Operators {
  SparseMatrix jacobian, laplacian;  ///< J, Lambda; rows and columns are all sites
  Vector areas, boundary;            ///< a, b
};

/// Adds the matrix rows of one site. The edges of its facet lie in the plane n.x = 1.
class FacetRows {
 public:
  FacetRows(const SphereMesh& mesh, SparseEntries& jacobian, SparseEntries& laplacian)
      : mesh_(mesh), jacobian_(jacobian), laplacian_(laplacian) {}

  /// Adds site i and returns the area of its facet.
  double add(Index i) {
    const auto& ring = mesh_.ring(i);
    const std::size_t count = ring.neighbours.size();
    area_ = 0;
    for (std::size_t t = 0; t < count; ++t) {
      const Index k = ring.neighbours[t];
      // Neighbour t lies between the triangles t - 1 and t; at the ends of a boundary chain the midpoint of
      // the arc replaces the missing one.
      const bool chain = mesh_.is_boundary(i);
      const Vector3 from =
          chain && t == 0 ? middle(i, k) : centre(i, ring.triangles[(t + count - 1) % count]);
      const Vector3 to = chain && t + 1 == count ? middle(i, k) : centre(i, ring.triangles[t]);
      add_edge(i, k, from, to);
    }
    return area_;
  }

 private:
  Vector3 project(Index i, const Vector3& direction) const {
    return direction / direction.dot(mesh_.site(i));
  }
  Vector3 middle(Index i, Index k) const { return project(i, mesh_.site(i) + mesh_.site(k)); }
  Vector3 centre(Index i, Index triangle) const { return project(i, mesh_.centres()[triangle]); }
  void add_edge(Index i, Index k, const Vector3& from, const Vector3& to) {
    const Vector3 axis = mesh_.site(i).cross(mesh_.site(k));
    const double sine = axis.norm(), cosine = mesh_.site(i).dot(mesh_.site(k));
    const double length = (to - from).dot(axis) / sine;  // positive where the outer side faces site k
    jacobian_.emplace_back(i, k, length / sine);
    jacobian_.emplace_back(i, i, -length * cosine / sine);
    laplacian_.emplace_back(i, k, length / sine);
    laplacian_.emplace_back(i, i, -length / sine);
    area_ += length * sine / (1 + cosine) / 2;  // the edge is at distance tan(angle / 2) from the site
  }

  const SphereMesh& mesh_;
  SparseEntries &jacobian_, &laplacian_;
  double area_ = 0;
};

Operators make_operators(const SphereMesh& mesh, const BoundaryData& boundary) {
  const Eigen::Index count = mesh.site_count();
  Operators out;
  out.areas.resize(count);
  out.boundary = Vector::Zero(count);
  SparseEntries jacobian, laplacian;
  jacobian.reserve(std::size_t(count) * 14);
  laplacian.reserve(std::size_t(count) * 14);
  FacetRows rows(mesh, jacobian, laplacian);
  for (Index i = 0; i < mesh.site_count(); ++i) out.areas[i] = rows.add(i);
  for (Index i = 0; i < mesh.boundary_count(); ++i) {
    const Vector3& n = mesh.site(i);
    const auto middle = [&](Index k) {
      const Vector3 sum = n + mesh.site(k);
      return Vector3(sum / sum.dot(n));
    };
    // Both half edges at the site: n -> midpoint of the next arc, and midpoint of the previous arc -> n.
    const Vector3 edges = (middle(mesh.next(i)) - n) + (n - middle(mesh.previous(i)));
    out.boundary[i] = edges.cross(n).dot(boundary.points[i]);
  }
  out.jacobian = sparse_matrix(count, count, jacobian);
  out.laplacian = sparse_matrix(count, count, laplacian);
  return out;
}

std::optional<Vector> solve_umbilic(const Operators& operators, const Vector& known, Eigen::Index inner) {
  const SparseMatrix scaled = scaled_rows(operators.areas.cwiseInverse(), operators.jacobian);
  const SparseMatrix inner_rows = operators.laplacian.bottomRows(inner);
  const SparseMatrix system = sparse_product(inner_rows, scaled.rightCols(inner));
  const Vector right = -(inner_rows * known);
  const SparseLu solver(system);
  if (!solver.succeeded()) return {};
  return solver.solve(right);
}

std::optional<Vector> solve_curvature(const Operators& operators, const Vector& known, Eigen::Index inner,
                                      const std::vector<RadiusSum>& sums) {
  constexpr double pull = 100;  // weight mu of gaussmap.md 4
  const SparseMatrix radii = scaled_rows(operators.areas.cwiseInverse(), operators.jacobian);
  const SparseMatrix unknown = radii.rightCols(inner);
  Vector weights = Vector::Zero(known.size()), wanted = Vector::Zero(known.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    weights[Eigen::Index(i)] = pull * sums[i].weight;
    wanted[Eigen::Index(i)] = sums[i].value;
  }
  SparseMatrix form = -operators.laplacian;
  for (Eigen::Index i = 0; i < Eigen::Index(sums.size()); ++i) form.coeffRef(i, i) += weights[i];
  const SparseMatrix system = transposed_product(unknown, sparse_product(form, unknown));
  const Vector right = unknown.transpose() * (weights.cwiseProduct(wanted) - form * known);
  const SparseCholesky solver(system);
  if (!solver.succeeded()) return {};
  Vector solution = solver.solve(right);
  // One refinement step restores the digits that the normal equations lose.
  const Vector rest = right - system * solution;
  solution += solver.solve(rest);
  return solution;
}

}  // namespace

std::vector<RadiusSum> boundary_radius_sums(const SphereMesh& mesh, const BoundaryData& boundary) {
  std::vector<RadiusSum> out(mesh.boundary_count());
  for (Index i = 0; i < mesh.boundary_count(); ++i) {
    const Index before = mesh.previous(i), after = mesh.next(i);
    const Vector3& n = mesh.site(i);
    const double step_before = (n - mesh.site(before)).norm(), step_after = (mesh.site(after) - n).norm();
    const auto derivative = [&](const Vector3& low, const Vector3& at, const Vector3& high) {
      return Vector3((step_before / step_after * (high - at) + step_after / step_before * (at - low)) /
                     (step_before + step_after));
    };
    const Vector3 dp = derivative(boundary.points[before], boundary.points[i], boundary.points[after]);
    Vector3 dn = derivative(mesh.site(before), n, mesh.site(after));
    dn -= dn.dot(n) * n;
    const double speed = dn.norm();
    const Vector3 e = dn / speed, f = n.cross(e);
    const double ee = dp.dot(e) / speed, ef = dp.dot(f) / speed, inverse = 1 / boundary.curvature[i];
    const double scale = std::sqrt(ee * ee + ef * ef + std::abs(inverse));
    if (inverse < 0 && std::abs(ee) < 0.2 * scale) continue;
    if (!(std::abs(ee) > 1e-12 * scale)) continue;
    out[i] = {ee + (inverse + ef * ef) / ee, 1};
  }
  return out;
}

Result<std::vector<double>> linear_fill(const SphereMesh& mesh, const BoundaryData& boundary,
                                        bool use_curvature) {
  std::vector<double> support(mesh.site_count(), 0.0);
  for (Index i = 0; i < mesh.boundary_count(); ++i) support[i] = mesh.site(i).dot(boundary.points[i]);
  const Eigen::Index inner = mesh.inner_count();
  if (inner == 0) return support;
  const Operators operators = make_operators(mesh, boundary);
  const Vector given = Eigen::Map<const Vector>(support.data(), Eigen::Index(support.size()));
  // w for the given values alone.
  const Vector known = (operators.jacobian * given + operators.boundary).cwiseQuotient(operators.areas);
  const auto solution = use_curvature
                            ? solve_curvature(operators, known, inner, boundary_radius_sums(mesh, boundary))
                            : solve_umbilic(operators, known, inner);
  if (!solution || !solution->allFinite())
    return make_error(e_diverged, "The boundary data do not determine a bounded surface.",
                      "Sample the outline more densely, or use the mode position.");
  std::copy(solution->begin(), solution->end(), support.begin() + mesh.boundary_count());
  return support;
}

}  // namespace hariko
