// The primitives: valid, outward, of the sizes asked for, symmetric, and refused for silly numbers.

#include "core/modeling/objects/primitives.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <tuple>

#include "core/document/source.hpp"
#include "core/polyhedron/validation.hpp"
#include "core/polyhedron/volume.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

struct Counts {
  Index vertices, edges, faces;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Vector3 low_of(const PolygonMesh& mesh) {
  Vector3 low = mesh.positions[0];
  for (const Vector3& p : mesh.positions) low = low.cwiseMin(p);
  return low;
}

Vector3 high_of(const PolygonMesh& mesh) {
  Vector3 high = mesh.positions[0];
  for (const Vector3& p : mesh.positions) high = high.cwiseMax(p);
  return high;
}

/// Manifold, without warnings, symmetric across x = 0 to the last bit.
void expect_good(const PolygonMesh& mesh) {
  const auto built = Polyhedron::build(mesh);
  ASSERT_TRUE(built.ok()) << to_string(built.error());
  for (const Message& message : validate(mesh))
    if (message.code != w_valence_2) ADD_FAILURE() << to_string(message);
  std::set<std::tuple<double, double, double>> points;
  for (const Vector3& p : mesh.positions) points.insert({p.x() + 0.0, p.y(), p.z()});
  EXPECT_EQ(points.size(), mesh.positions.size());
  for (const Vector3& p : mesh.positions)
    EXPECT_TRUE(points.contains({0.0 - p.x(), p.y(), p.z()})) << p.transpose();
}

double enclosed_volume(const PolygonMesh& mesh) {
  return closed_component_volumes(HalfEdgeMesh::build(mesh).value(), mesh.positions).at(0);
}

template <class Shape>
PolygonMesh made(const Shape& shape) {
  const auto mesh = test::must(make_primitive(shape));
  expect_good(*mesh);
  return *mesh;
}

Counts counts_of(const PolygonMesh& mesh) {
  const auto built = Polyhedron::build(mesh);
  return {built->vertex_count(), built->edge_count(), built->face_count()};
}

TEST(Primitives, BoxesHaveTheirSize) {
  const PolygonMesh box = made(BoxShape{{1, 2, 3}, {1, 1, 1}, Placement::centred});
  EXPECT_EQ(counts_of(box), (Counts{8, 12, 6}));
  EXPECT_EQ(low_of(box), Vector3(-0.5, -1, -1.5));
  EXPECT_EQ(high_of(box), Vector3(0.5, 1, 1.5));
  const PolygonMesh fine = made(BoxShape{{1, 2, 3}, {2, 3, 4}, Placement::on_ground});
  EXPECT_EQ(counts_of(fine).faces, 2u * (2 * 3 + 3 * 4 + 4 * 2));
  EXPECT_EQ(low_of(fine), Vector3(-0.5, -1, 0));
  EXPECT_EQ(high_of(fine), Vector3(0.5, 1, 3));
  EXPECT_NEAR(enclosed_volume(fine), 6, 1e-12);
}

TEST(Primitives, PrismsAndPyramids) {
  for (int n = 3; n <= max_primitive_sides; ++n) {
    const auto sides = static_cast<Index>(n);
    const PolygonMesh prism = made(PrismShape{n, 2, 5, Placement::on_ground});
    EXPECT_EQ(counts_of(prism), (Counts{2 * sides, 3 * sides, sides + 2}));
    EXPECT_EQ(low_of(prism).z(), 0);
    EXPECT_EQ(high_of(prism).z(), 5);
    EXPECT_EQ(high_of(prism).y(), 2);
    const PolygonMesh pyramid = made(PyramidShape{n, 2, 5, Placement::centred});
    EXPECT_EQ(counts_of(pyramid), (Counts{sides + 1, 2 * sides, sides + 1}));
    const double base = sides / 2.0 * 4 * std::sin(2 * std::numbers::pi / n);
    EXPECT_NEAR(enclosed_volume(prism), base * 5, 1e-10);
    EXPECT_NEAR(enclosed_volume(pyramid), base * 5 / 3, 1e-10);
  }
}

TEST(Primitives, PlatonicSolidsAreRegular) {
  const auto cubed = [](double edge) { return edge * edge * edge; };
  const std::array<std::tuple<PlatonicSolid, Counts, double>, 5> expected{{
      {PlatonicSolid::tetrahedron, {4, 6, 4}, 8 * std::sqrt(3.0) / 27},
      {PlatonicSolid::cube, {8, 12, 6}, 8 * std::sqrt(3.0) / 9},
      {PlatonicSolid::octahedron, {6, 12, 8}, 4.0 / 3},
      {PlatonicSolid::dodecahedron,
       {20, 30, 12},
       (15 + 7 * std::sqrt(5.0)) / 4 * cubed(4 / (std::sqrt(3.0) * (1 + std::sqrt(5.0))))},
      {PlatonicSolid::icosahedron,
       {12, 30, 20},
       5 * (3 + std::sqrt(5.0)) / 12 * cubed(1 / std::sin(2 * std::numbers::pi / 5))},
  }};
  for (const auto& [solid, counts, volume] : expected)
    for (const Placement placement : {Placement::centred, Placement::on_ground}) {
      const PolygonMesh mesh = made(PlatonicShape{solid, 3, placement});
      EXPECT_EQ(counts_of(mesh), counts);
      EXPECT_NEAR(enclosed_volume(mesh), volume * 27, 1e-9);
      const Polyhedron polyhedron = *Polyhedron::build(mesh);
      double shortest = infinity, longest = 0;
      for (Index h = 0; h < polyhedron.topology().half_edge_count(); ++h) {
        const double length = (polyhedron.position(polyhedron.topology().target(h)) -
                               polyhedron.position(polyhedron.topology().origin(h)))
                                  .norm();
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
      }
      EXPECT_NEAR(longest, shortest, 1e-12);
      if (placement == Placement::on_ground) {
        EXPECT_EQ(low_of(mesh).z(), 0);
        const auto on_ground = std::count_if(mesh.positions.begin(), mesh.positions.end(),
                                             [](const Vector3& p) { return p.z() == 0; });
        EXPECT_EQ(static_cast<std::size_t>(on_ground), mesh.face(0).size());
      } else {
        for (const Vector3& p : mesh.positions) EXPECT_NEAR(p.norm(), 3, 1e-12);
      }
    }
}

TEST(Primitives, ToriAndPlanes) {
  for (int m = 3; m < 14; ++m)
    for (int n = 3; n < 9; ++n) {
      const PolygonMesh torus = made(TorusShape{3, 1, m, n, Placement::on_ground});
      const auto quads = static_cast<Index>(m * n);
      EXPECT_EQ(counts_of(torus), (Counts{quads, 2 * quads, quads}));
      EXPECT_EQ(low_of(torus).z(), 0);
      EXPECT_GT(enclosed_volume(torus), 0);
    }
  const PolygonMesh plane = made(PlaneShape{4, 6, 2, 3});
  EXPECT_EQ(counts_of(plane), (Counts{12, 17, 6}));
  EXPECT_EQ(low_of(plane), Vector3(-2, -3, 0));
  EXPECT_EQ(high_of(plane), Vector3(2, 3, 0));
}

TEST(Primitives, SpheresAreRound) {
  for (int n = 1; n <= 16; ++n) {
    const PolygonMesh cage = made(SphereCageShape{2, n, Placement::centred});
    EXPECT_EQ(cage.face_count(), static_cast<std::size_t>(6 * n * n));
    for (const Vector3& p : cage.positions) EXPECT_NEAR(p.norm(), 2, 1e-12);
  }
  for (int level = 0; level <= 4; ++level) {
    const PolygonMesh sphere = made(IcosphereShape{2, level, Placement::centred});
    EXPECT_EQ(sphere.face_count(), static_cast<std::size_t>(20 << (2 * level)));
    for (const Vector3& p : sphere.positions) EXPECT_NEAR(p.norm(), 2, 1e-12);
  }
  EXPECT_EQ(low_of(made(SphereCageShape{2, 3, Placement::on_ground})).z(), 0);
  EXPECT_EQ(low_of(made(IcosphereShape{2, 2, Placement::on_ground})).z(), 0);
}

TEST(Primitives, EveryRandomShapeIsGood) {
  test::for_random(71, 300, [](std::mt19937_64& rng) {
    const double size = test::log_uniform(rng, 10 * min_primitive_length, max_primitive_length / 2);
    const double other = size * test::uniform(rng, 0.1, 0.9);
    const auto placement = test::chance(rng, 0.5) ? Placement::centred : Placement::on_ground;
    const auto count = [&](int low, int high) { return test::uniform_int(rng, low, high); };
    made(BoxShape{{size, other, size}, {count(1, 5), count(1, 5), count(1, 5)}, placement});
    made(PrismShape{count(3, 30), size, other, placement});
    made(PyramidShape{count(3, 30), other, size, placement});
    made(PlatonicShape{static_cast<PlatonicSolid>(count(0, 4)), size, placement});
    made(TorusShape{size, other, count(3, 20), count(3, 20), placement});
    made(PlaneShape{size, other, count(1, 20), count(1, 20)});
    made(SphereCageShape{size, count(1, 8), placement});
    made(IcosphereShape{size, count(0, 2), placement});
  });
}

template <class Shape>
void expect_refused(const Shape& shape, Code code) {
  const auto mesh = make_primitive(shape);
  test::must_fail(mesh, code);
  EXPECT_FALSE(mesh.error().text.empty());
  EXPECT_FALSE(mesh.error().remedy.empty());
}

TEST(Primitives, SillyNumbersAreRefused) {
  for (const double bad : {0.0, -1.0, nan, infinity, -infinity, 1e-300, 1e300}) {
    expect_refused(BoxShape{{1, bad, 1}, {1, 1, 1}, {}}, e_primitive_size);
    expect_refused(PrismShape{6, bad, 1, {}}, e_primitive_size);
    expect_refused(PrismShape{6, 1, bad, {}}, e_primitive_size);
    expect_refused(PyramidShape{6, bad, 1, {}}, e_primitive_size);
    expect_refused(PlatonicShape{PlatonicSolid::cube, bad, {}}, e_primitive_size);
    expect_refused(TorusShape{bad, 1, 8, 4, {}}, e_primitive_size);
    expect_refused(TorusShape{1, bad, 8, 4, {}}, e_primitive_size);
    expect_refused(PlaneShape{bad, 1, 1, 1}, e_primitive_size);
    expect_refused(SphereCageShape{bad, 2, {}}, e_primitive_size);
    expect_refused(IcosphereShape{bad, 2, {}}, e_primitive_size);
  }
  expect_refused(TorusShape{1, 1, 8, 4, {}}, e_primitive_size);
  for (const int bad : {-1000000, -1, 0, 2, 1000, std::numeric_limits<int>::max()}) {
    expect_refused(PrismShape{bad, 1, 1, {}}, e_primitive_count);
    expect_refused(PyramidShape{bad, 1, 1, {}}, e_primitive_count);
    expect_refused(TorusShape{2, 1, bad, 4, {}}, e_primitive_count);
    expect_refused(TorusShape{2, 1, 4, bad, {}}, e_primitive_count);
    if (bad == 2) continue;
    expect_refused(BoxShape{{1, 1, 1}, {1, bad, 1}, {}}, e_primitive_count);
    expect_refused(PlaneShape{1, 1, bad, 1}, e_primitive_count);
    expect_refused(PlaneShape{1, 1, 1, bad}, e_primitive_count);
    expect_refused(SphereCageShape{1, bad, {}}, e_primitive_count);
    if (bad != 0) expect_refused(IcosphereShape{1, bad, {}}, e_primitive_count);
  }
}

}  // namespace
}  // namespace hariko
