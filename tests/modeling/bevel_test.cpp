// Bevelling vertices and edges.

#include <map>

#include "core/document/edits/edit_elements.hpp"
#include "core/modeling/operations/bevel_edges.hpp"
#include "core/modeling/operations/bevel_vertices.hpp"
#include "tests/modeling/support.hpp"

namespace hariko {
namespace {

using namespace test;
using Vertices = std::vector<VertexId>;
using Edges = std::vector<EdgeId>;
using Measure = BevelVerticesOptions::Measure;

/// Number of faces by number of sides.
std::map<Index, int> side_counts(const PolyhedronSource& source) {
  std::map<Index, int> out;
  for (Index f = 0; f < source.polyhedron.face_count(); ++f)
    ++out[source.polyhedron.topology().side_count(f)];
  return out;
}

TEST(BevelVertices, TruncatedCube) {
  const PolyhedronSource cube = source_of(test::cube());
  const double share = 1 - std::sqrt(0.5);
  const EditResult out = bevel_vertices(cube, all_vertices(cube), {.amount = share}).value();
  EXPECT_EQ(counts(out.source), "24/36/14");
  EXPECT_EQ(side_counts(out.source), (std::map<Index, int>{{3, 8}, {8, 6}}));
  EXPECT_EQ(out.selection.faces.size(), 8U);
  const PolygonMesh mesh = out.source.polyhedron.to_mesh();
  for (Index e = 0; e < 36; ++e) {
    const Index h = out.source.polyhedron.topology().half_edge_of_edge(e);
    EXPECT_NEAR((mesh.positions[out.source.polyhedron.topology().origin(h)] -
                 mesh.positions[out.source.polyhedron.topology().target(h)])
                    .norm(),
                2 * (1 - 2 * share), 1e-14)
        << "all edges are equally long";
  }
  expect_planar(out.source, 1e-14);
  expect_surface(out.source);
}

TEST(BevelVertices, OneCornerByDistance) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult out =
      bevel_vertices(cube, Vertices{{6}}, {.amount = 0.5, .measure = Measure::distance}).value();
  EXPECT_EQ(counts(out.source), "10/15/7");
  EXPECT_EQ(out.source.polyhedron.find(VertexId{6}), no_index);
  for (const VertexId v : {VertexId{8}, VertexId{9}, VertexId{10}})
    EXPECT_DOUBLE_EQ(
        (out.source.polyhedron.position(out.source.polyhedron.find(v)) - Vector3(1, 1, 1)).norm(), 0.5);
  EXPECT_DOUBLE_EQ(largest_vertex_bevel(cube, Vertices{{6}}, Measure::distance).value(), 2);
  EXPECT_DOUBLE_EQ(largest_vertex_bevel(cube, Vertices{{6}, {5}}, Measure::distance).value(), 1);
}

TEST(BevelVertices, BordersAndValenceTwo) {
  const PolyhedronSource sheet = source_of(test::grid(2, 2));
  const EditResult tip = bevel_vertices(sheet, Vertices{{0}}, {.amount = 0.5}).value();
  EXPECT_EQ(counts(tip.source), "10/13/4");
  EXPECT_EQ(tip.selection.edges.size(), 1U);
  const EditResult side = bevel_vertices(sheet, Vertices{{1}}, {.amount = 0.5}).value();
  EXPECT_EQ(counts(side.source), "11/15/5");
  EXPECT_EQ(side.selection.faces.size(), 1U);
  expect_areas(side.source, 0.01);
  const EditResult all = bevel_vertices(sheet, all_vertices(sheet), {.amount = 0.25}).value();
  EXPECT_EQ(euler(all.source), 1);
  expect_surface(all.source);
}

TEST(BevelVertices, ShapingIsCarried) {
  PolyhedronSource cube = source_of(test::cube());
  Shaping shaping;
  shaping.alpha.set({6}, 3);
  shaping.beta.set(EdgeId::of({6}, {7}), 5);
  for (const std::uint32_t v : {2U, 5U, 7U}) shaping.crease.set(EdgeId::of({6}, {v}), true);
  shaping.crease.set(EdgeId::of({4}, {5}), true);
  shaping.pin.set({6}, {Pin::Kind::normal, {{0, 0, 1}}});
  cube.shaping = shaping;
  const EditResult out = bevel_vertices(cube, Vertices{{6}, {4}}, {.amount = 0.3}).value();
  const Shaping& after = *out.source.shaping;
  EXPECT_EQ(after.alpha.size(), 3U);
  EXPECT_EQ(after.beta.size(), 1U);
  EXPECT_EQ(after.crease.size(), 3U + 3U + 1U) << "a sharp corner is cut sharply, a single crease ends";
  EXPECT_TRUE(after.pin.empty());
}

TEST(BevelVertices, Refusals) {
  const PolyhedronSource cube = source_of(test::cube());
  expect_error(bevel_vertices(cube, Vertices{}, {.amount = 0.1}), e_nothing_selected);
  expect_error(bevel_vertices(cube, Vertices{{8}}, {.amount = 0.1}), e_unknown_element);
  for (const double bad : {0.0, -0.1, 1.0, 7.0, infinity, not_a_number})
    expect_error(bevel_vertices(cube, Vertices{{0}}, {.amount = bad}), e_bad_amount);
  expect_error(bevel_vertices(cube, Vertices{{0}, {1}}, {.amount = 0.5}), e_bad_amount);
}

TEST(BevelVertices, RandomMeshes) {
  int done = 0, surfaces = 0;
  for_random(4000, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = random_shape_source(rng);
    const bool share = chance(rng, 0.6);
    const BevelVerticesOptions options{random_amount(rng, share ? 0.3 : size_of(source) / 10),
                                       share ? Measure::share : Measure::distance};
    const auto result = bevel_vertices(source, random_vertices(source, rng), options);
    expect_same_euler(source, result);
    if (!result) return;
    ++done;
    if (surfaces < 25 && ++surfaces) expect_surface(result->source);
  });
  EXPECT_GT(done, repetitions(300) / 3);
}

