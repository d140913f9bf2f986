// Queries for selecting: conversions, grow and shrink, linked, boundaries, similar elements.

#include <algorithm>

#include "core/modeling/selection/select_convert.hpp"
#include "core/modeling/selection/select_region.hpp"
#include "core/modeling/selection/select_similar.hpp"
#include "tests/modeling/support.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/random_shaping.hpp"

namespace hariko::test {
namespace {

ElementSet random_set(const Polyhedron& polyhedron, std::mt19937_64& rng, double share) {
  ElementSet set;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v)
    if (test::chance(rng, share)) set.vertices.insert(polyhedron.vertex_id(v));
  for (Index e = 0; e < polyhedron.edge_count(); ++e)
    if (test::chance(rng, share)) set.edges.insert(polyhedron.edge_id(e));
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    if (test::chance(rng, share)) set.faces.insert(polyhedron.face_id(f));
  return set;
}

template <class Id>
bool contains(const std::set<Id>& all, const std::set<Id>& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

bool contains(const ElementSet& all, const ElementSet& some) {
  return contains(all.vertices, some.vertices) && contains(all.edges, some.edges) &&
         contains(all.faces, some.faces);
}

TEST(SelectConvert, CubeFaceToItsEdgesAndVerticesAndBack) {
  const Polyhedron cube = source_of(test::cube()).polyhedron;
  const ElementSet top{{}, {}, {{1}}};
  const ElementSet corners{{{4}, {5}, {6}, {7}}, {}, {}};
  EXPECT_EQ(to_vertices(cube, top), corners);
  EXPECT_EQ(to_edges(cube, top).edges.size(), 4U);
  EXPECT_EQ(to_edges(cube, corners), to_edges(cube, top));
  EXPECT_EQ(to_faces(cube, corners), top);
  EXPECT_EQ(to_faces(cube, to_edges(cube, top)), top);
  EXPECT_EQ(to_faces(cube, corners, Reach::touching).faces.size(), 5U);
  EXPECT_EQ(to_edges(cube, corners, Reach::touching).edges.size(), 8U);
  EXPECT_EQ(to_faces(cube, ElementSet{{{4}}, {}, {}}, Reach::touching).faces.size(), 3U);
}

TEST(SelectConvert, WhatIsSelectedInWholeStays) {
  test::for_random(81, 300, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = source_of(test::random_polyhedron(rng)).polyhedron;
    const ElementSet set = random_set(polyhedron, rng, test::uniform(rng));
    const ElementSet faces{{}, {}, set.faces}, edges{{}, set.edges, {}};
    EXPECT_TRUE(contains(to_faces(polyhedron, to_vertices(polyhedron, faces)), faces));
    EXPECT_TRUE(contains(to_faces(polyhedron, to_edges(polyhedron, faces)), faces));
    EXPECT_TRUE(contains(to_edges(polyhedron, to_vertices(polyhedron, edges)), edges));
    EXPECT_TRUE(contains(to_edges(polyhedron, set, Reach::touching), to_edges(polyhedron, set)));
    EXPECT_TRUE(contains(to_faces(polyhedron, set, Reach::touching), to_faces(polyhedron, set)));
    // Selections of one kind only, and complete: nothing stays nothing, all stays all.
    EXPECT_TRUE(to_faces(polyhedron, {}).empty());
    EXPECT_EQ(to_faces(polyhedron, select_all(polyhedron, ElementKind::vertex)),
              select_all(polyhedron, ElementKind::face));
    EXPECT_EQ(to_edges(polyhedron, select_all(polyhedron, ElementKind::face)),
              select_all(polyhedron, ElementKind::edge));
    EXPECT_EQ(to_vertices(polyhedron, select_all(polyhedron, ElementKind::edge)),
              select_all(polyhedron, ElementKind::vertex));
  });
}

TEST(SelectRegion, GrowOnAGridIsASquare) {
  const Polyhedron grid = source_of(test::grid(4, 4)).polyhedron;  // vertices 0 .. 24, faces 0 .. 15
  EXPECT_EQ(grow(grid, {{{12}}, {}, {}}).vertices,
            (std::set<VertexId>{{6}, {7}, {8}, {11}, {12}, {13}, {16}, {17}, {18}}));
  EXPECT_EQ(grow(grid, {{}, {}, {{5}}}).faces,
            (std::set<FaceId>{{0}, {1}, {2}, {4}, {5}, {6}, {8}, {9}, {10}}));
  EXPECT_EQ(grow(grid, {{}, {EdgeId{{12}, {13}}}, {}}).edges.size(), 7U);
  EXPECT_EQ(shrink(grid, grow(grid, {{}, {}, {{5}}})).faces, (std::set<FaceId>{{0}, {1}, {4}, {5}}))
      << "the border is no outside";
}

TEST(SelectRegion, LawsOfGrowShrinkInvertLinked) {
  test::for_random(82, 300, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = source_of(test::random_polyhedron(rng)).polyhedron;
    const ElementSet set = random_set(polyhedron, rng, test::uniform(rng, 0, 0.5));
    const ElementSet larger = grow(polyhedron, set), smaller = shrink(polyhedron, set);
    EXPECT_TRUE(contains(larger, set));
    EXPECT_TRUE(contains(set, smaller));
    EXPECT_TRUE(contains(shrink(polyhedron, larger), set));
    EXPECT_TRUE(contains(set, grow(polyhedron, smaller)));
    const ElementSet whole = linked(polyhedron, set);
    EXPECT_TRUE(contains(whole, larger));
    EXPECT_EQ(grow(polyhedron, whole), whole) << "a component has no neighbours";
    EXPECT_EQ(shrink(polyhedron, whole), whole);
    for (const ElementKind kind : {ElementKind::vertex, ElementKind::edge, ElementKind::face}) {
      const ElementSet rest = invert(polyhedron, set, kind);
      const ElementSet back = invert(polyhedron, rest, kind);
      EXPECT_EQ(back.vertices, kind == ElementKind::vertex ? set.vertices : std::set<VertexId>{});
      EXPECT_EQ(back.edges, kind == ElementKind::edge ? set.edges : std::set<EdgeId>{});
      EXPECT_EQ(back.faces, kind == ElementKind::face ? set.faces : std::set<FaceId>{});
      EXPECT_EQ(back.size() + rest.size(), select_all(polyhedron, kind).size());
    }
  });
}

