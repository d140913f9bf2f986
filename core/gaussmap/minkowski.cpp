#include "core/gaussmap/minkowski.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include "core/base/solvers/small_solver.hpp"
#include "core/base/solvers/sparse_solver.hpp"
#include "core/gaussmap/halfspace_intersection.hpp"
#include "core/geometry/edge_key.hpp"

namespace hariko {
namespace {

using Vector = Eigen::VectorXd;

Element boundary_element(const SphereMesh& mesh, Index site) {
  return element_of(VertexId{nearest_boundary(mesh.sites(), mesh.boundary_count(), site)});
}

class Newton {
 public:
  Newton(const SphereMesh& mesh, const BoundaryData& boundary, std::vector<double> start, Vector targets)
      : mesh_(mesh), points_(boundary.points), support_(std::move(start)), targets_(std::move(targets)) {}

  Result<MinkowskiResult> run(const CancelToken& cancel) {
    if (!(polytope_ = polytope(support_))) return unreachable();
    areas_ = inner_areas(*polytope_);
    const double least = 0.5 * std::min(areas_.minCoeff(), targets_.minCoeff());
    MinkowskiResult out;
    out.residual = residual(areas_);
    if (nearly_singular()) {
      out.singular = true;
      out.support = support_;
      return out;
    }
    while (out.residual > 1e-11 && out.iterations < 60) {
      if (cancel.cancelled()) return make_error(e_cancelled, "The computation was cancelled.");
      if (!step(least, out.residual)) {
        // Rounding may end the descent slightly above the tolerance.
        if (out.residual < 1e-10) break;
        return unreachable();
      }
      ++out.iterations;
    }
    if (out.residual > 1e-10) return unreachable();
    out.support = support_;
    out.triangles = inside_triangles();
    return out;
  }

 private:
  /// Error that names the point of the outline next to the area with the largest error.
  Message unreachable() const {
    Element element;
    if (polytope_) {
      Eigen::Index worst = 0;
      (areas_ - targets_).cwiseQuotient(targets_).cwiseAbs().maxCoeff(&worst);
      element = boundary_element(mesh_, mesh_.boundary_count() + Index(worst));
    }
    return make_error(e_curvature_unreachable, "No convex surface through the outline has this curvature.",
                      "Use the mode curvature, which does not need it to be exact.", element);
  }
  std::optional<TangentPolytope> polytope(const std::vector<double>& support) const {
    const auto inner = inner_point(mesh_.sites(), support, points_, 1);
    if (!inner) return {};
    return TangentPolytope::build(mesh_.sites(), support, *inner, 1);
  }
  Vector inner_areas(const TangentPolytope& polytope) const {
    Vector out(mesh_.inner_count());
    for (Index i = 0; i < mesh_.inner_count(); ++i) {
      const Index site = mesh_.boundary_count() + i;
      out[i] = polytope.area(site, mesh_.site(site));
    }
    return out;
  }
  double residual(const Vector& areas) const { return (areas - targets_).cwiseQuotient(targets_).norm(); }

  /// Derivatives of the inner areas by the inner support values; symmetric.
  SparseMatrix jacobian() const {
    SparseEntries entries;
    const Index first = mesh_.boundary_count();
    for (Index i = first; i < mesh_.site_count(); ++i) {
      const auto& facet = polytope_->facets()[i];
      for (std::size_t e = 0; e < facet.corners.size(); ++e) {
        const Index k = facet.neighbours[e];
        if (k == no_index) continue;
        const double length = (facet.corners[(e + 1) % facet.corners.size()] - facet.corners[e]).norm();
        const double sine = mesh_.site(i).cross(mesh_.site(k)).norm(),
                     cosine = mesh_.site(i).dot(mesh_.site(k));
        entries.emplace_back(i - first, i - first, -length * cosine / sine);
        if (k >= first) entries.emplace_back(i - first, k - first, length / sine);
      }
    }
    return sparse_matrix(mesh_.inner_count(), mesh_.inner_count(), entries);
  }

  /// Whether the matrix a^-1/2 J a^-1/2 has an eigenvalue near 0, by inverse iteration.
  bool nearly_singular() const {
    const Vector root = areas_.cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    SparseMatrix scaled = jacobian();
    for (int column = 0; column < scaled.outerSize(); ++column)
      for (SparseMatrix::InnerIterator entry(scaled, column); entry; ++entry)
        entry.valueRef() = root[entry.row()] * entry.value() * root[column];
    const SparseLu solver(scaled);
    if (!solver.succeeded()) return true;
    Vector x = Vector::Ones(root.size());
    double inverse = 0;
    for (int i = 0; i < 12; ++i) {
      x.normalize();
      const Vector y = solver.solve(x);
      if (!y.allFinite()) return true;
      inverse = y.norm();
      x = y;
    }
    return inverse > 1 / 0.05;
  }

  bool step(double least, double& current) {
    const SparseLu solver(jacobian());
    if (!solver.succeeded()) return false;
    const Vector move = solver.solve(targets_ - areas_);
    if (!move.allFinite()) return false;
    for (double share = 1; share >= 1e-6; share /= 2) {
      std::vector<double> next = support_;
      for (Index i = 0; i < mesh_.inner_count(); ++i) next[mesh_.boundary_count() + i] += share * move[i];
      auto shape = polytope(next);
      if (!shape) continue;
      const Vector areas = inner_areas(*shape);
      const double error = residual(areas);
      if (!(areas.minCoeff() > least) || !(error < (1 - 0.3 * share) * current)) continue;
      support_ = std::move(next);
      polytope_ = std::move(shape);
      areas_ = areas;
      current = error;
      return true;
    }
    return false;
  }

