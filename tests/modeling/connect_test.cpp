// Operations that connect and take apart: bridge, fill holes, flip, duplicate, separate, detach, join.

#include <limits>

#include "core/document/edits/edits.hpp"
#include "core/modeling/operations/bridge.hpp"
#include "core/modeling/operations/delete_elements.hpp"
#include "core/modeling/operations/fill_hole.hpp"
#include "core/modeling/operations/flip.hpp"
#include "core/modeling/operations/join.hpp"
#include "core/modeling/operations/separate.hpp"
#include "core/polyhedron/volume.hpp"
#include "tests/modeling/operation_cases.hpp"

namespace hariko::test {
namespace {

double volume_of(const Polyhedron& polyhedron) {
  double sum = 0;
  for (const double v : closed_component_volumes(polyhedron.topology(), polyhedron.positions())) sum += v;
  return sum;
}

/// Two n- and m-gon prisms above each other: faces 0 (bottom) and 1 (top) of the first, m + 2 ... of the
/// second.
PolyhedronSource two_prisms(int n, int m) {
  return source_of(test::together(test::prism(n), test::prism(m), {0, 0, 5}));
}

TEST(Bridge, FacesWithEqualCountsAreJoinedStraight) {
  for (int n = 3; n <= 20; ++n) {
    const PolyhedronSource prisms = two_prisms(n, n);
    const FaceId lower_top{1}, upper_bottom{static_cast<std::uint32_t>(n + 2)};
    for (const bool swap : {false, true}) {
      const auto done =
          test::must(bridge_faces(prisms, swap ? upper_bottom : lower_top, swap ? lower_top : upper_bottom));
      test::expect_sound(*done, prisms);
      const Polyhedron& polyhedron = done->source.polyhedron;
      EXPECT_EQ(euler_number(polyhedron), 2);
      EXPECT_EQ(done->selection.faces.size(), static_cast<std::size_t>(n));
      // The whole is a prism of height 7.
      const double area = n / 2.0 * std::sin(2 * std::numbers::pi / n);
      EXPECT_NEAR(volume_of(polyhedron), 7 * area, 1e-12);
    }
  }
}

TEST(Bridge, FacesWithUnequalCountsGetTriangles) {
  for (int n = 3; n <= 12; ++n)
    for (int m = 3; m <= 12; ++m) {
      const PolyhedronSource prisms = two_prisms(n, m);
      const auto done = bridge_faces(prisms, FaceId{1}, FaceId{static_cast<std::uint32_t>(n + 2)});
      ASSERT_TRUE(done.ok()) << to_string(done.error());
      test::expect_sound(*done, prisms);
      EXPECT_EQ(euler_number(done->source.polyhedron), 2);
      int triangles = 0;
      for (const FaceId id : done->selection.faces) {
        const Index f = done->source.polyhedron.find(id);
        const Index sides = done->source.polyhedron.topology().side_count(f);
        EXPECT_TRUE(sides == 3 || sides == 4);
        triangles += sides == 3;
      }
      EXPECT_EQ(triangles, std::abs(n - m));
      EXPECT_EQ(done->selection.faces.size(), static_cast<std::size_t>(std::max(n, m)));
    }
}

TEST(Bridge, TwistTurnsTheFarEnd) {
  const PolyhedronSource prisms = two_prisms(6, 6);
  const auto straight = bridge_faces(prisms, {1}, {8}), twisted = bridge_faces(prisms, {1}, {8}, {1});
  const auto round = bridge_faces(prisms, {1}, {8}, {6}), back = bridge_faces(prisms, {1}, {8}, {-5});
  ASSERT_TRUE(twisted.ok());
  EXPECT_FALSE(twisted->source == straight->source);
  EXPECT_TRUE(round->source == straight->source);
  EXPECT_TRUE(back->source == twisted->source);
  EXPECT_TRUE(bridge_faces(prisms, {1}, {8}, {std::numeric_limits<int>::min()}).ok());
}

TEST(Bridge, ThroughABlockMakesATunnel) {
  // The middle cells of top and bottom of a 3 x 3 slab.
  const PolyhedronSource slab = source_of(test::cells(3, 3, 1, [](int, int, int) { return true; }));
  std::vector<FaceId> middle;
  for (Index f = 0; f < slab.polyhedron.face_count(); ++f) {
    Vector3 centre = Vector3::Zero();
    for (const Index v : slab.polyhedron.topology().face_vertices(f))
      centre += slab.polyhedron.position(v) / 4;
    if (std::abs(centre.x()) < 0.1 && std::abs(centre.y()) < 0.1)
      middle.push_back(slab.polyhedron.face_id(f));
  }
  ASSERT_EQ(middle.size(), 2U);
  const auto done = test::must(bridge_faces(slab, middle[0], middle[1]));
  EXPECT_EQ(euler_number(done->source.polyhedron), 0);
  EXPECT_NEAR(volume_of(done->source.polyhedron), 8, 1e-12);
}

TEST(Bridge, RefusesWhatCannotBe) {
  const PolyhedronSource cube = source_of(test::cube());
  const auto opposite = bridge_faces(cube, {0}, {1});
  ASSERT_FALSE(opposite.ok()) << "the sides of the cube are in the way";
  EXPECT_EQ(opposite.error().code, e_would_be_nonmanifold);
  test::must_fail(bridge_faces(cube, {1}, {2}), e_wrong_selection);
  EXPECT_EQ(bridge_faces(cube, {1}, {1}).error().code, e_wrong_selection);
  EXPECT_EQ(bridge_faces(cube, {1}, {77}).error().code, e_unknown_element);
  EXPECT_EQ(bridge_borders(cube, {}).error().code, e_nothing_selected);
  EXPECT_EQ(bridge_borders(cube, std::vector<EdgeId>{{{0}, {1}}}).error().code, e_wrong_selection);
  const PolyhedronSource grid = source_of(test::grid(2, 2));
  EXPECT_EQ(bridge_borders(grid, border_edges(grid.polyhedron)).error().code, e_wrong_selection);
}

TEST(Bridge, BordersAndStretches) {
  // A tube of four sides, open at both ends of each of two pieces.
  PolyhedronSource prisms = two_prisms(4, 7);
  prisms = delete_faces(prisms, std::vector<FaceId>{{1}, {6}})->source;
  const auto loops = test::must(bridge_borders(prisms, border_edges(prisms.polyhedron)));
  EXPECT_EQ(euler_number(loops->source.polyhedron), 2);
  EXPECT_EQ(loops->source.polyhedron.topology().border_loop_count(), 0U);
  const PolyhedronSource sheets = source_of(test::together(test::grid(2, 2), test::grid(3, 2), {3, 0, 0}));
  // Right side of the first: 2 5 8; left side of the second: 9, 13, 17.
  const std::vector<EdgeId> sides{{{2}, {5}}, {{5}, {8}}, {{9}, {13}}, {{13}, {17}}};
  const auto stretches = test::must(bridge_borders(sheets, sides));
  test::expect_sound(*stretches, sheets);
  EXPECT_EQ(stretches->selection.faces.size(), 2U);
  EXPECT_EQ(euler_number(stretches->source.polyhedron), 1);
  EXPECT_EQ(stretches->source.polyhedron.topology().border_loop_count(), 1U);
}

TEST(Bridge, RandomMeshes) {
  int done_count = 0;
  test::for_random(101, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = test::random_source(rng);
    const auto faces = test::all_faces(source);
    for (int i = 0; i < 5; ++i) {
      const auto done = bridge_faces(source, faces[rng() % faces.size()], faces[rng() % faces.size()],
                                     {test::uniform_int(rng, -3, 3)});
      if (!done.ok()) {
        test::expect_refusal(done.error());
        continue;
      }
      ++done_count;
      test::expect_sound(*done, source);
      EXPECT_EQ(euler_number(done->source.polyhedron), euler_number(source.polyhedron) - 2);
    }
    const auto borders = bridge_borders(source, border_edges(source.polyhedron));
    if (borders.ok()) {
      ++done_count;
      test::expect_sound(*borders, source);
      EXPECT_EQ(euler_number(borders->source.polyhedron), euler_number(source.polyhedron));
      EXPECT_EQ(borders->source.polyhedron.topology().border_loop_count(), 0U);
    } else {
      test::expect_refusal(borders.error());
    }
  });
  EXPECT_GT(done_count, test::repetitions(100));
}

TEST(FillHoles, RandomMeshesBecomeClosed) {
  int done_count = 0;
  test::for_random(102, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = test::random_source(rng);
    const Polyhedron& polyhedron = source.polyhedron;
    const auto edges = border_edges(polyhedron);
    const auto all = fill_holes(source, edges);
    if (edges.empty()) {
      EXPECT_FALSE(all.ok());
      return;
    }
    if (!all.ok()) return test::expect_refusal(all.error());
    ++done_count;
    test::expect_sound(*all, source);
    const auto holes = polyhedron.topology().border_loop_count();
    EXPECT_EQ(all->selection.faces.size(), holes);
    EXPECT_EQ(all->source.polyhedron.topology().border_loop_count(), 0U);
    EXPECT_EQ(euler_number(all->source.polyhedron), euler_number(polyhedron) + static_cast<int>(holes));
    EXPECT_EQ(all->source.polyhedron.edge_count(), polyhedron.edge_count());
    // Deleting the new faces gives back what was there, but for the ids to come.
    const std::vector<FaceId> fresh(all->selection.faces.begin(), all->selection.faces.end());
    EXPECT_TRUE(delete_faces(all->source, fresh)->source.polyhedron == polyhedron);
    const auto one = test::must(fill_holes(source, std::vector<EdgeId>{edges[rng() % edges.size()]}));
    EXPECT_EQ(one->selection.faces.size(), 1U);
  });
  EXPECT_GT(done_count, test::repetitions(50));
  const PolyhedronSource cube = source_of(test::cube());
  EXPECT_EQ(fill_holes(cube, std::vector<EdgeId>{{{0}, {1}}}).error().code, e_wrong_selection);
}

