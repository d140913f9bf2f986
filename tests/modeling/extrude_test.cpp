// Extruding faces and open borders.

#include "core/modeling/operations/extrude.hpp"

#include "core/document/edits/edit_elements.hpp"
#include "core/polyhedron/validation.hpp"
#include "tests/modeling/support.hpp"

namespace hariko {
namespace {

using namespace test;
using Faces = std::vector<FaceId>;
using Edges = std::vector<EdgeId>;

double volume_of(const PolyhedronSource& source) {
  double volume = 0;
  for (Index f = 0; f < source.polyhedron.face_count(); ++f) {
    const auto corners = corners_of(source.polyhedron, f);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      volume += corners[0].dot(corners[i].cross(corners[i + 1])) / 6;
  }
  return volume;
}

TEST(ExtrudeFaces, CubeTop) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult out = extrude_faces(cube, Faces{{1}}, {.distance = 3}).value();
  EXPECT_EQ(counts(out.source), "12/20/10");
  EXPECT_EQ(out.selection, (ElementSet{{}, {}, {{1}}}));
  EXPECT_DOUBLE_EQ(volume_of(out.source), 8 + 12);
  EXPECT_DOUBLE_EQ(face_centre(out.source.polyhedron, out.source.polyhedron.find(FaceId{1})).z(), 4);
  for (std::uint32_t v = 0; v < 8; ++v)
    EXPECT_EQ(out.source.polyhedron.position(out.source.polyhedron.find(VertexId{v})),
              cube.polyhedron.position(v))
        << "the old rim stays";
  expect_planar(out.source, 1e-15);
  expect_areas(out.source, 1);
  expect_surface(out.source);
  EXPECT_DOUBLE_EQ(volume_of(extrude_faces(cube, Faces{{1}}, {.distance = -1}).value().source), 8 - 4);
}

TEST(ExtrudeFaces, InPlaceIsAllowed) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult out = extrude_faces(cube, Faces{{1}}).value();
  EXPECT_EQ(counts(out.source), "12/20/10");
  EXPECT_DOUBLE_EQ(volume_of(out.source), 8);
}

TEST(ExtrudeFaces, RegionsMoveTogetherFacesApart) {
  const PolyhedronSource cube = source_of(test::cube());
  const Faces two{{1}, {3}};  // z = 1 and x = 1
  const EditResult together = extrude_faces(cube, two, {.distance = std::sqrt(2)}).value();
  EXPECT_EQ(counts(together.source), "14/24/12");
  EXPECT_NEAR(
      (face_centre(together.source.polyhedron, together.source.polyhedron.find(FaceId{1})) - Vector3(1, 0, 2))
          .norm(),
      0, 1e-14);
  const EditResult apart = extrude_faces(cube, two, {.distance = 2, .as = Grouping::individual}).value();
  EXPECT_EQ(counts(apart.source), "16/28/14");
  EXPECT_NEAR(volume_of(apart.source), 8 + 2 * 8, 1e-12);
  const EditResult all =
      extrude_faces(cube, all_faces(cube), {.distance = 2, .as = Grouping::individual}).value();
  EXPECT_EQ(counts(all.source), "32/60/30");
  EXPECT_NEAR(volume_of(all.source), 8 + 6 * 8, 1e-12);
  expect_surface(all.source);
}

TEST(ExtrudeFaces, InnerVerticesMoveWithTheirIds) {
  const PolyhedronSource sheet = source_of(test::grid(4, 4));
  const Faces middle{{5}, {6}, {9}, {10}};
  const EditResult out = extrude_faces(sheet, middle, {.distance = 1}).value();
  EXPECT_EQ(euler(out.source), 1);
  EXPECT_EQ(out.source.polyhedron.vertex_count(), 25U + 8U);
  const Index centre = out.source.polyhedron.find(VertexId{12});
  EXPECT_NEAR((out.source.polyhedron.position(centre) - sheet.polyhedron.position(12)).norm(), 1, 1e-12);
}

