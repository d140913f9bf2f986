#pragma once

// Paper models of test meshes, and an independent check of whole pages.

#include <memory>

#include "core/unfolding/unfolding.hpp"
#include "tests/unfolding/check_layout.hpp"
#include "tests/unfolding/meshes.hpp"

namespace hariko::test {

inline std::shared_ptr<const FacetGraph> shared_graph(const PolygonMesh& mesh) {
  auto graph = must(FacetGraph::build(mesh));
  return std::make_shared<const FacetGraph>(std::move(graph).value());
}

/// mm for one unit, so that the mesh is `size` mm along the axis.
inline double scale_for(const PolygonMesh& mesh, int axis, double size) {
  double low = 1e300, high = -1e300;
  for (const Vector3& p : mesh.positions) low = std::min(low, p[axis]), high = std::max(high, p[axis]);
  return size / (high - low);
}

inline CheckedLayout checked_layout(const Unfolding& unfolding) {
  CheckedLayout out{unfolding.settings.scale, unfolding.corners, unfolding.piece_of, {}, {}};
  for (Index f = 0; f < unfolding.corners.size(); ++f) out.sheet.push_back(unfolding.page_of(f));
  for (Index e = 0; e < unfolding.graph->edge_count(); ++e)
    if (unfolding.folds[e])
      out.folds.emplace_back(unfolding.graph->edge(e).facets[0], unfolding.graph->edge(e).facets[1]);
  return out;
}

/// Facets, tabs and strips: exact overlaps, margins, every joint with a tab or a strip.
inline void check_pages(const PolygonMesh& mesh, const Unfolding& unfolding) {
  check_layout(mesh, checked_layout(unfolding));
  const double tolerance = 1e-9 * unfolding.settings.scale * longest_edge_of(mesh);
  std::size_t joints = 0;
  for (Index e = 0; e < unfolding.graph->edge_count(); ++e)
    joints += !unfolding.graph->edge(e).border() && !unfolding.folds[e] ? 1 : 0;
  ASSERT_EQ(unfolding.joints.size(), joints);

  struct Extra {
    std::array<Vector2, 4> corners;
    Index page;
  };
  std::vector<Extra> extras;
  for (Index j = 0; j < unfolding.joints.size(); ++j) {
    const Joint& joint = unfolding.joints[j];
    if (joint.tab) {
      // It hangs on a side of a facet at the cut.
      const FacetCorners& facet = unfolding.corners[joint.tab->facet];
      EXPECT_EQ(joint.tab->corners[1], facet[joint.tab->side]);
      EXPECT_EQ(joint.tab->corners[0], facet[(joint.tab->side + 1) % 3]);
      EXPECT_EQ(unfolding.graph->edge_at(joint.tab->facet, joint.tab->side), joint.edge);
      EXPECT_GT(joint.tab->height, 0);
      extras.push_back({joint.tab->corners, unfolding.page_of(joint.tab->facet)});
    } else {
      extras.push_back({strip_corners(unfolding, j), unfolding.strips[j].page});
    }
  }
  std::size_t overlapping = 0, outside = 0;
  for (std::size_t i = 0; i < extras.size(); ++i) {
    for (Index f = 0; f < unfolding.corners.size(); ++f)
      overlapping += unfolding.page_of(f) == extras[i].page &&
                             boxes_touch(extras[i].corners, unfolding.corners[f]) &&
                             exactly_overlap(extras[i].corners, unfolding.corners[f], tolerance)
                         ? 1
                         : 0;
    for (std::size_t k = i + 1; k < extras.size(); ++k)
      overlapping += extras[k].page == extras[i].page && boxes_touch(extras[i].corners, extras[k].corners) &&
                             exactly_overlap(extras[i].corners, extras[k].corners, tolerance)
                         ? 1
                         : 0;
  }
  EXPECT_EQ(overlapping, 0U) << "tabs and strips that overlap something";
  const PaperSettings& s = unfolding.settings;
  const auto look = [&](const auto& polygon) {
    for (const Vector2& p : polygon)
      outside += p.x() < s.margin - 1e-6 || p.y() < s.margin - 1e-6 ||
                         p.x() > s.page.width - s.margin + 1e-6 || p.y() > s.page.height - s.margin + 1e-6
                     ? 1
                     : 0;
  };
  for (const FacetCorners& corners : unfolding.corners) look(corners);
  for (const Extra& extra : extras) look(extra.corners);
  EXPECT_EQ(outside, 0U) << "corners beyond the margins";
  for (Index f = 0; f < unfolding.corners.size(); ++f) EXPECT_LT(unfolding.page_of(f), unfolding.page_count);
}

}  // namespace hariko::test
