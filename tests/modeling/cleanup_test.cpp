// Operations that tidy: triangulate, decompose, dissolve, delete, merge. On random meshes each gives a sound
// polyhedron with the Euler number it should have, or a refusal with a code.

#include <limits>
#include <numeric>

#include "core/document/edits/edit_elements.hpp"
#include "core/geometry/polygon.hpp"
#include "core/modeling/cuts/cut_faces.hpp"
#include "core/modeling/operations/delete_elements.hpp"
#include "core/modeling/operations/dissolve.hpp"
#include "core/modeling/operations/merge_vertices.hpp"
#include "core/polyhedron/face_decomposition.hpp"
#include "tests/modeling/operation_cases.hpp"

namespace hariko {
namespace {

using test::corners_of;
using test::euler_number;
using test::source_of;

std::set<std::set<std::uint32_t>> face_sets(const Polyhedron& polyhedron) {
  std::set<std::set<std::uint32_t>> out;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    std::set<std::uint32_t> corners;
    for (const Index v : polyhedron.topology().face_vertices(f))
      corners.insert(polyhedron.vertex_id(v).value);
    out.insert(corners);
  }
  return out;
}

/// The u-shaped outline of kuriyama.md 11 as a prism.
PolygonMesh concave_prism() {
  PolygonMesh mesh;
  const std::array<Vector2, 8> outline{Vector2{-2, -1}, {2, -1}, {2, 1.4},  {1, 1.4},
                                       {1, 0},          {-1, 0}, {-1, 1.4}, {-2, 1.4}};
  for (const double z : {-0.6, 0.6})
    for (const Vector2& p : outline) mesh.positions.emplace_back(p.x(), p.y(), z);
  mesh.add_face({8, 9, 10, 11, 12, 13, 14, 15});
  mesh.add_face({7, 6, 5, 4, 3, 2, 1, 0});
  for (Index i = 0; i < 8; ++i) mesh.add_face({i, (i + 1) % 8, (i + 1) % 8 + 8, i + 8});
  return mesh;
}

TEST(Decompose, ReproducesTheSplitByHand) {
  const PolyhedronSource source = source_of(concave_prism());
  const auto done = test::must(decompose_concave_faces(source, test::all_faces(source)));
  const auto faces = face_sets(done->source.polyhedron);
  EXPECT_EQ(done->source.polyhedron.face_count(), 14U);
  for (const std::uint32_t level : {0U, 8U}) {
    EXPECT_TRUE(faces.contains({level, level + 5, level + 6, level + 7}));
    EXPECT_TRUE(faces.contains({level, level + 1, level + 4, level + 5}));
    EXPECT_TRUE(faces.contains({level + 1, level + 2, level + 3, level + 4}));
  }
  EXPECT_EQ(done->selection.faces.size(), 6U);
  EXPECT_TRUE(done->source.shaping->crease.empty());
  EXPECT_EQ(euler_number(done->source.polyhedron), 2);
}

TEST(Decompose, RandomStarsBecomeConvex) {
  test::for_random(91, 300, [](std::mt19937_64& rng) {
    const int n = test::uniform_int(rng, 4, 40);
    std::vector<Vector3> corners;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n, r = test::uniform(rng, 0.3, 1);
      corners.emplace_back(r * std::cos(angle), r * std::sin(angle), test::uniform(rng, -0.02, 0.02));
    }
    const auto pieces = convex_pieces(corners, [](Index, Index) { return true; });
    ASSERT_TRUE(pieces.has_value());
    double area = 0;
    std::size_t sides = 0;
    for (const auto& piece : *pieces) {
      std::vector<Vector3> own;
      for (const Index i : piece) own.push_back(corners[i]);
      EXPECT_EQ(classify_face(own), FaceShape::convex);
      area += newell_normal(own).z() / 2;
      sides += piece.size();
    }
    EXPECT_NEAR(area, newell_normal(corners).z() / 2, 1e-12);
    EXPECT_EQ(sides, corners.size() + 2 * (pieces->size() - 1)) << "each diagonal has two sides";
  });
}

TEST(Triangulate, PillowsUseDifferentDiagonals) {
  PolygonMesh pillow;
  pillow.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  pillow.add_face({0, 1, 2, 3});
  pillow.add_face({3, 2, 1, 0});
  const PolyhedronSource source = source_of(pillow);
  const auto done = test::must(triangulate_faces(source, test::all_faces(source)));
  EXPECT_EQ(done->source.polyhedron.face_count(), 4U);
  EXPECT_EQ(euler_number(done->source.polyhedron), 2);
}

