#include "core/approximation/decimation/offset_vertices.hpp"

#include <algorithm>
#include <cmath>

#include "core/approximation/decimation/optimise.hpp"
#include "core/approximation/refinement/bisection.hpp"
#include "core/approximation/refinement/facet_error.hpp"
#include "core/approximation/refinement/split_rule.hpp"
#include "core/approximation/surface_projector.hpp"
#include "core/base/parallel.hpp"
#include "core/base/solvers/sparse_solver.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

namespace {

constexpr int curvature_grid = 8;
constexpr int row_grid = 6;     ///< intervals per side of a facet between the rows of the system
constexpr int border_rows = 8;  ///< intervals of a border edge
constexpr std::array factors{1.78, 1.7, 1.66, 1.62, 1.58, 1.5, 1.35};
constexpr int most_cuts = 16;  ///< cuts of facets that are above the tolerance after balancing
/// Powers of the sums that approximate the maximum; each is minimised by a few weighted least squares.
constexpr std::array powers{2, 4, 8, 16, 32, 64};
constexpr int solves_a_power = 6;
/// Largest distance of vertices from the surface, relative to the tolerance.
constexpr double farthest = 0.99;

/// Minimisation of the largest distance by offsets of the vertices along their normals.
class Balance {
 public:
  Balance(const SurfaceSampler& sampler, ParameterMesh& mesh) : sampler_(sampler), mesh_(mesh) {
    start_ = mesh.positions;
    offset_.assign(start_.size(), 0.0);
    find_normals();
    for (Index f = 0; f < mesh.facets.size(); ++f) {
      if (mesh.facets[f].degenerate()) continue;
      add_facet(f);
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (mesh.twin[h] == no_index) add_border(h);
    }
  }

  /// Moves the vertices, none farther than `most`, a length.
  void solve(double most) {
    for (const int power : powers)
      for (int round = 0; round < solves_a_power; ++round) improve(power, most);
  }

 private:
  /// Point of the surface over a facet (or a border edge), with its barycentric coordinates there.
  struct Row {
    Vector3 point;
    std::array<Index, 3> vertex;
    std::array<double, 3> weight;
    bool border;
  };

  void find_normals() {
    normal_.assign(start_.size(), Vector3::Zero());
    for (const ParameterFacet& facet : mesh_.facets) {
      if (facet.degenerate()) continue;
      std::array<Vector3, 3> at;
      sampler_.normals(facet.patch, facet.parameter, at);
      for (std::size_t c = 0; c < 3; ++c) normal_[facet.vertex[c]] += at[c];
    }
    for (Vector3& n : normal_)
      if (n.norm() > 0) n.normalize();
  }
  void add_facet(Index f) {
    const ParameterPieces pieces = pieces_of(mesh_.facets[f]);
    const BarycentricGrid grid(row_grid);
    std::vector<Vector2> parameters(grid.points.size());
    std::vector<Vector3> points(grid.points.size());
    // The coordinates of a pole's second triangle are those of its base point; the first triangle is enough.
    for (std::size_t k = 0; k < grid.points.size(); ++k)
      parameters[k] = at_barycentric(pieces.triangle[0], grid.points[k].x(), grid.points[k].y());
    sampler_.positions(mesh_.facets[f].patch, parameters, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double b = grid.points[k].x(), c = grid.points[k].y();
      rows_.push_back({points[k], mesh_.facets[f].vertex, {1 - b - c, b, c}, false});
    }
  }
  void add_border(Index h) {
    const ParameterLine line = mesh_.line(h);
    for (int i = 0; i <= border_rows; ++i) {
      const double t = double(i) / border_rows;
      rows_.push_back({sampler_.position(line.patch, line.at(t)),
                       {mesh_.from(h), mesh_.to(h), mesh_.to(h)},
                       {1 - t, t, 0},
                       true});
    }
  }
  /// Height of the point above its facet, or distance beside its edge, and the direction in which it is
  /// measured.
  std::pair<double, Vector3> height(const Row& row) const {
    const Vector3 &a = mesh_.positions[row.vertex[0]], &b = mesh_.positions[row.vertex[1]];
    if (!row.border) {
      const Vector3 normal = facet_normal(a, b, mesh_.positions[row.vertex[2]]);
      return {(row.point - a).dot(normal), normal};
    }
    const Vector3 edge = (b - a).normalized();
    Vector3 across = row.point - a;
    across -= across.dot(edge) * edge;
    const double distance = across.norm();
    if (!(distance > 0)) return {0, normal_[row.vertex[0]]};
    // Sign by the outward side of the surface.
    const Vector3 outward = row.weight[0] * normal_[row.vertex[0]] + row.weight[1] * normal_[row.vertex[1]];
    const double sign = across.dot(outward) < 0 ? -1 : 1;
    return {sign * distance, sign / distance * across};
  }
  void improve(int power, double most) {
    std::vector<std::pair<double, Vector3>> heights(rows_.size());
    double largest = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      heights[k] = height(rows_[k]);
      largest = std::max(largest, std::abs(heights[k].first));
    }
    if (!(largest > 0)) return;
    const auto count = static_cast<Eigen::Index>(start_.size());
    SparseEntries entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    double sum = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const Row& row = rows_[k];
      const double weight = std::max(std::pow(std::abs(heights[k].first) / largest, power - 2), 1e-9);
      std::array<double, 3> slope;
      for (std::size_t c = 0; c < 3; ++c)
        slope[c] = row.weight[c] * normal_[row.vertex[c]].dot(heights[k].second);
      for (std::size_t i = 0; i < 3; ++i) {
        right[row.vertex[i]] += weight * slope[i] * heights[k].first;
        for (std::size_t j = 0; j < 3; ++j) {
          entries.emplace_back(int(row.vertex[i]), int(row.vertex[j]), weight * slope[i] * slope[j]);
          if (i == j) sum += weight * slope[i] * slope[j];
        }
      }
    }
    for (Eigen::Index v = 0; v < count; ++v) entries.emplace_back(int(v), int(v), 1e-6 * sum / double(count));
    const SparseCholesky solver(sparse_matrix(count, count, entries));
    if (!solver.succeeded()) return;
    const Eigen::VectorXd change = solver.solve(right);
    if (!change.allFinite()) return;
    // Step length of Newton's method for this power.
    const double step = 1.0 / (power - 1);
    for (std::size_t v = 0; v < start_.size(); ++v) {
      offset_[v] = std::clamp(offset_[v] + step * change[Eigen::Index(v)], -most, most);
      mesh_.positions[v] = start_[v] + offset_[v] * normal_[v];
    }
  }

  const SurfaceSampler& sampler_;
  ParameterMesh& mesh_;
  std::vector<Vector3> start_, normal_;
  std::vector<double> offset_;
  std::vector<Row> rows_;
};

