#include "core/modeling/selection/region.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/index_list.hpp"

namespace hariko {
namespace {

/// Number of the region of each face; no_index for faces that are not selected.
std::vector<Index> group_faces(const HalfEdgeMesh& mesh, const std::vector<Index>& faces, Grouping as,
                               Index& count) {
  std::vector<Index> group(mesh.face_count(), no_index);
  std::vector<char> chosen(mesh.face_count(), 0);
  for (const Index f : faces) chosen[f] = 1;
  count = 0;
  std::vector<Index> stack;
  for (const Index seed : faces) {
    if (group[seed] != no_index) continue;
    group[seed] = count;
    if (as == Grouping::region) stack.push_back(seed);
    while (!stack.empty()) {
      const Index f = stack.back();
      stack.pop_back();
      for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
        if (mesh.twin(h) == no_index) continue;
        const Index other = mesh.face(mesh.twin(h));
        if (!chosen[other] || group[other] != no_index) continue;
        group[other] = count;
        stack.push_back(other);
      }
    }
    ++count;
  }
  return group;
}

class RegionFinder {
 public:
  RegionFinder(const Polyhedron& polyhedron, const std::vector<Index>& faces, Grouping as)
      : polyhedron_(polyhedron), mesh_(polyhedron.topology()) {
    Index count = 0;
    group_ = group_faces(mesh_, faces, as, count);
    regions_.resize(count);
    for (const Index f : faces) regions_[group_[f]].faces.push_back(f);
  }

  std::vector<Region> find() {
    for (Index g = 0; g < regions_.size(); ++g) {
      Region& region = regions_[g];
      region.whole_part = true;
      for (const Index f : region.faces)
        for (Index h = mesh_.face_begin(f); h < mesh_.face_end(f); ++h) {
          if (mesh_.twin(h) != no_index && group_[mesh_.face(mesh_.twin(h))] != g) region.whole_part = false;
          if (is_rim(h)) add_rim_point(region, h);
        }
      find_inner_vertices(region);
    }
    return std::move(regions_);
  }

 private:
  bool is_rim(Index h) const {
    return mesh_.twin(h) == no_index || group_[mesh_.face(mesh_.twin(h))] != group_[mesh_.face(h)];
  }

  /// Adds the point where the rim leaves the origin of `out`: turns through the region to the half-edge where
  /// it arrives.
  void add_rim_point(Region& region, Index out) const {
    const Index v = mesh_.origin(out);
    RimPoint point{v, polyhedron_.vertex_id(v), {}, no_index, out, {}};
    Index corner = out;
    while (!is_rim(mesh_.previous(corner))) {
      point.inner_edges.push_back(mesh_.edge(mesh_.previous(corner)));
      corner = mesh_.rotate(corner);
    }
    point.in = mesh_.previous(corner);
    region.rim.push_back(std::move(point));
  }

  void find_inner_vertices(Region& region) const {
    std::vector<Index> rim, all;
    for (const RimPoint& point : region.rim) rim.push_back(point.vertex);
    std::sort(rim.begin(), rim.end());
    for (const Index f : region.faces)
      for (const Index v : mesh_.face_vertices(f))
        if (!std::binary_search(rim.begin(), rim.end(), v)) all.push_back(v);
    sort_unique(all);
    region.inner_vertices = std::move(all);
  }

  const Polyhedron& polyhedron_;
  const HalfEdgeMesh& mesh_;
  std::vector<Index> group_;
  std::vector<Region> regions_;
};

}  // namespace

std::vector<Region> find_regions(const Polyhedron& polyhedron, const std::vector<Index>& faces, Grouping as) {
  return RegionFinder(polyhedron, faces, as).find();
}

void raise_regions(MeshEditor& draft, const Polyhedron& polyhedron, std::vector<Region>& regions) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const Shaping before = draft.shaping();
  std::vector<VertexId> at_corner(mesh.half_edge_count());  ///< only at corners of the regions
  for (Index h = 0; h < mesh.half_edge_count(); ++h) at_corner[h] = polyhedron.vertex_id(mesh.origin(h));

  for (Region& region : regions)
    for (RimPoint& point : region.rim) {
      point.top = draft.add_vertex(polyhedron.position(point.vertex));
      for (Index corner = point.out;; corner = mesh.rotate(corner)) {
        at_corner[corner] = point.top;
        if (mesh.previous(corner) == point.in) break;
      }
    }
  for (const Region& region : regions) {
    for (const Index f : region.faces)
      draft.set_face(polyhedron.face_id(f),
                     {at_corner.begin() + mesh.face_begin(f), at_corner.begin() + mesh.face_end(f)});
    for (const RimPoint& point : region.rim) {
      const Index out = point.out;
      draft.add_face(
          {point.base, polyhedron.vertex_id(mesh.target(out)), at_corner[mesh.next(out)], point.top});
      for (const Index e : point.inner_edges) {
        // The edge runs between faces of the region, so one of its half-edges names both new ends.
        const Index h = mesh.half_edge_of_edge(e);
        const EdgeId from = polyhedron.edge_id(e);
        const EdgeId to = EdgeId::of(at_corner[h], at_corner[mesh.next(h)]);
        if (const double* beta = before.beta.find(from)) draft.shaping().beta.set(to, double(*beta));
        if (before.crease.contains(from)) draft.shaping().crease.set(to, true);
      }
    }
  }
}

}  // namespace hariko
