#pragma once

// WindingTree: generalised winding numbers of triangle meshes. Is a point inside, also where the mesh cuts
// itself?

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "core/geometry/box_tree.hpp"

namespace hariko {

/// Triangles in a tree of boxes; far ones count by their area vector (Barill et al. 2018, first order).
class WindingTree {
 public:
  /// The mesh must be closed; positions and triangles must outlive the tree. O(n log n).
  WindingTree(std::span<const Vector3> positions, std::span<const std::array<Index, 3>> triangles);

  /// About the number of times that the mesh winds round the point: 1 inside, 0 outside. O(log n).
  double winding(const Vector3& point) const;
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    Index triangle = no_index;
  };
  /// The nearest triangle. O(log n).
  Nearest nearest(const Vector3& point) const;
  /// No triangle is nearer than `radius`. O(log n); cheaper than `nearest` the more triangles there are.
  bool is_clear(const Vector3& point, double radius) const;

 private:
  /// The triangles of a node as seen from far away.
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