TEST(ExtrudeFaces, ASheetBecomesABody) {
  for (const double distance : {2.0, -2.0}) {
    PolygonMesh flat = test::grid(3, 2);
    for (Vector3& p : flat.positions) p.z() = 0;
    const PolyhedronSource sheet = source_of(flat);
    const EditResult out = extrude_faces(sheet, all_faces(sheet), {.distance = distance}).value();
    EXPECT_EQ(euler(out.source), 2);
    EXPECT_EQ(out.source.polyhedron.topology().border_loop_count(), 0U);
    EXPECT_NEAR(volume_of(out.source), 8, 1e-12) << "outside is outside";
    EXPECT_EQ(out.source.polyhedron.face_count(), 6U + 6U + 10U);
  }
  const PolyhedronSource tube = source_of(test::without_face(test::without_face(test::prism(6), 1), 0));
  Faces faces = all_faces(tube);
  const auto refused = extrude_faces(tube, faces, {.distance = 1});
  expect_error(refused, e_wrong_selection);  // its normals cancel out
  const EditResult wall = extrude_faces(tube, faces).value();
  EXPECT_EQ(euler(wall.source), 0) << "the wall of a tube is a torus";
}

TEST(ExtrudeFaces, ShapingIsCarried) {
  PolyhedronSource cube = source_of(test::cube());
  Shaping shaping;
  shaping.alpha.set({4}, 3);
  shaping.beta.set(EdgeId::of({4}, {5}), 5);
  shaping.crease.set(EdgeId::of({4}, {5}), true);
  shaping.pin.set({6}, {Pin::Kind::normal, {{0, 0, 1}}});
  cube.shaping = shaping;
  const EditResult out = extrude_faces(cube, Faces{{1}}, {.distance = 1}).value();
  const Polyhedron& p = out.source.polyhedron;
  const auto top = p.topology().face_vertices(p.find(FaceId{1}));
  const VertexId a = p.vertex_id(top[0]), b = p.vertex_id(top[1]);
  const Shaping& after = *out.source.shaping;
  EXPECT_EQ(after.alpha.get_or({4}, 0), 3);
  EXPECT_EQ(after.alpha.get_or(a, 0), 3);
  EXPECT_EQ(after.beta.get_or(EdgeId::of({4}, {5}), 1), 5);
  EXPECT_EQ(after.beta.get_or(EdgeId::of(a, b), 1), 5);
  EXPECT_TRUE(after.crease.contains(EdgeId::of({4}, {5})));
  EXPECT_TRUE(after.crease.contains(EdgeId::of(a, b)));
  EXPECT_EQ(after.crease.size(), 2U);
  EXPECT_EQ(after.pin.size(), 1U);
  EXPECT_TRUE(after.pin.contains({6}));
}

TEST(ExtrudeFaces, ACreaseAcrossTheRimGoesUpTheWall) {
  PolyhedronSource sheet = source_of(test::grid(4, 4));
  Shaping shaping;
  for (const auto& [a, b] : {std::pair{2, 7}, {7, 12}, {12, 17}})
    shaping.crease.set(EdgeId::of({std::uint32_t(a)}, {std::uint32_t(b)}), true);
  sheet.shaping = shaping;
  const EditResult out = extrude_faces(sheet, Faces{{5}, {6}, {9}, {10}}, {.distance = 1}).value();
  // 2-7, 7-7', 7'-12, 12-17', and 17-17' is no crease: nothing beyond 17 is one.
  EXPECT_EQ(out.source.shaping->crease.size(), 4U);
}

TEST(ExtrudeFaces, Refusals) {
  const PolyhedronSource cube = source_of(test::cube());
  expect_error(extrude_faces(cube, Faces{}), e_nothing_selected);
  expect_error(extrude_faces(cube, Faces{{6}}), e_unknown_element);
  expect_error(extrude_faces(cube, all_faces(cube), {.distance = 1}), e_wrong_selection);
  for (const double bad : {infinity, not_a_number})
    expect_error(extrude_faces(cube, Faces{{1}}, {.distance = bad}), e_bad_amount);
  PolyhedronSource far = cube;
  for (Index v = 0; v < 8; ++v) {
    const Vector3 p = cube.polyhedron.position(v) * 1.7e308;
    far.polyhedron = far.polyhedron.with_positions(std::vector<Index>{v}, std::vector<Vector3>{p}).value();
  }
  expect_error(extrude_faces(far, Faces{{1}}, {.distance = 1.7e308}), e_nonfinite);
}

