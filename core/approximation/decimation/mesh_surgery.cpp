#include "core/approximation/decimation/mesh_surgery.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/index_list.hpp"

namespace hariko {

namespace {

constexpr double least_area = 1e-9;  ///< least doubled area of a facet's parameters

double twice_area(const ParameterTriangle& t) {
  const Vector2 a = t[1] - t[0], b = t[2] - t[0];
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

void MeshSurgery::Change::clear() {
  facets.clear();
  before.clear();
  twins.clear();
  removed.clear();
  position.reset();
}

MeshSurgery::MeshSurgery(const SurfaceSampler& sampler, ParameterMesh& mesh)
    : sampler_(sampler),
      mesh_(mesh),
      alive_(mesh.facets.size(), 1),
      leaving_(mesh.positions.size(), no_index),
      count_(mesh.facets.size()) {
  for (Index h = 0; h < mesh.twin.size(); ++h) leaving_[mesh.from(h)] = h;
}

void MeshSurgery::star(Index vertex, std::vector<Index>& out) const {
  out.clear();
  const Index start = leaving_[vertex];
  for (Index h = start;;) {
    out.push_back(h);
    h = mesh_.twin[previous_of(h)];
    if (h == start || h == no_index) {
      if (h == start) return;
      break;
    }
  }
  for (Index h = mesh_.twin[start]; h != no_index; h = mesh_.twin[next_of(h)]) out.push_back(next_of(h));
  // Each step gives the half-edge that arrives; its next one leaves.
}

bool MeshSurgery::is_border_edge(Index h) const {
  const Index other = mesh_.twin[h];
  if (other == no_index) return true;
  const ParameterFacet &mine = mesh_.facets[facet_of(h)], &theirs = mesh_.facets[facet_of(other)];
  // A patch that closes on itself has two parameters along its seam.
  return mine.patch != theirs.patch || mine.leaving(h % 3) != theirs.arriving(next_of(other) % 3) ||
         mine.arriving(next_of(h) % 3) != theirs.leaving(other % 3);
}

bool MeshSurgery::at_domain_corner(const Vector2& p) const {
  const Domain domain = sampler_.surface().domain();
  for (int c = 0; c < corner_count(domain); ++c)
    if ((p - corner_parameter(domain, c)).cwiseAbs().maxCoeff() < 1e-12) return true;
  return false;
}

MeshSurgery::Freedom MeshSurgery::freedom(Index vertex) const {
  star(vertex, star_);
  int borders = 0;
  for (const Index h : star_) {
    const ParameterFacet& facet = mesh_.facets[facet_of(h)];
    if (facet.pole >= 0 || facet.degenerate() || at_domain_corner(facet.parameter[h % 3]))
      return Freedom::fixed;
    borders += is_border_edge(h);
    // The last facet of an open star has a border edge that arrives.
    if (mesh_.twin[previous_of(h)] == no_index) ++borders;
  }
  return borders == 0 ? Freedom::inside : borders == 2 ? Freedom::border : Freedom::fixed;
}

bool MeshSurgery::turned(Index facet) const {
  return !(twice_area(mesh_.facets[facet].parameter) > least_area);
}

bool MeshSurgery::linked(Index a, Index b) const {
  star(a, other_star_);
  return std::any_of(other_star_.begin(), other_star_.end(),
                     [&](Index h) { return mesh_.to(h) == b || mesh_.from(previous_of(h)) == b; });
}

void MeshSurgery::set_twin(Index half_edge, Index other, Change& change) {
  change.twins.emplace_back(half_edge, mesh_.twin[half_edge]);
  mesh_.twin[half_edge] = other;
}

void MeshSurgery::save(Index facet, Change& change) {
  change.before.emplace_back(facet, mesh_.facets[facet]);
}

bool MeshSurgery::keeps_manifold(Index half_edge) const {
  star(mesh_.from(half_edge), star_);
  // Link condition: common neighbours are the corners opposite to the edge, and no others.
  std::vector<Index> round_v, round_w;
  const auto neighbours = [&](const std::vector<Index>& leaving, std::vector<Index>& out) {
    for (const Index h : leaving) {
      out.push_back(mesh_.to(h));
      out.push_back(mesh_.from(previous_of(h)));
    }
    sort_unique(out);
  };
  neighbours(star_, round_v);
  star(mesh_.to(half_edge), other_star_);
  neighbours(other_star_, round_w);
  std::vector<Index> both;
  std::set_intersection(round_v.begin(), round_v.end(), round_w.begin(), round_w.end(),
                        std::back_inserter(both));
  // At least one facet must remain in the star.
  const std::size_t opposite = mesh_.twin[half_edge] == no_index ? 1 : 2;
  return both.size() == opposite && star_.size() > opposite;
}

bool MeshSurgery::collapse(Index half_edge, Change& change) {
  change.clear();
  const Index v = mesh_.from(half_edge), w = mesh_.to(half_edge), across = mesh_.twin[half_edge];
  const Freedom own = freedom(v);
  if (own == Freedom::fixed || (own == Freedom::border && !is_border_edge(half_edge))) return false;
  if (!keeps_manifold(half_edge)) return false;

  // Parameter of w, in the patch on the facet's side of the border that v lies on.
  const auto parameter_of = [&](const ParameterFacet& facet, Index h) -> std::optional<Vector2> {
    for (const Index e : {half_edge, across}) {
      if (e == no_index) continue;
      const ParameterFacet& at = mesh_.facets[facet_of(e)];
      if (at.patch != facet.patch || at.pole >= 0) continue;
      const Index mine = e == half_edge ? e % 3 : next_of(e) % 3,
                  other = e == half_edge ? next_of(e) % 3 : e % 3;
      if (at.parameter[mine] == facet.parameter[h % 3]) return at.parameter[other];
    }
    return std::nullopt;
  };
  std::vector<std::pair<Index, Vector2>> targets;
  for (const Index h : star_) {
    const ParameterFacet& facet = mesh_.facets[facet_of(h)];
    if (mesh_.to(h) == w || mesh_.from(previous_of(h)) == w) continue;
    const auto target = parameter_of(facet, h);
    if (!target) return false;
    targets.emplace_back(h, *target);
  }
  for (const auto& [h, target] : targets) {
    const Index f = facet_of(h);
    save(f, change);
    mesh_.facets[f].vertex[h % 3] = w;
    mesh_.facets[f].parameter[h % 3] = target;
    change.facets.push_back(f);
  }
  const auto close = [&](Index a, Index b) {
    const Index x = mesh_.twin[a], y = mesh_.twin[b];
    if (x != no_index) set_twin(x, y, change);
    if (y != no_index) set_twin(y, x, change);
  };
  close(next_of(half_edge), previous_of(half_edge));
  if (across != no_index) close(next_of(across), previous_of(across));
  change.removed.push_back(facet_of(half_edge));
  if (across != no_index) change.removed.push_back(facet_of(across));
  // No facet may be inverted in its parameters.
  for (const Index f : change.facets) {
    if (turned(f)) {
      undo(change);
      return false;
    }
  }
  return true;
}

bool MeshSurgery::flip(Index h, Change& change) {
  change.clear();
  const Index g = mesh_.twin[h];
  if (g == no_index || is_border_edge(h)) return false;
  const Index f1 = facet_of(h), f2 = facet_of(g);
  if (mesh_.facets[f1].pole >= 0 || mesh_.facets[f2].pole >= 0) return false;
  const Index c = mesh_.from(previous_of(h)), d = mesh_.from(previous_of(g));
  if (c == d || linked(c, d)) return false;
  // f1 = (a, b, c) and f2 = (b, a, d) become (a, d, c) and (b, c, d).
  const Index i = h % 3, j = g % 3;
  const ParameterFacet first = mesh_.facets[f1], second = mesh_.facets[f2];
  const Index bc = mesh_.twin[next_of(h)], ad = mesh_.twin[next_of(g)];
  save(f1, change);
  save(f2, change);
  mesh_.facets[f1].vertex[(i + 1) % 3] = d;
  mesh_.facets[f1].parameter[(i + 1) % 3] = second.parameter[(j + 2) % 3];
  mesh_.facets[f2].vertex[(j + 1) % 3] = c;
  mesh_.facets[f2].parameter[(j + 1) % 3] = first.parameter[(i + 2) % 3];
  // f1: a->d (at h), d->c (next), c->a; f2: b->c (at g), c->d (next), d->b.
  set_twin(h, ad, change);
  if (ad != no_index) set_twin(ad, h, change);
  set_twin(g, bc, change);
  if (bc != no_index) set_twin(bc, g, change);
  set_twin(next_of(h), next_of(g), change);
  set_twin(next_of(g), next_of(h), change);
  change.facets = {f1, f2};
  if (!turned(f1) && !turned(f2)) return true;
  undo(change);
  return false;
}

bool MeshSurgery::move(Index vertex, const Vector2& by, Change& change) {
  change.clear();
  star(vertex, star_);
  const Index patch = mesh_.facets[facet_of(star_[0])].patch;
  const Vector2 at = mesh_.facets[facet_of(star_[0])].parameter[star_[0] % 3] + by;
  for (const Index h : star_) {
    const Index f = facet_of(h);
    save(f, change);
    mesh_.facets[f].parameter[h % 3] = at;
    change.facets.push_back(f);
  }
  for (const Index f : change.facets)
    if (turned(f)) {
      undo(change);
      return false;
    }
  change.position = {vertex, mesh_.positions[vertex]};
  sampler_.positions(patch, {&at, 1}, {&mesh_.positions[vertex], 1});
  return true;
}

bool MeshSurgery::slide(Index half_edge, double t, Change& change) {
  change.clear();
  const Index vertex = mesh_.from(half_edge), across = mesh_.twin[half_edge];
  star(vertex, star_);
  const ParameterLine mine = mesh_.line(half_edge);
  ParameterLine theirs = across != no_index ? mesh_.line(across) : mine;
  std::swap(theirs.from, theirs.to);
  if (across == no_index) theirs = mine;
  const ParameterLine owner = theirs.patch < mine.patch ? theirs : mine;
  for (const Index h : star_) {
    const Index f = facet_of(h);
    ParameterFacet& facet = mesh_.facets[f];
    save(f, change);
    change.facets.push_back(f);
    const Vector2 own = facet.parameter[h % 3];
    if (facet.patch == mine.patch && own == mine.from)
      facet.parameter[h % 3] = mine.at(t);
    else
      facet.parameter[h % 3] = theirs.at(t);
  }
  for (const Index f : change.facets)
    if (turned(f)) {
      undo(change);
      return false;
    }
  change.position = {vertex, mesh_.positions[vertex]};
  const Vector2 at = owner.at(t);
  sampler_.positions(owner.patch, {&at, 1}, {&mesh_.positions[vertex], 1});
  return true;
}

void MeshSurgery::undo(const Change& change) {
  for (auto it = change.twins.rbegin(); it != change.twins.rend(); ++it) mesh_.twin[it->first] = it->second;
  for (auto it = change.before.rbegin(); it != change.before.rend(); ++it)
    mesh_.facets[it->first] = it->second;
  if (change.position) mesh_.positions[change.position->first] = change.position->second;
}

void MeshSurgery::keep(const Change& change) {
  for (const Index f : change.removed) {
    alive_[f] = 0;
    --count_;
    for (const Index v : mesh_.facets[f].vertex)
      if (leaving_[v] != no_index && facet_of(leaving_[v]) == f) leaving_[v] = no_index;
  }
  // Every vertex of a removed or changed facet gets a half-edge of a living facet.
  const auto claim = [&](Index f) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) leaving_[mesh_.from(h)] = h;
  };
  for (const Index f : change.removed)
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (mesh_.twin[h] != no_index && alive_[facet_of(mesh_.twin[h])]) claim(facet_of(mesh_.twin[h]));
  for (const Index f : change.facets)
    if (alive_[f]) claim(f);
  for (const auto& [f, before] : change.before)
    for (const Index v : before.vertex)
      if (leaving_[v] != no_index && mesh_.from(leaving_[v]) != v) leaving_[v] = no_index;
}

ParameterMesh MeshSurgery::compact(const ParameterMesh& mesh, const std::vector<char>& alive) {
  ParameterMesh out;
  std::vector<Index> facet(mesh.facets.size(), no_index), vertex(mesh.positions.size(), no_index);
  for (Index f = 0; f < mesh.facets.size(); ++f) {
    if (!alive[f]) continue;
    facet[f] = static_cast<Index>(out.facets.size());
    ParameterFacet copy = mesh.facets[f];
    for (Index& v : copy.vertex) {
      if (vertex[v] == no_index) {
        vertex[v] = static_cast<Index>(out.positions.size());
        out.positions.push_back(mesh.positions[v]);
      }
      v = vertex[v];
    }
    out.add_facet(copy);
  }
  for (Index h = 0; h < mesh.twin.size(); ++h)
    if (facet[facet_of(h)] != no_index && mesh.twin[h] != no_index)
      out.twin[3 * facet[facet_of(h)] + h % 3] = 3 * facet[facet_of(mesh.twin[h])] + mesh.twin[h] % 3;
  return out;
}

}  // namespace hariko
