// Facet graphs: what can be unfolded and what cannot, edges, angles of folds, and facets in the plane.

#include "core/unfolding/facet_graph.hpp"

#include <algorithm>
#include <numbers>

#include "core/base/ids.hpp"
#include "core/polyhedron/validation.hpp"
#include "core/unfolding/cuts/facet_layout.hpp"
#include "tests/unfolding/check_layout.hpp"
#include "tests/unfolding/meshes.hpp"

namespace hariko::test {
namespace {

PolygonMesh three_at_an_edge() {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  mesh.add_face({0, 1, 2});
  mesh.add_face({1, 0, 3});
  mesh.add_face({0, 1, 4});
  return mesh;
}

TEST(FacetGraph, RefusalsNameTheElement) {
  const auto refused = FacetGraph::build(three_at_an_edge());
  must_fail(refused, e_edge_nonmanifold_or_flipped);
  EXPECT_EQ(refused.error().element, element_of(EdgeId{{0}, {1}}));
  EXPECT_NE(refused.error().text.find("non-manifold edge: 3 facets share edge (0,1)"), std::string::npos);

  PolygonMesh crossed;
  crossed.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}};
  crossed.add_face({1, 4, 2});
  crossed.add_face({0, 2, 1, 3});
  const auto bow = FacetGraph::build(crossed);
  must_fail(bow, e_facet_degenerate);
  EXPECT_EQ(bow.error().element, element_of(FaceId{1}));
  EXPECT_NE(bow.error().text.find("facet 1 has no area, or crosses itself"), std::string::npos);

  PolygonMesh flat;
  flat.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  flat.add_face({0, 1, 2});
  const auto degenerate = FacetGraph::build(flat);
  must_fail(degenerate, e_facet_degenerate);
  EXPECT_NE(degenerate.error().text.find("degenerate facet 0 has zero area"), std::string::npos);

  PolygonMesh flipped;
  flipped.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  flipped.add_face({0, 1, 2});
  flipped.add_face({0, 3, 2});
  const auto opposite = FacetGraph::build(flipped);
  ASSERT_FALSE(opposite.ok());
  EXPECT_EQ(opposite.error().element, element_of(EdgeId{{0}, {2}}));

  EXPECT_EQ(FacetGraph::build({}).error().code, e_no_faces);
}

TEST(FacetGraph, AllFaultsAreListed) {
  PolygonMesh mesh = three_at_an_edge();
  const auto first = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {{5, 0, 0}, {6, 0, 0}, {7, 0, 0}, {8, 0, 0}, {8, 1, 0}});
  mesh.add_face({first, first + 1, first + 2});
  mesh.add_face({first, first + 1, first + 2, first + 3});
  const std::vector<Message> errors = unfolding_errors(mesh);
  const auto has = [&](Code code) {
    return std::any_of(errors.begin(), errors.end(), [&](const Message& m) { return m.code == code; });
  };
  EXPECT_EQ(std::count_if(errors.begin(), errors.end(),
                          [](const Message& m) { return m.code == e_facet_degenerate; }),
            2);
  EXPECT_TRUE(has(e_edge_nonmanifold_or_flipped));
}

TEST(FacetGraph, FoldAnglesOfASolidAreMountains) {
  const PolygonMesh sphere = icosphere(0);
  const auto graph = must(FacetGraph::build(sphere));
  EXPECT_EQ(graph->edge_count(), 30U);
  const double wanted = std::numbers::pi - std::acos(-std::sqrt(5.0) / 3);
  for (const FacetEdge& edge : graph->edges()) EXPECT_NEAR(edge.fold_angle, wanted, 1e-12);
  PolygonMesh hollow = sphere;
  for (std::size_t f = 0; f < hollow.face_count(); ++f)
    std::swap(hollow.face_vertices[3 * f], hollow.face_vertices[3 * f + 1]);
  const auto inside_out = must(FacetGraph::build(hollow));
  for (const FacetEdge& edge : inside_out->edges()) EXPECT_NEAR(edge.fold_angle, -wanted, 1e-12);
}

TEST(FacetGraph, NeighboursAreMutual) {
  for_random(21, 20, [&](std::mt19937_64& rng) {
    const auto graph = must(FacetGraph::build(random_sheet(rng)));
    for (Index f = 0; f < graph->facet_count(); ++f)
      for (Index side = 0; side < 3; ++side) {
        const FacetEdge& edge = graph->edge(graph->edge_at(f, side));
        EXPECT_EQ(graph->find_edge(edge.high, edge.low), graph->edge_at(f, side));
        const Index next = graph->neighbour(f, side);
        if (next == no_index) continue;
        const Index mate = graph->mate_side(f, side);
        EXPECT_EQ(graph->neighbour(next, mate), f);
        EXPECT_EQ(graph->triangle(f)[side], graph->triangle(next)[(mate + 1) % 3]);
        EXPECT_EQ(graph->component(next), graph->component(f));
      }
  });
}

TEST(FacetLayout, AnyForestOfFoldsIsIsometric) {
  for_random(22, 40, [&](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_sheet(rng);
    const auto graph = must(FacetGraph::build(mesh));
    CheckedLayout checked;
    checked.scale = log_uniform(rng, 0.1, 100);
    Folds folds(graph->edge_count(), 0);
    std::vector<Index> group(graph->facet_count());
    std::iota(group.begin(), group.end(), Index{0});
    for (Index e = 0; e < graph->edge_count(); ++e) {
      const FacetEdge& edge = graph->edge(e);
      if (edge.border() || chance(rng, 0.2) || group[edge.facets[0]] == group[edge.facets[1]]) continue;
      folds[e] = 1;
      checked.folds.emplace_back(edge.facets[0], edge.facets[1]);
      const Index from = group[edge.facets[0]], to = group[edge.facets[1]];
      std::replace(group.begin(), group.end(), from, to);
    }
    const FlatLayout layout = lay_out(*graph, facet_shapes(*graph, checked.scale), folds);
    checked.corners = layout.corners;
    checked.piece = checked.sheet = layout.piece_of;
    check_shape(mesh, checked);
  });
}

}  // namespace
}  // namespace hariko::test
