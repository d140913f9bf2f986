#pragma once

// Generalised winding numbers of triangle meshes: is a point inside, also where the mesh cuts itself?

#include <vector>

#include "core/surface/tessellation.hpp"

namespace hariko {

/// Triangles in a tree of boxes; far ones count by their area vector (Barill et al. 2018, first order).
class WindingTree {
 public:
  /// The mesh must be closed and outlive the tree. O(n log n).
  explicit WindingTree(const TriangleMesh& mesh);

  /// About the number of times that the mesh winds round the point: 1 inside, 0 outside. O(log n).
  double winding(const Vector3& point) const;
  struct Nearest {
    double distance = 1e300;
    Index triangle = no_index;
  };
  /// The nearest triangle. O(log n).
  Nearest nearest(const Vector3& point) const;
  /// No triangle is nearer than `radius`. O(log n); cheaper than `nearest` the more triangles there are.
  bool is_clear(const Vector3& point, double radius) const;

 private:
  struct Node {
    Vector3 low, high, centre, area;
    double radius = 0;
    double total = 0;                            ///< sum of the triangles' areas
    Index begin = 0, end = 0, right = no_index;  ///< leaf: right is none; left child follows its parent
  };
  struct Item {
    Vector3 middle;
    Index triangle;
  };
  Index build(Index begin, Index end);
  Node leaf(Index begin, Index end) const;
  double winding(Index node, const Vector3& point) const;
  void nearest(Index node, const Vector3& point, Nearest& best) const;  ///< distances squared
  bool is_clear_by_square(Index node, const Vector3& point, double square) const;
  double square_distance(const Item& item, const Vector3& point) const;

  const TriangleMesh* mesh_;
  std::vector<Item> items_;  ///< those of a leaf beside each other
  std::vector<Node> nodes_;
};

}  // namespace hariko
