#include "core/surface/tessellation.hpp"

#include "core/base/assert.hpp"
#include "core/base/disjoint_sets.hpp"
#include "core/base/index_list.hpp"
#include "core/base/parallel.hpp"
#include "core/surface/adjacency.hpp"

namespace hariko {

namespace {

constexpr std::size_t patches_per_task = 16;

/// Numbering of the points of a uniform grid on every patch: shared corners first, then the inner points of
/// sides, then the inner points of patches. Used twice, for positions and for normals, which are shared
/// differently.
class Numbering {
 public:
  /// `corner_class`: number of each corner, below `class_count`. `shared`: whether a full seam shares its
  /// points.
  template <class Shared>
  Numbering(const Surface& surface, const Adjacency& adjacency, const GridPattern& pattern,
            std::vector<Index> corner_class, Index class_count, const Shared& shared)
      : corners_(corner_count(pattern.domain)),
        inner_side_(pattern.density - 1),
        corner_(std::move(corner_class)) {
    const std::size_t sides = corner_.size();
    std::size_t next = class_count;
    side_base_.resize(sides);
    reversed_.assign(sides, 0);
    for (std::size_t k = 0; k < sides; ++k) {
      const PatchSide side{static_cast<Index>(k / std::size_t(corners_)),
                           static_cast<std::uint8_t>(k % std::size_t(corners_))};
      const Index seam = adjacency.full_seam(side);
      if (seam != no_index && shared(surface.seams()[seam])) {
        const PatchSide first = surface.seams()[seam].first;
        const PatchSide second = surface.seams()[seam].second;
        const std::size_t a = slot(first), b = slot(second);
        if (k != std::min(a, b)) {
          side_base_[k] = side_base_[std::min(a, b)];
          reversed_[k] = 1;
          continue;
        }
      }
      side_base_[k] = static_cast<Index>(next);
      next += static_cast<std::size_t>(inner_side_);
    }
    patch_base_ = next;
    const int boundary_points = corners_ * pattern.density;
    inner_patch_ = pattern.point_count() - boundary_points;
    if (pattern.density == 1) inner_patch_ = 0;
    count_ = next + std::size_t{surface.patch_count()} * static_cast<std::size_t>(inner_patch_);
    HARIKO_ASSERT(count_ < no_index, "too many points for 32-bit indices");
    make_layout(pattern);
  }

  std::size_t count() const { return count_; }

  /// Number of grid point i of a patch.
  Index operator()(Index patch, int i) const {
    const Place& place = layout_[static_cast<std::size_t>(i)];
    if (place.side < 0)
      return static_cast<Index>(patch_base_ + std::size_t{patch} * std::size_t(inner_patch_) +
                                std::size_t(place.at));
    const std::size_t k = std::size_t{patch} * std::size_t(corners_) + std::size_t(place.side);
    if (place.at < 0) return corner_[k];
    return side_base_[k] + static_cast<Index>(reversed_[k] ? inner_side_ - 1 - place.at : place.at);
  }

 private:
  /// Place of a grid point. side = -1: inside the patch, number `at`. at = -1: corner `side`. Otherwise inner
  /// point `at` of the side.
  struct Place {
    int side = -1, at = -1;
  };
  std::size_t slot(PatchSide side) const {
    return std::size_t{side.patch} * std::size_t(corners_) + side.side;
  }
  void make_layout(const GridPattern& pattern) {
    layout_.assign(static_cast<std::size_t>(pattern.point_count()), Place{});
    for (int side = 0; side < corners_; ++side) {
      const std::vector<int> points = pattern.side(side);
      layout_[static_cast<std::size_t>(points[0])] = {side, -1};
      for (int m = 0; m < inner_side_; ++m)
        layout_[static_cast<std::size_t>(points[static_cast<std::size_t>(m) + 1])] = {side, m};
    }
    int inside = 0;
    for (Place& place : layout_)
      if (place.side < 0) place.at = inside++;
    HARIKO_ASSERT(inside == inner_patch_, "grid points miscounted");
  }

