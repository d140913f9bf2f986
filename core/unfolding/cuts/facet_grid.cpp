#include "core/unfolding/cuts/facet_grid.hpp"

#include <bit>

namespace hariko {

FacetGrid::FacetGrid(const std::vector<FacetCorners>& shapes) : seen_(shapes.size(), 0) {
  double sum = 0;
  for (const FacetCorners& shape : shapes) sum += longest_side(shape);
  double cell = shapes.empty() ? 1 : sum / static_cast<double>(shapes.size());
  // Bounds the table where few large facets are among many small ones.
  const auto entries = [&] {
    double count = 0;
    for (const FacetCorners& shape : shapes) count += std::pow(longest_side(shape) / cell + 2, 2);
    return count;
  };
  while (entries() > 16.0 * static_cast<double>(shapes.size())) cell *= 1.5;
  cells_per_length_ = 1 / cell;
  const std::size_t slots = std::bit_ceil(std::max<std::size_t>(16, 4 * shapes.size()));
  shift_ = 64 - std::countr_zero(slots);
  heads_.assign(slots, no_index);
  nodes_.reserve(4 * shapes.size());
}

FacetGrid::Cells FacetGrid::cells_of(const FacetCorners& corners) const {
  const auto cell = [&](double x) { return static_cast<std::int64_t>(std::floor(x * cells_per_length_)); };
  const auto [low_x, high_x] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
  const auto [low_y, high_y] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
  return {cell(low_x), cell(low_y), cell(high_x), cell(high_y)};
}

void FacetGrid::insert(Index piece, Index facet, const FacetCorners& corners) {
  const Cells cells = cells_of(corners);
  for (std::int64_t y = cells.low_y; y <= cells.high_y; ++y)
    for (std::int64_t x = cells.low_x; x <= cells.high_x; ++x) {
      const std::uint64_t key = key_of(piece, x, y);
      Index& head = heads_[slot_of(key)];
      if (free_ == no_index) {
        nodes_.push_back({key, facet, head});
        head = static_cast<Index>(nodes_.size() - 1);
      } else {
        const Index node = free_;
        free_ = nodes_[node].next;
        nodes_[node] = {key, facet, head};
        head = node;
      }
    }
}

void FacetGrid::remove(Index piece, Index facet, const FacetCorners& corners) {
  const Cells cells = cells_of(corners);
  for (std::int64_t y = cells.low_y; y <= cells.high_y; ++y)
    for (std::int64_t x = cells.low_x; x <= cells.high_x; ++x) {
      const std::uint64_t key = key_of(piece, x, y);
      Index* link = &heads_[slot_of(key)];
      while (*link != no_index && (nodes_[*link].key != key || nodes_[*link].facet != facet))
        link = &nodes_[*link].next;
      HARIKO_ASSERT(*link != no_index, "the facet is not in the grid");
      const Index node = *link;
      *link = nodes_[node].next;
      nodes_[node].next = free_;
      free_ = node;
    }
}

}  // namespace hariko
