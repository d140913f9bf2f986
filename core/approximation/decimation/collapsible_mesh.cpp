#include "core/approximation/decimation/collapsible_mesh.hpp"

#include <algorithm>
#include <map>

#include "core/base/index_list.hpp"
#include "core/geometry/angles.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

CollapsibleMesh::CollapsibleMesh(std::vector<Vector3> positions, std::vector<std::array<Index, 3>> triangles,
                                 double sharp)
    : positions_(std::move(positions)),
      triangles_(std::move(triangles)),
      alive_(triangles_.size(), 1),
      round_(positions_.size()),
      count_(triangles_.size()) {
  for (Index f = 0; f < triangles_.size(); ++f)
    for (const Index v : triangles_[f]) round_[v].push_back(f);
  find_kept(sharp);
  freedom_.resize(positions_.size());
  for (Index v = 0; v < positions_.size(); ++v) freedom_[v] = freedom_of(v);
}

void CollapsibleMesh::find_kept(double sharp) {
  struct Use {
    std::uint64_t key;
    Index facet;
    bool forward;
  };
  std::vector<Use> uses;
  uses.reserve(3 * triangles_.size());
  for (Index f = 0; f < triangles_.size(); ++f)
    for (std::size_t c = 0; c < 3; ++c) {
      const Index a = triangles_[f][c], b = triangles_[f][(c + 1) % 3];
      uses.push_back({edge_key(a, b), f, a < b});
    }
  std::sort(uses.begin(), uses.end(),
            [](const Use& a, const Use& b) { return std::tie(a.key, a.facet) < std::tie(b.key, b.facet); });
  const auto normal = [&](Index f) {
    const auto& t = triangles_[f];
    return facet_normal(positions_[t[0]], positions_[t[1]], positions_[t[2]]);
  };
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t j = i;
    while (j < uses.size() && uses[j].key == uses[i].key) ++j;
    const bool pair = j - i == 2 && uses[i].forward != uses[i + 1].forward;
    if (!pair) border_.insert(uses[i].key);
    if (!pair || angle_between(normal(uses[i].facet), normal(uses[i + 1].facet)) > sharp)
      kept_.insert(uses[i].key);
    i = j;
  }
}

CollapsibleMesh::Freedom CollapsibleMesh::freedom_of(Index vertex) const {
  const std::vector<Index>& facets = round_[vertex];
  if (facets.empty()) return Freedom::fixed;
  neighbours(vertex, near_v_);
  int kept = 0, borders = 0;
  for (const Index w : near_v_) {
    kept += kept_edge(vertex, w);
    borders += border_.contains(edge_key(vertex, w));
  }
  // A closed fan has as many neighbours as facets, an open fan has one more.
  const bool closed = borders == 0 && near_v_.size() == facets.size();
  const bool open = borders == 2 && near_v_.size() == facets.size() + 1;
  if (!(closed || open) || (kept != 0 && kept != 2)) return Freedom::fixed;
  // Several fans may have these numbers as well: one fan is walked.
  std::map<Index, std::vector<Index>> across;
  for (const Index f : facets)
    for (const Index w : triangles_[f])
      if (w != vertex) across[w].push_back(f);
  std::vector<Index> seen{facets[0]};
  for (std::size_t k = 0; k < seen.size(); ++k)
    for (const Index w : triangles_[seen[k]]) {
      if (w == vertex) continue;
      for (const Index f : across[w])
        if (std::find(seen.begin(), seen.end(), f) == seen.end()) seen.push_back(f);
    }
  if (seen.size() != facets.size()) return Freedom::fixed;
  return kept == 0 ? Freedom::inside : Freedom::along;
}

void CollapsibleMesh::neighbours(Index vertex, std::vector<Index>& out) const {
  out.clear();
  for (const Index f : round_[vertex])
    for (const Index w : triangles_[f])
      if (w != vertex) out.push_back(w);
  sort_unique(out);
}

bool CollapsibleMesh::may_collapse(Index v, Index w) const {
  if (freedom_[v] == Freedom::fixed || (freedom_[v] == Freedom::along && !kept_edge(v, w))) return false;
  neighbours(v, near_v_);
  neighbours(w, near_w_);
  std::size_t facets = 0;
  std::vector<Index> opposite;
  for (const Index f : round_[v]) {
    const auto& t = triangles_[f];
    if (std::find(t.begin(), t.end(), w) == t.end()) continue;
    ++facets;
    for (const Index u : t)
      if (u != v && u != w) opposite.push_back(u);
  }
  if (facets == 0 || facets > 2 || round_[v].size() <= facets) return false;
  // Link condition: common neighbours are the corners opposite to the edge, and no others.
  std::sort(opposite.begin(), opposite.end());
  std::vector<Index> both;
  std::set_intersection(near_v_.begin(), near_v_.end(), near_w_.begin(), near_w_.end(),
                        std::back_inserter(both));
  if (both != opposite) return false;
  // A kept edge from v to an opposite corner would fall onto the edge from w to it.
  return std::none_of(opposite.begin(), opposite.end(), [&](Index u) { return kept_edge(v, u); });
}

void CollapsibleMesh::moved_facets(Index v, Index w,
                                   std::vector<std::pair<Index, std::array<Index, 3>>>& out) const {
  out.clear();
  for (const Index f : round_[v]) {
    std::array<Index, 3> t = triangles_[f];
    if (std::find(t.begin(), t.end(), w) != t.end()) continue;
    std::replace(t.begin(), t.end(), v, w);
    out.emplace_back(f, t);
  }
}

void CollapsibleMesh::collapse(Index v, Index w) {
  neighbours(v, near_v_);
  for (const Index u : near_v_)
    for (auto* edges : {&kept_, &border_})
      if (edges->erase(edge_key(v, u)) > 0 && u != w) edges->insert(edge_key(w, u));
  for (const Index f : round_[v]) {
    std::array<Index, 3>& t = triangles_[f];
    if (std::find(t.begin(), t.end(), w) == t.end()) {
      std::replace(t.begin(), t.end(), v, w);
      round_[w].push_back(f);
      continue;
    }
    alive_[f] = 0;
    --count_;
    for (const Index u : t)
      if (u != v) std::erase(round_[u], f);
  }
  std::sort(round_[w].begin(), round_[w].end());
  round_[v].clear();
  freedom_[v] = Freedom::fixed;
}

}  // namespace hariko
