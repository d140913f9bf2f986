#include "core/approximation/refinement/parameter_mesh.hpp"

#include "core/base/assert.hpp"

namespace hariko {

ParameterPieces pieces_of(const ParameterFacet& facet) {
  ParameterPieces out;
  out.triangle[0] = facet.parameter;
  if (facet.pole < 0) return out;
  const auto pole = std::size_t(facet.pole);
  const Vector2 &next = facet.parameter[(pole + 1) % 3], &previous = facet.parameter[(pole + 2) % 3];
  out.triangle[0] = {facet.parameter[pole], next, previous};
  out.triangle[1] = {facet.pole_parameter, facet.parameter[pole], previous};
  out.count = 2;
  return out;
}

ParameterLine ParameterMesh::line(Index half_edge) const {
  const ParameterFacet& facet = facets[facet_of(half_edge)];
  return {facet.patch, facet.leaving(half_edge % 3), facet.arriving(next_of(half_edge) % 3)};
}

ParameterLine ParameterMesh::canonical_line(Index half_edge) const {
  Index owner = half_edge;
  if (const Index other = twin[half_edge]; other != no_index) {
    const Index mine = facets[facet_of(half_edge)].patch, theirs = facets[facet_of(other)].patch;
    if (theirs < mine || (theirs == mine && other < half_edge)) owner = other;
  }
  ParameterLine out = line(owner);
  if (from(owner) > to(owner)) std::swap(out.from, out.to);
  return out;
}

Index ParameterMesh::add_facet(const ParameterFacet& facet) {
  facets.push_back(facet);
  twin.insert(twin.end(), 3, no_index);
  return static_cast<Index>(facets.size() - 1);
}

/// Cuts facet f = (a, b, o), with a -> b the half-edge: it becomes (a, m, o), and a new one (m, b, o) is
/// added.
void ParameterMesh::cut(Index half_edge, Index vertex, const Vector2& parameter, Split& out) {
  const Index f = facet_of(half_edge), c = half_edge % 3, b = (c + 1) % 3, o = (c + 2) % 3;
  ParameterFacet second = facets[f];
  ParameterFacet& first = facets[f];
  // The cut ends between the pole's two parameters where the pole is opposite.
  if (first.pole == std::int32_t(o)) {
    const double span = (first.parameter[b] - first.parameter[c]).norm();
    const double t = span > 0 ? (parameter - first.parameter[c]).norm() / span : 0.5;
    const Vector2 middle = first.parameter[o] + t * (first.pole_parameter - first.parameter[o]);
    first.pole_parameter = middle;
    second.parameter[o] = middle;
  }
  if (first.pole == std::int32_t(b)) first.pole = -1;
  if (second.pole == std::int32_t(c)) second.pole = -1;
  first.vertex[b] = vertex;
  first.parameter[b] = parameter;
  second.vertex[c] = vertex;
  second.parameter[c] = parameter;

  const Index g = add_facet(second);
  const Index opposite = twin[3 * f + b];
  if (opposite != no_index) link(3 * g + b, opposite);
  link(3 * f + b, 3 * g + o);
  out.facets[std::size_t(out.count++)] = f;
  out.facets[std::size_t(out.count++)] = g;
  out.edges[std::size_t(out.edge_count++)] = 3 * f + b;
}

ParameterMesh::Split ParameterMesh::split(Index half_edge, double t, const Vector3& position) {
  Split out;
  out.vertex = static_cast<Index>(positions.size());
  const Index other = twin[half_edge];
  HARIKO_ASSERT(other == no_index || facet_of(other) != facet_of(half_edge), "a facet is its own neighbour");
  const auto local = [&](Index h) { return from(h) < to(h) ? t : 1 - t; };
  const Vector2 mine = line(half_edge).at(local(half_edge));
  const Vector2 theirs = other != no_index ? line(other).at(local(other)) : Vector2::Zero();
  positions.push_back(position);
  cut(half_edge, out.vertex, mine, out);
  const Index first = 3 * out.facets[0] + half_edge % 3, second = 3 * out.facets[1] + half_edge % 3;
  if (other != no_index) {
    cut(other, out.vertex, theirs, out);
    link(first, 3 * out.facets[3] + other % 3);
    link(second, 3 * out.facets[2] + other % 3);
  }
  out.edges[std::size_t(out.edge_count++)] = first;
  out.edges[std::size_t(out.edge_count++)] = second;
  return out;
}

}  // namespace hariko
