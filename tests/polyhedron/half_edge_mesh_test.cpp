#include "core/polyhedron/half_edge_mesh.hpp"

#include <map>
#include <set>
#include <utility>

#include "core/polyhedron/polyhedron.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {
namespace {

HalfEdgeMesh built_mesh(const PolygonMesh& mesh) {
  Result<HalfEdgeMesh> result = must(HalfEdgeMesh::build(mesh));
  return std::move(result).value();
}

long euler_number(const HalfEdgeMesh& mesh) {
  long used = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) used += mesh.outgoing(v) != no_index;
  return used - static_cast<long>(mesh.edge_count()) + static_cast<long>(mesh.face_count());
}

Index component_count(const HalfEdgeMesh& mesh) {
  const std::vector<Index> component = mesh.face_components();
  return *std::max_element(component.begin(), component.end()) + 1;
}

/// Twins straight from the definition, with a map.
std::map<std::pair<Index, Index>, Index> directed_edges(const PolygonMesh& mesh) {
  std::map<std::pair<Index, Index>, Index> out;
  Index h = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) out[{face[i], face[(i + 1) % face.size()]}] = h++;
  }
  return out;
}

void expect_links(const PolygonMesh& polygons, const HalfEdgeMesh& mesh) {
  const auto directed = directed_edges(polygons);
  ASSERT_EQ(mesh.half_edge_count(), directed.size());
  std::set<Index> edges;
  for (const auto& [ends, h] : directed) {
    const auto [a, b] = ends;
    EXPECT_EQ(mesh.origin(h), a);
    EXPECT_EQ(mesh.target(h), b);
    EXPECT_EQ(mesh.previous(mesh.next(h)), h);
    EXPECT_EQ(mesh.face(mesh.next(h)), mesh.face(h));
    const auto opposite = directed.find({b, a});
    EXPECT_EQ(mesh.twin(h), opposite == directed.end() ? no_index : opposite->second);
    EXPECT_EQ(mesh.find_half_edge(a, b), h);
    if (opposite == directed.end()) {
      EXPECT_EQ(mesh.find_half_edge(b, a), no_index);
    }
    const Index e = mesh.edge(h);
    edges.insert(e);
    EXPECT_EQ(mesh.half_edge_of_edge(e), std::min(h, mesh.twin(h)));
    EXPECT_EQ(mesh.is_border_edge(e), mesh.twin(h) == no_index);
  }
  EXPECT_EQ(edges.size(), mesh.edge_count());
  EXPECT_TRUE(edges.empty() || *edges.rbegin() + 1 == mesh.edge_count());
}

/// Walks every fan: each corner of the vertex once, in counter-clockwise order, opened by the border edge if
/// any.
void expect_fans(const HalfEdgeMesh& mesh) {
  std::vector<Index> corners(mesh.vertex_count(), 0);
  for (Index h = 0; h < mesh.half_edge_count(); ++h) ++corners[mesh.origin(h)];
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(mesh.corner_count(v), corners[v]);
    const Index start = mesh.outgoing(v);
    if (start == no_index) {
      EXPECT_EQ(corners[v], 0U);
      EXPECT_TRUE(fan_ends(mesh, v).empty());
      continue;
    }
    std::set<Index> seen;
    std::vector<Index> walked, listed;
    Index h = start, last = no_index;
    while (h != no_index && seen.insert(h).second) {
      EXPECT_EQ(mesh.origin(h), v);
      walked.push_back(h);
      // The edge that closes a corner opens the next one.
      const Index next = mesh.rotate(h);
      if (next != no_index) {
        EXPECT_EQ(mesh.edge(next), mesh.edge(mesh.previous(h)));
      }
      last = h;
      h = next;
    }
    EXPECT_EQ(seen.size(), corners[v]);
    for (const Index corner : mesh.fan_corners(v)) listed.push_back(corner);
    EXPECT_EQ(listed, walked);
    const std::vector<FanEnd> ends = fan_ends(mesh, v);
    ASSERT_EQ(ends.size(), mesh.valence(v));
    for (std::size_t k = 0; k < walked.size(); ++k) {
      EXPECT_EQ(ends[k].end, 2 * walked[k]);
      EXPECT_EQ(ends[k].other, mesh.target(walked[k]));
    }
    if (mesh.is_border_vertex(v)) {
      EXPECT_EQ(ends.back().end, 2 * mesh.previous(last) + 1);
      EXPECT_EQ(ends.back().other, mesh.origin(mesh.previous(last)));
      EXPECT_EQ(h, no_index);
      EXPECT_TRUE(mesh.is_border_edge(mesh.edge(start)));
      EXPECT_TRUE(mesh.is_border_edge(mesh.edge(mesh.previous(last))));
      EXPECT_EQ(mesh.valence(v), corners[v] + 1);
    } else {
      EXPECT_EQ(h, start);
      EXPECT_EQ(mesh.valence(v), corners[v]);
    }
  }
}