TEST(BevelEdges, OneEdgeOfACube) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult out = bevel_edges(cube, Edges{EdgeId::of({5}, {6})}, 0.5).value();
  EXPECT_EQ(counts(out.source), "10/15/7");
  EXPECT_EQ(side_counts(out.source), (std::map<Index, int>{{4, 5}, {5, 2}}));
  EXPECT_EQ(out.selection.faces.size(), 1U);
  expect_planar(out.source, 1e-15);
  const Polyhedron& p = out.source.polyhedron;
  const Index band = p.find(*out.selection.faces.begin());
  EXPECT_NEAR(area_of(p, band), 2 * std::sqrt(0.5), 1e-14);
  EXPECT_LE((face_normal(p, band) - Vector3(1, 0, 1).normalized()).norm(), 1e-14);
  EXPECT_DOUBLE_EQ(largest_edge_bevel(cube, Edges{EdgeId::of({5}, {6})}).value(), 2);
  expect_surface(out.source);
}

TEST(BevelEdges, AllEdgesOfACube) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult out = bevel_edges(cube, all_edges(cube), 0.5).value();
  EXPECT_EQ(counts(out.source), "24/48/26");
  EXPECT_EQ(side_counts(out.source), (std::map<Index, int>{{3, 8}, {4, 18}}));
  EXPECT_EQ(out.selection.faces.size(), 12U + 8U);
  expect_planar(out.source, 1e-14);
  const Polyhedron& p = out.source.polyhedron;
  for (std::uint32_t f = 0; f < 6; ++f) EXPECT_NEAR(area_of(p, p.find(FaceId{f})), 1, 1e-14);
  EXPECT_DOUBLE_EQ(largest_edge_bevel(cube, all_edges(cube)).value(), 1);
  expect_surface(out.source);
}

TEST(BevelEdges, TwoAndThreeEdgesMeet) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult two = bevel_edges(cube, Edges{EdgeId::of({5}, {6}), EdgeId::of({6}, {7})}, 0.5).value();
  EXPECT_EQ(counts(two.source), "11/17/8") << "the bands meet in an edge";
  expect_planar(two.source, 1e-14);
  const EditResult three =
      bevel_edges(cube, Edges{EdgeId::of({5}, {6}), EdgeId::of({6}, {7}), EdgeId::of({2}, {6})}, 0.5).value();
  EXPECT_EQ(counts(three.source), "13/21/10");
  EXPECT_EQ(three.selection.faces.size(), 4U);
  const EditResult loop =
      bevel_edges(
          cube, Edges{EdgeId::of({4}, {5}), EdgeId::of({5}, {6}), EdgeId::of({6}, {7}), EdgeId::of({4}, {7})},
          0.5)
          .value();
  EXPECT_EQ(counts(loop.source), "12/20/10");
  expect_planar(loop.source, 1e-14);
}

TEST(BevelEdges, EndsAtVerticesOfFourEdgesAndAtBorders) {
  const PolyhedronSource sheet = source_of(test::grid(4, 4));
  const EditResult inner = bevel_edges(sheet, Edges{EdgeId::of({7}, {12})}, 0.1).value();
  EXPECT_EQ(inner.source.polyhedron.face_count(), 16U + 3U) << "a band and a triangle at each end";
  EXPECT_EQ(inner.source.polyhedron.vertex_count(), 25U + 4U);
  expect_areas(inner.source, 1e-3);
  const EditResult across = bevel_edges(sheet,
                                        Edges{EdgeId::of({2}, {7}), EdgeId::of({7}, {12}),
                                              EdgeId::of({12}, {17}), EdgeId::of({17}, {22})},
                                        0.1)
                                .value();
  EXPECT_EQ(across.source.polyhedron.face_count(), 16U + 4U);
  EXPECT_EQ(across.source.polyhedron.vertex_count(), 25U + 5U);
  expect_areas(across.source, 0.01);
  for (Index v = 0; v < across.source.polyhedron.vertex_count(); ++v) {
    const Vector3& p = across.source.polyhedron.position(v);
    EXPECT_LE(std::abs(p.x()), 1);
    EXPECT_LE(std::abs(p.y()), 1) << "the outline stays";
  }
  const EditResult all = bevel_edges(sheet, all_edges(sheet), 0.1).value();
  EXPECT_EQ(euler(all.source), 1);
  expect_surface(all.source);
}

