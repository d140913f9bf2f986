#include "core/envelope/enclosure_check.hpp"

#include <algorithm>

#include "core/base/parallel.hpp"
#include "core/envelope/winding.hpp"

namespace hariko {

namespace {
constexpr int points_to_edge = 20;  ///< spread over a solid for one on each of its edges
}

EnclosureReport check_enclosure(const Surface& surface, std::span<const PlacedSolid> solids, int density,
                                int points, double slack, const CancelToken& cancel) {
  const TriangleMesh mesh = tessellate(surface, density, cancel);
  const WindingTree tree(mesh);
  std::vector<std::pair<Vector3, Index>> tested;
  for (Index s = 0; s < solids.size(); ++s) {
    for (const Vector3& p : solids[s].test_points) tested.emplace_back(p, s);
    for (const Vector3& p : solids[s].surface_points(points)) tested.emplace_back(p, s);
    for (const Vector3& p : solids[s].edge_points(points / points_to_edge)) tested.emplace_back(p, s);
  }
  std::vector<WindingTree::Nearest> miss(tested.size(), {0, no_index});
  parallel_for(tested.size(), 256, [&](std::size_t begin, std::size_t end) {
    if (cancel.cancelled()) return;
    for (std::size_t i = begin; i < end; ++i)
      if (tree.winding(tested[i].first) < 0.5) miss[i] = tree.nearest(tested[i].first);
  });
  EnclosureReport out;
  out.tested = tested.size();
  const std::size_t per_patch = mesh.triangles.size() / std::max<std::size_t>(1, surface.patch_count());
  for (std::size_t i = 0; i < tested.size(); ++i) {
    if (!(miss[i].distance > slack)) continue;
    ++out.outside;
    out.worst = std::max(out.worst, miss[i].distance);
    out.points.push_back(
        {tested[i].first, tested[i].second, Index(miss[i].triangle / per_patch), miss[i].distance});
  }
  return out;
}

}  // namespace hariko
