#include "core/gaussmap/sphere/arc_crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/geometry/orientation.hpp"

namespace hariko {
namespace {

struct Arc {
  Vector3 from, to;
  Index first, second;  ///< numbers of the end points
};

int side(const Vector3& a, const Vector3& b, const Vector3& c) {
  return side_of_plane(Vector3::Zero(), a, b, c);
}

/// Whether a point on the great circle of the arc lies strictly between its ends.
bool between(const Arc& arc, const Vector3& point) {
  const Vector3 middle = (arc.from + arc.to).normalized();
  return point.dot(middle) > arc.from.dot(middle);
}

bool arcs_cross(const Arc& a, const Arc& b) {
  if ((a.from + a.to).dot(b.from + b.to) <= 0) return false;
  const bool joined = a.second == b.first || a.first == b.second;
  const int s1 = side(a.from, a.to, b.from), s2 = side(a.from, a.to, b.to);
  if (s1 == 0 && s2 == 0) {  // on one great circle
    if (a.second == b.first && a.first == b.second) return true;
    return between(a, b.from) || between(a, b.to) || between(b, a.from) || between(b, a.to);
  }
  if (joined) return false;
  const int s3 = side(b.from, b.to, a.from), s4 = side(b.from, b.to, a.to);
  return s1 * s2 <= 0 && s3 * s4 <= 0;
}

/// Calls body for the cells of a spatial grid that an arc's bounding box touches, at most eight for arcs no
/// longer than a cell.
template <class Body>
void for_cells(const Arc& arc, double cell, Body&& body) {
  std::array<std::int64_t, 3> low{}, high{};
  // An arc leaves the bounding box of its chord by less than its sagitta.
  const double bulge = 1 - (arc.from + arc.to).norm() / 2;
  for (int k = 0; k < 3; ++k) {
    low[std::size_t(k)] = std::int64_t(std::floor((std::min(arc.from[k], arc.to[k]) - bulge) / cell));
    high[std::size_t(k)] = std::int64_t(std::floor((std::max(arc.from[k], arc.to[k]) + bulge) / cell));
  }
  for (std::int64_t x = low[0]; x <= high[0]; ++x)
    for (std::int64_t y = low[1]; y <= high[1]; ++y)
      for (std::int64_t z = low[2]; z <= high[2]; ++z)
        body((std::uint64_t(x + 0x100000) << 42) | (std::uint64_t(y + 0x100000) << 21) |
             std::uint64_t(z + 0x100000));
}

}  // namespace

std::optional<std::pair<Index, Index>> crossing_arcs(const std::vector<std::vector<Vector3>>& loops) {
  std::vector<Arc> arcs;
  double longest = 1e-5;  // large enough for a cell's index to fit into 21 bits
  for (const auto& loop : loops) {
    const Index first = static_cast<Index>(arcs.size()), count = static_cast<Index>(loop.size());
    for (Index i = 0; i < count; ++i) {
      arcs.push_back({loop[i], loop[(i + 1) % count], first + i, first + (i + 1) % count});
      longest = std::max(longest, (arcs.back().from - arcs.back().to).norm());
    }
  }
  std::vector<std::pair<std::uint64_t, Index>> entries;
  for (Index i = 0; i < arcs.size(); ++i)
    for_cells(arcs[i], longest, [&](std::uint64_t cell) { entries.emplace_back(cell, i); });
  std::sort(entries.begin(), entries.end());
  std::optional<std::pair<Index, Index>> found;
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    while (end < entries.size() && entries[end].first == entries[begin].first) ++end;
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = i + 1; j < end; ++j) {
        const std::pair pair{entries[i].second, entries[j].second};
        if ((!found || pair < *found) && arcs_cross(arcs[pair.first], arcs[pair.second])) found = pair;
      }
  }
  return found;
}

}  // namespace hariko