TEST(ExtrudeFaces, RandomMeshes) {
  int done = 0, surfaces = 0;
  for_random(1000, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = random_shape_source(rng);
    const ExtrudeOptions options{random_amount(rng, size_of(source)),
                                 chance(rng, 0.5) ? Grouping::region : Grouping::individual};
    const Faces faces = random_faces(source, rng);
    const auto result = extrude_faces(source, faces, options);
    expect_whole(source, result);
    if (!result) return;
    ++done;
    // Whole open parts double; all else keeps the number.
    std::vector<Index> dense;
    for (const FaceId id : faces) dense.push_back(source.polyhedron.find(id));
    std::sort(dense.begin(), dense.end());
    int expected = euler(source);
    for (const Region& region : find_regions(source.polyhedron, dense, options.as)) {
      if (!region.whole_part) continue;
      const int v = static_cast<int>(region.rim.size() + region.inner_vertices.size());
      int corners = 0;
      for (const Index f : region.faces)
        corners += static_cast<int>(source.polyhedron.topology().side_count(f));
      const int rim = static_cast<int>(region.rim.size());
      expected += v - (corners + rim) / 2 + static_cast<int>(region.faces.size());
    }
    EXPECT_EQ(euler(result->source), expected);
    for (const FaceId face : faces) EXPECT_TRUE(result->selection.faces.contains(face));
    if (std::abs(options.distance) < 1e3 * size_of(source) && surfaces < 25 && ++surfaces)
      expect_surface(result->source);
  });
  EXPECT_GT(done, repetitions(300) / 3);
}

TEST(ExtrudeFaces, EveryFaceMovesByTheDistance) {
  for_random(1500, 100, [](std::mt19937_64& rng) {
    const PolyhedronSource source = with_gaps(source_of(random_closed_polyhedron(rng)), rng);
    const Faces faces = random_faces(source, rng);
    const auto result = extrude_faces(source, faces, {.distance = 0.25, .as = Grouping::individual});
    if (faces.empty()) return;
    ASSERT_TRUE(result);
    const Polyhedron& after = result->source.polyhedron;
    for (const FaceId face : faces) {
      const Index f = source.polyhedron.find(face);
      const Vector3 moved = face_centre(after, after.find(face)) - face_centre(source.polyhedron, f);
      EXPECT_LE((moved - 0.25 * face_normal(source.polyhedron, f)).norm(), 1e-13);
    }
    expect_areas(result->source, 1e-4);
  });
}

TEST(ExtrudeBorders, OfAGrid) {
  PolygonMesh flat = test::grid(1, 1);
  for (Vector3& p : flat.positions) p.z() = 0;
  const PolyhedronSource sheet = source_of(flat);
  const EditResult one = extrude_borders(sheet, Edges{EdgeId::of({0}, {1})}, 0.5).value();
  EXPECT_EQ(counts(one.source), "6/7/2");
  EXPECT_EQ(one.selection.edges.size(), 1U);
  for (const VertexId v : {one.selection.edges.begin()->low, one.selection.edges.begin()->high})
    EXPECT_DOUBLE_EQ(one.source.polyhedron.position(one.source.polyhedron.find(v)).y(), -1.5);
  EXPECT_TRUE(one.source.shaping->tag.empty()) << "the border goes on straight";
  const EditResult all = extrude_borders(sheet, all_edges(sheet), 0.5).value();
  EXPECT_EQ(counts(all.source), "8/12/5");
  for (const VertexId v : all_vertices(all.source)) {
    const Vector3& p = all.source.polyhedron.position(all.source.polyhedron.find(v));
    EXPECT_DOUBLE_EQ(std::abs(p.x()), v.value < 4 ? 1 : 1.5);
    EXPECT_DOUBLE_EQ(std::abs(p.y()), v.value < 4 ? 1 : 1.5);
  }
  expect_surface(all.source);
  expect_error(extrude_borders(all.source, Edges{EdgeId::of({0}, {1})}), e_wrong_selection);
  expect_error(extrude_borders(all.source, Edges{}), e_nothing_selected);
  expect_error(extrude_borders(all.source, Edges{EdgeId::of({0}, {3})}), e_unknown_element);
  expect_error(extrude_borders(sheet, all_edges(sheet), not_a_number), e_bad_amount);
}

TEST(ExtrudeBorders, RandomMeshes) {
  int done = 0, surfaces = 0;
  for_random(2000, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = random_shape_source(rng);
    Edges edges = random_edges(source, rng);
    if (chance(rng, 0.9))
      std::erase_if(edges, [&](EdgeId id) {
        return !source.polyhedron.topology().is_border_edge(source.polyhedron.find(id));
      });
    const double distance = random_amount(rng, size_of(source));
    const auto result = extrude_borders(source, edges, distance);
    expect_same_euler(source, result);
    if (!result) return;
    ++done;
    EXPECT_EQ(result->source.polyhedron.face_count(), source.polyhedron.face_count() + edges.size());
    if (std::abs(distance) < 1e3 * size_of(source) && surfaces < 25 && ++surfaces)
      expect_surface(result->source);
  });
  EXPECT_GT(done, repetitions(300) / 10);
}

}  // namespace
}  // namespace hariko