  /// Dual triangles of the polytope's corners; empty where these omit a loop's edge or a site.
  std::vector<std::array<Index, 3>> inside_triangles() const;

  const SphereMesh& mesh_;
  std::span<const Vector3> points_;
  std::vector<double> support_;
  Vector targets_, areas_;
  std::optional<TangentPolytope> polytope_;
};

std::vector<std::array<Index, 3>> Newton::inside_triangles() const {
  const auto& all = polytope_->corner_planes();
  std::unordered_map<std::uint64_t, Index> face_of;
  for (Index t = 0; t < all.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) face_of[half_edge_key(all[t][k], all[t][(k + 1) % 3])] = t;
  std::vector<char> inside(all.size(), 0);
  std::vector<Index> stack;
  const auto enter = [&](Index t) {
    if (!inside[t]) stack.push_back(t);
    inside[t] = 1;
  };
  for (Index i = 0; i < mesh_.boundary_count(); ++i) {
    const auto found = face_of.find(half_edge_key(i, mesh_.next(i)));
    if (found == face_of.end()) return {};
    enter(found->second);
  }
  std::vector<std::array<Index, 3>> out;
  std::vector<char> used(mesh_.site_count(), 0);
  while (!stack.empty()) {
    const auto triangle = all[stack.back()];
    stack.pop_back();
    out.push_back(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = triangle[k], b = triangle[(k + 1) % 3];
      used[a] = 1;
      if (mesh_.is_boundary(b) && mesh_.next(b) == a) return {};
      if (mesh_.is_boundary(a) && mesh_.next(a) == b) continue;
      const auto beyond = face_of.find(half_edge_key(b, a));
      if (beyond == face_of.end()) return {};
      enter(beyond->second);
    }
  }
  if (std::find(used.begin(), used.end(), 0) != used.end()) return {};
  std::sort(out.begin(), out.end());
  return out;
}

double cell_area(const SphereMesh& mesh, Index site, CellMeasure measure) {
  return measure == CellMeasure::solid_angle ? mesh.solid_angle(site) : mesh.gnomonic_area(site);
}

}  // namespace

Result<MinkowskiResult> minkowski(const SphereMesh& mesh, const BoundaryData& boundary,
                                  std::vector<double> start, const std::vector<double>& curvature,
                                  CellMeasure measure, const CancelToken& cancel) {
  if (mesh.inner_count() == 0) return MinkowskiResult{std::move(start), mesh.triangles(), 0, 0, false};
  Vector targets(mesh.inner_count());
  for (Index i = 0; i < mesh.inner_count(); ++i) {
    const Index site = mesh.boundary_count() + i;
    targets[i] = cell_area(mesh, site, measure) / curvature[site];
  }
  return Newton(mesh, boundary, std::move(start), std::move(targets)).run(cancel);
}

std::vector<double> spread_curvature(const SphereMesh& mesh, const std::vector<double>& boundary_curvature) {
  std::vector<double> out = boundary_curvature;
  out.resize(mesh.site_count());
  const Index first = mesh.boundary_count();
  if (mesh.inner_count() == 0) return out;
  SparseEntries entries;
  Vector right = Vector::Zero(mesh.inner_count());
  for (const auto& triangle : mesh.triangles())
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = triangle[k], b = triangle[(k + 1) % 3];
      const Vector3 &c = mesh.site(triangle[(k + 2) % 3]), u = mesh.site(a) - c, v = mesh.site(b) - c;
      const double weight = u.dot(v) / u.cross(v).norm() / 2;
      for (const auto& [i, j] : {std::pair{a, b}, std::pair{b, a}}) {
        if (i < first) continue;
        entries.emplace_back(i - first, i - first, weight);
        if (j < first)
          right[i - first] += weight * std::log(boundary_curvature[j]);
        else
          entries.emplace_back(i - first, j - first, -weight);
      }
    }
  const SparseCholesky solver(sparse_matrix(mesh.inner_count(), mesh.inner_count(), entries));
  const Vector logarithms = solver.solve(right);
  for (Index i = 0; i < mesh.inner_count(); ++i) out[first + i] = std::exp(logarithms[i]);
  return out;
}

Result<std::vector<double>> closing_curvature(const SphereMesh& mesh, const BoundaryData& boundary,
                                              std::vector<double> curvature) {
  Matrix3 system = Matrix3::Zero();
  Vector3 right = Vector3::Zero();
  for (Index i = 0; i < mesh.boundary_count(); ++i)
    right += boundary.points[i].cross(boundary.points[mesh.next(i)]) / 2;
  for (Index i = 0; i < mesh.site_count(); ++i) {
    const double area = mesh.solid_angle(i) / curvature[i];
    system += area * mesh.site(i) * mesh.site(i).transpose();
    right -= area * mesh.site(i);
  }
  const Vector3 factor = solve_symmetric(system, right);
  Index worst = 0;
  for (Index i = 0; i < mesh.site_count(); ++i) {
    const double change = 1 + factor.dot(mesh.site(i));
    if (!(change >= 1 + factor.dot(mesh.site(worst)))) worst = i;
    curvature[i] /= change;
  }
  if (!(1 + factor.dot(mesh.site(worst)) > 0.2))
    return make_error(e_curvature_incompatible,
                      "No surface through the outline has curvature like that along the outline.",
                      "Use the mode curvature, or give the curvature inside.", boundary_element(mesh, worst));
  return curvature;
}

}  // namespace hariko
