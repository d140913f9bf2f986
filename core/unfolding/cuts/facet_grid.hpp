#pragma once

// FacetGrid: spatial hash of the facets of pieces, in square cells, with one plane for each piece.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/unfolding/cuts/facet_layout.hpp"

namespace hariko {

/// Finds the facets of a piece near a triangle.
class FacetGrid {
 public:
  /// Chooses cells of about the size of a mean facet. `shapes`: the facets to be inserted, which may be moved
  /// but not scaled.
  explicit FacetGrid(const std::vector<FacetCorners>& shapes);

  /// Inserts a facet of a piece at these corners.
  void insert(Index piece, Index facet, const FacetCorners& corners);
  /// Removes a facet; arguments as when it was inserted.
  void remove(Index piece, Index facet, const FacetCorners& corners);

  /// Calls visit(facet) once for every facet of the piece whose cells meet the box of the corners; stops, and
  /// returns false, when visit returns false.
  template <class Visit>
  bool for_each_near(Index piece, const FacetCorners& corners, Visit&& visit) const {
    const Cells cells = cells_of(corners);
    ++stamp_;
    for (std::int64_t y = cells.low_y; y <= cells.high_y; ++y)
      for (std::int64_t x = cells.low_x; x <= cells.high_x; ++x) {
        const std::uint64_t key = key_of(piece, x, y);
        for (Index node = heads_[slot_of(key)]; node != no_index; node = nodes_[node].next) {
          if (nodes_[node].key != key || seen_[nodes_[node].facet] == stamp_) continue;
          seen_[nodes_[node].facet] = stamp_;
          if (!visit(nodes_[node].facet)) return false;
        }
      }
    return true;
  }

 private:
  struct Node {
    std::uint64_t key;
    Index facet, next;
  };
  struct Cells {
    std::int64_t low_x, low_y, high_x, high_y;
  };
  Cells cells_of(const FacetCorners& corners) const;
  /// Hash key of a cell: unique for pieces below 2^20 and cells within 2^21 of the origin. Others may share
  /// keys, which only makes more facets count as near.
  static std::uint64_t key_of(Index piece, std::int64_t x, std::int64_t y) {
    constexpr std::uint64_t mask = (1U << 22) - 1;
    return (std::uint64_t(piece) << 44) | ((std::uint64_t(x) & mask) << 22) | (std::uint64_t(y) & mask);
  }
  std::size_t slot_of(std::uint64_t key) const {
    return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15U) >> shift_);
  }

  double cells_per_length_ = 1;
  int shift_ = 0;
  std::vector<Index> heads_;
  std::vector<Node> nodes_;
  Index free_ = no_index;
  mutable std::vector<std::uint64_t> seen_;
  mutable std::uint64_t stamp_ = 0;
};

}  // namespace hariko
