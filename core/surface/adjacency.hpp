#pragma once

// Adjacency: the seams at each side of a patch, and the boundary. Derived from a surface's seams.

#include <span>
#include <vector>

#include "core/surface/surface.hpp"

namespace hariko {

/// Seams by sides of patches.
class Adjacency {
 public:
  /// Collects the seams of every side. O(patches + seams).
  explicit Adjacency(const Surface& surface);

  /// Indices of the seams on a side, ascending. A seam between two parts of one side is listed twice.
  std::span<const Index> seams(PatchSide side) const;
  /// The seam that covers the whole side; no_index when there is none.
  Index full_seam(PatchSide side) const;
  /// Sides that are not wholly covered by seams, in order of patch and side.
  const std::vector<PatchSide>& boundary() const { return boundary_; }
  /// Whether the surface has no boundary.
  bool closed() const { return boundary_.empty(); }

 private:
  std::size_t slot(PatchSide side) const { return std::size_t{side.patch} * corners_ + side.side; }
  std::size_t corners_;
  std::vector<Index> offsets_, seams_;
  std::vector<PatchSide> boundary_;
  std::vector<Index> full_;
};

/// Whether a seam joins two whole sides, in opposite directions.
bool is_full(const Seam& seam);

}  // namespace hariko