TEST(Triangulate, KeepsAreaOfPlaneFacesWithStraightCorners) {
  // A rectangle with corners inside its sides: no triangle may be flat.
  PolygonMesh sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0},   {2, 0, 0}, {3, 0, 0},
                     {3, 2, 0}, {1.5, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  sheet.add_face({0, 1, 2, 3, 4, 5, 6, 7});
  const PolyhedronSource source = source_of(sheet);
  const auto done = test::must(triangulate_faces(source, test::all_faces(source)));
  double area = 0;
  for (Index f = 0; f < done->source.polyhedron.face_count(); ++f) {
    const double own = newell_normal(corners_of(done->source.polyhedron, f)).z() / 2;
    EXPECT_GT(own, 0.1);
    area += own;
  }
  EXPECT_NEAR(area, 6, 1e-12);
}

TEST(CutFaces, RandomMeshes) {
  int done_count = 0;
  test::for_random(92, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = test::random_source(rng);
    const auto faces = test::some_faces(source.polyhedron, rng, test::uniform(rng));
    for (const bool triangulate : {true, false}) {
      const auto done =
          triangulate ? triangulate_faces(source, faces) : decompose_concave_faces(source, faces);
      if (!done.ok()) {
        test::expect_refusal(done.error());
        continue;
      }
      ++done_count;
      const Polyhedron& polyhedron = done->source.polyhedron;
      test::expect_sound(*done, source);
      EXPECT_EQ(euler_number(polyhedron), euler_number(source.polyhedron));
      EXPECT_EQ(polyhedron.vertex_count(), source.polyhedron.vertex_count());
      for (const FaceId id : done->selection.faces) {
        const Index f = polyhedron.find(id);
        EXPECT_TRUE(triangulate ? polyhedron.topology().side_count(f) == 3
                                : classify_face(corners_of(polyhedron, f)) == FaceShape::convex);
      }
    }
  });
  EXPECT_GT(done_count, test::repetitions(150));
}

TEST(Dissolve, CubeVertexEdgeAndFaces) {
  const PolyhedronSource cube = source_of(test::cube());
  const auto vertex = test::must(dissolve_vertices(cube, std::vector<VertexId>{{6}}));
  EXPECT_EQ(vertex->source.polyhedron.vertex_count(), 7U);
  EXPECT_EQ(vertex->source.polyhedron.face_count(), 4U);
  EXPECT_EQ(vertex->source.polyhedron.topology().side_count(
                vertex->source.polyhedron.find(*vertex->selection.faces.begin())),
            6U);
  const auto edge = test::must(dissolve_edges(cube, std::vector<EdgeId>{{{6}, {7}}}));
  EXPECT_EQ(edge->source.polyhedron.vertex_count(), 6U) << "its ends would only bend an edge";
  EXPECT_EQ(edge->source.polyhedron.face_count(), 5U);
  const auto faces = test::must(dissolve_faces(cube, std::vector<FaceId>{{1}, {2}, {4}}));
  EXPECT_EQ(faces->source.polyhedron.face_count(), 4U);
  test::must_fail(dissolve_faces(cube, test::all_faces(cube)), e_would_be_nonmanifold);
  const auto ring = dissolve_faces(cube, std::vector<FaceId>{{2}, {3}, {4}, {5}});
  ASSERT_FALSE(ring.ok()) << "a ring has two borders";
  test::must_fail(dissolve_faces(cube, std::vector<FaceId>{{0}, {1}}), e_wrong_selection);
}

TEST(Dissolve, EdgesThatJoinKeepWhatTheyAgreeOn) {
  PolyhedronSource grid = source_of(test::grid(2, 1));  // vertices 0 1 2 / 3 4 5
  Shaping shaping;
  shaping.beta.set(EdgeId{{0}, {1}}, 4);
  shaping.beta.set(EdgeId{{1}, {2}}, 4);
  shaping.beta.set(EdgeId{{3}, {4}}, 4);
  shaping.crease.set(EdgeId{{0}, {1}}, true);
  shaping.crease.set(EdgeId{{1}, {2}}, true);
  grid.shaping = shaping;
  const auto done = test::must(dissolve_edges(grid, std::vector<EdgeId>{{{1}, {4}}}));
  EXPECT_EQ(done->source.polyhedron.vertex_count(), 4U);
  EXPECT_EQ(done->source.shaping->beta.get_or(EdgeId{{0}, {2}}, 1), 4);
  EXPECT_EQ(done->source.shaping->beta.get_or(EdgeId{{3}, {5}}, 1), 1);
  EXPECT_TRUE(done->source.shaping->crease.contains(EdgeId{{0}, {2}}));
}