TEST(Flip, WholePartsOnly) {
  test::for_random(103, 300, [](std::mt19937_64& rng) {
    const PolyhedronSource source = test::random_source(rng);
    const auto all = test::all_faces(source);
    const auto done = test::must(flip_faces(source, all));
    test::expect_sound(*done, source);
    EXPECT_NEAR(volume_of(done->source.polyhedron), -volume_of(source.polyhedron),
                1e-9 * std::abs(volume_of(source.polyhedron)));
    EXPECT_TRUE(flip_faces(done->source, all)->source == source);
    const auto some = test::some_faces(source.polyhedron, rng, 0.5);
    const auto part = flip_faces(source, some);
    const auto components = source.polyhedron.topology().face_components();
    std::set<Index> touched;
    for (const FaceId id : some) touched.insert(components[source.polyhedron.find(id)]);
    const auto whole =
        std::count_if(components.begin(), components.end(), [&](Index c) { return touched.contains(c); });
    EXPECT_EQ(part.ok(), !some.empty() && static_cast<std::size_t>(whole) == some.size());
  });
}

TEST(Flip, PinnedNormalsTurn) {
  PolyhedronSource cube = source_of(test::cube());
  Shaping shaping;
  shaping.pin.set({6}, {Pin::Kind::normal, {Vector3(1, 2, 3)}});
  cube.shaping = shaping;
  const auto done = flip_faces(cube, test::all_faces(cube));
  EXPECT_EQ(done->source.shaping->pin.find({6})->vectors[0], Vector3(-1, -2, -3));
}

