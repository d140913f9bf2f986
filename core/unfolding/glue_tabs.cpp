#include "core/unfolding/glue_tabs.hpp"

#include <algorithm>

#include "core/base/index_list.hpp"
#include "core/unfolding/cuts/convex_overlap.hpp"
#include "core/unfolding/cuts/facet_grid.hpp"

namespace hariko {

namespace {

constexpr double heights[] = {1, 0.7, 0.45, 0.25};

/// Tab outside a side from a to b, which has its facet on the left.
std::array<Vector2, 4> trapezoid(const Vector2& a, const Vector2& b, double height) {
  const Vector2 along = (b - a).normalized(), outward(along.y(), -along.x());
  return {b, a, a + height * (along + outward), b + height * (outward - along)};
}

/// Occupied space: facets and tabs of all pieces, each piece on a sheet of its own.
class TabRoom {
 public:
  TabRoom(const FlatLayout& layout, std::size_t joints, double tolerance)
      : layout_(layout), tolerance_(tolerance), grid_(with_room_for(layout.corners, joints)), tabs_(joints) {
    for (Index f = 0; f < layout.corners.size(); ++f) grid_.insert(layout.piece_of[f], f, layout.corners[f]);
  }

  bool is_free(Index piece, const std::array<Vector2, 4>& quad) const {
    for (const FacetCorners& half : halves(quad))
      if (!grid_.for_each_near(piece, half, [&](Index other) { return !meets(quad, other); })) return false;
    return true;
  }
  void add(Index piece, Index joint, const std::array<Vector2, 4>& quad) {
    tabs_[joint] = quad;
    Index id = facet_count() + 2 * joint;
    for (const FacetCorners& half : halves(quad)) grid_.insert(piece, id++, half);
  }

 private:
  static std::vector<FacetCorners> with_room_for(std::vector<FacetCorners> corners, std::size_t joints) {
    corners.resize(corners.size() + 2 * joints, corners.front());
    return corners;
  }
  static std::array<FacetCorners, 2> halves(const std::array<Vector2, 4>& quad) {
    return {FacetCorners{quad[0], quad[1], quad[2]}, FacetCorners{quad[0], quad[2], quad[3]}};
  }
  Index facet_count() const { return static_cast<Index>(layout_.corners.size()); }
  bool meets(const std::array<Vector2, 4>& quad, Index other) const {
    if (other < facet_count()) return overlaps(quad, layout_.corners[other], tolerance_);
    return overlaps(quad, tabs_[(other - facet_count()) / 2], tolerance_);
  }

  const FlatLayout& layout_;
  double tolerance_;
  FacetGrid grid_;
  std::vector<std::array<Vector2, 4>> tabs_;
};

}  // namespace

std::vector<Joint> find_joints(const FacetGraph& graph, const Folds& folds, const FlatLayout& layout,
                               const std::vector<TabChoice>& choices, const PaperSettings& settings) {
  const double height = settings.tab_height, least = std::min(settings.least_tab, height);
  std::vector<Joint> joints;
  for (Index e = 0; e < graph.edge_count(); ++e)
    if (!folds[e] && !graph.edge(e).border()) joints.push_back({e, {}});
  const std::vector<Index> order = stable_order(joints.size(), [&](Index a, Index b) {
    return graph.edge(joints[a].edge).length > graph.edge(joints[b].edge).length;
  });
  // Stricter than the final overlap test, so that rounding when a piece is moved does not matter.
  TabRoom room(layout, joints.size(), 0.5 * overlap_tolerance * longest_side(layout.corners));

  const auto place = [&](Index j) {
    const FacetEdge& edge = graph.edge(joints[j].edge);
    const TabChoice choice = choices.empty() ? TabChoice::automatic : choices[joints[j].edge];
    if (choice == TabChoice::strip) return;
    for (const double part : heights)
      for (std::size_t k = 0; k < 2; ++k) {
        if ((choice == TabChoice::first && k == 1) || (choice == TabChoice::second && k == 0)) continue;
        const FacetCorners& facet = layout.corners[edge.facets[k]];
        const Vector2 &a = facet[edge.sides[k]], &b = facet[(edge.sides[k] + 1) % 3];
        const double own = std::min(part * height, 0.4 * (b - a).norm());
        const auto quad = trapezoid(a, b, own);
        const Index piece = layout.piece_of[edge.facets[k]];
        if (!(own > 0) || own < least || !room.is_free(piece, quad)) continue;
        room.add(piece, j, quad);
        joints[j].tab = GlueTab{edge.facets[k], edge.sides[k], own, quad};
        return;
      }
  };
  for (const Index j : order) place(j);
  return joints;
}

}  // namespace hariko
