#include "core/approximation/decimation/decimate.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "core/approximation/decimation/collapsible_mesh.hpp"
#include "core/approximation/hausdorff_bound.hpp"
#include "core/approximation/luminance.hpp"
#include "core/base/index_list.hpp"
#include "core/base/parallel.hpp"
#include "core/geometry/angles.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

namespace {

constexpr double most_turn = 0.61;   ///< 35 degrees: largest turn of a facet's normal in one collapse
constexpr double long_edges = 1e-6;  ///< weight of a squared length relative to a squared distance
constexpr std::size_t elements_per_task = 256;
/// Factors of the tolerance. Collapses test points only; where the certain bound is larger, they are repeated
/// with a smaller tolerance.
constexpr std::array<double, 6> narrowings{1, 0.97, 0.9, 0.8, 0.6, 0.3};

Vector3 normal_of(const std::vector<Vector3>& p, const std::array<Index, 3>& t) {
  return facet_normal(p[t[0]], p[t[1]], p[t[2]]);
}

/// Dense mesh as the reference: its corners, and the centroids of its facets with their normals.
struct DenseMesh {
  std::vector<Vector3> positions;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Vector3> normals;  ///< normals of facets; zero without area
  TriangleTree tree;

  explicit DenseMesh(const TriangleMesh& mesh)
      : positions(mesh.positions), triangles(proper(mesh.triangles)), tree(positions, triangles) {
    for (const auto& t : triangles) normals.push_back(normal_of(positions, t));
  }
  static std::vector<std::array<Index, 3>> proper(const std::vector<std::array<Index, 3>>& all) {
    std::vector<std::array<Index, 3>> out;
    for (const auto& t : all)
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) out.push_back(t);
    return out;
  }
  /// Number of samples: first the centroids of the facets, then the corners.
  std::size_t sample_count() const { return triangles.size() + positions.size(); }
  Vector3 sample(Index s) const {
    if (s >= triangles.size()) return positions[s - triangles.size()];
    const auto& t = triangles[s];
    return (positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3;
  }
};

class Decimator {
 public:
  Decimator(const DenseMesh& dense, const MeshCriteria& criteria, double narrowing, const CancelToken& cancel)
      : dense_(dense),
        criteria_(criteria),
        brightness_(criteria.luminance_model),
        cancel_(cancel),
        mesh_(dense.positions, dense.triangles,
              criteria.fold_angle ? std::min(sharp_angle, *criteria.fold_angle) : sharp_angle),
        samples_(dense.triangles.size()),
        version_(dense.positions.size(), 0) {
    if (criteria_.distance) criteria_.distance = *criteria_.distance * narrowing;
    std::vector<char> placed(dense.positions.size(), 0);
    for (Index f = 0; f < dense.triangles.size(); ++f) {
      samples_[f].push_back(f);
      for (const Index v : dense.triangles[f]) {
        if (placed[v]) continue;
        placed[v] = 1;
        samples_[f].push_back(Index(dense.triangles.size()) + v);
      }
    }
    make_quadrics();
  }

  void run(const Progress& progress) {
    for (Index v = 0; v < version_.size(); ++v) push(v);
    std::vector<Index> touched;
    const auto total = double(mesh_.facet_count());
    while (!queue_.empty() && mesh_.facet_count() > 4 && !cancel_.cancelled()) {
      const Entry top = queue_.top();
      queue_.pop();
      if (top.version != version_[top.from] || !mesh_.may_collapse(top.from, top.to)) continue;
      mesh_.moved_facets(top.from, top.to, moved_);
      if (!good_shape(top.from) || !share_samples(top.from) || !near_dense(top.to) || !good_folds()) continue;
      mesh_.neighbours(top.from, touched);
      mesh_.collapse(top.from, top.to);
      for (std::size_t k = 0; k < moved_.size(); ++k) samples_[moved_[k].first].swap(shared_[k]);
      quadric_[top.to] += quadric_[top.from];
      std::vector<Index> around;
      mesh_.neighbours(top.to, around);
      touched.insert(touched.end(), around.begin(), around.end());
      sort_unique(touched);
      for (const Index v : touched) {
        ++version_[v];
        push(v);
      }
      progress.report(1 - double(mesh_.facet_count()) / total);
    }
  }