TEST(Separate, DuplicatesAndLooseParts) {
  int done_count = 0;
  test::for_random(104, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = test::random_source(rng);
    const Polyhedron& polyhedron = source.polyhedron;
    const auto faces = test::some_faces(polyhedron, rng, test::uniform(rng));
    PolygonMesh inside, outside;
    inside.positions = outside.positions = polyhedron.positions();
    for (Index f = 0; f < polyhedron.face_count(); ++f)
      (std::binary_search(faces.begin(), faces.end(), polyhedron.face_id(f)) ? inside : outside)
          .add_face(polyhedron.topology().face_vertices(f));
    const auto part = Polyhedron::build(remove_isolated_vertices(inside));
    const auto rest = Polyhedron::build(remove_isolated_vertices(outside));

    const auto copied = duplicate_faces(source, faces);
    ASSERT_EQ(copied.ok(), part.ok());
    if (copied.ok()) {
      ++done_count;
      test::expect_sound(*copied, source);
      EXPECT_EQ(euler_number(copied->source.polyhedron), euler_number(polyhedron) + euler_number(*part));
      EXPECT_EQ(copied->selection.faces.size(), faces.size());
      // The copy lies on the original, and without it the original is there as before.
      const std::vector<FaceId> fresh(copied->selection.faces.begin(), copied->selection.faces.end());
      EXPECT_TRUE(delete_faces(copied->source, fresh)->source == source);
    } else {
      test::expect_refusal(copied.error());
    }
    const auto apart = separate_faces(source, faces);
    if (apart.ok()) {
      ++done_count;
      test::expect_sound(*apart, source);
      ASSERT_TRUE(part.ok() && rest.ok());
      EXPECT_EQ(euler_number(apart->source.polyhedron), euler_number(*part) + euler_number(*rest));
      EXPECT_EQ(apart->source.polyhedron.face_count(), polyhedron.face_count());
    } else {
      test::expect_refusal(apart.error());
    }
  });
  EXPECT_GT(done_count, test::repetitions(200));
}

