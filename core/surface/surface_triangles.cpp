#include "core/surface/surface_triangles.hpp"

#include <algorithm>
#include <utility>

#include "core/base/assert.hpp"
#include "core/base/index_list.hpp"
#include "core/base/parallel.hpp"
#include "core/surface/adjacency.hpp"

namespace hariko {

namespace {

constexpr std::size_t gridded_patches_per_task = 16;

/// Whether a side is a point, to 1e-9 of its patch.
bool is_shrunk(const Surface& surface, const PatchSide& side) {
  const auto at = [&](double x) {
    return surface.patches()
        .evaluate(side.patch, side_parameter(surface.domain(), side.side, x), Order::first)
        .position;
  };
  const Vector3 begin = at(0);
  const double limit = 1e-9 * surface.patch_scale(side.patch);
  for (const double x : {0.25, 0.5, 0.75, 1.0})
    if ((at(x) - begin).norm() > limit) return false;
  return true;
}

/// Whether every side between two nodes has as many others in the opposite direction.
bool sides_pair_up(const Surface& surface) {
  const int corners = corner_count(surface.domain());
  std::vector<std::pair<Index, Index>> forward, backward;
  for (Index p = 0; p < surface.patch_count(); ++p)
    for (int c = 0; c < corners; ++c) {
      const Index from = surface.node(p, c), to = surface.node(p, (c + 1) % corners);
      if (from == to) continue;
      forward.emplace_back(from, to);
      backward.emplace_back(to, from);
    }
  std::sort(forward.begin(), forward.end());
  std::sort(backward.begin(), backward.end());
  return forward == backward;
}

}  // namespace

SurfaceTriangles surface_triangles(const Surface& surface, int density) {
  HARIKO_ASSERT(density >= 1, "at least one interval a side");
  SurfaceTriangles out;
  if (surface.patch_count() == 0) return out;
  const GridPattern pattern{surface.domain(), density};
  const auto local = pattern.triangles();
  const auto points = static_cast<std::size_t>(pattern.point_count());
  HARIKO_ASSERT(points * surface.patch_count() < no_index, "too many points for 32-bit indices");
  out.positions.resize(points * surface.patch_count());
  out.triangles.resize(local.size() * surface.patch_count());
  parallel_for(surface.patch_count(), gridded_patches_per_task, [&](std::size_t begin, std::size_t end) {
    const std::vector<Index> patches = ascending_indices(end - begin, static_cast<Index>(begin));
    std::vector<Vector3> normals(points * patches.size());
    surface.patches().evaluate_grid(
        patches, pattern, std::span<Vector3>(out.positions.data() + begin * points, normals.size()), normals);
    for (std::size_t p = begin; p < end; ++p)
      for (std::size_t t = 0; t < local.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c)
          out.triangles[p * local.size() + t][c] =
              static_cast<Index>(p * points + static_cast<std::size_t>(local[t][c]));
  });
  return out;
}

bool is_closed(const Surface& surface) {
  if (surface.patch_count() == 0) return false;
  if (surface.seams().empty()) return sides_pair_up(surface);
  const Adjacency adjacency(surface);
  return std::all_of(adjacency.boundary().begin(), adjacency.boundary().end(),
                     [&](const PatchSide& side) { return is_shrunk(surface, side); });
}

}  // namespace hariko