  /// Remaining mesh, with vertices renumbered.
  TriangleMesh result(const Vector3& origin) const {
    TriangleMesh out;
    out.origin = origin;
    std::vector<Index> number(dense_.positions.size(), no_index);
    for (Index f = 0; f < mesh_.triangles().size(); ++f) {
      if (!mesh_.alive(f)) continue;
      std::array<Index, 3> t = mesh_.triangles()[f];
      for (Index& v : t) {
        if (number[v] == no_index) {
          number[v] = Index(out.positions.size());
          out.positions.push_back(dense_.positions[v]);
        }
        v = number[v];
      }
      out.triangles.push_back(t);
    }
    return out;
  }

 private:
  struct Entry {
    double cost;
    Index from, to;
    std::uint32_t version;
    bool operator<(const Entry& other) const {
      return std::tie(cost, from, to) > std::tie(other.cost, other.from, other.to);
    }
  };
  using Quadric = Eigen::Matrix4d;

  void make_quadrics() {
    quadric_.assign(dense_.positions.size(), Quadric::Zero());
    const auto add = [&](Index v, const Vector3& normal, const Vector3& point) {
      const Eigen::Vector4d plane(normal.x(), normal.y(), normal.z(), -normal.dot(point));
      quadric_[v] += plane * plane.transpose();
    };
    for (std::size_t f = 0; f < dense_.triangles.size(); ++f) {
      const auto& t = dense_.triangles[f];
      const Vector3& normal = dense_.normals[f];
      for (std::size_t c = 0; c < 3; ++c) {
        const Index a = t[c], b = t[(c + 1) % 3];
        add(a, normal, dense_.positions[a]);
        if (!mesh_.kept_edge(a, b)) continue;
        // Kept edges are held in place by planes through them, across their facets.
        const Vector3 across = normal.cross(dense_.positions[b] - dense_.positions[a]);
        if (across.norm() > 0)
          for (const Index v : {a, b}) add(v, across.normalized(), dense_.positions[a]);
      }
    }
  }
  double cost(Index from, Index to) const {
    const Vector3& p = dense_.positions[to];
    const Eigen::Vector4d at(p.x(), p.y(), p.z(), 1);
    return std::max(0.0, at.dot(quadric_[from] * at)) +
           long_edges * (p - dense_.positions[from]).squaredNorm();
  }
  void push(Index v) {
    mesh_.neighbours(v, near_);
    for (const Index w : near_)
      if (mesh_.may_collapse(v, w)) queue_.push({cost(v, w), v, w, version_[v]});
  }

  bool good_shape(Index from) const {
    double smallest_before = 4, smallest_after = 4;
    for (const auto& [f, t] : moved_) {
      const Vector3 before = normal_of(mesh_.positions(), mesh_.triangles()[f]),
                    after = normal_of(mesh_.positions(), t);
      if (after.isZero(0) || before.dot(after) < (before.isZero(0) ? 0 : std::cos(most_turn))) return false;
      const TriangleCorners p = corners(t);
      if (criteria_.max_edge)
        for (std::size_t c = 0; c < 3; ++c)
          if ((p[(c + 1) % 3] - p[c]).norm() > *criteria_.max_edge) return false;
      smallest_after = std::min(smallest_after, smallest_angle(p));
    }
    if (!criteria_.min_angle || smallest_after >= *criteria_.min_angle) return true;
    for (const Index f : mesh_.round(from))
      smallest_before = std::min(smallest_before, smallest_angle(corners(mesh_.triangles()[f])));
    return smallest_after >= smallest_before;
  }
  TriangleCorners corners(const std::array<Index, 3>& t) const {
    return {mesh_.positions()[t[0]], mesh_.positions()[t[1]], mesh_.positions()[t[2]]};
  }