TEST(Separate, ShapingIsCopied) {
  PolyhedronSource cube = source_of(test::cube());
  Shaping shaping;
  shaping.alpha.set({6}, 4);
  shaping.beta.set(EdgeId{{6}, {7}}, 9);
  shaping.crease.set(EdgeId{{4}, {5}}, true);
  shaping.pin.set({4}, {Pin::Kind::normal, {Vector3(0, 0, 1)}});
  cube.shaping = shaping;
  const auto done = duplicate_faces(cube, std::vector<FaceId>{{1}});
  ASSERT_TRUE(done.ok());  // copies of 4 5 6 7 are 8 9 10 11
  EXPECT_EQ(done->source.shaping->alpha.get_or({10}, 0), 4);
  EXPECT_EQ(done->source.shaping->beta.get_or(EdgeId{{10}, {11}}, 1), 9);
  EXPECT_TRUE(done->source.shaping->crease.contains(EdgeId{{8}, {9}}));
  EXPECT_TRUE(done->source.shaping->pin.contains({8}));
}

TEST(Detach, FacesBecomeAnObject) {
  Document document = document_from_mesh(test::cube(), "Cube").value();
  Similarity place{.translation = {1, 2, 3}};
  document = set_transform(document, {1}, place).value();
  const auto done = test::must(detach_faces(document, {1}, std::vector<FaceId>{{1}}));
  ASSERT_EQ(done->document.objects.size(), 2U);
  EXPECT_EQ(done->document.find({1})->polyhedron()->polyhedron.face_count(), 5U);
  const Object& part = *done->document.find(done->object);
  EXPECT_EQ(part.polyhedron()->polyhedron.face_count(), 1U);
  EXPECT_EQ(part.polyhedron()->polyhedron.vertex_id(0), VertexId{4}) << "ids stay";
  EXPECT_EQ(part.transform, place);
  EXPECT_EQ(detach_faces(document, {1}, test::all_faces(*document.find({1})->polyhedron())).error().code,
            e_no_faces);
  EXPECT_EQ(detach_faces(document, {9}, std::vector<FaceId>{{1}}).error().code, e_unknown_object);
  EXPECT_EQ(detach_faces(set_locked(document, {1}, true).value(), {1}, std::vector<FaceId>{{1}}).error().code,
            e_locked);
}

