#include "core/envelope/surface_dips.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.hpp"
#include "core/base/parallel.hpp"
#include "core/envelope/grid_summit.hpp"

namespace hariko {

namespace {

constexpr int refinements = 3;  ///< of the grid round a summit
/// A summit half a cell away each way is higher by a quarter of the second differences; half more where cells
/// are large.
constexpr double largest_rise = 0.375;
constexpr int halvings = 30;  ///< towards the surface of a solid
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// How far it is from a point inside to the solid's surface.
double way_out(const PlacedSolid& solid, const Vector3& from, const Vector3& direction) {
  const auto is_inside = [&](double way) { return solid.depth_with_body(from + way * direction) > 0; };
  double low = 0, high = 1e-6 * solid.reach;
  while (is_inside(high)) low = high, high *= 2;
  for (int round = 0; round < halvings; ++round) {
    const double middle = 0.5 * (low + high);
    (is_inside(middle) ? low : high) = middle;
  }
  return low;
}

class DipFinder {
 public:
  DipFinder(const Surface& surface, const TriangleMesh& mesh, int density,
            std::span<const PlacedSolid> solids, double least)
      : surface_(surface),
        mesh_(mesh),
        solids_(solids),
        least_(least),
        pattern_{surface.domain(), density},
        triangles_of_patch_(mesh.triangles.size() / surface.patch_count()) {
    const auto triangles = pattern_.triangles();
    corner_of_point_.resize(std::size_t(pattern_.point_count()));
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t c = 0; c < 3; ++c) corner_of_point_[std::size_t(triangles[t][c])] = {t, c};
  }

  std::vector<SurfaceDip> of_patch(Index patch) const {
    std::vector<Vector3> at;
    Vector3 low = Vector3::Constant(1e300), high = -low;
    for (const auto& [triangle, corner] : corner_of_point_) {
      at.push_back(mesh_.positions[mesh_.triangles[patch * triangles_of_patch_ + triangle][corner]]);
      low = low.cwiseMin(at.back());
      high = high.cwiseMax(at.back());
    }
    const double cell = longest_step(at);
    std::vector<SurfaceDip> out;
    std::vector<double> depth(at.size());
    for (Index s = 0; s < solids_.size(); ++s) {
      const PlacedSolid& solid = solids_[s];
      const double far = solid.reach + solid.body.norm() + 0.5 * (high - low).norm();
      if ((0.5 * (low + high) - solid.centre).squaredNorm() > far * far) continue;
      for (std::size_t i = 0; i < at.size(); ++i) depth[i] = solid.level(at[i]);
      add_dips(patch, s, depth, cell, out);
    }
    return out;
  }

 private:
  bool is_node(int i, int j) const {
    const int n = pattern_.density;
    return i >= 0 && j >= 0 && j <= n && (pattern_.domain == Domain::triangle ? i + j <= n : i <= n);
  }

  /// Between nodes that are neighbours in a row or column.
  double longest_step(const std::vector<Vector3>& at) const {
    double square = 0;
    for (int j = 0; j <= pattern_.density; ++j)
      for (int i = 0; is_node(i, j); ++i)
        for (const auto& [column, row] : {std::pair(i + 1, j), std::pair(i, j + 1)})
          if (is_node(column, row))
            square = std::max(
                square, (at[std::size_t(pattern_.index(column, row))] - at[std::size_t(pattern_.index(i, j))])
                            .squaredNorm());
    return std::sqrt(square);
  }

  /// `cell`: the longest step between neighbours. No depth changes by more than twice that from a node to
  /// what is nearer to it than to others.
  void add_dips(Index patch, Index s, const std::vector<double>& depth, double cell,
                std::vector<SurfaceDip>& out) const {
    const int n = pattern_.density;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; is_node(i, j); ++i) {
        const double own = depth[std::size_t(pattern_.index(i, j))];
        if (own + 2 * cell <= least_) continue;
        NeighbourValues values;
        for (int k = 0; k < 9; ++k) {
          const int column = i + k % 3 - 1, row = j + k / 3 - 1;
          values[std::size_t(k)] =
              is_node(column, row) ? depth[std::size_t(pattern_.index(column, row))] : missing;
        }
        if (std::ranges::any_of(values, [&](double other) { return other > own; })) continue;
        if (own + largest_rise * bend_near(depth, i, j) > least_)
          add_dip(patch, s, (Vector2(i, j) + summit_beside(values).offset) / n, out);
      }
  }

