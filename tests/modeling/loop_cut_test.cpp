// Edge loops, edge rings, and loop cuts through them.

#include "core/modeling/cuts/loop_cut.hpp"

#include <set>

#include "core/document/edits/edit_elements.hpp"
#include "core/modeling/selection/edge_paths.hpp"
#include "tests/modeling/support.hpp"

namespace hariko::test {
namespace {

TEST(EdgePaths, OnATorus) {
  const Polyhedron torus = source_of(test::torus(8, 5)).polyhedron;
  EXPECT_EQ(edge_loop(torus, edge(0, 5)).size(), 8U);
  EXPECT_EQ(edge_ring(torus, edge(0, 5)).size(), 5U);
  EXPECT_EQ(edge_loop(torus, edge(0, 1)).size(), 5U);
  EXPECT_EQ(edge_ring(torus, edge(0, 1)).size(), 8U);
}

TEST(EdgePaths, OnAGrid) {
  const Polyhedron grid = source_of(test::grid(3, 4)).polyhedron;
  const std::vector<EdgeId> line{edge(1, 5), edge(5, 9), edge(9, 13), edge(13, 17)};
  for (const EdgeId start : line) {
    std::vector<EdgeId> found = edge_loop(grid, start);
    if (found.front() != line.front()) std::reverse(found.begin(), found.end());
    EXPECT_EQ(found, line) << "in order, whichever edge it starts from";
  }
  EXPECT_EQ(edge_loop(grid, edge(0, 1)).size(), 14U) << "all along the border";
  EXPECT_EQ(edge_ring(grid, edge(1, 5)).size(), 4U);
  EXPECT_EQ(edge_ring(grid, edge(0, 1)).size(), 5U);
  EXPECT_TRUE(edge_loop(grid, edge(0, 9)).empty());
  EXPECT_TRUE(edge_ring(grid, edge(0, 9)).empty());
}

TEST(EdgePaths, StopAtOtherVerticesAndFaces) {
  const Polyhedron cube = source_of(test::cube()).polyhedron;
  EXPECT_EQ(edge_loop(cube, edge(0, 1)).size(), 1U);
  EXPECT_EQ(edge_ring(cube, edge(0, 1)).size(), 4U);
  const Polyhedron prism = source_of(test::prism(6)).polyhedron;
  EXPECT_EQ(edge_ring(prism, edge(0, 6)).size(), 6U);
  EXPECT_EQ(edge_ring(prism, edge(0, 1)).size(), 2U);
  const Polyhedron octahedron = source_of(test::octahedron()).polyhedron;
  EXPECT_EQ(edge_loop(octahedron, edge(0, 2)).size(), 4U);
  EXPECT_EQ(edge_ring(octahedron, edge(0, 2)).size(), 1U);
}

TEST(EdgePaths, RandomMeshesHaveNoEdgeTwiceAndAgreeFromEveryStart) {
  for_random(5500, 100, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = random_shape_source(rng).polyhedron;
    const EdgeId start = polyhedron.edge_id(static_cast<Index>(rng() % polyhedron.edge_count()));
    for (const auto follow : {edge_loop, edge_ring}) {
      const auto path = follow(polyhedron, start);
      const std::set<EdgeId> members(path.begin(), path.end());
      EXPECT_EQ(members.size(), path.size());
      EXPECT_TRUE(members.contains(start));
      const auto again = follow(polyhedron, path[rng() % path.size()]);
      EXPECT_EQ(std::set<EdgeId>(again.begin(), again.end()), members);
    }
  });
}

TEST(LoopCut, Cube) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult one = loop_cut(cube, edge(0, 4)).value();
  EXPECT_EQ(counts(one.source), "12/20/10");
  EXPECT_EQ(one.selection.edges.size(), 4U);
  for (std::uint32_t v = 8; v < 12; ++v) EXPECT_EQ(one.source.polyhedron.position(v).z(), 0);
  expect_planar(one.source, 1e-15);
  const EditResult three = loop_cut(cube, edge(0, 4), {.count = 3}).value();
  EXPECT_EQ(counts(three.source), "20/36/18");
  const EditResult low = loop_cut(cube, edge(0, 4), {.slide = -0.5}).value();
  for (std::uint32_t v = 8; v < 12; ++v)
    EXPECT_DOUBLE_EQ(low.source.polyhedron.position(v).z(), -0.5) << "all to the same side";
  const EditResult high = loop_cut(cube, edge(3, 7), {.slide = 0.5}).value();
  for (std::uint32_t v = 8; v < 12; ++v) EXPECT_DOUBLE_EQ(high.source.polyhedron.position(v).z(), 0.5);
  expect_surface(three.source);
}