  /// Assigns each sample of the facets around the vertex to the nearest of the moved facets; false where one
  /// is too far, or has a normal that does not fit.
  bool share_samples(Index from) {
    closed_.clear();
    for (const auto& [f, t] : moved_) closed_.emplace_back(corners(t));
    if (closed_.empty()) return false;
    shared_.resize(std::max(shared_.size(), moved_.size()));
    for (std::size_t k = 0; k < moved_.size(); ++k) shared_[k].clear();
    const double limit = criteria_.distance ? *criteria_.distance * *criteria_.distance
                                            : std::numeric_limits<double>::infinity();
    for (const Index f : mesh_.round(from))
      for (const Index s : samples_[f]) {
        const Vector3 p = dense_.sample(s);
        std::size_t best = 0;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < moved_.size(); ++k) {
          const double d = closed_[k].squared_distance(p);
          if (d < nearest) nearest = d, best = k;
        }
        if (nearest > limit || !faces(s, closed_[best].normal())) return false;
        shared_[best].push_back(s);
      }
    return true;
  }
  bool faces(Index sample, const Vector3& facet) const {
    if (sample >= dense_.triangles.size()) return true;
    const Vector3& normal = dense_.normals[sample];
    if (normal.isZero(0)) return true;
    if (!(normal.dot(facet) > 0)) return false;
    if (criteria_.normal_angle && angle_between(normal, facet) > *criteria_.normal_angle) return false;
    if (criteria_.luminance)
      for (std::size_t light = 0; light < brightness_.lights(); ++light)
        if (std::abs(brightness_.of(normal, light) - brightness_.of(facet, light)) > *criteria_.luminance)
          return false;
    return true;
  }
  /// Whether points of the moved facets and of their edges from w are near the dense mesh.
  bool near_dense(Index to) const {
    if (!criteria_.distance) return true;
    const double limit = *criteria_.distance;
    const auto close = [&](const Vector3& p) { return dense_.tree.nearest(p, limit).triangle != no_index; };
    const Vector3& w = mesh_.positions()[to];
    for (const auto& [f, t] : moved_) {
      const TriangleCorners p = corners(t);
      if (!close((p[0] + p[1] + p[2]) / 3)) return false;
      for (std::size_t c = 0; c < 3; ++c) {
        if (t[c] == to) continue;
        for (const double x : {0.25, 0.5, 0.75})
          if (!close(w + x * (p[c] - w))) return false;
      }
    }
    return true;
  }
  /// Whether the folds between the moved facets, and between them and their neighbours, are small enough.
  bool good_folds() const {
    if (!criteria_.fold_angle) return true;
    const auto moved_as = [&](Index f) {
      for (const auto& [g, t] : moved_)
        if (g == f) return t;
      return mesh_.triangles()[f];
    };
    const auto has = [](const std::array<Index, 3>& t, Index v) {
      return std::find(t.begin(), t.end(), v) != t.end();
    };
    for (const auto& [facet, t] : moved_) {
      const Index f = facet;
      const Vector3 own = normal_of(mesh_.positions(), t);
      for (std::size_t c = 0; c < 3; ++c) {
        const Index a = t[c], b = t[(c + 1) % 3];
        if (mesh_.kept_edge(a, b)) continue;
        const auto folded = [&](Index g, const std::array<Index, 3>& other) {
          return g != f && has(other, a) && has(other, b) &&
                 angle_between(own, normal_of(mesh_.positions(), other)) > *criteria_.fold_angle;
        };
        for (const auto& [g, other] : moved_)
          if (folded(g, other)) return false;
        for (const Index v : {a, b})
          for (const Index g : mesh_.round(v))
            if (folded(g, moved_as(g))) return false;
      }
    }
    return true;
  }

