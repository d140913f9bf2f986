#include "core/drawing/surface_grid.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/index_list.hpp"
#include "core/drawing/facet_curves.hpp"

namespace hariko {

namespace {

constexpr int coarse_density = 4, finest_density = 128;
constexpr double wanted_edge = 4;  ///< length of a triangle's edge, page units
/// Safety factor: the error inside a triangle is larger than at the middles of its sides.
constexpr double chord_safety = 3;
constexpr double grazing_share = 0.2;  ///< least weight of edges that are seen end-on

/// Least number of intervals on a side. Three keep two edges of a patch that is joined to itself from having
/// the same two samples.
int least_density(const Surface& surface) {
  const auto to_itself = [](const Seam& seam) { return seam.first.patch == seam.second.patch; };
  return std::any_of(surface.seams().begin(), surface.seams().end(), to_itself) ? 3 : 2;
}

}  // namespace

SurfaceGrid::SurfaceGrid(const DrawnSurface& drawn, const DrawingView& view, std::size_t largest)
    : drawn_(drawn) {
  normals_to_world_ = drawn.transform.linear().inverse().transpose();
  choose_density(view, largest);
  triangles_ = pattern_.triangles();
  const Index count = drawn.surface.patch_count();
  positions_.resize(std::size_t(count) * std::size_t(pattern_.point_count()));
  normals_.resize(positions_.size());
  drawn.surface.patches().evaluate_grid(ascending_indices(count), pattern_, positions_, normals_);
  for (Vector3& p : positions_) p = world(p);
  for (Vector3& n : normals_) n = world_normal(n);
  measure_chords();
}

void SurfaceGrid::choose_density(const DrawingView& view, std::size_t largest) {
  const Surface& surface = drawn_.surface;
  // Flat facets need no subdivision.
  pattern_ = {surface.domain(), is_facets(surface) ? 1 : coarse_density};
  if (pattern_.density == 1) return;
  const std::vector<std::array<int, 3>> triangles = pattern_.triangles();
  std::vector<Vector3> positions(std::size_t(pattern_.point_count())), normals(positions.size());
  double longest = 0;
  for (Index patch = 0; patch < surface.patch_count(); ++patch) {
    surface.patches().evaluate_grid(std::span(&patch, 1), pattern_, positions, normals);
    std::vector<Vector3> page;
    for (const Vector3& p : positions) page.push_back(view.project(world(p)));
    for (const auto& triangle : triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t a = std::size_t(triangle[k]), b = std::size_t(triangle[(k + 1) % 3]);
        if (!view.in_front(page[a].z()) || !view.in_front(page[b].z())) continue;
        const double depth = std::min(page[a].z(), page[b].z());
        const double length = (world(positions[a]) - world(positions[b])).norm() *
                              (view.orthographic ? view.focal : view.focal / depth);
        longest = std::max({longest, (page[a] - page[b]).head<2>().norm(), grazing_share * length});
      }
  }
  // An edge cannot be larger than the page shows.
  longest = std::min(longest, view.width + view.height);
  const std::size_t patches = std::max<std::size_t>(1, surface.patch_count());
  const double most =
      std::sqrt(double(largest) / double(patches) / (surface.domain() == Domain::square ? 2 : 1));
  const double wanted = std::min(coarse_density * longest / wanted_edge, most);
  pattern_.density = std::clamp(int(std::ceil(wanted)), least_density(surface), finest_density);
}

void SurfaceGrid::measure_chords() {
  const int n = pattern_.density;
  double largest = 0;
  const auto measure = [&](const Vector3& a, const Vector3& b, const Vector3& c) {
    largest = std::max(largest, (a - 2 * b + c).squaredNorm());
  };
  for (Index patch = 0; patch < surface().patch_count(); ++patch)
    for (int j = 0; j <= n; ++j) {
      const int end = pattern_.domain == Domain::triangle ? n - j : n;
      for (int i = 1; i < end; ++i) {
        measure(position(patch, pattern_.index(i - 1, j)), position(patch, pattern_.index(i, j)),
                position(patch, pattern_.index(i + 1, j)));
        measure(position(patch, pattern_.index(j, i - 1)), position(patch, pattern_.index(j, i)),
                position(patch, pattern_.index(j, i + 1)));
      }
    }
  chord_error_ = chord_safety * std::sqrt(largest) / 8;
}

SurfaceGrid::Point SurfaceGrid::evaluate(Index patch, const Vector2& parameter) const {
  const PatchPoint point = surface().patches().evaluate(patch, parameter, Order::first);
  return {world(point.position), world_normal(surface().normal(patch, parameter))};
}

double SurfaceGrid::bending(Index patch, const Vector2& parameter, const Vector3& direction) const {
  const PatchPoint point = surface().patches().evaluate(patch, parameter, Order::second);
  const Matrix3 linear = drawn_.transform.linear();
  const Vector3 ds = linear * point.ds, dt = linear * point.dt;
  const double ss = ds.squaredNorm(), st = ds.dot(dt), tt = dt.squaredNorm(), det = ss * tt - st * st;
  if (!(det > 0)) return 0;
  const double ps = ds.dot(direction), pt = dt.dot(direction);
  const double a = (tt * ps - st * pt) / det, b = (ss * pt - st * ps) / det;
  const Vector3 second = linear * (a * a * point.dss + 2 * a * b * point.dst + b * b * point.dtt);
  return second.dot(world_normal(surface().normal(patch, parameter)));
}

}  // namespace hariko
