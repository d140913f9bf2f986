// Insetting faces.

#include "core/modeling/operations/inset.hpp"

#include "core/document/edits/edit_elements.hpp"
#include "tests/modeling/support.hpp"

namespace hariko {
namespace {

using namespace test;
using Faces = std::vector<FaceId>;
using Measure = InsetOptions::Measure;

/// Distance of a point from the line through a and b.
double distance_to_line(const Vector3& p, const Vector3& a, const Vector3& b) {
  return (p - a).cross((b - a).normalized()).norm();
}

TEST(InsetFaces, CubeTop) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult out = inset_faces(cube, Faces{{1}}, {.amount = 0.25}).value();
  EXPECT_EQ(counts(out.source), "12/20/10");
  EXPECT_EQ(out.selection, (ElementSet{{}, {}, {{1}}}));
  const Polyhedron& p = out.source.polyhedron;
  EXPECT_NEAR(area_of(p, p.find(FaceId{1})), 1.5 * 1.5, 1e-14);
  expect_planar(out.source, 1e-15);
  expect_areas(out.source, 0.1);
  expect_surface(out.source);
  const EditResult share = inset_faces(cube, Faces{{1}}, {.amount = 0.25, .measure = Measure::share}).value();
  EXPECT_TRUE(share.source == out.source) << "the first edges vanish at 1";
  EXPECT_DOUBLE_EQ(largest_inset(cube, Faces{{1}}, Grouping::region).value(), 1);
}

TEST(InsetFaces, ARegionSlidesOnItsInnerEdges) {
  const PolyhedronSource cube = source_of(test::cube());
  const Faces two{{1}, {3}};
  const EditResult out = inset_faces(cube, two, {.amount = 0.25}).value();
  EXPECT_EQ(counts(out.source), "14/24/12");
  expect_planar(out.source, 1e-14);
  const Polyhedron& p = out.source.polyhedron;
  for (const FaceId face : two) EXPECT_NEAR(area_of(p, p.find(face)), 1.5 * 1.75, 1e-14);
  const EditResult apart = inset_faces(cube, two, {.amount = 0.25, .as = Grouping::individual}).value();
  EXPECT_EQ(counts(apart.source), "16/28/14");
}

TEST(InsetFaces, ConcaveFace) {
  PolygonMesh ell;
  ell.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  ell.add_face({0, 1, 2, 3, 4, 5});
  const PolyhedronSource source = source_of(ell);
  const EditResult out = inset_faces(source, Faces{{0}}, {.amount = 0.25}).value();
  EXPECT_EQ(counts(out.source), "12/18/7");
  const Polyhedron& p = out.source.polyhedron;
  EXPECT_NEAR(area_of(p, p.find(FaceId{0})), 1.25, 1e-14);
  expect_areas(out.source, 0.1);
  EXPECT_EQ(out.source.shaping->tag.size(), 6U) << "the outline keeps its corners";
}

TEST(InsetFaces, TheBandIsEvenlyWide) {
  for_random(3000, 200, [](std::mt19937_64& rng) {
    PolygonMesh mesh = random_closed_shape(rng);
    const PolyhedronSource source = source_of(mesh);
    const Faces faces{source.polyhedron.face_id(static_cast<Index>(rng() % source.polyhedron.face_count()))};
    const double width = uniform(rng, 0.1, 0.9) * largest_inset(source, faces, Grouping::region).value();
    const auto result = must(inset_faces(source, faces, {.amount = width}));
    const Index before = source.polyhedron.find(faces[0]);
    const Polyhedron& after = result->source.polyhedron;
    const auto old = corners_of(source.polyhedron, before), rim = corners_of(after, after.find(faces[0]));
    for (std::size_t i = 0; i < old.size(); ++i) {
      const Vector3 &a = old[i], &b = old[(i + 1) % old.size()];
      EXPECT_NEAR(distance_to_line(rim[i], a, b), width, 1e-12);
      EXPECT_NEAR(distance_to_line(rim[(i + 1) % old.size()], a, b), width, 1e-12);
    }
    EXPECT_LE(unevenness(after, after.find(faces[0])), 1e-12);
    expect_areas(result->source, 1e-6);
  });
}

TEST(InsetFaces, CreasesRunAcrossTheBand) {
  PolyhedronSource cube = source_of(test::cube());
  Shaping shaping;
  shaping.crease.set(EdgeId::of({5}, {6}), true);  // between the two faces
  shaping.crease.set(EdgeId::of({4}, {5}), true);  // on the rim
  shaping.beta.set(EdgeId::of({5}, {6}), 4);
  cube.shaping = shaping;
  const EditResult out = inset_faces(cube, Faces{{1}, {3}}, {.amount = 0.25}).value();
  EXPECT_EQ(out.source.shaping->crease.size(), 4U) << "three pieces of the inner edge and the rim";
  EXPECT_EQ(edges_of_tension(out.source, 4), 3);
  EXPECT_TRUE(out.source.shaping->crease.contains(EdgeId::of({4}, {5})));
}

TEST(InsetFaces, Refusals) {
  const PolyhedronSource cube = source_of(test::cube());
  expect_error(inset_faces(cube, Faces{}, {.amount = 0.1}), e_nothing_selected);
  expect_error(inset_faces(cube, Faces{{9}}, {.amount = 0.1}), e_unknown_element);
  expect_error(inset_faces(cube, all_faces(cube), {.amount = 0.1}), e_wrong_selection);
  for (const double bad : {0.0, -0.1, 1.0, 5.0, infinity, not_a_number})
    for (const Measure measure : {Measure::distance, Measure::share})
      expect_error(inset_faces(cube, Faces{{1}}, {.amount = bad, .measure = measure}), e_bad_amount);
}

TEST(InsetFaces, RandomMeshes) {
  int done = 0, surfaces = 0;
  for_random(3500, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = random_shape_source(rng);
    const Faces faces = random_faces(source, rng);
    const bool share = chance(rng, 0.6);
    const InsetOptions options{random_amount(rng, share ? 0.5 : size_of(source) / 10),
                               share ? Measure::share : Measure::distance,
                               chance(rng, 0.5) ? Grouping::region : Grouping::individual};
    const auto result = inset_faces(source, faces, options);
    expect_same_euler(source, result);
    if (!result) return;
    ++done;
    const double size = size_of(source);
    // The most seen in random meshes is 1.11.
    EXPECT_LE(size_of(result->source), 1.2 * size) << "only warped faces leave the old box, by little";
    if (surfaces < 25 && ++surfaces) expect_surface(result->source);
  });
  EXPECT_GT(done, repetitions(300) / 4);
}

}  // namespace
}  // namespace hariko