  const DenseMesh& dense_;
  MeshCriteria criteria_;
  Brightness brightness_;
  const CancelToken& cancel_;
  CollapsibleMesh mesh_;
  std::vector<std::vector<Index>> samples_;  ///< per facet: the samples nearest to it
  std::vector<std::uint32_t> version_;
  std::vector<Quadric> quadric_;
  std::priority_queue<Entry> queue_;
  std::vector<Index> near_;
  std::vector<std::pair<Index, std::array<Index, 3>>> moved_;
  std::vector<ClosedTriangle> closed_;
  std::vector<std::vector<Index>> shared_;
};

double size_of(const DenseMesh& dense) {
  Eigen::AlignedBox3d box;
  for (const auto& t : dense.triangles)
    for (const Index v : t) box.extend(dense.positions[v]);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

void note(CriterionErrors& errors, Index facet, double value) {
  errors.facets[facet] = std::max(errors.facets[facet], float(value));
  if (errors.facet != no_index && !(value > errors.largest)) return;
  errors.largest = value;
  errors.facet = facet;
}

/// Measures the result at the dense mesh's corners and centroids and at points of the facets.
void measure(const DenseMesh& dense, const Brightness& brightness, bool luminance, MeshApproximation& out) {
  const std::vector<Vector3>& p = out.mesh.positions;
  const auto& triangles = out.mesh.triangles;
  const TriangleTree tree(p, triangles);
  const std::size_t count = dense.sample_count();
  std::vector<TriangleTree::Nearest> nearest(count);
  parallel_for(count, elements_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) nearest[s] = tree.nearest(dense.sample(Index(s)));
  });
  std::vector<double> back(triangles.size());
  parallel_for(triangles.size(), elements_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Vector3 &a = p[triangles[f][0]], &b = p[triangles[f][1]], &c = p[triangles[f][2]];
      for (const Vector3& q :
           {Vector3((a + b + c) / 3), Vector3((a + b) / 2), Vector3((b + c) / 2), Vector3((c + a) / 2)})
        back[f] = std::max(back[f], dense.tree.nearest(q).distance);
    }
  });
  for (CriterionErrors* errors : {&out.distance, &out.normal_angle, &out.fold_angle}) {
    errors->measured = true;
    errors->facets.assign(triangles.size(), 0.0F);
  }
  if (luminance) out.luminance = out.normal_angle;
  double angles = 0, differences = 0;
  for (Index s = 0; s < count; ++s) {
    note(out.distance, nearest[s].triangle, nearest[s].distance);
    out.distance.mean += nearest[s].distance / double(count);
    if (s >= dense.triangles.size() || dense.normals[s].isZero(0)) continue;
    const Vector3& facet = tree.triangle(nearest[s].triangle).normal();
    const double angle = angle_between(dense.normals[s], facet);
    note(out.normal_angle, nearest[s].triangle, angle);
    angles += angle;
    if (!luminance) continue;
    double worst = 0;
    for (std::size_t light = 0; light < brightness.lights(); ++light)
      worst = std::max(worst, std::abs(brightness.of(dense.normals[s], light) - brightness.of(facet, light)));
    note(out.luminance, nearest[s].triangle, worst);
    differences += worst;
  }
  for (Index f = 0; f < triangles.size(); ++f) note(out.distance, f, back[f]);
  out.normal_angle.mean = angles / double(dense.triangles.size());
  if (luminance) out.luminance.mean = differences / double(dense.triangles.size());
}