  int corners_, inner_side_, inner_patch_ = 0;
  std::vector<Index> corner_, side_base_;
  std::vector<char> reversed_;
  std::size_t patch_base_ = 0, count_ = 0;
  std::vector<Place> layout_;
};

struct CornerClasses {
  std::vector<Index> corner_class;
  Index count = 0;
};

CornerClasses position_corners(const Surface& surface) {
  CornerClasses out;
  const int corners = corner_count(surface.domain());
  for (Index p = 0; p < surface.patch_count(); ++p)
    for (int c = 0; c < corners; ++c) out.corner_class.push_back(surface.node(p, c));
  out.count = surface.node_count();
  return out;
}

bool smooth(const Seam& seam) {
  return seam.intended != Continuity::g0;
}

/// Classes of corners that share a normal: the node has one, or smooth seams lead from one corner to the
/// other.
CornerClasses normal_corners(const Surface& surface) {
  const int corners = corner_count(surface.domain());
  const std::size_t total = std::size_t{surface.patch_count()} * std::size_t(corners);
  DisjointSets classes(total);
  const auto corner = [&](PatchSide side, int offset) {
    return static_cast<Index>(side.patch * Index(corners) + Index((side.side + offset) % corners));
  };
  for (const Seam& seam : surface.seams()) {
    if (!smooth(seam) || !is_full(seam)) continue;
    classes.join(corner(seam.first, 0), corner(seam.second, 1));
    classes.join(corner(seam.first, 1), corner(seam.second, 0));
  }
  std::vector<Index> first_at_node(surface.node_count(), no_index);
  for (Index k = 0; k < total; ++k) {
    const Index node = surface.node(k / Index(corners), int(k % Index(corners)));
    if (surface.node_normal(node).isZero(0)) continue;
    if (first_at_node[node] == no_index)
      first_at_node[node] = k;
    else
      classes.join(first_at_node[node], k);
  }
  CornerClasses out;
  out.corner_class.resize(total);
  for (Index k = 0; k < total; ++k) {
    const Index root = classes.find(k);
    out.corner_class[k] = root == k ? out.count++ : out.corner_class[root];
  }
  return out;
}

/// Owner of every number: the first (patch, grid point), in order of patches, that has it; it writes the
/// value.
std::vector<Index> owners(const Surface& surface, const Numbering& numbering, int points) {
  std::vector<Index> owner(numbering.count(), no_index);
  for (Index p = surface.patch_count(); p-- > 0;)
    for (int i = 0; i < points; ++i) owner[numbering(p, i)] = p;
  return owner;
}

}  // namespace

TriangleMesh tessellate(const Surface& surface, int density, const CancelToken& cancel) {
  HARIKO_ASSERT(density >= 1, "at least one interval a side");
  TriangleMesh mesh;
  mesh.origin = surface.origin();
  if (surface.patch_count() == 0) return mesh;

  const GridPattern pattern{surface.domain(), density};
  const Adjacency adjacency(surface);
  CornerClasses corners = position_corners(surface);
  const Numbering positions(surface, adjacency, pattern, std::move(corners.corner_class), corners.count,
                            [](const Seam&) { return true; });
  corners = normal_corners(surface);
  const Numbering normals(surface, adjacency, pattern, std::move(corners.corner_class), corners.count,
                          smooth);

  const int n = pattern.point_count();
  const auto position_owner = owners(surface, positions, n);
  const auto normal_owner = owners(surface, normals, n);
  const auto local_triangles = pattern.triangles();
  const std::vector<Vector2> parameters = pattern.parameters();
  mesh.positions.assign(positions.count(), Vector3::Zero());
  mesh.normals.assign(normals.count(), Vector3::Zero());
  mesh.triangles.resize(local_triangles.size() * surface.patch_count());
  mesh.normal_triangles.resize(mesh.triangles.size());

  const auto fill = [&](std::size_t begin, std::size_t end) {
    if (cancel.cancelled()) return;
    const std::vector<Index> patches = ascending_indices(end - begin, static_cast<Index>(begin));
    const auto points = static_cast<std::size_t>(n);
    std::vector<Vector3> at(patches.size() * points), across(at.size());
    surface.patches().evaluate_grid(patches, pattern, at, across);
    for (std::size_t k = 0; k < patches.size(); ++k) {
      const Index p = patches[k];
      for (int i = 0; i < n; ++i) {
        const std::size_t local = k * points + std::size_t(i);
        if (const Index v = positions(p, i); position_owner[v] == p) mesh.positions[v] = at[local];
        if (const Index v = normals(p, i); normal_owner[v] == p)
          mesh.normals[v] =
              across[local].isZero(0) ? surface.normal(p, parameters[std::size_t(i)]) : across[local];
      }
      for (std::size_t t = 0; t < local_triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c) {
          mesh.triangles[p * local_triangles.size() + t][c] = positions(p, local_triangles[t][c]);
          mesh.normal_triangles[p * local_triangles.size() + t][c] = normals(p, local_triangles[t][c]);
        }
    }
  };
  parallel_for(surface.patch_count(), patches_per_task, fill);
  if (cancel.cancelled()) return {};

  // The tangent plane at a node is known exactly, whereas evaluation at a corner may be degenerate.
  const int corner_total = corner_count(surface.domain());
  for (int c = 0; c < corner_total; ++c) {
    const int i = pattern.side(c)[0];
    for (Index p = 0; p < surface.patch_count(); ++p)
      if (const Vector3& normal = surface.node_normal(surface.node(p, c)); !normal.isZero(0))
        mesh.normals[normals(p, i)] = normal;
  }
  return mesh;
}

}  // namespace hariko