TEST(BevelEdges, ShapingIsCarried) {
  PolyhedronSource cube = source_of(test::cube());
  Shaping shaping;
  shaping.crease.set(EdgeId::of({5}, {6}), true);
  shaping.beta.set(EdgeId::of({5}, {6}), 4);
  shaping.beta.set(EdgeId::of({6}, {7}), 3);
  shaping.alpha.set({6}, 2);
  cube.shaping = shaping;
  const EditResult out = bevel_edges(cube, Edges{EdgeId::of({5}, {6})}, 0.8).value();
  EXPECT_EQ(out.source.shaping->crease.size(), 2U) << "both sides of the band";
  EXPECT_EQ(out.source.shaping->beta.size(), 3U);
  EXPECT_EQ(out.source.shaping->alpha.size(), 2U);
}

TEST(BevelEdges, Refusals) {
  const PolyhedronSource cube = source_of(test::cube());
  const Edges one{EdgeId::of({5}, {6})};
  expect_error(bevel_edges(cube, Edges{}, 0.1), e_nothing_selected);
  expect_error(bevel_edges(cube, Edges{EdgeId::of({0}, {6})}, 0.1), e_unknown_element);
  for (const double bad : {0.0, -0.1, 2.0, 1e300, infinity, not_a_number})
    expect_error(bevel_edges(cube, one, bad), e_bad_amount);
  const PolyhedronSource sheet = source_of(test::grid(1, 1));
  expect_error(bevel_edges(sheet, all_edges(sheet), 0.1), e_wrong_selection);
  PolygonMesh pillow;
  pillow.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  pillow.add_face({0, 1, 2});
  pillow.add_face({2, 1, 0});
  expect_error(bevel_edges(source_of(pillow), Edges{EdgeId::of({0}, {1})}, 0.1), e_wrong_selection);
}

TEST(BevelEdges, RandomMeshes) {
  int done = 0, surfaces = 0;
  for_random(4500, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = random_shape_source(rng);
    const Edges edges = random_edges(source, rng);
    double width = random_amount(rng, size_of(source) / 10);
    const auto limit = largest_edge_bevel(source, edges);
    if (limit && chance(rng, 0.6)) width = *limit * uniform(rng, 0.01, 0.99);
    const auto result = bevel_edges(source, edges, width);
    expect_same_euler(source, result);
    if (!result) return;
    ++done;
    if (surfaces < 25 && ++surfaces) expect_surface(result->source);
  });
  EXPECT_GT(done, repetitions(300) / 2);
}

TEST(BevelEdges, BandsOfRegularShapesHaveTheirWidth) {
  for_random(5000, 100, [](std::mt19937_64& rng) {
    const PolyhedronSource source = source_of(random_closed_shape(rng));
    const Edges edges = random_edges(source, rng);
    if (edges.empty()) return;
    const double width = largest_edge_bevel(source, edges).value() * uniform(rng, 0.1, 0.3);
    const auto result = must(bevel_edges(source, edges, width));
    expect_areas(result->source, 1e-7);
    for (Index f = 0; f < source.polyhedron.face_count(); ++f) {
      const Index kept = result->source.polyhedron.find(source.polyhedron.face_id(f));
      EXPECT_GT(face_normal(source.polyhedron, f).dot(face_normal(result->source.polyhedron, kept)), 0.2);
    }
  });
}

/// As the header says: at corners of three edges no two unbevelled ones lie between bands.
TEST(BevelEdges, PlanarFacesWithCornersOfThreeEdgesStayInTheirPlanes) {
  int checked = 0;
  for_random(5500, 200, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = source_of(random_closed_shape(rng));
    const Edges edges = random_edges(source, rng);
    if (edges.empty()) return;
    const double width = largest_edge_bevel(source, edges).value() * uniform(rng, 0.1, 0.3);
    const auto result = must(bevel_edges(source, edges, width));
    const HalfEdgeMesh& mesh = source.polyhedron.topology();
    for (Index f = 0; f < source.polyhedron.face_count(); ++f) {
      const auto corners = mesh.face_vertices(f);
      const bool simple = std::all_of(corners.begin(), corners.end(), [&](Index v) {
        return mesh.valence(v) == 3 && !mesh.is_border_vertex(v);
      });
      if (!simple || unevenness(source.polyhedron, f) > 1e-12) continue;
      ++checked;
      const Index kept = result->source.polyhedron.find(source.polyhedron.face_id(f));
      for (const Vector3& p : corners_of(result->source.polyhedron, kept))
        EXPECT_NEAR((p - face_centre(source.polyhedron, f)).dot(face_normal(source.polyhedron, f)), 0, 1e-9);
    }
  });
  EXPECT_GT(checked, repetitions(200) / 2);
}

}  // namespace
}  // namespace hariko