/// Facet of a balanced mesh with the largest error, measured in both directions.
struct Worst {
  double error = 0;  ///< relative to the tolerance
  Index facet = no_index;
};
Worst worst_facet(const FacetErrors& errors, const SurfaceProjector& feet, const ParameterMesh& mesh,
                  double tolerance) {
  const BarycentricGrid grid(row_grid);
  std::vector<double> error(mesh.facets.size(), 0.0);
  parallel_for(mesh.facets.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      if (mesh.facets[f].degenerate()) continue;
      error[f] = errors.relative_error(mesh, Index(f));
      const auto p = mesh.corners(Index(f));
      for (const Vector2& at : grid.points) {
        const Vector3 q = p[0] + at.x() * (p[1] - p[0]) + at.y() * (p[2] - p[0]);
        error[f] = std::max(error[f], feet.foot(q).distance / tolerance);
      }
    }
  });
  Worst out;
  for (Index f = 0; f < error.size(); ++f)
    if (error[f] > out.error) out = {error[f], f};
  return out;
}

/// Cuts the facet's most strongly curved edge, at half of its curvature integral.
bool cut(const SurfaceSampler& sampler, ParameterMesh& mesh, Index facet) {
  Index best = no_index;
  EdgeSplit split;
  for (Index h = 3 * facet; h < 3 * facet + 3; ++h) {
    const EdgeSplit own = edge_split(sampler, mesh, h, SplitRule::curvature);
    if (own.priority > split.priority) split = own, best = h;
  }
  if (best == no_index || split.priority < 0) return false;
  const ParameterLine line = mesh.canonical_line(best);
  mesh.split(best, split.parameter, sampler.position(line.patch, line.at(split.parameter)));
  return true;
}

}  // namespace

bool bends_one_way(const SurfaceSampler& sampler) {
  const Surface& surface = sampler.surface();
  const std::vector<Vector2> parameters = GridPattern{surface.domain(), curvature_grid}.parameters();
  int side = 0;
  for (Index p = 0; p < surface.patch_count(); ++p)
    for (const Vector2& at : parameters) {
      const PatchPoint q = sampler.second_order(p, at);
      const Vector3 normal = unit_normal(q);
      if (normal.isZero(0)) continue;  // normal undefined at a pole
      const double l = q.dss.dot(normal), m = q.dst.dot(normal), n = q.dtt.dot(normal);
      if (!(l * n - m * m > 0)) return false;
      const int own = l > 0 ? 1 : -1;
      if (side != 0 && own != side) return false;
      side = own;
    }
  return side != 0;
}

std::optional<ParameterMesh> balanced_mesh(const SurfaceSampler& sampler, const MeshOptions& options,
                                           const CancelToken& cancel, const Progress& progress) {
  const MeshCriteria& criteria = options.criteria;
  MeshCriteria others = criteria;
  others.distance.reset();
  if (!criteria.distance || others.any() || !bends_one_way(sampler)) return std::nullopt;
  const double tolerance = *criteria.distance;
  const FacetErrors errors(sampler, criteria);
  const SurfaceProjector feet(sampler);
  std::optional<ParameterMesh> best;
  double done = 0;
  for (const double factor : factors) {
    MeshOptions wider = options;
    wider.criteria.distance = factor * tolerance;
    const Progress part = progress.part(done / factors.size(), (done + 1) / factors.size());
    ++done;
    ParameterMesh start = optimised_mesh(sampler, wider, cancel, part);
    const BisectionResult refined =
        bisect(sampler, FacetErrors(sampler, wider.criteria), wider, start, cancel);
    if (cancel.cancelled() || refined.limit_reached) return std::nullopt;
    for (int cuts = 0; cuts <= most_cuts && !(best && start.facets.size() >= best->facets.size()); ++cuts) {
      ParameterMesh mesh = start;
      Balance(sampler, mesh).solve(farthest * tolerance);
      const Worst worst = worst_facet(errors, feet, mesh, tolerance);
      if (worst.error <= 1) best = std::move(mesh);
      if (worst.error <= 1 || !cut(sampler, start, worst.facet)) break;
    }
  }
  return best;
}

}  // namespace hariko