void measure_shapes(MeshApproximation& out) {
  const auto& triangles = out.mesh.triangles;
  const CollapsibleMesh mesh(out.mesh.positions, triangles, sharp_angle);
  const auto& p = out.mesh.positions;
  out.smallest_angle = 4;
  double sum = 0;
  std::size_t edges = 0;
  for (Index f = 0; f < triangles.size(); ++f) {
    const auto& t = triangles[f];
    for (std::size_t c = 0; c < 3; ++c) {
      const Index a = t[c], b = t[(c + 1) % 3];
      out.longest_edge = std::max(out.longest_edge, (p[b] - p[a]).norm());
      if (mesh.kept_edge(a, b)) continue;
      for (const Index g : mesh.round(a)) {
        if (g <= f || std::find(triangles[g].begin(), triangles[g].end(), b) == triangles[g].end()) continue;
        const double fold = angle_between(normal_of(p, t), normal_of(p, triangles[g]));
        note(out.fold_angle, f, fold);
        note(out.fold_angle, g, fold);
        sum += fold;
        ++edges;
      }
    }
    out.smallest_angle = std::min(out.smallest_angle, smallest_angle({p[t[0]], p[t[1]], p[t[2]]}));
  }
  if (edges > 0) out.fold_angle.mean = sum / double(edges);
}

}  // namespace

Result<MeshApproximation> decimate(const TriangleMesh& mesh, const MeshOptions& options,
                                   const CancelToken& cancel, const Progress& progress) {
  const DenseMesh dense(mesh);
  if (dense.triangles.empty())
    return make_error(e_mesh_nothing, "There is nothing to approximate.", "Select an object with facets.");
  const double size = size_of(dense);
  if (!(size > 0)) return make_error(e_mesh_surface, "The mesh is shrunk to a point.", "Give it a size.");
  if (auto error = check_criteria(options.criteria, size)) return *error;
  const auto cancelled = [] { return make_error(e_cancelled, "The meshing was cancelled."); };
  MeshApproximation out;
  // Without a tolerance for distances no bound is computed.
  const bool bounded = options.criteria.distance.has_value();
  double done = 0;
  for (const double narrowing : narrowings) {
    Decimator decimator(dense, options.criteria, narrowing, cancel);
    decimator.run(progress.part(done, done + 0.5 * (1 - done)));
    done += 0.5 * (1 - done);
    if (cancel.cancelled()) return cancelled();
    out.mesh = decimator.result(mesh.origin);
    if (!bounded) break;
    const double tolerance = *options.criteria.distance;
    const TriangleTree tree(out.mesh.positions, out.mesh.triangles);
    const MeshBound there = bounded_distance(dense.positions, dense.triangles, tree, out.mesh.positions,
                                             out.mesh.triangles, tolerance, cancel);
    if (!there.bound) continue;
    const MeshBound back = bounded_distance(out.mesh.positions, out.mesh.triangles, dense.tree,
                                            dense.positions, dense.triangles, tolerance, cancel);
    if (!back.bound) continue;
    out.distance.bound = std::max(*there.bound, *back.bound);
    out.distance.certified = true;
    break;
  }
  if (cancel.cancelled()) return cancelled();
  if (bounded && !out.distance.certified) {
    // Falls back to the dense mesh itself, at distance zero.
    out.mesh = {mesh.origin, dense.positions, dense.triangles, {}, {}};
    out.distance.certified = true;
  }
  const bool certified = out.distance.certified;
  const double bound = out.distance.bound;
  measure(dense, Brightness(options.criteria.luminance_model), options.criteria.luminance.has_value(), out);
  measure_shapes(out);
  out.distance.certified = certified;
  // The distance of samples does not exceed the certain bound, except for rounding.
  if (certified) out.distance.largest = std::min(out.distance.largest, bound);
  out.distance.bound = std::max(bound, out.distance.largest);
  for (CriterionErrors* errors : {&out.normal_angle, &out.fold_angle, &out.luminance})
    errors->bound = errors->largest;
  const std::optional<double>& angle = options.criteria.min_angle;
  const bool unreached =
      (options.criteria.max_edge && out.longest_edge > *options.criteria.max_edge) ||
      (options.criteria.fold_angle && out.fold_angle.largest > *options.criteria.fold_angle) ||
      (angle && out.smallest_angle < *angle);
  if (unreached)
    out.warnings.push_back(make_warning(
        w_mesh_unreached, "The mesh itself does not keep the tolerances, and it is never refined.",
        "Ask for larger ones."));
  progress.report(1);
  return out;
}

}  // namespace hariko
