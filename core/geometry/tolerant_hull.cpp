#include "core/geometry/tolerant_hull.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/index_list.hpp"
#include "core/base/solvers/small_solver.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

namespace {

/// Flatness limit of a vertex: least eigenvalue of the area-weighted mean of n n^T over the facets around it
/// (n: unit normals), a squared sine.
constexpr double flat_share = 1e-14;

struct Facet {
  std::array<Index, 3> corner{};
  std::array<Index, 3> across{};  ///< facet beyond the side from corner i to corner i + 1
  Vector3 normal = Vector3::Zero();
  double offset = 0;
  std::vector<Index> outside;
  bool alive = true;
};

/// Quickhull. Each round takes the farthest point of a facet, so that points inside faces come last.
class Quickhull {
 public:
  Quickhull(std::span<const Vector3> points, std::span<const Index> use, double tolerance)
      : points_(points), use_(use), tolerance_(tolerance) {}

  std::vector<std::array<Index, 3>> make() {
    if (!start()) return {};
    // New facets come last and take over the points, so facets before f receive none.
    for (Index f = 0; f < facets_.size(); ++f)
      while (facets_[f].alive && !facets_[f].outside.empty()) take(f);
    std::vector<std::array<Index, 3>> out;
    for (const Facet& facet : facets_)
      if (facet.alive) out.push_back(facet.corner);
    return out;
  }

 private:
  double height(const Facet& facet, Index p) const { return facet.normal.dot(points_[p]) - facet.offset; }

  Index add(Index a, Index b, Index c) {
    Facet facet;
    facet.corner = {a, b, c};
    facet.normal = area_vector(points_[a], points_[b], points_[c]).stableNormalized();
    facet.offset = facet.normal.dot(points_[a] + points_[b] + points_[c]) / 3;
    facets_.push_back(std::move(facet));
    return Index(facets_.size() - 1);
  }

  bool start() {
    if (use_.size() < 4) return false;
    const auto farthest = [&](auto&& measure) {
      Index best = use_[0];
      double most = -1;
      for (const Index p : use_)
        if (const double m = measure(points_[p]); m > most) most = m, best = p;
      return std::pair{best, most};
    };
    Vector3 mean = Vector3::Zero();
    for (const Index p : use_) mean += points_[p] / double(use_.size());
    const Index a = farthest([&](const Vector3& p) { return (p - mean).squaredNorm(); }).first;
    const Index b = farthest([&](const Vector3& p) { return (p - points_[a]).squaredNorm(); }).first;
    const Vector3 line = (points_[b] - points_[a]).stableNormalized();
    const auto [c, width] = farthest([&](const Vector3& p) { return (p - points_[a]).cross(line).norm(); });
    if (!(width > tolerance_)) return false;
    const Vector3 normal = line.cross(points_[c] - points_[a]).stableNormalized();
    const auto [d, depth] =
        farthest([&](const Vector3& p) { return std::abs((p - points_[a]).dot(normal)); });
    if (!(depth > tolerance_)) return false;
    const bool above = (points_[d] - points_[a]).dot(normal) > 0;
    const std::array<Index, 3> base = above ? std::array{a, c, b} : std::array{a, b, c};
    const Index f0 = add(base[0], base[1], base[2]);
    const Index f1 = add(base[1], base[0], d), f2 = add(base[2], base[1], d), f3 = add(base[0], base[2], d);
    facets_[f0].across = {f1, f2, f3};
    facets_[f1].across = {f0, f3, f2};
    facets_[f2].across = {f0, f1, f3};
    facets_[f3].across = {f0, f2, f1};
    for (const Index p : use_)
      if (p != a && p != b && p != c && p != d) assign(p, {f0, f1, f2, f3});
    return true;
  }

  void assign(Index p, std::span<const Index> among) {
    Index best = no_index;
    double most = tolerance_;
    for (const Index f : among)
      if (const double h = height(facets_[f], p); h > most) most = h, best = f;
    if (best != no_index) facets_[best].outside.push_back(p);
  }
  void assign(Index p, std::initializer_list<Index> among) {
    assign(p, std::span(among.begin(), among.size()));
  }