TEST(HalfEdgeMesh, InvariantsOfRandomPolyhedra) {
  for_random(101, 300, [](std::mt19937_64& rng) {
    const PolygonMesh polygons = random_polyhedron(rng);
    const HalfEdgeMesh mesh = built_mesh(polygons);
    expect_links(polygons, mesh);
    expect_fans(mesh);
    // V - E + F = 2 (components - genus) - loops: even once the loops are filled, and at most that of
    // spheres.
    const long filled = euler_number(mesh) + static_cast<long>(mesh.border_loop_count());
    EXPECT_EQ(filled % 2, 0);
    EXPECT_LE(filled, 2 * static_cast<long>(component_count(mesh)));
  });
}

TEST(HalfEdgeMesh, FanRunsCounterClockwise) {
  // Vertex 4 in the middle of a 2 x 2 grid seen from above: directions turn left by a right angle each.
  const PolygonMesh polygons = grid(2, 2);
  const HalfEdgeMesh mesh = built_mesh(polygons);
  Index h = mesh.outgoing(4);
  for (int k = 0; k < 4; ++k) {
    const Index next = mesh.rotate(h);
    const Vector3 a = polygons.positions[mesh.target(h)], b = polygons.positions[mesh.target(next)];
    EXPECT_GT(a.x() * b.y() - a.y() * b.x(), 0);
    h = next;
  }
  EXPECT_EQ(h, mesh.outgoing(4));
  // Corner vertex 0: one corner, from the border edge along x to the one along y.
  EXPECT_EQ(mesh.target(mesh.outgoing(0)), 1U);
  EXPECT_EQ(mesh.origin(mesh.previous(mesh.outgoing(0))), 3U);
  EXPECT_EQ(mesh.valence(0), 2U);
  // Border vertex 1: e_0 has no face on its right, so it runs along the border in the direction of x.
  EXPECT_EQ(mesh.target(mesh.outgoing(1)), 2U);
}

struct Counts {
  const char* name;
  PolygonMesh mesh;
  long euler;
  Index loops, components;
};

TEST(HalfEdgeMesh, EulerNumbersLoopsAndComponents) {
  const std::vector<Counts> cases = {
      {"cube", cube(), 2, 0, 1},
      {"octahedron", octahedron(), 2, 0, 1},
      {"prism 20", prism(20), 2, 0, 1},
      {"pyramid 7", pyramid(7), 2, 0, 1},
      {"torus", torus(8, 4), 0, 0, 1},
      {"genus 0", genus_box(0), 2, 0, 1},
      {"genus 3", genus_box(3), -4, 0, 1},
      {"genus 6", genus_box(6), -10, 0, 1},
      {"grid", grid(5, 2), 1, 1, 1},
      {"open prism", without_face(without_face(prism(6), 0), 0), 0, 2, 1},
      {"torus with a hole", without_face(torus(5, 5), 3), -1, 1, 1},
      {"two cubes", together(cube(), cube(), {5, 0, 0}), 4, 0, 2},
      {"cube and grid", together(cube(), grid(1, 1), {5, 0, 0}), 3, 1, 2},
  };
  for (const Counts& c : cases) {
    SCOPED_TRACE(c.name);
    const HalfEdgeMesh mesh = built_mesh(c.mesh);
    EXPECT_EQ(euler_number(mesh), c.euler);
    EXPECT_EQ(mesh.border_loop_count(), c.loops);
    EXPECT_EQ(component_count(mesh), c.components);
  }
}

TEST(HalfEdgeMesh, ComponentsAreNumberedByTheirFirstFace) {
  const HalfEdgeMesh mesh = built_mesh(together(cube(), octahedron(), {5, 0, 0}));
  const std::vector<Index> component = mesh.face_components();
  for (Index f = 0; f < 14; ++f) EXPECT_EQ(component[f], f < 6 ? 0U : 1U);
}

TEST(HalfEdgeMesh, HubOfManyEdges) {
  // A vertex with 200,000 edges must not make the build quadratic.
  const int n = 200000;
  PolygonMesh fan;
  fan.positions.assign(static_cast<std::size_t>(n) + 1, Vector3::Zero());
  // Faces in an order far from that of their vertices (7919 is coprime to n).
  for (long k = 0; k < n; ++k) {
    const long i = k * 7919 % n;
    fan.add_face({0, static_cast<Index>(1 + i), static_cast<Index>(1 + (i + 1) % n)});
  }
  const HalfEdgeMesh mesh = built_mesh(fan);
  EXPECT_EQ(mesh.valence(0), static_cast<Index>(n));
  EXPECT_EQ(mesh.border_loop_count(), 1U);
}

TEST(HalfEdgeMesh, IsolatedVerticesHaveNoFan) {
  PolygonMesh polygons = cube();
  polygons.positions.emplace_back(9, 9, 9);
  const HalfEdgeMesh mesh = built_mesh(polygons);
  EXPECT_EQ(mesh.outgoing(8), no_index);
  EXPECT_EQ(mesh.valence(8), 0U);
  EXPECT_FALSE(mesh.is_border_vertex(8));
  EXPECT_EQ(mesh.find_half_edge(8, 0), no_index);
  EXPECT_EQ(mesh.find_half_edge(0, 8), no_index);
}

}  // namespace
}  // namespace hariko::test