TEST(Join, ObjectsStayWhereTheyAre) {
  test::for_random(105, 100, [](std::mt19937_64& rng) {
    Document document;
    std::vector<ObjectId> ids;
    std::vector<Vector3> points;
    int euler = 0;
    const int count = test::uniform_int(rng, 2, 4);
    for (int i = 0; i < count; ++i) {
      PolyhedronSource source = test::random_source(rng);
      Similarity place;
      place.rotation = Eigen::Quaterniond(1, test::uniform(rng), test::uniform(rng), test::uniform(rng));
      place.rotation.normalize();
      place.scale = test::log_uniform(rng, 0.1, 10);
      place.translation = test::random_vector(rng, 100);
      for (Index v = 0; v < source.polyhedron.vertex_count(); ++v)
        points.push_back(place.apply(source.origin + source.polyhedron.position(v)));
      euler += euler_number(source.polyhedron);
      const auto added = add_object(document, "Part", source, place);
      document = added->document;
      ids.push_back(added->id);
    }
    const auto joined = test::must(join_objects(document, ids));
    ASSERT_EQ(joined->objects.size(), 1U);
    const Object& whole = *joined->find(ids[0]);
    const Polyhedron& polyhedron = whole.polyhedron()->polyhedron;
    EXPECT_EQ(euler_number(polyhedron), euler);
    ASSERT_EQ(polyhedron.vertex_count(), points.size());
    double size = 0;
    for (const Vector3& p : points) size = std::max(size, p.norm());
    for (Index v = 0; v < polyhedron.vertex_count(); ++v)
      EXPECT_LE(
          (whole.transform.apply(whole.polyhedron()->origin + polyhedron.position(v)) - points[v]).norm(),
          1e-13 * size);
  });
}

TEST(Join, PinsAndTensionsComeAlong) {
  PolyhedronSource cube = source_of(test::cube());
  Shaping shaping;
  shaping.alpha.set({2}, 3);
  shaping.pin.set({1}, {Pin::Kind::tangents, {Vector3(1, 0, 0), Vector3(0, 1, 0)}});
  shaping.crease.set(EdgeId{{0}, {1}}, true);
  cube.shaping = shaping;
  Similarity turned;
  turned.rotation = Eigen::AngleAxisd(std::numbers::pi / 2, Vector3::UnitZ());
  turned.scale = 2;
  const auto done = test::must(join(source_of(test::cube()), cube, turned));
  EXPECT_EQ(done->source.shaping->alpha.get_or({10}, 0), 3);
  EXPECT_TRUE(done->source.shaping->crease.contains(EdgeId{{8}, {9}}));
  const Pin* pin = done->source.shaping->pin.find({9});
  ASSERT_TRUE(pin && pin->kind == Pin::Kind::tangents);
  EXPECT_LE((pin->vectors[0] - Vector3(0, 2, 0)).norm(), 1e-12);
}

TEST(Join, RefusesWhatCannotBe) {
  Document document = document_from_mesh(test::cube(), "Cube").value();
  document = duplicate_object(document, {1})->document;
  const std::vector<ObjectId> one{{1}, {1}}, lost{{1}, {9}}, both{{1}, {2}};
  EXPECT_EQ(join_objects(document, {}).error().code, e_wrong_selection);
  EXPECT_EQ(join_objects(document, one).error().code, e_wrong_selection);
  EXPECT_EQ(join_objects(document, lost).error().code, e_unknown_object);
  EXPECT_EQ(join_objects(set_locked(document, {2}, true).value(), both).error().code, e_locked);
  EXPECT_EQ(join_objects(set_locked(document, {1}, true).value(), both).error().code, e_locked);
}

}  // namespace
}  // namespace hariko::test