TEST(SelectRegion, LinkedStaysInItsComponent) {
  const Polyhedron two = source_of(test::together(test::cube(), test::octahedron(), {0, 0, 10})).polyhedron;
  EXPECT_EQ(linked(two, {{{3}}, {}, {}}).vertices.size(), 8U);
  EXPECT_EQ(linked(two, {{{9}}, {}, {}}).vertices.size(), 6U);
  EXPECT_EQ(linked(two, {{}, {}, {{6}}}).faces.size(), 8U);
  EXPECT_EQ(linked(two, {{{3}, {9}}, {}, {}}).vertices.size(), 14U);
  EXPECT_TRUE(linked(two, {{}, {}, {{6}}}).vertices.empty());
}

TEST(SelectRegion, BoundaryOfFaces) {
  const Polyhedron grid = source_of(test::grid(3, 3)).polyhedron;
  EXPECT_EQ(boundary_of_faces(grid, {{}, {}, {{4}}}).edges.size(), 4U);
  EXPECT_EQ(boundary_of_faces(grid, {{}, {}, {{0}, {1}}}).edges.size(), 6U);
  EXPECT_EQ(boundary_of_faces(grid, select_all(grid, ElementKind::face)).edges.size(), 12U);
  const Polyhedron cube = source_of(test::cube()).polyhedron;
  EXPECT_TRUE(boundary_of_faces(cube, select_all(cube, ElementKind::face)).empty());
}

TEST(SelectRegion, IdsThatAreGoneDoNoHarm) {
  const Polyhedron cube = source_of(test::cube()).polyhedron;
  const ElementSet stale{{{99}}, {EdgeId{{0}, {6}}, EdgeId{{98}, {99}}}, {{77}}};
  EXPECT_TRUE(grow(cube, stale).empty());
  EXPECT_TRUE(shrink(cube, stale).empty());
  EXPECT_TRUE(linked(cube, stale).empty());
  EXPECT_TRUE(to_vertices(cube, stale).empty());
  EXPECT_TRUE(to_faces(cube, stale, Reach::touching).empty());
  EXPECT_TRUE(boundary_of_faces(cube, stale).empty());
}