TEST(Dissolve, ATorusWithoutADiskIsNoDisk) {
  const PolyhedronSource torus = source_of(test::torus(5, 5));
  std::vector<FaceId> faces = test::all_faces(torus);
  faces.erase(faces.begin());
  test::must_fail(dissolve_faces(torus, faces), e_would_be_nonmanifold);
}

TEST(Dissolve, RandomMeshes) {
  int done_count = 0;
  test::for_random(93, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = test::random_source(rng);
    const double share = test::chance(rng, 0.5) ? 0.05 : test::uniform(rng, 0, 0.5);
    const auto check = [&](const Result<EditResult>& done) {
      if (!done.ok()) return test::expect_refusal(done.error());
      ++done_count;
      test::expect_sound(*done, source);
      EXPECT_EQ(euler_number(done->source.polyhedron), euler_number(source.polyhedron));
      EXPECT_LE(done->source.polyhedron.face_count(), source.polyhedron.face_count());
    };
    const auto vertices = test::some_vertices(source.polyhedron, rng, share);
    const auto dissolved = dissolve_vertices(source, vertices);
    check(dissolved);
    if (dissolved.ok()) {
      for (const VertexId id : vertices) EXPECT_EQ(dissolved->source.polyhedron.find(id), no_index);
    }
    check(dissolve_edges(source, test::some_edges(source.polyhedron, rng, share)));
    check(dissolve_faces(source, test::some_faces(source.polyhedron, rng, share)));
  });
  EXPECT_GT(done_count, test::repetitions(150));
}

TEST(Delete, RandomMeshesAsIfTheFacesHadNeverBeen) {
  int done_count = 0;
  test::for_random(94, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = test::random_source(rng);
    const Polyhedron& polyhedron = source.polyhedron;
    const double share = test::chance(rng, 0.5) ? 0.1 : test::uniform(rng);
    const auto check = [&](const Result<EditResult>& done, const std::set<FaceId>& gone) {
      PolygonMesh left;
      left.positions = polyhedron.positions();
      for (Index f = 0; f < polyhedron.face_count(); ++f)
        if (!gone.contains(polyhedron.face_id(f))) left.add_face(polyhedron.topology().face_vertices(f));
      const auto expected = Polyhedron::build(remove_isolated_vertices(left));
      ASSERT_EQ(done.ok(), expected.ok() && !gone.empty());
      if (!done.ok()) return test::expect_refusal(done.error());
      ++done_count;
      test::expect_sound(*done, source);
      EXPECT_EQ(done->source.polyhedron.vertex_count(), expected->vertex_count());
      EXPECT_EQ(done->source.polyhedron.edge_count(), expected->edge_count());
      EXPECT_EQ(done->source.polyhedron.face_count(), expected->face_count());
    };
    std::set<FaceId> gone;
    const auto vertices = test::some_vertices(polyhedron, rng, share);
    for (Index h = 0; h < polyhedron.topology().half_edge_count(); ++h)
      if (std::binary_search(vertices.begin(), vertices.end(),
                             polyhedron.vertex_id(polyhedron.topology().origin(h))))
        gone.insert(polyhedron.face_id(polyhedron.topology().face(h)));
    check(delete_vertices(source, vertices), gone);
    gone.clear();
    const auto edges = test::some_edges(polyhedron, rng, share);
    for (Index h = 0; h < polyhedron.topology().half_edge_count(); ++h)
      if (std::find(edges.begin(), edges.end(), polyhedron.edge_id(polyhedron.topology().edge(h))) !=
          edges.end())
        gone.insert(polyhedron.face_id(polyhedron.topology().face(h)));
    check(delete_edges(source, edges), gone);
    const auto faces = test::some_faces(polyhedron, rng, share);
    check(delete_faces(source, faces), {faces.begin(), faces.end()});
  });
  EXPECT_GT(done_count, test::repetitions(100));
}

