#include "core/polyhedron/polyhedron.hpp"

#include <limits>

#include "core/polyhedron/validation.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {
namespace {

Polyhedron built(const PolygonMesh& mesh) {
  return Polyhedron::build(mesh).value();
}

bool equal_meshes(const PolygonMesh& a, const PolygonMesh& b) {
  return a.positions == b.positions && a.face_offsets == b.face_offsets && a.face_vertices == b.face_vertices;
}

TEST(Polyhedron, GivesBackItsPolygons) {
  for_random(201, 100, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_polyhedron(rng);
    const Polyhedron polyhedron = built(mesh);
    EXPECT_TRUE(equal_meshes(polyhedron.to_mesh(), mesh));
    EXPECT_EQ(polyhedron, built(mesh));
  });
}

TEST(Polyhedron, FindsEveryElementByItsId) {
  for_random(202, 100, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_polyhedron(rng);
    std::vector<VertexId> vertex_ids(mesh.positions.size());
    std::vector<FaceId> face_ids(mesh.face_count());
    std::uint32_t next = 7;
    for (VertexId& id : vertex_ids) id = {next += static_cast<std::uint32_t>(uniform_int(rng, 1, 3))};
    for (FaceId& id : face_ids) id = {next += static_cast<std::uint32_t>(uniform_int(rng, 1, 3))};
    const Polyhedron p = Polyhedron::build(mesh, vertex_ids, face_ids).value();
    for (Index v = 0; v < p.vertex_count(); ++v) {
      EXPECT_EQ(p.vertex_id(v), vertex_ids[v]);
      EXPECT_EQ(p.find(vertex_ids[v]), v);
    }
    for (Index f = 0; f < p.face_count(); ++f) EXPECT_EQ(p.find(face_ids[f]), f);
    for (Index e = 0; e < p.edge_count(); ++e) EXPECT_EQ(p.find(p.edge_id(e)), e);
    EXPECT_EQ(p.find(VertexId{3}), no_index);
    EXPECT_EQ(p.find(VertexId{}), no_index);
    EXPECT_EQ(p.find(FaceId{3}), no_index);
    EXPECT_EQ(p.find(EdgeId::of(VertexId{3}, vertex_ids[0])), no_index);
    EXPECT_NE(p, built(mesh));
  });
}

TEST(Polyhedron, NoEdgeBetweenVerticesThatAreNotJoined) {
  EXPECT_EQ(built(cube()).find(EdgeId::of(VertexId{0}, VertexId{6})), no_index);
  EXPECT_NE(built(cube()).find(EdgeId::of(VertexId{1}, VertexId{0})), no_index);
}

std::string build_error(const PolygonMesh& mesh, std::vector<VertexId> vertex_ids,
                        std::vector<FaceId> face_ids) {
  const auto result = Polyhedron::build(mesh, std::move(vertex_ids), std::move(face_ids));
  return result.ok() ? "" : std::string(result.error().code.name) + " " + to_string(result.error().element);
}

TEST(Polyhedron, RefusesIdsThatDoNotNameEveryElementOnce) {
  const PolygonMesh triangle = without_face(without_face(without_face(pyramid(3), 0), 0), 0);
  ASSERT_EQ(triangle.face_count(), 1U);
  const std::vector<FaceId> face{{0}};
  EXPECT_EQ(build_error(triangle, {{0}, {1}, {2}, {9}}, face), "");
  EXPECT_EQ(build_error(triangle, {{0}, {1}, {2}}, face), "E_INDEX_RANGE ");
  EXPECT_EQ(build_error(triangle, {{0}, {1}, {1}, {2}}, face), "E_INDEX_RANGE ");
  EXPECT_EQ(build_error(triangle, {{0}, {2}, {1}, {3}}, face), "E_INDEX_RANGE ");
  EXPECT_EQ(build_error(triangle, {{0}, {1}, {2}, {0xffffffffU}}, face), "E_INDEX_RANGE ");
  EXPECT_EQ(build_error(triangle, {{0}, {1}, {2}, {3}}, {}), "E_INDEX_RANGE ");
}

TEST(Polyhedron, ErrorsNameElementsByTheGivenIds) {
  PolygonMesh mesh = without_face(cube(), 1);
  mesh.add_face({4, 7, 6, 5});  // flipped
  std::vector<VertexId> vertex_ids;
  std::vector<FaceId> face_ids;
  for (Index v = 0; v < 8; ++v) vertex_ids.push_back({100 + v});
  for (Index f = 0; f < 6; ++f) face_ids.push_back({50 + f});
  EXPECT_EQ(build_error(mesh, vertex_ids, face_ids), "E_EDGE_NONMANIFOLD_OR_FLIPPED edge 104-105");
  mesh.face_vertices[0] = 3;
  EXPECT_EQ(build_error(mesh, vertex_ids, face_ids), "E_FACE_REPEATED_VERTEX face 50");
  mesh.positions[2].y() = std::nan("");
  EXPECT_EQ(build_error(mesh, vertex_ids, face_ids), "E_NONFINITE vertex 102");
}

