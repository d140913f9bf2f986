// Subdividing edges and faces, poking faces.

#include "core/modeling/cuts/subdivide.hpp"
#include "core/geometry/polygon.hpp"

#include "core/document/edits/edit_elements.hpp"
#include "core/modeling/operations/face_geometry.hpp"
#include "tests/modeling/support.hpp"

namespace hariko {
namespace {

using namespace test;
using Faces = std::vector<FaceId>;
using Edges = std::vector<EdgeId>;

TEST(SubdivideEdges, EvenlySpaced) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult out = subdivide_edges(cube, Edges{edge(0, 1)}, 3).value();
  EXPECT_EQ(counts(out.source), "11/15/6");
  EXPECT_EQ(out.selection.vertices, (std::set<VertexId>{{8}, {9}, {10}}));
  for (std::uint32_t i = 0; i < 3; ++i)
    EXPECT_EQ(out.source.polyhedron.position(8 + i), Vector3(-0.5 + 0.5 * i, -1, -1));
  expect_error(subdivide_edges(cube, Edges{}), e_nothing_selected);
  expect_error(subdivide_edges(cube, Edges{edge(0, 6)}), e_unknown_element);
  for (const int bad : {0, -5, 1001})
    expect_error(subdivide_edges(cube, Edges{edge(0, 1)}, bad), e_bad_amount);
  const PolyhedronSource many = source_of(test::torus(60, 50));
  expect_error(subdivide_edges(many, all_edges(many), 1000), e_too_many_elements);
}

TEST(SubdivideEdges, TheBorderStaysSmooth) {
  PolyhedronSource sheet = source_of(test::grid(1, 1));
  const EditResult out = subdivide_edges(sheet, all_edges(sheet), 1).value();
  for (const VertexId v : out.selection.vertices)
    EXPECT_EQ(out.source.shaping->tag.get_or(v, VertexTag::automatic), VertexTag::smooth);
  EXPECT_EQ(out.source.shaping->tag.size(), 4U);
  expect_surface(out.source);
}

TEST(SubdivideFaces, Cube) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult all = subdivide_faces(cube, all_faces(cube)).value();
  EXPECT_EQ(counts(all.source), "26/48/24");
  EXPECT_EQ(all.selection.faces.size(), 24U);
  expect_planar(all.source, 1e-15);
  for (Index f = 0; f < 24; ++f) EXPECT_NEAR(area_of(all.source.polyhedron, f), 1, 1e-15);
  const EditResult one = subdivide_faces(cube, Faces{{1}}).value();
  EXPECT_EQ(counts(one.source), "13/20/9");
  EXPECT_EQ(one.selection.faces.size(), 4U);
  expect_surface(one.source);
  expect_error(subdivide_faces(cube, Faces{}), e_nothing_selected);
  expect_error(subdivide_faces(cube, Faces{{77}}), e_unknown_element);
}

TEST(PokeFaces, Cube) {
  const PolyhedronSource cube = source_of(test::cube());
  const EditResult out = poke_faces(cube, all_faces(cube)).value();
  EXPECT_EQ(counts(out.source), "14/36/24");
  EXPECT_EQ(out.selection.vertices.size(), 6U);
  for (Index f = 0; f < 24; ++f) EXPECT_NEAR(area_of(out.source.polyhedron, f), 1, 1e-15);
  expect_error(poke_faces(cube, Faces{}), e_nothing_selected);
  expect_error(poke_faces(cube, Faces{{77}}), e_unknown_element);
}

TEST(Subdivide, RandomMeshes) {
  int done = 0, surfaces = 0;
  for_random(8000, 300, [&](std::mt19937_64& rng) {
    const PolyhedronSource source = random_shape_source(rng);
    const double area_before = [&] {
      double sum = 0;
      for (Index f = 0; f < source.polyhedron.face_count(); ++f) sum += area_of(source.polyhedron, f);
      return sum;
    }();
    const int which = uniform_int(rng, 0, 2);
    const auto result = which == 0
                            ? subdivide_edges(source, random_edges(source, rng), uniform_int(rng, 0, 4))
                        : which == 1 ? subdivide_faces(source, random_faces(source, rng))
                                     : poke_faces(source, random_faces(source, rng));
    expect_same_euler(source, result);
    if (!result) return;
    ++done;
    double area = 0;
    for (Index f = 0; f < result->source.polyhedron.face_count(); ++f)
      area += area_of(result->source.polyhedron, f);
    if (which == 0) {
      EXPECT_NEAR(area / area_before, 1, 1e-9);
    }
    EXPECT_GE(area / area_before, 1 - 1e-9) << "parts of a face have at least the area of its mean plane";
    if (surfaces < 25 && ++surfaces) expect_surface(result->source);
  });
  EXPECT_GT(done, repetitions(300) / 2);
}

/// An L, whose corners have their mean at the corner that turns inwards, and a U, of which no point sees all.
TEST(SubdivideFaces, ConcaveFacesAreDividedRoundAPointThatSeesAllCorners) {
  const auto flat = [](const std::vector<Vector2>& corners) {
    PolygonMesh mesh;
    std::vector<Index> face;
    for (const Vector2& p : corners) {
      face.push_back(Index(mesh.positions.size()));
      mesh.positions.emplace_back(p.x(), 0.6 * p.y(), 0.8 * p.y());
    }
    mesh.add_face(face);
    return source_of(std::move(mesh));
  };
  const PolyhedronSource l = flat({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const Faces first{l.polyhedron.face_id(0)};
  for (const PolyhedronSource& out : {subdivide_faces(l, first)->source, poke_faces(l, first)->source})
    for (Index f = 0; f < out.polyhedron.face_count(); ++f) {
      EXPECT_GT(face_normal(out.polyhedron, f).dot(Vector3(0, -0.8, 0.6)), 0.999) << "no part is turned over";
      std::vector<Vector3> corners;
      for (const Index v : out.polyhedron.topology().face_vertices(f))
        corners.push_back(out.polyhedron.position(v));
      EXPECT_GT(newell_normal(corners).norm(), 0.2) << "nor without area";
    }
  const PolyhedronSource u = flat({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});
  expect_error(subdivide_faces(u, Faces{u.polyhedron.face_id(0)}), e_no_centre);
  expect_error(poke_faces(u, Faces{u.polyhedron.face_id(0)}), e_no_centre);
  // Convex faces keep the mean of their corners.
  const PolyhedronSource cube = source_of(test::cube());
  Vector3 mean = Vector3::Zero();
  for (const Index v : cube.polyhedron.topology().face_vertices(0)) mean += cube.polyhedron.position(v) / 4;
  EXPECT_EQ(star_centre(cube.polyhedron, 0).value(), mean);
}

}  // namespace
}  // namespace hariko
