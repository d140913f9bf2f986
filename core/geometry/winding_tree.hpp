#pragma once

// WindingTree: generalised winding numbers of triangle meshes, to tell whether a point is inside, even where
// the mesh intersects itself.

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "core/geometry/box_tree.hpp"

namespace hariko {

/// Bounding volume hierarchy of triangles; far nodes count by their area vector (Barill et al. 2018, first
/// order).
class WindingTree {
 public:
  /// Builds the tree over a closed mesh; positions and triangles must outlive it. O(n log n).
  WindingTree(std::span<const Vector3> positions, std::span<const std::array<Index, 3>> triangles);

  /// Approximate winding number of the mesh about the point: 1 inside, 0 outside. O(log n).
  double winding(const Vector3& point) const;
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    Index triangle = no_index;
  };
  /// Nearest triangle. O(log n).
  Nearest nearest(const Vector3& point) const;
  /// True when no triangle is nearer than `radius`. O(log n); the more triangles, the cheaper than `nearest`.
  bool is_clear(const Vector3& point, double radius) const;

 private:
  /// Far-field summary of the triangles of a node.
  struct Moments {
    Vector3 centre = Vector3::Zero(), area = Vector3::Zero();
    double radius = 0;
    double total = 0;  ///< sum of the triangles' areas
  };
  Moments moments_of_leaf(const BoxTree::Node& leaf) const;
  Moments moments_of_both(Index node) const;
  double winding(Index node, const Vector3& point) const;
  double square_distance(Index triangle, const Vector3& point) const;

  std::span<const Vector3> positions_;
  std::span<const std::array<Index, 3>> triangles_;
  BoxTree tree_;
  std::vector<Moments> moments_;  ///< per node
};

}  // namespace hariko