  /// The larger second difference of the depths, downwards, at the node or the nearest one inside of the
  /// patch.
  double bend_near(const std::vector<double>& depth, int i, int j) const {
    const int n = pattern_.density;
    i = std::clamp(i, 1, n - 1);
    j = std::clamp(j, 1, n - 1);
    while (!is_node(i + 1, j) || !is_node(i, j + 1)) --(i > j ? i : j);
    const auto at = [&](int column, int row) { return depth[std::size_t(pattern_.index(column, row))]; };
    return 2 * at(i, j) - std::min(at(i - 1, j) + at(i + 1, j), at(i, j - 1) + at(i, j + 1));
  }

  /// What there is of a dip beside this place of the patch.
  void add_dip(Index patch, Index s, const Vector2& start, std::vector<SurfaceDip>& out) const {
    const PlacedSolid& solid = solids_[s];
    const auto depth_at = [&](const Vector2& place) {
      return solid.level(surface_.patches().evaluate(patch, place, Order::first).position);
    };
    Vector2 place = start;
    double deepest = depth_at(place), step = 0.5 / pattern_.density;
    for (int round = 0; round < refinements; ++round, step *= 0.5) {
      const Vector2 middle = place;
      const auto take_deeper = [&](const Vector2& other, double depth) {
        if (depth > deepest) place = other, deepest = depth;
      };
      NeighbourValues values;
      values[4] = deepest;
      for (int k = 0; k < 9; ++k) {
        if (k == 4) continue;
        const Vector2 beside = middle + step * Vector2(k % 3 - 1, k / 3 - 1);
        values[std::size_t(k)] = contains(beside) ? depth_at(beside) : missing;
        take_deeper(beside, values[std::size_t(k)]);
      }
      const Vector2 summit = middle + step * summit_beside(values).offset;
      take_deeper(summit, depth_at(summit));
    }
    if (!(deepest > 0)) return;
    const Vector3 from = surface_.patches().evaluate(patch, place, Order::first).position;
    const Vector3 normal = surface_.normal(patch, place);
    if (normal.isZero(0)) return;
    if (const double way = way_out(solid, from, normal); way > least_)
      out.push_back({patch, s, from, normal, way});
  }

  bool contains(const Vector2& place) const {
    const bool positive = place.minCoeff() >= 0;
    return positive && (pattern_.domain == Domain::triangle ? place.sum() <= 1 : place.maxCoeff() <= 1);
  }

  const Surface& surface_;
  const TriangleMesh& mesh_;
  std::span<const PlacedSolid> solids_;
  double least_;
  GridPattern pattern_;
  std::size_t triangles_of_patch_;
  std::vector<std::pair<std::size_t, std::size_t>> corner_of_point_;  ///< a triangle of the patch, its corner
};

}  // namespace

std::vector<SurfaceDip> surface_dips(const Surface& surface, const TriangleMesh& mesh, int density,
                                     std::span<const PlacedSolid> solids, double least,
                                     const CancelToken& cancel) {
  HARIKO_ASSERT(density >= 4, "too few vertices to see how depths change");
  if (mesh.triangles.empty()) return {};
  const DipFinder finder(surface, mesh, density, solids, least);
  std::vector<std::vector<SurfaceDip>> found(surface.patch_count());
  parallel_for(found.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end && !cancel.cancelled(); ++p) found[p] = finder.of_patch(Index(p));
  });
  std::vector<SurfaceDip> out;
  for (const auto& some : found) out.insert(out.end(), some.begin(), some.end());
  return out;
}

}  // namespace hariko
