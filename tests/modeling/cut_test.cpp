// Cutting faces: connecting points, paths, splitting.

#include "core/modeling/cuts/cut.hpp"

#include "core/document/edits/edit_elements.hpp"
#include "core/modeling/cuts/diagonal.hpp"
#include "tests/modeling/support.hpp"

namespace hariko::test {
namespace {

using Vertices = std::vector<VertexId>;
using Edges = std::vector<EdgeId>;

PolygonMesh ell() {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  mesh.add_face({0, 1, 2, 3, 4, 5});
  return mesh;
}

TEST(Diagonal, OfAConcavePolygon) {
  const std::vector<Vector3> corners = ell().positions;
  const auto inner = [&](std::size_t i, std::size_t j) {
    EXPECT_EQ(is_inner_diagonal(corners, i, j), is_inner_diagonal(corners, j, i));
    return is_inner_diagonal(corners, i, j);
  };
  EXPECT_TRUE(inner(0, 3));
  EXPECT_TRUE(inner(0, 2));
  EXPECT_TRUE(inner(1, 3));
  EXPECT_FALSE(inner(2, 4)) << "outside";
  EXPECT_FALSE(inner(1, 4)) << "through the notch's corner";
  EXPECT_FALSE(inner(0, 1)) << "a side";
  EXPECT_FALSE(inner(5, 0)) << "a side";
  EXPECT_FALSE(inner(3, 3));
}

TEST(ConnectPoints, TwoCornersOfACube) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult out = connect_points(cube, Vertices{{4}, {6}}, {}).value();
  EXPECT_EQ(counts(out.source), "8/13/7");
  EXPECT_EQ(out.selection.edges, std::set<EdgeId>{edge(4, 6)});
  expect_areas(out.source, 1);
  expect_error(connect_points(out.source, Vertices{{4}, {6}}, {}), e_wrong_selection);
  expect_error(connect_points(cube, Vertices{{4}, {5}}, {}), e_wrong_selection);
  expect_error(connect_points(cube, Vertices{{0}, {6}}, {}), e_wrong_selection);
  expect_error(connect_points(cube, Vertices{{0}}, {}), e_wrong_selection);
  expect_error(connect_points(cube, {}, {}), e_nothing_selected);
  expect_error(connect_points(cube, Vertices{{8}, {0}}, {}), e_unknown_element);
  expect_error(connect_points(cube, {}, Edges{edge(0, 6)}), e_unknown_element);
}

TEST(ConnectPoints, EdgesAreConnectedAtTheirMiddles) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult ring =
      connect_points(cube, {}, Edges{edge(0, 4), edge(1, 5), edge(2, 6), edge(3, 7)}).value();
  EXPECT_EQ(counts(ring.source), "12/20/10") << "as a loop cut";
  EXPECT_EQ(ring.selection.edges.size(), 4U);
  const EditResult mixed = connect_points(cube, Vertices{{4}}, Edges{edge(5, 6)}).value();
  EXPECT_EQ(counts(mixed.source), "9/14/7");
  const EditResult four =
      connect_points(cube, {}, Edges{edge(4, 5), edge(5, 6), edge(6, 7), edge(4, 7)}).value();
  EXPECT_EQ(counts(four.source), "12/20/10") << "a square within the square";
  expect_areas(four.source, 0.4);
}

TEST(ConnectPoints, AChainOverSeveralFaces) {
  const PolyhedronSource sheet = source_of(test::grid(3, 3));
  const EditResult out = connect_points(sheet, Vertices{{0}, {5}, {10}, {15}}, {}).value();
  EXPECT_EQ(counts(out.source), "16/27/12");
  EXPECT_EQ(out.selection.edges, (std::set<EdgeId>{edge(0, 5), edge(5, 10), edge(10, 15)}));
  EXPECT_EQ(out.source.shaping->tag.get_or({0}, VertexTag::automatic), VertexTag::corner)
      << "the outline keeps its corner";
}

TEST(ConnectPoints, NotThroughTheOutside) {
  const PolyhedronSource source = source_of(ell());
  expect_error(connect_points(source, Vertices{{2}, {4}}, {}), e_wrong_selection);
  EXPECT_EQ(counts(connect_points(source, Vertices{{0}, {3}}, {}).value().source), "6/7/2");
}