TEST(Merge, CubeEdgeAtEveryPlace) {
  const PolyhedronSource cube = source_of(test::cube());
  const std::vector<VertexId> edge{{6}, {7}};
  const auto centre = test::must(merge_vertices(cube, edge, MergeAt::centre));
  EXPECT_EQ(centre->source.polyhedron.vertex_count(), 7U);
  EXPECT_EQ(euler_number(centre->source.polyhedron), 2);
  EXPECT_EQ(centre->source.polyhedron.position(centre->source.polyhedron.find(VertexId{6})),
            Vector3(0, 1, 1));
  EXPECT_EQ(centre->selection.vertices, (std::set<VertexId>{{6}}));
  const auto first = merge_vertices(cube, edge, MergeAt::first);
  EXPECT_EQ(first->source.polyhedron.position(first->source.polyhedron.find(VertexId{6})), Vector3(1, 1, 1));
  const auto last = merge_vertices(cube, edge, MergeAt::last);
  EXPECT_EQ(last->source.polyhedron.position(last->source.polyhedron.find(VertexId{7})), Vector3(-1, 1, 1));
  EXPECT_EQ(last->source.polyhedron.find(VertexId{6}), no_index);
  const auto top = merge_vertices(cube, std::vector<VertexId>{{4}, {5}, {6}, {7}}, MergeAt::centre);
  ASSERT_TRUE(top.ok()) << "a pyramid";
  EXPECT_EQ(top->source.polyhedron.face_count(), 5U);
  test::must_fail(merge_vertices(cube, std::vector<VertexId>{{0}, {6}}, MergeAt::first),
                  e_would_be_nonmanifold);
  test::must_fail(merge_vertices(cube, std::vector<VertexId>{{0}, {0}}, MergeAt::first), e_wrong_selection);
}

TEST(Merge, StitchesBordersThatLieOnEachOther) {
  PolyhedronSource two = source_of(test::together(test::grid(2, 2), test::grid(2, 2), {2, 0, 0}));
  // The second sheet continues the first at x = 1 only where z agrees; make both flat.
  std::vector<Index> all;
  std::vector<Vector3> flat;
  for (Index v = 0; v < two.polyhedron.vertex_count(); ++v) {
    all.push_back(v);
    flat.push_back({two.polyhedron.position(v).x(), two.polyhedron.position(v).y(), 0});
  }
  two.polyhedron = two.polyhedron.with_positions(all, flat).value();
  std::vector<VertexId> ids;
  for (const Index v : all) ids.push_back(two.polyhedron.vertex_id(v));
  const auto done = test::must(merge_by_distance(two, ids, 1e-6));
  EXPECT_EQ(done->source.polyhedron.vertex_count(), 15U);
  EXPECT_EQ(done->source.polyhedron.edge_count(), 22U);
  EXPECT_EQ(euler_number(done->source.polyhedron), 1);
  EXPECT_EQ(done->selection.vertices.size(), 3U);
  EXPECT_FALSE(merge_by_distance(done->source, ids, 1e-6).ok()) << "ids that are gone";
}

TEST(Merge, SettingsOfEdgesGoWithThem) {
  PolyhedronSource cube = source_of(test::cube());
  Shaping shaping;
  shaping.beta.set(EdgeId{{3}, {7}}, 5);
  shaping.beta.set(EdgeId{{6}, {7}}, 7);
  shaping.crease.set(EdgeId{{4}, {7}}, true);
  shaping.alpha.set({7}, 3);
  cube.shaping = shaping;
  const auto done = test::must(merge_vertices(cube, std::vector<VertexId>{{6}, {7}}, MergeAt::first));
  EXPECT_EQ(done->source.shaping->beta.get_or(EdgeId{{3}, {6}}, 1), 5);
  EXPECT_EQ(done->source.shaping->beta.size(), 1U);
  EXPECT_TRUE(done->source.shaping->crease.contains(EdgeId{{4}, {6}}));
  EXPECT_TRUE(done->source.shaping->alpha.empty()) << "the first vertex has no tension";
}

