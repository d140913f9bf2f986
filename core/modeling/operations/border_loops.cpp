#include "core/modeling/operations/border_loops.hpp"

#include <map>
#include <set>

#include "core/base/assert.hpp"

namespace hariko {

std::vector<Index> border_loop(const HalfEdgeMesh& mesh, Index edge) {
  HARIKO_ASSERT(mesh.is_border_edge(edge), "a border loop starts at a border edge");
  std::vector<Index> loop;
  // The first half-edge of a border vertex's fan leads along the border; reversed, the walk has the direction
  // of a face on the other side.
  const Index start = mesh.origin(mesh.half_edge_of_edge(edge));
  for (Index v = start; loop.empty() || v != start; v = mesh.target(mesh.outgoing(v))) loop.push_back(v);
  return {loop.rbegin(), loop.rend()};
}

std::vector<BorderChain> border_chains(const HalfEdgeMesh& mesh, std::span<const Index> edges) {
  std::map<Index, Index> next;  // on a border each vertex starts one edge and ends one
  std::set<Index> targets;
  for (const Index e : edges) {
    HARIKO_ASSERT(mesh.is_border_edge(e), "a chain of border edges");
    const Index h = mesh.half_edge_of_edge(e);
    next.emplace(mesh.target(h), mesh.origin(h));
    targets.insert(mesh.origin(h));
  }
  std::vector<BorderChain> chains;
  const auto follow = [&](Index start) {
    BorderChain chain;
    Index v = start;
    while (next.contains(v)) {
      chain.vertices.push_back(v);
      const Index following = next.at(v);
      next.erase(v);
      v = following;
    }
    chain.closed = v == start;
    if (!chain.closed) chain.vertices.push_back(v);
    chains.push_back(std::move(chain));
  };
  std::vector<Index> open_starts;
  for (const auto& [v, w] : next)
    if (!targets.contains(v)) open_starts.push_back(v);
  for (const Index v : open_starts) follow(v);
  while (!next.empty()) follow(next.begin()->first);
  return chains;
}

}  // namespace hariko
