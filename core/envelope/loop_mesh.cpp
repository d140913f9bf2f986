#include "core/envelope/loop_mesh.hpp"

#include <algorithm>
#include <map>

namespace hariko {

std::set<std::pair<Index, Index>> edges_of(const CageLoops& loops) {
  std::set<std::pair<Index, Index>> out;
  for (const CageLoop& loop : loops)
    for (std::size_t i = 0; i < loop.corners.size(); ++i)
      out.insert(std::minmax(loop.corners[i], loop.corners[(i + 1) % loop.corners.size()]));
  return out;
}

bool is_sphere(const CageLoops& loops) {
  // The vertex that follows v in the loop that comes from u.
  std::map<std::pair<Index, Index>, Index> after;
  std::map<Index, std::size_t> valence;
  std::map<Index, Index> first;  ///< one neighbour of every vertex
  for (const CageLoop& loop : loops) {
    const std::size_t n = loop.corners.size();
    if (n < 3) return false;
    std::vector<Index> sorted = loop.corners;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return false;
    for (std::size_t i = 0; i < n; ++i) {
      const Index u = loop.corners[i], v = loop.corners[(i + 1) % n];
      if (!after.emplace(std::pair(u, v), loop.corners[(i + 2) % n]).second) return false;
      ++valence[u];
      first[v] = u;
    }
  }
  for (const auto& [edge, next] : after)
    if (!after.contains({edge.second, edge.first})) return false;
  for (const auto& [v, count] : valence) {
    if (count < 3) return false;
    Index u = first[v];
    std::size_t fan = 0;
    do {
      u = after[{u, v}];  // the face u, v, w; the next one comes from w
      if (!after.contains({u, v})) return false;
      ++fan;
    } while (u != first[v] && fan <= count);
    if (fan != count) return false;
  }
  return long(valence.size()) - long(after.size() / 2) + long(loops.size()) == 2;
}

CageLoops collapsed(const CageLoops& loops, Index kept, Index gone) {
  CageLoops out;
  for (CageLoop loop : loops) {
    std::replace(loop.corners.begin(), loop.corners.end(), gone, kept);
    loop.corners.erase(std::unique(loop.corners.begin(), loop.corners.end()), loop.corners.end());
    while (loop.corners.size() > 1 && loop.corners.front() == loop.corners.back()) loop.corners.pop_back();
    if (loop.corners.size() >= 3) out.push_back(std::move(loop));
  }
  return out;
}

}  // namespace hariko
