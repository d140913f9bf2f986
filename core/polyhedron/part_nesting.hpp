#pragma once

// PartNesting: which closed parts of a mesh lie inside others.

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/base/vector.hpp"
#include "core/geometry/box_tree.hpp"
#include "core/geometry/winding_tree.hpp"

namespace hariko {

/// Nesting of the closed parts of a mesh, by winding numbers.
class PartNesting {
 public:
  using Triangles = std::vector<std::array<Index, 3>>;
  /// Closed parts as triangles of one orientation each; positions must outlive it.
  PartNesting(std::span<const Vector3> positions, std::vector<Triangles> parts);

  /// Parts round a part, the one with the largest box first. O(log parts) where few boxes overlap, and
  /// O(n log n) once for each part whose box holds that of another one.
  std::vector<Index> around(Index part);

 private:
  bool encloses(Index outer, const Vector3& point);

  std::span<const Vector3> positions_;
  std::vector<Triangles> parts_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<Index> rank_;                          ///< by part: place in the order of the boxes' sizes
  std::vector<Index> held_;                          ///< parts with triangles
  BoxTree tree_of_boxes_;                            ///< over the boxes of these
  std::vector<std::unique_ptr<WindingTree>> trees_;  ///< made when they are needed
};

}  // namespace hariko
