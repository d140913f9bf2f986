#include "core/polyhedron/near_vertices.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

/// Hash grid: points by cells of a uniform grid, with the points of a cell chained.
class CellTable {
 public:
  explicit CellTable(std::size_t capacity)
      : heads_(std::bit_ceil(std::max<std::size_t>(16, capacity * 2)), no_index), next_(capacity, no_index) {}

  Index& head(const Vector3& cell) { return heads_[hash(cell) & (heads_.size() - 1)]; }
  Index next(Index point) const { return next_[point]; }
  void insert(const Vector3& cell, Index point) {
    Index& first = head(cell);
    next_[point] = first;
    first = point;
  }

 private:
  static std::uint64_t hash(const Vector3& cell) {
    std::uint64_t h = 0;
    for (int axis = 0; axis < 3; ++axis) {
      h ^= std::bit_cast<std::uint64_t>(cell[axis] + 0.0);  // + 0.0 makes -0 and 0 one cell
      h *= 0x9e3779b97f4a7c15U;
      h ^= h >> 29;
    }
    return h * 0xbf58476d1ce4e5b9U >> 7;
  }
  std::vector<Index> heads_, next_;
};

}  // namespace

std::vector<Index> representatives(std::span<const Vector3> points, double distance) {
  HARIKO_ASSERT(distance >= 0, "distance must not be negative");
  double largest = 0;
  for (const Vector3& p : points)
    if (p.allFinite()) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  const bool exact = distance <= largest * 1e-290;
  if (exact) distance = 0;
  // Representatives are more than `distance` apart, so a cell of twice that size holds at most a few dozen of
  // them, and all neighbours of a point are in the eight cells round the nearest grid corner. Cell numbers
  // are doubles: beyond 2^53 they are coarser than the cells, but distinct coordinates are then farther apart
  // than `distance` anyway.
  const double cell_size = 2 * distance;

  CellTable table(points.size());
  std::vector<Index> out(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    out[i] = i;
    const Vector3& p = points[i];
    if (!p.allFinite()) continue;
    const Vector3 scaled = exact ? p : Vector3(p / cell_size);
    const Vector3 cell = exact ? p : Vector3(scaled.array().floor());
    double nearest = distance;
    Index best = no_index;
    const int neighbours = exact ? 1 : 8;
    for (int corner = 0; corner < neighbours; ++corner) {
      Vector3 probe = cell;
      for (int axis = 0; axis < 3; ++axis)
        if (corner >> axis & 1) probe[axis] += scaled[axis] - cell[axis] < 0.5 ? -1 : 1;
      for (Index j = table.head(probe); j != no_index; j = table.next(j)) {
        const double d = (points[j] - p).norm();
        if (d < nearest || (d == nearest && (best == no_index || j < best))) {
          nearest = d;
          best = j;
        }
      }
    }
    if (best == no_index)
      table.insert(cell, i);
    else
      out[i] = best;
  }
  return out;
}

}  // namespace hariko