TEST(CutPath, AcrossFacesThroughPointsOnEdges) {
  const PolyhedronSource cube = source_of(test::cube());
  const std::vector<CutPoint> path{VertexId{4}, EdgePoint{edge(5, 6), 0.25}, EdgePoint{edge(1, 2), 0.5},
                                   EdgePoint{edge(0, 3), 0.5}};
  const EditResult out = cut_path(cube, path).value();
  EXPECT_EQ(counts(out.source), "11/18/9");
  EXPECT_EQ(out.selection.edges.size(), 3U);
  const Index first = out.source.polyhedron.find(VertexId{9});
  EXPECT_EQ(out.source.polyhedron.position(out.source.polyhedron.find(VertexId{10})), Vector3(1, -0.5, 1))
      << "a quarter from vertex 5";
  EXPECT_NE(first, no_index);
  expect_planar(out.source, 1e-15);
  expect_surface(out.source);

  const std::vector<CutPoint> two_on_one{EdgePoint{edge(4, 5), 0.75}, EdgePoint{edge(6, 7), 0.5},
                                         EdgePoint{edge(4, 5), 0.25}};
  EXPECT_EQ(counts(cut_path(cube, two_on_one).value().source), "11/17/8");
}

TEST(CutPath, Refusals) {
  const PolyhedronSource cube = source_of(test::cube());
  const auto cut = [&](std::vector<CutPoint> path) { return cut_path(cube, path); };
  expect_error(cut({}), e_nothing_selected);
  expect_error(cut({VertexId{0}}), e_nothing_selected);
  expect_error(cut({VertexId{0}, VertexId{0}}), e_nothing_selected);
  expect_error(cut({VertexId{0}, VertexId{6}}), e_wrong_selection);
  expect_error(cut({VertexId{4}, VertexId{6}, VertexId{5}, VertexId{7}}),
               e_wrong_selection);  // crosses itself
  expect_error(cut({VertexId{0}, VertexId{99}}), e_unknown_element);
  expect_error(cut({VertexId{0}, EdgePoint{edge(0, 6), 0.5}}), e_unknown_element);
  for (const double bad : {0.0, 1.0, -3.0, infinity, not_a_number})
    expect_error(cut({VertexId{4}, EdgePoint{edge(5, 6), bad}}), e_bad_amount);
  EXPECT_EQ(counts(cut({VertexId{4}, VertexId{5}, VertexId{7}}).value().source), "8/13/7")
      << "along a side, then across";
}

TEST(SplitFace, BetweenCorners) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult out = split_face(cube, {1}, {4}, {6}).value();
  EXPECT_EQ(counts(out.source), "8/13/7");
  EXPECT_EQ(out.selection.edges, std::set<EdgeId>{edge(4, 6)});
  expect_error(split_face(cube, {1}, {4}, {5}), e_wrong_selection);
  expect_error(split_face(cube, {1}, {4}, {0}), e_wrong_selection);
  expect_error(split_face(cube, {1}, {4}, {4}), e_wrong_selection);
  expect_error(split_face(cube, {9}, {4}, {6}), e_unknown_element);
  expect_error(split_face(cube, {1}, {4}, {66}), e_unknown_element);
}

TEST(ConnectPoints, RandomMeshes) {
  int done = 0, surfaces = 0;
  for_random(7000, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = random_shape_source(rng);
    const auto vertices = chance(rng, 0.7) ? random_vertices(source, rng) : Vertices{};
    const auto edges = chance(rng, 0.7) ? random_edges(source, rng) : Edges{};
    const auto result = connect_points(source, vertices, edges);
    expect_same_euler(source, result);
    if (!result) return;
    ++done;
    if (surfaces < 25 && ++surfaces) expect_surface(result->source);
  });
  EXPECT_GT(done, repetitions(300) / 3);
}

TEST(CutPath, RandomPaths) {
  int done = 0;
  for_random(7500, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = random_shape_source(rng);
    const HalfEdgeMesh& mesh = source.polyhedron.topology();
    // From face to face, so that some paths can be cut.
    std::vector<CutPoint> path;
    Index h = static_cast<Index>(rng() % mesh.half_edge_count());
    for (int i = uniform_int(rng, 2, 6); i > 0; --i) {
      if (chance(rng, 0.3))
        path.emplace_back(source.polyhedron.vertex_id(mesh.origin(h)));
      else
        path.emplace_back(EdgePoint{source.polyhedron.edge_id(mesh.edge(h)),
                                    chance(rng, 0.95) ? uniform(rng, 0.05, 0.95) : random_amount(rng, 1)});
      if (mesh.twin(h) != no_index) h = mesh.twin(h);
      for (int step = uniform_int(rng, 1, 3); step > 0; --step) h = mesh.next(h);
    }
    const auto result = cut_path(source, path);
    expect_same_euler(source, result);
    done += result ? 1 : 0;
  });
  EXPECT_GT(done, repetitions(300) / 6);
}

}  // namespace
}  // namespace hariko::test