TEST(LoopCut, StopsAtOtherFacesAndBorders) {
  const PolyhedronSource prism = source_of(test::prism(6));
  const EditResult side = loop_cut(prism, edge(0, 1)).value();
  EXPECT_EQ(counts(side.source), "14/21/9") << "one side cut, the hexagons became heptagons";
  EXPECT_EQ(side.selection.edges.size(), 1U);
  const EditResult round = loop_cut(prism, edge(0, 6)).value();
  EXPECT_EQ(counts(round.source), "18/30/14");
  const PolyhedronSource sheet = source_of(test::grid(3, 4));
  const EditResult across = loop_cut(sheet, edge(1, 5), {.count = 2}).value();
  EXPECT_EQ(across.source.polyhedron.face_count(), 12U + 6U);
  EXPECT_EQ(across.source.polyhedron.vertex_count(), 20U + 8U);
  expect_error(loop_cut(source_of(test::octahedron()), edge(0, 2)), e_wrong_selection);
}

TEST(LoopCut, AQuadCrossedTwiceBecomesAGrid) {
  // A square whose two opposite pairs of sides are joined by strips: the ring through it crosses it twice.
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
  mesh.add_face({0, 1, 2, 3});
  mesh.add_face({2, 1, 4, 5});
  mesh.add_face({3, 2, 5, 6});
  const PolyhedronSource source = source_of(mesh);
  const auto ring = edge_ring(source.polyhedron, edge(1, 2));
  EXPECT_EQ(std::set<EdgeId>(ring.begin(), ring.end()),
            (std::set<EdgeId>{edge(0, 3), edge(1, 2), edge(4, 5)}));
  // Both ways through the first face:
  PolygonMesh twice;
  twice.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 1}, {2, 2, 1}};
  twice.add_face({0, 1, 2, 3});
  twice.add_face({2, 1, 4, 5});
  twice.add_face({3, 2, 5, 4});
  const PolyhedronSource both = source_of(twice);
  const auto crossing = edge_ring(both.polyhedron, edge(1, 2));
  EXPECT_EQ(crossing.size(), 5U);
  for (const int count : {1, 2, 3}) {
    const auto k = static_cast<Index>(count);
    const EditResult out = loop_cut(both, edge(1, 2), {.count = count, .slide = 0.25}).value();
    EXPECT_EQ(euler(out.source), euler(both));
    EXPECT_EQ(out.source.polyhedron.face_count(), (k + 1) * (k + 1) + 2 * (k + 1));
    expect_areas(out.source, 1e-4);
  }
}

TEST(LoopCut, ShapingIsCarried) {
  PolyhedronSource cube = source_of(test::cube());
  Shaping shaping;
  shaping.alpha.set({0}, 4);
  shaping.beta.set(edge(0, 1), 3);
  shaping.beta.set(edge(4, 5), 3);
  shaping.crease.set(edge(0, 4), true);
  cube.shaping = shaping;
  const EditResult out = loop_cut(cube, edge(0, 4), {.slide = -0.5}).value();
  const Shaping& after = *out.source.shaping;
  EXPECT_EQ(after.alpha.get_or({8}, 0), 3) << "between 4 and 0";
  EXPECT_EQ(after.crease.size(), 2U);
  EXPECT_EQ(edges_of_tension(out.source, 3), 3) << "the cut between two edges of one tension has it too";
}

TEST(LoopCut, Refusals) {
  const PolyhedronSource cube = source_of(test::cube());
  expect_error(loop_cut(cube, edge(0, 6)), e_unknown_element);
  for (const int bad : {0, -1, 1001, 2000000000})
    expect_error(loop_cut(cube, edge(0, 4), {.count = bad}), e_bad_amount);
  for (const double bad : {-1.0, 1.0, 1e300, infinity, not_a_number})
    expect_error(loop_cut(cube, edge(0, 4), {.slide = bad}), e_bad_amount);
  expect_error(loop_cut(source_of(test::torus(2000, 3)), edge(0, 1), {.count = 1000}), e_too_many_elements);
  PolygonMesh pillow;
  pillow.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  pillow.add_face({0, 1, 2, 3});
  pillow.add_face({3, 2, 1, 0});
  expect_error(loop_cut(source_of(pillow), edge(0, 1)), e_would_be_nonmanifold);
}

TEST(LoopCut, RandomMeshes) {
  int done = 0, surfaces = 0;
  for_random(6000, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = random_shape_source(rng);
    const EdgeId start =
        source.polyhedron.edge_id(static_cast<Index>(rng() % source.polyhedron.edge_count()));
    LoopCutOptions options{chance(rng, 0.9) ? uniform_int(rng, 1, 5) : uniform_int(rng, -3, 1100),
                           chance(rng, 0.9) ? uniform(rng, -1, 1) : random_amount(rng, 1)};
    const auto result = loop_cut(source, start, options);
    expect_same_euler(source, result);
    if (!result) return;
    ++done;
    if (options.count < 6 && surfaces < 20 && ++surfaces) expect_surface(result->source);
  });
  EXPECT_GT(done, repetitions(300) / 3);
}

}  // namespace
}  // namespace hariko::test