TEST(Polyhedron, WithPositionsMovesOnlyWhatIsNamed) {
  const Polyhedron before = built(cube());
  const std::vector<Index> moved{6, 0};
  const std::vector<Vector3> to{{2, 2, 2}, {-3, -3, -3}};
  const Polyhedron after = before.with_positions(moved, to).value();
  EXPECT_EQ(after.position(6), to[0]);
  EXPECT_EQ(after.position(0), to[1]);
  for (Index v : {1U, 2U, 3U, 4U, 5U, 7U}) EXPECT_EQ(after.position(v), before.position(v));
  EXPECT_EQ(before, built(cube()));
  EXPECT_NE(after, before);
  EXPECT_EQ(after.shared_topology(), before.shared_topology());
}

TEST(Polyhedron, WithPositionsRefusesNonFiniteOnes) {
  const Index vertex = 5;
  for (double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    const Vector3 position(0, bad, 0);
    const auto result = built(cube()).with_positions({&vertex, 1}, {&position, 1});
    must_fail(result, e_nonfinite);
    EXPECT_EQ(result.error().element, element_of(VertexId{5}));
  }
}

TEST(Origin, IsZeroForObjectsNearZero) {
  EXPECT_EQ(origin_for(cube().positions), Vector3::Zero());
  EXPECT_EQ(origin_for(std::vector<Vector3>{{0, 0, 0}, {1, 1, 1}}), Vector3::Zero());
  EXPECT_EQ(origin_for({}), Vector3::Zero());
}

TEST(Origin, IsAMultipleOfThePowerOfTwoAboveTheSize) {
  // Extents 3, 1, 2: steps of 4.
  const std::vector<Vector3> box{{100, 50, -11}, {103, 51, -9}};
  EXPECT_EQ(origin_for(box), Vector3(100, 52, -8));
  // An extent that is a power of two is its own step.
  EXPECT_EQ(origin_for(std::vector<Vector3>{{10, 0, 0}, {14, 0, 0}}), Vector3(12, 0, 0));
}

TEST(Origin, ObjectsMovedFarAwayKeepTheirRelativeCoordinates) {
  for_random(203, 200, [](std::mt19937_64& rng) {
    std::vector<Vector3> near = random_polyhedron(rng).positions;
    // On a raster of 2^-20, so that moving by 1e6 loses nothing and any difference is the origin's.
    for (Vector3& p : near) p = (p * 0x1p20).array().round() * 0x1p-20;
    const Vector3 shift(1e6, -1e6, 1e6);  // a multiple of 64, the largest step here
    std::vector<Vector3> far = near;
    for (Vector3& p : far) p += shift;
    const Vector3 near_origin = origin_for(near), far_origin = origin_for(far);
    EXPECT_EQ(far_origin - near_origin, shift);
    for (std::size_t i = 0; i < near.size(); ++i) {
      const Vector3 relative = far[i] - far_origin;
      EXPECT_EQ(relative, near[i] - near_origin);
      EXPECT_EQ(relative + far_origin, far[i]);
    }
  });
}

TEST(Origin, SubtractingItIsExactFarFromZero) {
  for_random(204, 500, [](std::mt19937_64& rng) {
    const Vector3 centre = random_vector(rng, 1).normalized() * log_uniform(rng, 1e3, 1e12);
    std::vector<Vector3> points;
    for (int i = 0; i < 20; ++i) points.push_back(centre + random_vector(rng, 1));
    const Vector3 origin = origin_for(points);
    for (const Vector3& p : points)
      for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(centre[axis]) < 100) continue;
        const long double exact = static_cast<long double>(p[axis]) - static_cast<long double>(origin[axis]);
        EXPECT_EQ(static_cast<long double>(p[axis] - origin[axis]), exact);
      }
  });
}

TEST(Origin, SurvivesExtremeCoordinates) {
  const double largest = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(origin_for(std::vector<Vector3>{{-largest, 0, 0}, {largest, 0, 0}}).allFinite());
  EXPECT_TRUE(origin_for(std::vector<Vector3>{{largest, 0, 0}, {largest / 2, 0, 0}}).allFinite());
  EXPECT_TRUE(origin_for(std::vector<Vector3>{{0, 1e300, 0}, {4 * tiny, 1e300, 0}}).allFinite());
  EXPECT_EQ(
      origin_for(std::vector<Vector3>{{infinity, 0, 0}, {99, 0, 0}, {101, 0, std::nan("")}, {101, 0, 0}}),
      Vector3(100, 0, 0));
  EXPECT_EQ(origin_for(std::vector<Vector3>{{3, 4, 5}}), Vector3(3, 4, 5));
}

}  // namespace
}  // namespace hariko::test