TEST(SelectSimilar, ByCountsAndTension) {
  PolyhedronSource source = source_of(test::prism(6));
  EXPECT_EQ(similar_faces(source, {{0}}, FaceLikeness::side_count), (std::set<FaceId>{{0}, {1}}));
  EXPECT_EQ(similar_faces(source, {{2}}, FaceLikeness::side_count).size(), 6U);
  EXPECT_EQ(similar_faces(source, {{2}}, FaceLikeness::area).size(), 6U);
  EXPECT_EQ(similar_faces(source, {{2}}, FaceLikeness::normal).size(), 1U);
  EXPECT_EQ(similar_faces(source, {{0}}, FaceLikeness::normal, 0.5).size(), 7U) << "up to right angles";
  EXPECT_EQ(similar_edges(source, {EdgeId{{0}, {6}}}, EdgeLikeness::length).size(), 6U);
  EXPECT_EQ(similar_edges(source, {EdgeId{{0}, {6}}}, EdgeLikeness::fold).size(), 6U);
  Shaping shaping;
  shaping.alpha.set({0}, 10);
  shaping.alpha.set({3}, 10.5);
  shaping.beta.set(EdgeId{{0}, {1}}, 4);
  shaping.crease.set(EdgeId{{1}, {2}}, true);
  source.shaping = shaping;
  EXPECT_EQ(similar_vertices(source, {{0}}, VertexLikeness::tension), (std::set<VertexId>{{0}}));
  EXPECT_EQ(similar_vertices(source, {{0}}, VertexLikeness::tension, 0.1), (std::set<VertexId>{{0}, {3}}));
  EXPECT_EQ(similar_vertices(source, {{1}}, VertexLikeness::tension).size(), 10U);
  EXPECT_EQ(similar_vertices(source, {{1}}, VertexLikeness::sharp_edges), (std::set<VertexId>{{1}, {2}}));
  EXPECT_EQ(similar_edges(source, {EdgeId{{0}, {1}}}, EdgeLikeness::tension).size(), 1U);
  EXPECT_EQ(similar_edges(source, {EdgeId{{1}, {2}}}, EdgeLikeness::crease).size(), 1U);
  const PolyhedronSource pyramid = source_of(test::pyramid(5));
  EXPECT_EQ(similar_vertices(pyramid, {{0}}, VertexLikeness::valence).size(), 5U);
  EXPECT_EQ(similar_vertices(pyramid, {{5}}, VertexLikeness::valence).size(), 1U);
  const PolyhedronSource grid = source_of(test::grid(3, 3));
  EXPECT_EQ(similar_vertices(grid, {{0}}, VertexLikeness::place).size(), 12U);
  EXPECT_EQ(similar_edges(grid, {EdgeId{{0}, {1}}}, EdgeLikeness::place).size(), 12U);
}

TEST(SelectSimilar, FacesInOnePlane) {
  const PolyhedronSource slab = source_of(test::genus_box(1));
  // Eight faces lie on top of the slab with one hole.
  for (Index f = 0; f < slab.polyhedron.face_count(); ++f) {
    const auto corners = slab.polyhedron.topology().face_vertices(f);
    if (!std::all_of(corners.begin(), corners.end(),
                     [&](Index v) { return slab.polyhedron.position(v).z() == 0.5; }))
      continue;
    EXPECT_EQ(similar_faces(slab, {slab.polyhedron.face_id(f)}, FaceLikeness::plane).size(), 8U);
  }
}

TEST(SelectSimilar, AlwaysHoldsTheGivenAndIsStable) {
  test::for_random(83, 300, [](std::mt19937_64& rng) {
    PolyhedronSource source = source_of(test::random_polyhedron(rng));
    source.shaping = test::random_shaping(source.polyhedron, rng, 100, 0.01, 100);
    const ElementSet set = random_set(source.polyhedron, rng, 0.2);
    for (int kind = 0; kind < 4; ++kind) {
      const auto vertices = similar_vertices(source, set.vertices, static_cast<VertexLikeness>(kind), 0);
      EXPECT_TRUE(contains(vertices, set.vertices));
      EXPECT_EQ(similar_vertices(source, vertices, static_cast<VertexLikeness>(kind), 0), vertices);
      const auto faces = similar_faces(source, set.faces, static_cast<FaceLikeness>(kind), 0);
      EXPECT_TRUE(contains(faces, set.faces));
    }
    for (int kind = 0; kind < 5; ++kind) {
      const auto edges = similar_edges(source, set.edges, static_cast<EdgeLikeness>(kind), 0);
      EXPECT_TRUE(contains(edges, set.edges));
      EXPECT_EQ(similar_edges(source, edges, static_cast<EdgeLikeness>(kind), 0), edges);
    }
  });
}

}  // namespace
}  // namespace hariko::test