TEST(Merge, RandomMeshesAsIfTheVerticesHadBeenOne) {
  int done_count = 0;
  test::for_random(95, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = test::random_source(rng);
    const Polyhedron& polyhedron = source.polyhedron;
    // Corners that follow each other and became one vertex count once; faces of less than three go.
    const auto check = [&](const Result<EditResult>& done, const std::vector<Index>& target, bool any) {
      PolygonMesh merged;
      merged.positions = polyhedron.positions();
      for (Index f = 0; f < polyhedron.face_count(); ++f) {
        std::vector<Index> corners;
        for (const Index v : polyhedron.topology().face_vertices(f))
          if (corners.empty() || corners.back() != target[v]) corners.push_back(target[v]);
        while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
        if (corners.size() >= 3) merged.add_face(corners);
      }
      const auto expected = Polyhedron::build(remove_isolated_vertices(merged));
      ASSERT_EQ(done.ok(), expected.ok() && any);
      if (!done.ok()) return test::expect_refusal(done.error());
      ++done_count;
      test::expect_sound(*done, source);
      EXPECT_EQ(done->source.polyhedron.vertex_count(), expected->vertex_count());
      EXPECT_EQ(done->source.polyhedron.edge_count(), expected->edge_count());
      EXPECT_EQ(done->source.polyhedron.face_count(), expected->face_count());
    };
    std::vector<Index> target(polyhedron.vertex_count());
    std::iota(target.begin(), target.end(), Index{0});
    // The ends of one edge, or of a few edges.
    const Index h = static_cast<Index>(rng() % polyhedron.topology().half_edge_count());
    const Index a = polyhedron.topology().origin(h), b = polyhedron.topology().target(h);
    auto one = target;
    one[b] = a;
    const std::vector<VertexId> ends{polyhedron.vertex_id(a), polyhedron.vertex_id(b)};
    check(merge_vertices(source, ends, MergeAt::first), one, true);
    check(collapse_edges(source, std::vector<EdgeId>{EdgeId::of(ends[0], ends[1])}), one, true);
    const auto vertices = test::some_vertices(polyhedron, rng, 0.2);
    auto many = target;
    for (const VertexId id : vertices) many[polyhedron.find(id)] = polyhedron.find(vertices[0]);
    check(merge_vertices(source, vertices, MergeAt::centre), many, vertices.size() > 1);
  });
  EXPECT_GT(done_count, test::repetitions(200));
}

TEST(Cleanup, SillyParametersAreRefused) {
  const PolyhedronSource cube = source_of(test::cube());
  const auto code = [](const Result<EditResult>& result) {
    EXPECT_FALSE(result.ok());
    if (!result.ok()) test::expect_refusal(result.error());
    return result.ok() ? Code{""} : result.error().code;
  };
  const std::vector<VertexId> no_vertices, lost_vertices{{0}, {99}};
  const std::vector<EdgeId> no_edges, lost_edges{{{0}, {6}}};
  const std::vector<FaceId> no_faces, lost_faces{{0}, {99}};
  EXPECT_EQ(code(triangulate_faces(cube, no_faces)), e_nothing_selected);
  EXPECT_EQ(code(triangulate_faces(cube, lost_faces)), e_unknown_element);
  EXPECT_EQ(code(decompose_concave_faces(cube, test::all_faces(cube))), e_wrong_selection);
  EXPECT_EQ(code(dissolve_vertices(cube, no_vertices)), e_nothing_selected);
  EXPECT_EQ(code(dissolve_vertices(cube, lost_vertices)), e_unknown_element);
  EXPECT_EQ(code(dissolve_edges(cube, no_edges)), e_nothing_selected);
  EXPECT_EQ(code(dissolve_edges(cube, lost_edges)), e_unknown_element);
  EXPECT_EQ(code(dissolve_faces(cube, lost_faces)), e_unknown_element);
  EXPECT_EQ(code(delete_vertices(cube, lost_vertices)), e_unknown_element);
  EXPECT_EQ(code(delete_edges(cube, lost_edges)), e_unknown_element);
  EXPECT_EQ(code(delete_faces(cube, no_faces)), e_nothing_selected);
  EXPECT_EQ(code(delete_faces(cube, test::all_faces(cube))), e_no_faces);
  EXPECT_EQ(code(merge_vertices(cube, lost_vertices, MergeAt::centre)), e_unknown_element);
  EXPECT_EQ(code(collapse_edges(cube, no_edges)), e_nothing_selected);
  const std::vector<VertexId> both{{0}, {1}};
  for (const double bad :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(code(merge_by_distance(cube, both, bad)), e_bad_amount);
  EXPECT_EQ(code(merge_by_distance(cube, both, 0)), e_wrong_selection);
  const PolyhedronSource grid = source_of(test::grid(1, 1));
  EXPECT_EQ(code(dissolve_edges(grid, std::vector<EdgeId>{{{0}, {1}}})), e_wrong_selection);
  EXPECT_EQ(code(triangulate_faces(source_of(test::octahedron()), std::vector<FaceId>{{0}})),
            e_wrong_selection);
}

}  // namespace
}  // namespace hariko