  /// Adds the farthest point of a facet.
  void take(Index f) {
    Index apex = facets_[f].outside[0];
    double most = -1;
    for (const Index p : facets_[f].outside)
      if (const double h = height(facets_[f], p); h > most || (h == most && p < apex)) most = h, apex = p;
    std::vector<Index> seen{f};
    std::vector<char> visible(facets_.size(), 0);
    visible[f] = 1;
    for (std::size_t k = 0; k < seen.size(); ++k)
      for (const Index g : facets_[seen[k]].across)
        if (!visible[g] && height(facets_[g], apex) > 1e-3 * tolerance_) visible[g] = 1, seen.push_back(g);
    // Horizon as a map: from corner a to corner b and the facet beyond the side ab.
    std::map<Index, std::pair<Index, Index>> horizon;
    for (const Index g : seen)
      for (std::size_t i = 0; i < 3; ++i)
        if (const Index beyond = facets_[g].across[i]; !visible[beyond])
          if (!horizon.try_emplace(facets_[g].corner[i], facets_[g].corner[(i + 1) % 3], beyond).second)
            return drop(f, apex);
    std::vector<Index> fresh;
    Index at = horizon.begin()->first;
    const Index first = at;
    std::vector<std::array<Index, 3>> loop;  // a, b, beyond
    do {
      const auto found = horizon.find(at);
      if (found == horizon.end() || loop.size() > horizon.size()) return drop(f, apex);
      loop.push_back({at, found->second.first, found->second.second});
      at = found->second.first;
    } while (at != first);
    if (loop.size() != horizon.size()) return drop(f, apex);
    for (const auto& [a, b, beyond] : loop) {
      const Index g = add(a, b, apex);
      fresh.push_back(g);
      facets_[g].across[0] = beyond;
      for (std::size_t i = 0; i < 3; ++i)
        if (facets_[beyond].corner[i] == b && facets_[beyond].corner[(i + 1) % 3] == a)
          facets_[beyond].across[i] = g;
    }
    for (std::size_t k = 0; k < fresh.size(); ++k) {
      facets_[fresh[k]].across[1] = fresh[(k + 1) % fresh.size()];
      facets_[fresh[k]].across[2] = fresh[(k + fresh.size() - 1) % fresh.size()];
    }
    for (const Index g : seen) {
      facets_[g].alive = false;
      for (const Index p : facets_[g].outside)
        if (p != apex) assign(p, fresh);
      facets_[g].outside.clear();
    }
  }
  /// Drops a point whose visible facets are not a disk because of rounding: it lies on the hull within
  /// rounding.
  void drop(Index f, Index apex) { std::erase(facets_[f].outside, apex); }

  std::span<const Vector3> points_;
  std::span<const Index> use_;
  double tolerance_;
  std::vector<Facet> facets_;
};

std::vector<Index> used(const std::vector<std::array<Index, 3>>& triangles) {
  std::vector<Index> out;
  for (const auto& t : triangles) out.insert(out.end(), t.begin(), t.end());
  sort_unique(out);
  return out;
}

/// Vertices in the middle of a face or an edge of the hull: the planes around them do not form a corner.
std::vector<Index> flat_vertices(std::span<const Vector3> points,
                                 const std::vector<std::array<Index, 3>>& triangles) {
  struct Normals {
    Matrix3 products = Matrix3::Zero();
    double area = 0;
  };
  std::map<Index, Normals> around;
  for (const auto& t : triangles) {
    const Vector3 n = area_vector(points[t[0]], points[t[1]], points[t[2]]);
    const double area = n.norm();
    if (!(area > 0)) continue;
    for (const Index v : t) {
      around[v].products += n * n.transpose() / area;
      around[v].area += area;
    }
  }
  std::vector<Index> out;
  for (const auto& [v, normals] : around) {
    const double least = symmetric_axes(normals.products / normals.area).values[0];
    if (!(least > flat_share)) out.push_back(v);
  }
  return out;
}

}  // namespace

TolerantHull tolerant_hull(std::span<const Vector3> points, double tolerance) {
  std::vector<Index> use = ascending_indices(points.size());
  TolerantHull out;
  for (int round = 0; round < 8; ++round) {
    out.triangles = Quickhull(points, use, tolerance).make();
    out.vertices = used(out.triangles);
    if (out.triangles.empty()) return out;
    // All points at the same position are removed: a duplicate would come up in the next round.
    std::set<std::array<double, 3>> flat;
    const auto place = [&](Index p) {
      return std::array<double, 3>{points[p].x(), points[p].y(), points[p].z()};
    };
    for (const Index v : flat_vertices(points, out.triangles)) flat.insert(place(v));
    if (flat.empty()) return out;
    std::erase_if(use, [&](Index p) { return flat.contains(place(p)); });
  }
  return out;
}

bool is_convex(std::span<const Vector3> points) {
  if (points.empty()) return true;
  Vector3 low = points[0], high = low;
  for (const Vector3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double size = (high - low).norm();
  std::vector<double> depth(points.size(), 1e300);
  for (const auto& t : tolerant_hull(points, 1e-9 * size).triangles) {
    const Vector3 n = area_vector(points[t[0]], points[t[1]], points[t[2]]).stableNormalized();
    for (std::size_t i = 0; i < points.size(); ++i)
      depth[i] = std::min(depth[i], n.dot(points[t[0]] - points[i]));
  }
  return std::all_of(depth.begin(), depth.end(), [&](double d) { return d <= 1e-6 * size || d == 1e300; });
}

}  // namespace hariko
